import type { RefinedView } from './refining-sign.ts';
import type { VolumePresenter } from './volume-presenter.ts';

/** If a picture at rest is not final after this time, a sign shows that a better one is in progress, ms. */
const patience = 1000;

const timers = new WeakMap<Element, ReturnType<typeof setTimeout>>();

/** Whether a coarse picture is at rest, and a finer one is in progress. */
export function isRefining({ renderStats, paused }: RefinedView, { viewer }: Pick<VolumePresenter, 'viewer'>): boolean {
  if (!viewer || !paused || !renderStats || renderStats.converged || viewer.volume?.coarse) return false;
  return viewer.canDraw && viewer.wantsPicture && viewer.loop.unfinished && !viewer.moving && !viewer.animating;
}

/**
 * Called after each frame: where final pictures do not come soon, a sign shows that they are in progress. The code that draws the
 * sign is loaded then.
 */
export function followRefining(view: RefinedView, presenter: Pick<VolumePresenter, 'viewer'>): void {
  if (!isRefining(view, presenter)) {
    clearTimeout(timers.get(view));
    timers.delete(view);
  } else if (!timers.has(view)) {
    timers.set(
      view,
      setTimeout(() => void show(view, presenter), patience),
    );
  }
}

async function show(view: RefinedView, presenter: Pick<VolumePresenter, 'viewer'>): Promise<void> {
  // If that part can't be loaded, there is no sign.
  const part = isRefining(view, presenter) ? await import('./refining-sign.ts').catch(() => null) : null;
  await part?.showSign(view, () => (isRefining(view, presenter) ? presenter.viewer!.pictures : null));
  timers.delete(view);
}

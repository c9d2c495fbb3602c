import type { RefinedView } from './refining-sign.ts';
import type { VolumePresenter } from './volume-presenter.ts';

/** After so long at rest without a final picture a sign says that one is on its way, ms. */
const patience = 1000;

const timers = new WeakMap<Element, ReturnType<typeof setTimeout>>();

/** Whether a coarse picture is at rest, and a finer one is being made. */
export function isRefining({ renderStats, paused }: RefinedView, { viewer }: Pick<VolumePresenter, 'viewer'>): boolean {
  if (!viewer || !paused || !renderStats || renderStats.converged || viewer.volume?.coarse) return false;
  return viewer.canDraw && viewer.wantsPicture && viewer.loop.unfinished && !viewer.moving && !viewer.animating;
}

/** A frame was drawn: where final pictures do not come at once, a sign says that they are on their way. What draws it is loaded then. */
export function followRefining(view: RefinedView, presenter: Pick<VolumePresenter, 'viewer'>): void {
  if (!isRefining(view, presenter)) {
    clearTimeout(timers.get(view));
    timers.delete(view);
  } else if (!timers.has(view)) {
    timers.set(view, setTimeout(() => void show(view, presenter), patience));
  }
}

async function show(view: RefinedView, presenter: Pick<VolumePresenter, 'viewer'>): Promise<void> {
  // Without that part the picture is what it is.
  const part = isRefining(view, presenter) ? await import('./refining-sign.ts').catch(() => null) : null;
  await part?.showSign(view, () => (isRefining(view, presenter) ? presenter.viewer!.pictures : null));
  timers.delete(view);
}

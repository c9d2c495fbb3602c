import { loadPart } from '../../core/load-part.ts';
import type * as BlankPart from '../view/blank-note.ts';
import type * as ColorPart from '../attachments/color-moment.ts';
import { followChecks } from '../picking/lazy-check.ts';
import { followClicks } from '../picking/lazy-pick.ts';
import type { PickedView } from '../picking/pick-clicks.ts';
import { socketOf } from '../model/view-socket.ts';
import type { RotatingView } from '../view/auto-rotation.ts';
import { followRefining } from '../view/refining.ts';
import type { RefinedView } from '../view/refining-sign.ts';
import type { CheckedView } from '../picking/self-check.ts';
import type { VolumePresenter } from '../view/volume-presenter.ts';

let colors: typeof ColorPart | null = null;

/**
 * Follow those attributes of an element that need a picture, and load the code for those in use: clicks, checks, and the colours
 * of another moment.
 * @param presenter - of the element
 * @returns resolves when the picture agrees with the attributes
 */
export async function follow(
  view: HTMLElement &
    Partial<PickedView & CheckedView & ColorPart.ColoredView & RotatingView & RefinedView & BlankPart.NotedView>,
  presenter: VolumePresenter,
): Promise<void> {
  followRefining(view as RefinedView, presenter);
  void followBlank(view as BlankPart.NotedView, presenter);
  const follows = [followClicks(view), followChecks(view, presenter), followRotation(view as RotatingView, presenter)];
  if (view.colorMoment || colors) {
    const work = color(view as ColorPart.ColoredView, presenter);
    presenter.track(work);
    // Each picture updates the element: waiting for the next picture after each update would never end.
    if (await work) await presenter.viewer?.settled();
  }
  await Promise.all(follows);
}

/** Turn the camera while the element has `auto-rotate`. If that part can't be loaded, the picture stays as it is. */
async function followRotation(view: RotatingView, presenter: VolumePresenter): Promise<void> {
  const rotation = socketOf(view).last('rotation');
  if (rotation) rotation.follow();
  else if (view.autoRotate)
    await import('../view/auto-rotation.ts').then(({ rotate }) => rotate(view, presenter), console.warn);
}

/** Add a note to a picture at rest that may show nothing. If that part can't be loaded, there is no note. */
async function followBlank(view: BlankPart.NotedView, presenter: VolumePresenter): Promise<void> {
  const { renderStats: stats } = view;
  if (stats?.converged && !stats.error?.rays)
    await import('../view/blank-note.ts').then(({ noteBlank }) => noteBlank(view, presenter), console.warn);
}

/** @returns whether the next picture is different */
async function color(view: ColorPart.ColoredView, { errors }: VolumePresenter): Promise<boolean> {
  try {
    colors ??= await loadPart(import('../attachments/color-moment.ts'), 'colours by another moment');
    return await colors.colorsOf(view).refresh();
  } catch (error) {
    errors.report('overlay', error);
    return false;
  }
}

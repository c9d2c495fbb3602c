import { loadPart } from '../load-part.ts';
import type * as ColorPart from './color-moment.ts';
import { followClicks } from './lazy-pick.ts';
import type { PickedView } from './pick-clicks.ts';

let colors: typeof ColorPart | null = null;

/**
 * What of an element's attributes is followed where there is a picture, and loaded where it is used: clicks, and the colours of another moment.
 * @returns resolves when the picture is what they say
 */
export async function follow(view: HTMLElement & Partial<PickedView & ColorPart.ColoredView>): Promise<void> {
  const clicks = followClicks(view);
  if (view.colorMoment || colors) {
    const work = color(view as ColorPart.ColoredView);
    view._presenter!.track(work);
    await work;
    await view._presenter!.viewer?.settled();
  }
  await clicks;
}

async function color(view: ColorPart.ColoredView): Promise<void> {
  try {
    colors ??= await loadPart(import('./color-moment.ts'), 'colours by another moment');
    await colors.colorsOf(view).refresh();
  } catch (error) {
    view._presenter.errors.report('overlay', error);
  }
}

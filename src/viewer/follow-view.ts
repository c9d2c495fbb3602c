import { loadPart } from '../load-part.ts';
import type * as ColorPart from './color-moment.ts';
import { followClicks } from './lazy-pick.ts';
import type { PickedView } from './pick-clicks.ts';

let colors: typeof ColorPart | null = null;

/** What of an element's attributes is followed where there is a picture, and loaded where it is used: clicks, and the colours of another moment. */
export async function follow(view: HTMLElement & Partial<PickedView & ColorPart.ColoredView>): Promise<void> {
  await followClicks(view);
  if (!view.colorMoment && !colors) return;
  try {
    colors ??= await loadPart(import('./color-moment.ts'), 'colours by another moment');
    await colors.colorsOf(view as ColorPart.ColoredView).refresh();
  } catch (error) {
    view._presenter!.errors.report('overlay', error);
  }
}

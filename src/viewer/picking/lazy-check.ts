import { loadPart } from '../../core/load-part.ts';
import type { PictureCheck } from '../../quality/compare-rays.ts';
import type { CheckedView } from './self-check.ts';
import type * as SelfCheckPart from './self-check.ts';
import type { Viewer } from '../view/viewer.ts';
import type { VolumePresenter } from '../view/volume-presenter.ts';

let part: typeof SelfCheckPart | null = null;

/** See `checkPicture` of src/viewer/picking/check-picture.ts. @throws {VolumeViewError} `format/unsupported` */
export async function checkIn(viewer: Viewer | null): Promise<PictureCheck | null> {
  const { checkPicture } = await loadPart(import('./check-picture.ts'), 'checks pictures');
  return viewer && checkPicture(viewer);
}

/** Check the pictures of an element while it has `self-check`. */
export async function followChecks(
  view: HTMLElement & Partial<CheckedView>,
  presenter: VolumePresenter,
): Promise<void> {
  if (!view.selfCheck && !part) return;
  try {
    part ??= await loadPart(import('./self-check.ts'), 'checks pictures');
    part.checksOn(view as CheckedView, presenter);
  } catch (error) {
    presenter.errors.report('check', error);
  }
}

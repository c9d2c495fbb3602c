// Checks each picture at rest of an element that has `self-check`: loaded with the first such element.
import { VolumeViewError } from '../../core/errors.ts';
import type { PictureCheck } from '../../quality/compare-rays.ts';
import { checkPicture } from './check-picture.ts';
import type { RenderStats } from '../model/render-stats.ts';
import type { VolumePresenter } from '../view/volume-presenter.ts';

/** An element whose pictures can be checked. */
export interface CheckedView extends HTMLElement {
  readonly selfCheck: boolean;
}

/** One checker for each element, however many copies of the script the page has. */
const key = Symbol.for('volume-view.self-check');

/** Check the pictures of an element while it has `self-check`. */
export function checksOn(view: CheckedView & { [key]?: SelfCheck }, presenter: VolumePresenter): void {
  (view[key] ??= new SelfCheck(view, presenter)).start();
}

/** See `checksOn`. */
class SelfCheck {
  #isChecking = false;

  constructor(
    readonly view: CheckedView,
    readonly presenter: VolumePresenter,
  ) {
    view.addEventListener('render', ({ detail }: CustomEventInit<RenderStats>) => {
      if (detail!.converged) this.start();
    });
  }

  /** Start a check. Without a picture at rest there is nothing to check; the next such picture will be checked. */
  start(): void {
    if (!this.view.selfCheck) this.presenter.errors.clear('check');
    else if (!this.#isChecking) void this.#check();
  }

  async #check(): Promise<void> {
    const {
      view,
      presenter: { viewer, errors },
    } = this;
    if (!viewer) return;
    this.#isChecking = true;
    try {
      await viewer.settled();
      const check = view.selfCheck ? await checkPicture(viewer) : null;
      if (!check) return;
      view.dispatchEvent(new CustomEvent('picture-check', { detail: check }));
      if (!check.agrees) throw inaccurate(check);
      errors.clear('check');
    } catch (error) {
      errors.report('check', error);
    } finally {
      this.#isChecking = false;
    }
  }
}

function inaccurate({ rays, off, max }: PictureCheck): VolumeViewError {
  return new VolumeViewError(
    'webgl/inaccurate',
    `The graphics processor of this device draws the volume wrong: ${off} of ${rays} rays that were checked are off, by up to ${Math.min(255, Math.round(max))} of 255. Colours and opacities may mislead. Try another browser, or update this one and the driver of the graphics processor.`,
  );
}

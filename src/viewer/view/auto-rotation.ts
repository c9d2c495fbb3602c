// Turns the camera around a volume without interaction: loaded with the first element that has `auto-rotate`.
import { invalidAttribute } from '../../core/errors.ts';
import { isNumber } from '../model/parse-attributes.ts';
import { socketOf } from '../model/view-socket.ts';
import type { Viewer } from './viewer.ts';
import type { VolumePresenter } from './volume-presenter.ts';

/** An element whose camera may turn without interaction. */
export interface RotatingView extends HTMLElement {
  readonly autoRotate: boolean;
  readonly autoRotateDelay: number | null;
  readonly rotationPerSecond: string | null;
  requestUpdate(): void;
}

/** ms. */
const defaultDelay = 3000;

/** Radians a second: one turn takes 64 seconds, as in `<model-viewer>`. */
const usualSpeed = Math.PI / 32;

/** From now on the attributes of an element control its rotation. */
export function rotate(view: RotatingView, presenter: VolumePresenter): void {
  const socket = socketOf(view);
  // It stays when the attribute goes, with what the person has chosen.
  if (!socket.last('rotation')) void socket.join({ key: 'rotation', rotation: new AutoRotation(view, presenter) });
  socket.last('rotation')!.follow();
}

/**
 * Turns a camera without interaction: while the element is visible, nobody interacts with it or did a moment ago, and neither a
 * person nor the system's setting for less motion has stopped it.
 */
export class AutoRotation {
  /** The last choice of a person; null where nobody has chosen. */
  #asked: boolean | null = null;
  #inSight = false;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** Radians a second, and the attribute texts from which it was read. */
  #speed = 0;
  #read = '';
  readonly #fingers = new Set<number>();
  readonly #reduced = matchMedia('(prefers-reduced-motion: reduce)');
  /** The viewer that has the last speed, and that speed: radians a millisecond. */
  #reported: { readonly viewer: Viewer; readonly spin: number } | null = null;

  constructor(
    readonly view: RotatingView,
    readonly presenter: VolumePresenter,
  ) {
    view.addEventListener('pointerdown', ({ pointerId }) => {
      this.#fingers.add(pointerId);
      this.#apply();
    });
    for (const type of ['pointerup', 'pointercancel'] as const) {
      view.ownerDocument.addEventListener(type, ({ pointerId }) => this.#fingers.delete(pointerId) && this.#wait(), {
        capture: true,
      });
    }
    view.addEventListener('camera-change', () => this.#wait());
    this.#reduced.addEventListener('change', () => {
      this.#asked = null;
      this.#apply();
      view.requestUpdate();
    });
    new IntersectionObserver((entries) => {
      this.#inSight = entries.at(-1)!.isIntersecting;
      this.#apply();
    }).observe(view);
    this.#wait();
  }

  /** Whether a person, or the system's setting, has stopped it. */
  get stopped(): boolean {
    return !(this.#asked ?? !this.#reduced.matches);
  }

  /** A person stops the rotation, or lets it continue, then at once. */
  toggle(): void {
    this.#asked = this.stopped;
    clearTimeout(this.#timer);
    this.#timer = undefined;
    this.#apply();
    this.view.requestUpdate();
  }

  /** The attributes, or the viewer, may have changed. */
  follow(): void {
    const { autoRotateDelay, rotationPerSecond } = this.view;
    const texts = `${autoRotateDelay} ${rotationPerSecond}`;
    if (texts !== this.#read) {
      this.#read = texts;
      this.#speed = 0;
      this.presenter.errors.take('rotation', read(this.view), (speed) => (this.#speed = speed));
    }
    this.#apply();
  }

  /** A person has moved the camera, or it was placed: it stays there for a while. */
  #wait(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(
      () => {
        this.#timer = undefined;
        this.#apply();
      },
      Math.min(Math.max(0, this.view.autoRotateDelay ?? defaultDelay), 2 ** 31 - 1),
    );
    this.#apply();
  }

  #apply(): void {
    const { autoRotate } = this.view;
    const { viewer } = this.presenter;
    if (!viewer) return;
    const goes = autoRotate && this.#inSight && !this.stopped && this.#timer === undefined && this.#fingers.size === 0;
    const spin = goes ? -this.#speed / 1000 : 0; // The volume turns to the right as a person sees it, so the camera goes to the left.
    if (this.#reported?.viewer === viewer && this.#reported.spin === spin) return;
    this.#reported = { viewer, spin };
    viewer.rig.spin = spin;
    viewer.invalidate();
  }
}

/** Radians a second. */
function read({
  autoRotateDelay,
  rotationPerSecond: text,
}: RotatingView): { readonly value: number; readonly error?: undefined } | { readonly error: Error } {
  if (autoRotateDelay !== null && autoRotateDelay < 0)
    return { error: invalidAttribute('auto-rotate-delay', String(autoRotateDelay), 'a number of milliseconds from 0') };
  if (text === null || text.trim() === '') return { value: usualSpeed };
  const [, number, unit] = /^\s*(\S*?)(deg|rad|%)\s*$/i.exec(text) ?? [];
  const units = new Map([
    ['deg', Math.PI / 180],
    ['rad', 1],
    ['%', usualSpeed / 100],
  ]);
  const speed = isNumber(number ?? '') ? Number(number) * units.get(unit.toLowerCase())! : NaN;
  // With more than half a turn in a frame, nobody could see the rotation.
  return Math.abs(speed) <= 20 * Math.PI
    ? { value: speed }
    : {
        error: invalidAttribute(
          'rotation-per-second',
          text,
          'an angle such as 10deg or 0.2rad, or a percentage such as 50%, ten turns at most',
        ),
      };
}

import { parseCssColor } from '../optics/transfer/css-color.ts';
import { meanOfPatch } from '../optics/transfer/patches.ts';
import type { Patch, ValueAndGradient } from '../optics/transfer/patches.ts';
import { chooseSteepest } from './joint-histogram.ts';
import type { PlaneSamples } from './joint-histogram.ts';
import { boxBetween, hasRoom, moveGrip, newAppearance, newPatch, placeOfGrip, withNumber } from './patch-edits.ts';
import type { Grip, PlaneRange } from './patch-edits.ts';
import { moveByKey, PatchInput } from './patch-input.ts';
import type { Taken } from './patch-input.ts';
import type { ChartPlace } from './share-of-chart.ts';
import { toShare } from './transfer-function-axes.ts';
import type { EditSession } from './transfer-function-session.ts';

/** Receives the results of edits. */
export interface PatchListener {
  /** Something has changed that has to be drawn. */
  changed(): void;
  /** A patch's grip should get the focus after the next update. If the grip is gone, the button that adds one gets it. */
  focus(taken: Taken): void;
}

/** Patches that reach far above the data get at most so many times the data's height. */
const maxRoom = 2;

/** Edits boxes and Gaussians in the plane of values and gradients, by fields, keys, mouse and finger. */
export class PatchEditor {
  chosen = 0;
  readonly input: PatchInput;
  #range: PlaneRange = { domain: [0, 1], steepest: 1 };
  #samples: PlaneSamples | null = null;
  #drawing = -1;

  constructor(
    readonly session: EditSession,
    readonly listener: PatchListener,
  ) {
    this.input = new PatchInput({
      grips: () =>
        this.patches.flatMap((patch, index) =>
          (['middle', 'size'] as const).map((grip) => ({ index, grip, ...this.placeOf(placeOfGrip(patch, grip)) })),
        ),
      patchAt: (place) => this.#findAt(place),
      choose: (taken) => this.#choose(taken),
      drag: ({ index, grip }, to) =>
        this.#change(index, (patch) => moveGrip(patch, grip, this.#valueAt(to), this.#range)),
      draw: (from, to, isNew) => this.#draw([this.#valueAt(from), this.#valueAt(to)], isNew),
      drop: () => this.session.commit(),
    });
  }

  get patches(): readonly Patch[] {
    return this.session.look?.patches ?? [];
  }

  get range(): PlaneRange {
    return this.#range;
  }

  /** Sets what the chart spans: the editor's values, and the gradients of the data and the patches. */
  span(domain: readonly [number, number], samples: PlaneSamples | null): void {
    // While the gradients of another scan are being counted, the chart stays as it is.
    const isNew = samples !== null && samples !== this.#samples;
    this.#samples = samples ?? this.#samples;
    const steepestOfData = isNew ? chooseSteepest(samples) : this.#range.steepest;
    const tops = isNew ? this.patches.map((patch) => placeOfGrip(patch, 'size')[1]) : [];
    this.#range = {
      domain,
      steepest: Math.max(steepestOfData, ...tops.map((top) => Math.min(maxRoom * steepestOfData, 1.03 * top))),
    };
  }

  placeOf([value, gradient]: ValueAndGradient): ChartPlace {
    return { share: toShare(value, this.#range.domain), height: gradient / this.#range.steepest };
  }

  /** Changes a patch's appearance, without a step of the history; the colour is a CSS colour. */
  changeAppearance(index: number, { color, opacity }: { color?: string; opacity?: number }): void {
    this.#change(index, (patch) => ({
      ...patch,
      ...(color !== undefined && { color: parseCssColor(color)!.color }),
      ...(opacity !== undefined && { opacity: Math.min(1, Math.max(0, opacity)) }),
    }));
  }

  /** Changes one of the numbers of its position, without a step of the history. */
  changeNumber(index: number, which: number, number: number): void {
    this.#change(index, (patch) => withNumber(patch, which, number));
  }

  add(kind: Patch['kind']): void {
    if (hasRoom(this.patches))
      this.#put([...this.patches, newPatch(kind, this.patches.length, this.#range)], this.patches.length);
  }

  remove(index: number): void {
    this.#put(
      this.patches.filter((_, i) => i !== index),
      Math.max(0, Math.min(index, this.patches.length - 2)),
    );
  }

  /** Handles a key at a grip. @returns whether the key does anything */
  press(event: KeyboardEvent, { index, grip }: Taken): boolean {
    const patch = this.patches[index];
    if (!patch || event.ctrlKey || event.metaKey || event.altKey) return false;
    const move = moveByKey(event);
    if (move) {
      const {
        domain: [low, high],
        steepest,
      } = this.#range;
      const [value, gradient] = placeOfGrip(patch, grip);
      this.#change(index, () =>
        moveGrip(patch, grip, [value + move[0] * (high - low), gradient + move[1] * steepest], this.#range),
      );
    } else if (event.key === 'Delete' || event.key === 'Backspace') this.remove(index);
    else if (event.key === 'Insert' || event.key === '+') this.add(patch.kind);
    else return false;
    return true;
  }

  #choose(taken: { readonly index: number; readonly grip: Grip }): void {
    this.chosen = taken.index;
    this.listener.changed();
    this.listener.focus(taken);
  }

  #draw([from, to]: readonly [ValueAndGradient, ValueAndGradient], isNew: boolean): void {
    if (isNew) this.#drawing = hasRoom(this.patches) ? this.patches.length : -1;
    if (this.#drawing < 0) return;
    const appearance = this.patches[this.#drawing] ?? newAppearance(this.#drawing);
    const box = boxBetween(from, to, appearance, this.#range);
    this.#setAll([...this.patches.slice(0, this.#drawing), box]);
    if (isNew) this.#choose({ index: this.#drawing, grip: 'size' });
  }

  /** The chosen patch lies on top. */
  #findAt(place: ChartPlace): number {
    const at = this.#valueAt(place);
    const isAt = (patch: Patch): boolean => meanOfPatch(patch, at, at) > (patch.kind === 'box' ? 0 : Math.exp(-2));
    return this.patches[this.chosen] && isAt(this.patches[this.chosen]) ? this.chosen : this.patches.findIndex(isAt);
  }

  #valueAt({ share, height }: ChartPlace): ValueAndGradient {
    const {
      domain: [low, high],
      steepest,
    } = this.#range;
    return [low + share * (high - low), height * steepest];
  }

  #put(patches: readonly Patch[], chosen: number): void {
    this.#setAll(patches);
    this.session.commit();
    this.#choose({ index: chosen, grip: 'middle' });
  }

  /** A dragged patch may be gone: a key deletes it, or the page sets other ones. */
  #change(index: number, edit: (patch: Patch) => Patch): void {
    if (this.patches[index]) this.#setAll(this.patches.map((one, i) => (i === index ? edit(one) : one)));
  }

  #setAll(patches: readonly Patch[]): void {
    this.session.setPatches(patches);
    this.listener.changed();
  }
}

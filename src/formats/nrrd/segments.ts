// 3D Slicer's segmentations (.seg.nrrd): loaded with the first of them.
import { maxLabels, valueOf } from '../../volume/index-numbers.ts';
import type { NamedLabel } from '../../volume/labels.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Samples } from '../../volume/samples.ts';
import { cleanName } from '../base/clean-name.ts';
import { unsupportedFile } from '../base/file-problem.ts';
import { LabelPainter } from '../base/label-painter.ts';

/** One segment, as the header's keys describe it. */
export interface Segment {
  readonly name: string;
  readonly color: NamedLabel['color'];
  /** The value of its voxels in its layer, and the number of that layer among the file's volumes. */
  readonly value: number;
  readonly layer: number;
}

/**
 * The segments of a header, in the order of their numbers. Source: 3D Slicer 5, "Segmentation file format",
 * slicer.readthedocs.io, developer guide; files older than 4.11 have a layer for each segment, and no label values.
 * @param keys - Segment0_Name and similar
 * @param layers - number of volumes of the file
 */
export function readSegments(keys: ReadonlyMap<string, string>, layers: number): Segment[] {
  const numbers = [...new Set(Array.from(keys.keys(), (key) => Number(/^Segment(\d+)_/.exec(key)![1])))];
  numbers.sort((a, b) => a - b);
  return numbers.map((number) => {
    const text = (name: string): string => keys.get(`Segment${number}_${name}`)?.trim() ?? '';
    const whole = (name: string, fallback: number): number =>
      /^-?\d+$/.test(text(name)) ? Number(text(name)) : fallback;
    const channels = text('Color').split(/\s+/).map(Number);
    const isColor = channels.length === 3 && channels.every((channel) => channel >= 0 && channel <= 1);
    return {
      name: cleanName(text('Name') || text('ID')),
      color: isColor ? (channels as unknown as Vector3) : null,
      value: whole('LabelValue', layers > 1 ? 1 : number + 1),
      layer: whole('Layer', layers > 1 ? number : 0),
    };
  });
}

/** A layer's stored voxels. */
export interface Layer {
  readonly samples: Samples;
  readonly slope: number;
  readonly intercept: number;
  readonly ids?: readonly number[];
}

/** All layers in one grid of labels. */
export interface MergedSegments {
  readonly samples: Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>;
  readonly named: readonly NamedLabel[];
  /** Says which voxels are hidden because segments overlap. */
  readonly left: readonly string[];
}

/** The values of a voxel that is outside of a segment, and of one that is inside. */
type Fractions = readonly [none: number, all: number];

/** Puts layers on top of each other, the first at the bottom: where segments overlap, the later layer is shown. */
export class SegmentMerger {
  /** Id by layer and value. The id is the value, unless an earlier segment uses it. */
  readonly #ids = new Map<string, number>();
  readonly #named = new Map<number, NamedLabel>();
  readonly #painter: LabelPainter<Uint16Array<ArrayBuffer>>;
  #fractions: Fractions | null = null;

  constructor(
    readonly segments: readonly Segment[],
    voxels: number,
  ) {
    this.#painter = new LabelPainter(new Uint16Array(voxels));
    for (const { layer, value, name, color } of segments) this.#idOf(layer, value, { name, color });
  }

  #idOf(layer: number, value: number, { name = '', color = null }: Partial<Segment> = {}): number {
    const key = `${layer} ${value}`;
    const known = this.#ids.get(key);
    if (known !== undefined) return known;
    const isFree = Number.isInteger(value) && value > 0 && value < maxLabels && !this.#named.has(value);
    const id = isFree ? value : Math.max(0, ...this.#named.keys()) + 1;
    if (id >= maxLabels)
      throw unsupportedFile(
        'the NRRD file',
        `holds segments with values from ${value} on; expected at most 65,535 segments`,
      );
    this.#ids.set(key, id);
    this.#named.set(id, { id, name, color });
    return id;
  }

  /**
   * Looks for the values of no part of a voxel and of all of it, in all layers before the first of them is added: 3D Slicer has signed bytes from -108 to 108, others 0 to 1, 100
   * or 255, and no file says it.
   */
  countFractions(voxels: Layer): void {
    let [none, all] = this.#fractions ?? [0, 0];
    for (const stored of voxels.samples) {
      const value = valueOf(voxels, stored);
      if (value < none) none = value;
      if (value > all) all = value;
    }
    this.#fractions = [none, all];
  }

  add(layer: number, voxels: Layer): void {
    if (this.#fractions) {
      this.#addFractions(layer, voxels, this.#fractions);
      return;
    }
    const ids = new Map<number, number>();
    const { length } = this.#painter.samples;
    for (let i = 0; i < length; i++) {
      const stored = voxels.samples[i];
      let id = ids.get(stored);
      if (id === undefined) {
        const value = valueOf(voxels, stored);
        id = value === 0 || Number.isNaN(value) ? 0 : this.#idOf(layer, value);
        ids.set(stored, id);
      }
      if (id > 0) this.#painter.paint(i, id);
    }
  }

  /** A layer of fractions has one segment. */
  #addFractions(layer: number, voxels: Layer, [none, all]: Fractions): void {
    const segment = this.segments.find((one) => one.layer === layer);
    const id = this.#idOf(layer, segment?.value ?? 1);
    const half = (none + all) / 2;
    for (let i = 0; i < this.#painter.samples.length; i++) {
      const share = valueOf(voxels, voxels.samples[i]);
      if (share > none && share >= half) this.#painter.paint(i, id);
    }
  }

  finish(): MergedSegments {
    const { samples } = this.#painter;
    const isSmall = Math.max(0, ...this.#named.keys()) < 256;
    return {
      samples: isSmall ? Uint8Array.from(samples) : samples,
      named: [...this.#named.values()],
      left: [
        ...(this.#fractions
          ? [
              `fractions of segments: a voxel has the label where at least half of it is of the segment (values from ${this.#fractions.join(' to ')})`,
            ]
          : []),
        ...this.#painter.describeHidden((id) => `"${this.#named.get(id)!.name || id}"`, 'the segment '),
      ],
    };
  }
}

/** The names of a file with one layer, whose values are its ids. */
export function nameSegments(segments: readonly Segment[]): NamedLabel[] {
  return segments.map(({ value, name, color }) => ({ id: value, name, color }));
}

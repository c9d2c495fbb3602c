import type { Pixels } from '../../optics/rays/between-pixels.ts';
import { seekDetail } from '../../optics/cells/cell-detail.ts';
import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import { boundSeenCells } from '../../optics/cells/bound-seen-cells.ts';
import { maxSubsteps } from '../../optics/transfer/substep-limits.ts';
import { wholeSteps } from '../../optics/cells/substeps.ts';
import { largestOpacity } from '../../optics/transfer/transfer-function.ts';
import type { Substeps } from '../../optics/cells/substeps.ts';
import { estimateError } from '../../quality/error-estimate.ts';
import type { ErrorEstimate } from '../../quality/error-estimate.ts';
import { cutsOfLevels } from '../../quality/levels.ts';
import type { Level, LevelCuts } from '../../quality/levels.ts';
import { isWorthSearch, moreProbes, placeAround, placeProbes } from '../../quality/place-probes.ts';
import type { PixelLattice } from '../../optics/rays/rays.ts';
import type { PixelRectangle } from '../../quality/place-probes.ts';
import { autoSteps, stepLengthOf, voxelsAlong } from '../../quality/steps.ts';
import { atOnce } from '../../core/waiting.ts';
import type { Waiting } from '../../core/waiting.ts';
import { finestSpacing } from '../../volume/grid.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Scene, Size } from '../model/scene.ts';

/** Rows of the picture that show what error fewer pixels would have. */
const bandRows = 96;

/** The pixels of the last view's picture in which something may be visible; null where nothing can be. */
export function seenPixels(scene: Scene, { width, height }: Size): PixelRectangle | null {
  const seen = scene.whatIsSeen();
  const bounds = seen && boundSeenCells(seen.volume, seen.cells, scene.viewAt({ width, height }));
  if (!bounds) return null;
  const pixel = (place: number, pixels: number): number => ((place + 1) / 2) * pixels;
  const [left, bottom] = [Math.floor(pixel(bounds[0], width)), Math.floor(pixel(bounds[1], height))];
  return {
    left: Math.min(left, width - 1),
    bottom: Math.min(bottom, height - 1),
    width: Math.max(1, Math.min(width, Math.ceil(pixel(bounds[2], width))) - left),
    height: Math.max(1, Math.min(height, Math.ceil(pixel(bounds[3], height))) - bottom),
  };
}

/**
 * Whether one voxel of the visible values may hide what is behind it. False for radars: their gates are not voxels, and their rays
 * take long.
 */
function isOpaque(scene: Scene): boolean {
  const seen = scene.whatIsSeen();
  return (
    seen !== null &&
    !isPolar(seen.volume) &&
    (seen.hasSurfaces ||
      -Math.log1p(-largestOpacity([seen.transferFunction, ...(seen.functions ?? [])].flat())) *
        seen.opticalScale *
        finestSpacing(seen.volume.grid) >
        1)
  );
}

/** The share of cases in which more pixels than one in a thousand may be off by more than is found, where matter is opaque. */
const doubtOfOpaque = 0.05;

/** The same for steps that lose small things: with less, fewer would be spared. */
const doubtOfSmall = 0.2;

/** Number of pixels, in floats, that are drawn and read together to find those that show something. */
const searchedAtOnce = 2 ** 18;

/**
 * Do some work in parts, and leave the page time in between.
 * @param goesOn - whether the view is still needed
 * @returns null where it is not
 */
export async function aside<T>(
  work: Waiting<T>,
  scene: Scene,
  goesOn: () => boolean,
): Promise<{ readonly value: T } | null> {
  while (goesOn()) {
    const { done, value } = work.next();
    if (done) return goesOn() ? { value } : null;
    await scene.finished();
  }
  return null;
}

const onePixel: PixelLattice = { stride: 1, first: [0, 0], width: 1, height: 1 };

/** For which visible volume, and which loss, the present detail of a scene's cells was found. */
const detailed = new WeakMap<
  Scene,
  { readonly seen: SeenVolume; readonly mayLose: number; readonly long: Substeps['long'] }
>();

/**
 * Find how finely the cells of a scene must be sampled, with pauses: without this, the next picture would do it in one go.
 * @param warmUp - lets the GPU compile the probe's program meanwhile
 */
function* findCells(scene: Scene, cut: Substeps, warmUp: () => void): Waiting<void> {
  const { findDetail, mayLose, long } = cut;
  const seen = findDetail ? scene.whatIsSeen() : null;
  const known = detailed.get(scene);
  if (!seen || (known?.seen === seen && known.mayLose === mayLose && known.long === long)) return;
  warmUp();
  const codes = yield* seekDetail(seen, mayLose, !!long);
  scene.detail({ ...cut, findDetail: () => codes });
  detailed.set(scene, { seen, mayLose, long });
}

/** The number of a picture's pixels that show something. */
function countShown(picture: Float32Array): number {
  return picture.filter((x, i) => i % 4 === 3 && x > 0).length;
}

/** What to probe. */
export interface ProbedView {
  readonly grid: GridFrame;
  /** Pixels across and down of the picture in full. */
  readonly size: Size;
  readonly cuts: LevelCuts;
  /** Whether small things may be lost: then a few pixels may be much of the error, and so many are probed that some of these are met. */
  readonly losesSmall?: boolean;
}

/** Pictures of a level: its own one, and two finer ones. */
export interface Comparison {
  /** Whether each has half the step of the one before. */
  readonly isEven: boolean;
  readonly pictures: readonly (readonly [steps: number, cut: Substeps])[];
}

/** Probes rays of the last view to measure the error of a level; it probes each level once. */
export class ErrorProbe {
  readonly #pictures = new Map<string, Float32Array | null>();
  #rectangle: PixelRectangle | null | undefined;
  /** The pixels to probe: all of a small rectangle, or some. The first probes decide how many there are; null before them. */
  lattices: readonly PixelLattice[] | null = null;
  /** Whether all pixels have been searched, where this is worth the time. */
  #isSearched = false;
  /** Set where the probes are a sample of many pixels, of which a few may have a large error: see `ProbedPictures`. */
  #doubt: number | undefined;
  /** The share of the rectangle's pixels that are probed, where all others are known to show nothing. */
  #share = 1;

  constructor(
    readonly scene: Scene,
    readonly view: ProbedView,
  ) {}

  get grid(): GridFrame {
    return this.view.grid;
  }

  /** The rectangle that contains the probed pixels; null where nothing can be visible. */
  get rectangle(): PixelRectangle | null {
    if (this.#rectangle === undefined) this.#rectangle = seenPixels(this.scene, this.view.size);
    return this.#rectangle;
  }

  /**
   * The error of a level: its picture is compared with pictures of half and a quarter of its step length, and at most half a
   * voxel, whose steps are cut in the same way; or with those that are given. null where the device can't measure it.
   */
  estimate(level: Level, { isEven, pictures }: Comparison = this.#plan(level)): ErrorEstimate | null {
    const [shown, middle, fine] = pictures.map((picture) => atOnce(this.#probe(...picture)));
    return shown && middle && fine && estimateError({ shown, middle, fine, isEven, doubt: this.#doubt });
  }

  /**
   * Draw the pictures that `estimate` compares, and leave the page time in between.
   * @returns whether the view is still needed
   */
  async prepare(level: Level, goesOn: () => boolean, compared = this.#plan(level)): Promise<boolean> {
    return (await aside(this.#drawAll(compared), this.scene, goesOn)) !== null;
  }

  /** The same for the pictures that `distance` compares. */
  async prepareDistances(steps: readonly number[], level: Level, goesOn: () => boolean): Promise<boolean> {
    return (await aside(this.#drawPairs(steps, level), this.scene, goesOn)) !== null;
  }

  /** Parts of a level's picture, in floats; null where the device can't draw them. */
  drawParts(lattices: readonly PixelLattice[], level: Level): Waiting<Float32Array[] | null> {
    return this.#drawEach(lattices, level.steps, this.view.cuts.own(level));
  }

  *#drawPairs(steps: readonly number[], level: Level): Waiting<void> {
    for (const one of steps) yield* this.#pair(one, level);
  }

  *#drawAll({ pictures }: Comparison): Waiting<void> {
    const [[steps, cut]] = pictures;
    yield* findCells(this.scene, cut, () =>
      this.scene.startProbe({ stepLength: stepLengthOf(this.grid, steps) }, onePixel, this.view.size),
    );
    if (!this.#isSearched) {
      const first = yield* this.#probe(steps, cut);
      yield* this.#search(first, Math.max(steps, autoSteps(this.grid)), cut);
      this.#isSearched = true;
    }
    for (const picture of pictures) yield* this.#probe(...picture);
  }

  /** If so few probes show something that they may have missed other objects, look at all pixels, and probe those that show something. */
  *#search(first: Float32Array | null, steps: number, substeps: Substeps): Waiting<void> {
    const { rectangle } = this;
    if (!rectangle || !first || !isWorthSearch(this.lattices!, countShown(first))) return;
    const { left, bottom, width, height } = rectangle;
    const shown: [number, number][] = [];
    const rows = Math.max(1, Math.floor(searchedAtOnce / width));
    for (let row = 0; row < height; row += rows) {
      const lattice = { stride: 1, first: [left, bottom + row], width, height: Math.min(rows, height - row) } as const;
      const picture = yield* this.#drawAt([lattice], steps, substeps);
      picture?.forEach((x, i) => {
        const pixel = (i - 3) / 4;
        if (i % 4 === 3 && x > 0) shown.push([left + (pixel % width), bottom + row + Math.floor(pixel / width)]);
      });
    }
    if (shown.length === 0) return;
    this.lattices = placeAround(shown);
    if (this.lattices.every(({ stride }) => stride === 1)) this.#doubt = undefined;
    this.#pictures.clear();
    this.#share = Math.min(1, this.lattices.reduce((sum, one) => sum + one.width * one.height, 0) / (width * height));
  }

  /** A level's own picture, and those with half and a quarter of its step length: the number of steps, and how they are cut. */
  #plan(level: Level): Comparison {
    const { grid, cuts } = this.view;
    const one = autoSteps(grid);
    const isEven = level.steps >= one;
    const finer = isEven ? level : { steps: one, substeps: maxSubsteps };
    const cut = isEven ? cuts.own(finer) : cuts.reference(finer);
    return {
      isEven,
      pictures: [
        [level.steps, cuts.own(level)],
        [finer.steps * 2, cut],
        [finer.steps * 4, cut],
      ],
    };
  }

  /**
   * The error of fewer steps, compared with a level's finest picture: RMS over all probed pixels, 1/255; null where the device can
   * no longer measure it.
   */
  distance(steps: number, level: Level): number | null {
    const [coarse, fine] = atOnce(this.#pair(steps, level));
    if (!coarse || !fine) return null;
    const sum = coarse.reduce((total, x, i) => total + (x - fine[i]) ** 2, 0);
    return 255 * Math.sqrt((this.#share * sum) / Math.max(1, coarse.length));
  }

  *#pair(steps: number, level: Level): Waiting<readonly (Float32Array | null)[]> {
    const cut = this.view.cuts.reference(level);
    return [yield* this.#probe(steps, wholeSteps), yield* this.#probe(level.steps * 4, cut)];
  }

  /** RGBA of the rays of all lattices, one after the other. */
  *#probe(steps: number, substeps: Substeps): Waiting<Float32Array | null> {
    const key = `${steps} ${JSON.stringify(substeps)}`;
    let picture = this.#pictures.get(key);
    if (picture === undefined) this.#pictures.set(key, (picture = yield* this.#draw(steps, substeps)));
    return picture;
  }

  *#draw(steps: number, substeps: Substeps): Waiting<Float32Array | null> {
    if (this.lattices) return yield* this.#drawAt(this.lattices, steps, substeps);
    const opaque = isOpaque(this.scene);
    const hasRare = opaque || this.view.losesSmall === true;
    const place = (times: number): PixelLattice[] =>
      this.rectangle ? placeProbes(this.rectangle, hasRare, times) : [];
    const lattices = place(1);
    const picture = yield* this.#drawAt(lattices, steps, substeps);
    const times = picture && lattices.length > 1 ? moreProbes(countShown(picture), picture.length / 4, hasRare) : 1;
    this.lattices = times > 1 ? place(times) : lattices;
    if (hasRare && this.lattices.some(({ stride }) => stride > 1)) this.#doubt = opaque ? doubtOfOpaque : doubtOfSmall;
    return times > 1 ? yield* this.#drawAt(this.lattices, steps, substeps) : picture;
  }

  *#drawAt(lattices: readonly PixelLattice[], steps: number, substeps: Substeps): Waiting<Float32Array | null> {
    const parts = yield* this.#drawEach(lattices, steps, substeps);
    if (!parts) return null;
    return parts.length === 1 ? parts[0] : Float32Array.from(parts.flatMap((part) => [...part]));
  }

  /** Waits once for all of them: each wait for the GPU takes a millisecond or more, and most have few pixels. */
  *#drawEach(lattices: readonly PixelLattice[], steps: number, substeps: Substeps): Waiting<Float32Array[] | null> {
    const reads: (() => Float32Array | null)[] = [];
    for (const lattice of lattices) {
      const read = this.scene.startProbe(
        { stepLength: stepLengthOf(this.grid, steps), substeps },
        lattice,
        this.view.size,
      );
      if (!read) return null;
      reads.push(read);
    }
    yield;
    const parts: Float32Array[] = [];
    for (const read of reads) {
      const part = read();
      if (!part) return null;
      parts.push(part);
    }
    return parts;
  }
}

/** The error of the last view with this level's steps, before it is drawn; null where the device can't measure it. */
export function measureError(
  scene: Scene,
  grid: GridFrame,
  level: Level,
  size: Size = scene.canvas,
): ErrorEstimate | null {
  return new ErrorProbe(scene, { grid, size, cuts: cutsOfLevels(voxelsAlong(grid), null) }).estimate(level);
}

/**
 * The error that a picture would have with half the pixels across and down, enlarged bilinearly as browsers do it; RMS, 1/255.
 * Measured in a band across its middle.
 */
export function errorAtHalf({ data, width, height }: Pixels): number {
  const rows = Math.min(height, bandRows) & ~1;
  const columns = width & ~1;
  if (rows < 4 || columns < 4) return 0;
  const below = Math.floor((height - rows) / 2);
  let sum = 0;
  let count = 0;
  // Where four coarse pixels meet, bilinear filtering gives 9, 3, 3 and 1 sixteenths of their means to each fine one.
  for (let y = 2; y + 3 < rows; y += 2) {
    for (let x = 2; x + 3 < columns; x += 2) {
      for (let c = 0; c < 4; c++) {
        const mean = (i: number, j: number): number => {
          const at = ((below + y + j) * width + x + i) * 4 + c;
          return (data[at] + data[at + 4] + data[at + width * 4] + data[at + width * 4 + 4]) / 4;
        };
        const filtered = (9 * mean(0, 0) + 3 * mean(2, 0) + 3 * mean(0, 2) + mean(2, 2)) / 16;
        sum += (data[((below + y + 1) * width + x + 1) * 4 + c] - filtered) ** 2;
        count++;
      }
    }
  }
  return Math.sqrt(sum / count);
}

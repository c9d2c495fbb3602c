import type { Pixels } from '../optics/between-pixels.ts';
import type { PixelLattice } from '../optics/rays.ts';
import { estimateError } from '../quality/error-estimate.ts';
import type { ErrorEstimate } from '../quality/error-estimate.ts';
import { stepLengthOf } from '../quality/steps.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Scene, Size } from './scene.ts';

/**
 * Of so many pixels across and down one is probed, on two lattices. With its step, half of it and a quarter that is
 * 14 / 169 of the picture's own samples: a twelfth of a frame. Odd, so that pixels of all lattices of an adaptively sampled picture
 * have their turn.
 */
const pixelsPerRay = 13;

/** Fewest rays across and down by which a picture is probed. */
const minRays = 8;

/** Rows of the picture that tell what fewer pixels would cost. */
const bandRows = 96;

/** The rays that tell the error of a picture: on two lattices, one amid the other. */
export function probeLattices({ width, height }: Size): readonly [PixelLattice, PixelLattice] {
  const most = Math.floor(Math.min(width, height) / minRays);
  const stride = Math.max(1, Math.min(pixelsPerRay, most - ((most + 1) % 2)));
  const lattice = (first: number): PixelLattice => {
    const fitting = (pixels: number): number => Math.max(1, Math.floor((pixels - 1 - first) / stride) + 1);
    return { stride, first, width: fitting(width), height: fitting(height) };
  };
  return [lattice((stride - 1) / 2), lattice(0)];
}

/** A picture's rays with its step, half of it and a quarter. */
export type ProbedPictures = [Float32Array, Float32Array, Float32Array];

/**
 * Probes rays of the last view, which tell the error that a number of steps leaves; each of them once.
 */
export class ErrorProbe {
  readonly #probes = new Map<string, ProbedPictures | null>();

  /** @param size - pixels across and down of the picture in full */
  constructor(readonly scene: Scene, readonly grid: GridFrame, readonly size: Size) {}

  /** The rays of one lattice; null where the device can't draw them. */
  probe(steps: number, which: 0 | 1): ProbedPictures | null {
    const key = `${steps} ${which}`;
    let pictures = this.#probes.get(key);
    if (pictures === undefined) this.#probes.set(key, (pictures = this.#draw(steps, which)));
    return pictures;
  }

  /** The rays of both. */
  probeBoth(steps: number): ProbedPictures | null {
    const [a, b] = [this.probe(steps, 0), this.probe(steps, 1)];
    return a && b && [join(a[0], b[0]), join(a[1], b[1]), join(a[2], b[2])];
  }

  #draw(steps: number, which: 0 | 1): ProbedPictures | null {
    const lengths = [1, 2, 4].map((finer) => stepLengthOf(this.grid, steps * finer));
    const pictures = this.scene.probe(lengths, probeLattices(this.size)[which], this.size);
    return pictures && [pictures[0], pictures[1], pictures[2]];
  }
}

function join(a: Float32Array, b: Float32Array): Float32Array {
  const both = new Float32Array(a.length + b.length);
  both.set(a);
  both.set(b, a.length);
  return both;
}

/** The error that a number of steps leaves of the last view, before it is drawn; null where the device can't tell. */
export function measureError(scene: Scene, grid: GridFrame, steps: number, size: Size = scene.canvas): ErrorEstimate | null {
  const pictures = new ErrorProbe(scene, grid, size).probeBoth(steps);
  return pictures && estimateError(pictures);
}

/** The bytes that a whole picture shows of the pixels that are probed. @param picture - bottom row first */
export function pickProbed(picture: Pixels): number[] {
  const picked: number[] = [];
  for (const { stride, first, width, height } of probeLattices(picture)) {
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        const from = 4 * ((first + y * stride) * picture.width + first + x * stride);
        for (let c = 0; c < 4; c++) picked.push(picture.data[from + c]);
      }
    }
  }
  return picked;
}

/**
 * The error that a picture would have with half the pixels across and down, blown up again as browsers
 * do it, bilinear; RMS, 1/255. Measured in a band across its middle.
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

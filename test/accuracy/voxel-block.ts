import { axialIndexToWorld, cartesianGrid } from '../../src/volume/grid.ts';
import { summarize } from '../../src/volume/histogram.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** A cube of bytes to paint in, by whole voxel indices. */
export class VoxelBlock {
  readonly samples: Uint8Array<ArrayBuffer>;

  constructor(
    readonly edge: number,
    value: number | ((i: number, j: number, k: number) => number) = 0,
  ) {
    this.samples = new Uint8Array(edge ** 3);
    if (typeof value === 'number') this.samples.fill(value);
    else this.paint(value);
  }

  /** Give all voxels a value, 0..255. */
  paint(value: (i: number, j: number, k: number) => number): void {
    for (let k = 0, at = 0; k < this.edge; k++) {
      for (let j = 0; j < this.edge; j++) {
        for (let i = 0; i < this.edge; i++) this.samples[at++] = Math.round(value(i, j, k));
      }
    }
  }

  get([i, j, k]: Vector3): number {
    return this.samples[(k * this.edge + j) * this.edge + i];
  }

  /** Set the voxel nearest to a place; nothing outside of the block. */
  set(place: Vector3, value: number): void {
    const [i, j, k] = place.map(Math.round);
    if ([i, j, k].every((n) => n >= 0 && n < this.edge)) this.samples[(k * this.edge + j) * this.edge + i] = value;
  }

  copy(): VoxelBlock {
    const block = new VoxelBlock(this.edge);
    block.samples.set(this.samples);
    return block;
  }

  /** A volume with voxels of 1 mm around the origin, whose data values are the bytes. */
  toVolume(): Volume {
    const dimensions: Vector3 = [this.edge, this.edge, this.edge];
    return {
      grid: cartesianGrid(dimensions, axialIndexToWorld(dimensions, [1, 1, 1])),
      samples: this.samples,
      slope: 1,
      intercept: 0,
      unit: '',
      format: 'synthetic',
      macrocells: buildMacrocells(this.samples, dimensions),
      ...summarize(this.samples, 1, 0),
    };
  }
}

/** Smooth noise of 0..1: cubic B-splines through random numbers, so many voxels apart. */
export function smoothNoise(
  edge: number,
  apart: number,
  random: () => number,
): (i: number, j: number, k: number) => number {
  const nodes = Math.ceil(edge / apart) + 4;
  const values = Float64Array.from({ length: nodes ** 3 }, () => random());
  const weights = Array.from({ length: edge }, (_, i) => {
    const t = (i / apart) % 1;
    return [
      (1 - t) ** 3 / 6,
      (3 * t ** 3 - 6 * t ** 2 + 4) / 6,
      (-3 * t ** 3 + 3 * t ** 2 + 3 * t + 1) / 6,
      t ** 3 / 6,
    ];
  });
  return (i, j, k) => {
    const [ni, nj, nk] = [i, j, k].map((n) => Math.floor(n / apart));
    let sum = 0;
    for (let c = 0; c < 4; c++) {
      for (let b = 0; b < 4; b++) {
        const row = ((nk + c) * nodes + nj + b) * nodes + ni;
        const w = weights[k][c] * weights[j][b];
        for (let a = 0; a < 4; a++) sum += w * weights[i][a] * values[row + a];
      }
    }
    return sum;
  };
}

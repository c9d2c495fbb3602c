import { axialIndexToWorld, cartesianGrid } from '../../src/volume/grid.ts';
import { summarize } from '../../src/volume/histogram.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import type { Matrix4, Vector3 } from '../../src/volume/matrix.ts';
import type { Samples, Volume } from '../../src/volume/volume.ts';

/** A smooth field on the unit cube, 0..1, without any symmetry, so that a flip is visible. */
export function smoothField(x: number, y: number, z: number): number {
  const wave = Math.sin(5.1 * x + 1.3) * Math.cos(4.3 * y - 0.7) * Math.sin(3.7 * z + 0.4);
  const ball = Math.exp(-8 * ((x - 0.62) ** 2 + (y - 0.41) ** 2 + (z - 0.55) ** 2));
  return Math.min(1, Math.max(0, 0.25 + 0.25 * wave + 0.5 * ball));
}

/** The same field with a ball without data in it. */
export const fieldWithHole = (x: number, y: number, z: number): number =>
  Math.hypot(x - 0.3, y - 0.5, z - 0.6) < 0.25 ? NaN : smoothField(x, y, z);

export type SampleKind = 'uint8' | 'uint16' | 'float32';

export interface SyntheticOptions {
  readonly dimensions: Vector3;
  readonly kind?: SampleKind;
  readonly spacing?: Vector3;
  readonly indexToWorld?: Matrix4;
  readonly field?: (x: number, y: number, z: number) => number;
  readonly slope?: number;
  readonly intercept?: number;
}

/** A volume of a field sampled at voxel centres. Data values are the field's times slope plus intercept. */
export function syntheticVolume(options: SyntheticOptions): Volume {
  const { dimensions, kind = 'uint8', spacing = [1, 1, 1], field = smoothField } = options;
  const [nx, ny, nz] = dimensions;
  const scale = { uint8: 255, uint16: 65535, float32: 1 }[kind];
  const samples: Samples = new { uint8: Uint8Array, uint16: Uint16Array, float32: Float32Array }[kind](nx * ny * nz);
  for (let k = 0, at = 0; k < nz; k++) {
    for (let j = 0; j < ny; j++) {
      for (let i = 0; i < nx; i++, at++) {
        const value = field((i + 0.5) / nx, (j + 0.5) / ny, (k + 0.5) / nz);
        samples[at] = kind === 'float32' ? value : Math.round(value * scale);
      }
    }
  }
  const indexToWorld = options.indexToWorld ?? axialIndexToWorld(dimensions, spacing);
  const slope = (options.slope ?? 1) / scale;
  const intercept = options.intercept ?? 0;
  return {
    grid: cartesianGrid(dimensions, indexToWorld),
    samples,
    slope,
    intercept,
    unit: '',
    format: 'synthetic',
    macrocells: buildMacrocells(samples, dimensions),
    ...summarize(samples, slope, intercept),
  };
}

/** Numbers from 0 up to 1 that are the same in every run. Source: mulberry32, Tommy Ettinger, public domain. */
export function randomNumbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** An affine map with random rotation, scale, shear and offset: no entry of its upper rows has a special value. */
export function obliqueAffine(random: () => number, spacing: Vector3, center: Vector3 = [0, 0, 0]): Matrix4 {
  const entries = [0, 1, 2].flatMap((row) =>
    [0, 1, 2].map((c) => (row === c ? 1 : random() - 0.5) * spacing[c]).concat(center[row]),
  );
  return [...entries, 0, 0, 0, 1];
}

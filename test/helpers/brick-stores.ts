import { expect } from '@esm-bundle/chai';
import type { BrickStore } from '../../src/formats/base/brick-store.ts';
import { chooseKeptBytes } from '../../src/formats/base/brick-limits.ts';
import type { DecodeSettings } from '../../src/formats/base/decoded-volume.ts';
import { Queue } from '../../src/formats/base/queue.ts';
import { ByteCache } from '../../src/formats/zarr/byte-cache.ts';
import { ChunkSource } from '../../src/formats/zarr/chunk-source.ts';
import type { FileTree } from '../../src/formats/zarr/file-tree.ts';
import { limitReads } from '../../src/formats/zarr/limit-reads.ts';
import { openZarrBricks } from '../../src/formats/zarr/zarr-bricks.ts';
import type { BrickOpening } from '../../src/formats/zarr/zarr-bricks.ts';
import type { Brick } from '../../src/bricks/pyramid.ts';
import type { Formula, FormulaFiles } from './formula-pyramid.ts';

/** A signal that is never given. */
export const noSignal = (): AbortSignal => new AbortController().signal;

/** What a promise fails with. */
export const failureOf = (promise: Promise<unknown>): Promise<unknown> =>
  promise.then(
    () => Promise.reject(new Error('expected a failure, got none')),
    (reason: unknown) => reason,
  );

/** How a tree is opened in a test. */
export type TestOpening = Partial<BrickOpening> & { readonly requests?: Queue };

/** Opens a Zarr in bricks, as the worker does, but with chunks of its own. */
export function openBricksOf(
  found: FileTree,
  { requests = new Queue(8), ...opening }: TestOpening = {},
  settings: DecodeSettings = {},
): Promise<BrickStore | null> {
  const tree = { ...found, ...limitReads(found, requests) };
  const { keptBytes = chooseKeptBytes(), deviceBytes } = opening;
  const chunks = new ChunkSource(tree, new ByteCache(keptBytes), deviceBytes);
  return openZarrBricks({ tree, before: 0, chunks }, settings, { signal: noSignal(), ...opening });
}

/** Files that are computed, without a server. */
export const formulaTree = (files: FormulaFiles): FileTree => ({
  async read(path, { part, signal } = {}) {
    signal?.throwIfAborted();
    const size = files.sizeOf(path);
    if (size === null) return null;
    if (!part) return files.bytesOf(path, 0, size);
    return 'end' in part
      ? files.bytesOf(path, part.start, Math.min(size, part.end))
      : files.bytesOf(path, Math.max(0, size - part.last), size);
  },
  showPart: async () => undefined,
});

/** All bricks of all levels. */
export function allBricks({ levels }: BrickStore): Brick[] {
  return levels.flatMap(({ bricks: [nx, ny, nz] }, level) =>
    Array.from({ length: nx * ny * nz }, (_, n): Brick => ({
      level,
      at: [n % nx, Math.floor(n / nx) % ny, Math.floor(n / (nx * ny))],
    })),
  );
}

/**
 * Checks a brick, with its halo, against the formula.
 * @param isAlone - its halo repeats its outermost voxels
 */
export async function expectFormula(
  store: BrickStore,
  formula: Formula,
  brick: Brick,
  isAlone?: boolean,
): Promise<void> {
  const { samples, low, high } = await store.read(brick, noSignal(), isAlone);
  const first = brick.at.map((n) => 32 * n - 2);
  const all = formula.boxOf(brick.level, first, [36, 36, 36]);
  const inside = (n: number): number => (isAlone ? Math.min(33, Math.max(2, n)) : Math.min(34, Math.max(1, n)));
  const expected = all.map((_, n) => {
    const [i, j, k] = [n % 36, Math.floor(n / 36) % 36, Math.floor(n / 36 ** 2)].map(inside);
    return all[i + 36 * (j + 36 * k)];
  });
  const wrong = samples.findIndex((value, n) => value !== expected[n]);
  if (samples.length !== expected.length || wrong >= 0)
    expect({ brick, wrong, got: samples[wrong], length: samples.length }).to.equal(expected[wrong]);
  let [smallest, largest] = [Infinity, -Infinity];
  for (const value of expected) {
    smallest = Math.min(smallest, value);
    largest = Math.max(largest, value);
  }
  expect([low, high]).to.deep.equal([smallest, largest]);
}

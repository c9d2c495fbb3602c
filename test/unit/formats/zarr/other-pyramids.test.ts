// Pyramids that ngff-zarr and ome-zarr-py made, with one bead in each channel at a known place: `make-pyramid-fixtures.py`.
import { expect } from '@esm-bundle/chai';
import { transformPoint } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { DecodedCartesianVolume } from '../../../../src/formats/base/decoded-volume.ts';
import { fetchFixture, roomyLimits } from '../../../helpers/decode.ts';
import { memoryTree, readStore } from '../../../helpers/zarr-tree.ts';

interface Pyramid {
  /** Of the bead of each channel: x, y and z, micrometres, by formula. */
  readonly places: readonly Vector3[];
  /** As zarr-python reads them. */
  readonly channels: readonly { readonly label: string; readonly color: string; readonly window: [number, number] }[];
  readonly files: Readonly<Record<string, string>>;
}

const { cases } = JSON.parse(new TextDecoder().decode(await fetchFixture('pyramid-fixtures.json'))) as {
  readonly cases: Readonly<Record<string, Pyramid>>;
};

const filesOf = ({ files }: Pyramid): ReadonlyMap<string, Uint8Array<ArrayBuffer>> =>
  new Map(Object.entries(files).map(([path, text]) => [path, Uint8Array.from(atob(text), (c) => c.charCodeAt(0))]));

/** Voxels of the three levels, two bytes each. */
const levels = [
  [36, 28, 24],
  [18, 14, 12],
  [9, 7, 6],
] as const;

/** The share of a level's own voxel by which a bead may be away from its place: half a voxel of the finest level is 0.125 of the coarsest one's. */
const allowed = 0.02;

/** The middle of what is bright, in the world. */
function middleOf({ samples, slope, intercept, grid }: DecodedCartesianVolume): Vector3 {
  const [nx, ny] = grid.dimensions;
  const sum = [0, 0, 0];
  let weight = 0;
  for (const [index, sample] of samples.entries()) {
    const value = slope * sample + intercept;
    weight += value;
    for (const [axis, place] of [index % nx, Math.floor(index / nx) % ny, Math.floor(index / nx / ny)].entries())
      sum[axis] += place * value;
  }
  return transformPoint(grid.indexToWorld, sum.map((part) => part / weight) as unknown as Vector3);
}

describe('a pyramid of another program', () => {
  for (const [name, pyramid] of Object.entries(cases)) {
    for (const [level, dimensions] of levels.entries())
      it(`${name}: level ${level} has its beads where they are`, async () => {
        const maxBytes = 2 * dimensions.reduce((product, n) => product * n, 1);
        for (const [index, [x, y, z]] of pyramid.places.entries()) {
          const tree = memoryTree(filesOf(pyramid), false, { channel: String(index + 1) });
          const volume = await readStore(tree, {}, { limits: { ...roomyLimits, maxBytes } });
          expect(volume.grid.dimensions).to.deep.equal(dimensions);
          // Without directions, x and y of the world count against those of the image.
          const place = [-x, -y, z].map((one) => one / 1000);
          for (const [axis, found] of middleOf(volume).entries())
            expect(Math.abs(found - place[axis]) / volume.grid.spacing[axis]).to.be.below(allowed, 'xyz'[axis]);
        }
      });

    it(`${name}: channels have the colours and windows of the file`, async () => {
      const { channels } = await readStore(filesOf(pyramid));
      const told = channels!.list.map(({ name: label, color, window }) => ({
        label,
        color: color
          .map((part) =>
            Math.round(255 * part)
              .toString(16)
              .padStart(2, '0')
              .toUpperCase(),
          )
          .join(''),
        window,
      }));
      expect(told).to.deep.equal(pyramid.channels);
    });
  }
});

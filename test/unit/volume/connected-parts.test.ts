import { expect } from '@esm-bundle/chai';
import { findSmallParts, keptShare } from '../../../src/volume/connected-parts.ts';
import type { SmallParts } from '../../../src/volume/connected-parts.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

type Box = readonly [low: Vector3, high: Vector3];

/** 1 in all boxes; bounds are included. */
function fillBoxes([nx, ny, nz]: Vector3, boxes: readonly Box[]): Uint8Array {
  const mask = new Uint8Array(nx * ny * nz);
  for (const [low, high] of boxes)
    for (let k = low[2]; k <= high[2]; k++)
      for (let j = low[1]; j <= high[1]; j++) mask.fill(1, low[0] + nx * (j + ny * k), high[0] + 1 + nx * (j + ny * k));
  return mask;
}

const find = (dimensions: Vector3, mask: Uint8Array, max?: number): SmallParts | null =>
  findSmallParts(dimensions, (voxel) => mask[voxel] === 1, max);

function hiddenIn(dimensions: Vector3, mask: Uint8Array): Uint8Array {
  const hidden = new Uint8Array(mask.length);
  find(dimensions, mask)!.visit((first, end) => hidden.fill(1, first, end));
  return hidden;
}

/** Sizes of all parts, by flooding, which shares no step with runs; and of which part each voxel is. */
function flood([nx, ny, nz]: Vector3, mask: Uint8Array): { sizes: number[]; partOf: Int32Array } {
  const partOf = new Int32Array(mask.length).fill(-1);
  const sizes: number[] = [];
  for (let seed = 0; seed < mask.length; seed++) {
    if (!mask[seed] || partOf[seed] >= 0) continue;
    const queue = [seed];
    partOf[seed] = sizes.push(0) - 1;
    for (let voxel = queue.pop(); voxel !== undefined; voxel = queue.pop()) {
      sizes[partOf[seed]]++;
      const [i, j, k] = [voxel % nx, Math.floor(voxel / nx) % ny, Math.floor(voxel / (nx * ny))];
      for (const [is, next] of [
        [i > 0, voxel - 1],
        [i < nx - 1, voxel + 1],
        [j > 0, voxel - nx],
        [j < ny - 1, voxel + nx],
        [k > 0, voxel - nx * ny],
        [k < nz - 1, voxel + nx * ny],
      ] as const) {
        if (!is || !mask[next] || partOf[next] >= 0) continue;
        partOf[next] = partOf[seed];
        queue.push(next);
      }
    }
  }
  return { sizes, partOf };
}

const dimensions: Vector3 = [20, 16, 12];
const body: Box = [
  [2, 2, 2],
  [11, 11, 9],
]; // 800 voxels

describe('parts that touch nothing larger', () => {
  it('are hidden, and the largest one is not', () => {
    const mask = fillBoxes(dimensions, [
      body,
      [
        [14, 0, 0],
        [14, 8, 7],
      ],
      [
        [18, 14, 10],
        [18, 14, 10],
      ],
    ]);
    const { parts, voxels } = find(dimensions, mask)!;
    expect([parts, voxels]).to.deep.equal([2, 73]);
    expect(hiddenIn(dimensions, mask)).to.deep.equal(
      fillBoxes(dimensions, [
        [
          [14, 0, 0],
          [14, 8, 7],
        ],
        [
          [18, 14, 10],
          [18, 14, 10],
        ],
      ]),
    );
  });

  it('are kept where a bridge of one voxel leads to them, and not where edges or corners alone touch', () => {
    const rest: Box = [
      [14, 2, 2],
      [15, 6, 4],
    ]; // 30 voxels
    expect(find(dimensions, fillBoxes(dimensions, [body, rest]))!.parts).to.equal(1);
    expect(
      find(
        dimensions,
        fillBoxes(dimensions, [
          body,
          rest,
          [
            [12, 4, 3],
            [13, 4, 3],
          ],
        ]),
      )!.parts,
    ).to.equal(0);
    expect(
      find(
        dimensions,
        fillBoxes(dimensions, [
          body,
          [
            [12, 12, 5],
            [12, 14, 5],
          ],
        ]),
      )!.parts,
      'an edge',
    ).to.equal(1);
    expect(
      find(
        dimensions,
        fillBoxes(dimensions, [
          body,
          [
            [12, 12, 10],
            [12, 12, 11],
          ],
        ]),
      )!.parts,
      'a corner',
    ).to.equal(1);
  });

  it('are kept from a tenth of the largest one on, as two legs are', () => {
    expect(keptShare).to.equal(0.1);
    expect(
      find(
        dimensions,
        fillBoxes(dimensions, [
          body,
          [
            [14, 2, 2],
            [14, 11, 9],
          ],
        ]),
      )!.parts,
      '80 of 800',
    ).to.equal(0);
    expect(
      find(
        dimensions,
        fillBoxes(dimensions, [
          body,
          [
            [14, 2, 2],
            [14, 11, 8],
          ],
          [
            [14, 2, 9],
            [14, 10, 9],
          ],
        ]),
      )!.parts,
      '79 of 800',
    ).to.equal(1);
  });

  it('are none where nothing counts, or all does', () => {
    expect(find([3, 4, 5], new Uint8Array(60))).to.include({ parts: 0, voxels: 0 });
    expect(find([3, 4, 5], new Uint8Array(60).fill(1))).to.include({ parts: 0, voxels: 0 });
    expect(find([1, 1, 1], new Uint8Array([1]))).to.include({ parts: 0, voxels: 0 });
  });

  it('are not looked for where there are more runs than memory is given for', () => {
    const mask = Uint8Array.from({ length: 60 }, (_, i) => i % 2);
    expect(find([6, 5, 2], mask, 29)).to.equal(null);
    expect(find([6, 5, 2], mask, 30)).to.not.equal(null);
  });

  it('are as many as SciPy finds in noise that just hangs together', () => {
    // scipy.ndimage.label of SciPy 1.17.1, which joins by faces too: 7,046 parts, the largest of 2,203 voxels.
    const random = randomNumbers(35);
    const mask = Uint8Array.from({ length: 64 * 48 * 40 }, () => Number(random() < 0.31));
    expect(find([64, 48, 40], mask)).to.include({ parts: 7031, voxels: 25961 });
  });

  it('are those that flooding finds, in noise of any density', () => {
    const random = randomNumbers(7);
    for (const size of [
      [9, 8, 7],
      [1, 12, 13],
      [12, 1, 13],
      [13, 12, 1],
      [64, 3, 3],
    ] as const) {
      for (const density of [0.1, 0.25, 0.31, 0.5, 0.8]) {
        const mask = Uint8Array.from({ length: size[0] * size[1] * size[2] }, () => Number(random() < density));
        const { sizes, partOf } = flood(size, mask);
        const max = Math.max(0, ...sizes);
        const expected = mask.map((is, voxel) => Number(is === 1 && sizes[partOf[voxel]] < keptShare * max));
        expect(hiddenIn(size, mask), `${size.join(' ')} ${density}`).to.deep.equal(expected);
        const small = sizes.filter((one) => one < keptShare * max);
        expect(find(size, mask)).to.include({ parts: small.length, voxels: small.reduce((sum, one) => sum + one, 0) });
      }
    }
  });
});

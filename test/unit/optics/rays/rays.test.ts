import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { intersectUnitCube, raysOfLattice, rayThrough, setUpRays } from '../../../../src/optics/rays/rays.ts';
import type { RaySetup } from '../../../../src/optics/rays/rays.ts';
import { cartesianGrid, longestDiagonal, unitToWorld } from '../../../../src/volume/grid.ts';
import { add, length, scale, subtract, transformPoint } from '../../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../../src/volume/matrix.ts';
import { obliqueAffine, randomNumbers } from '../../../helpers/synthetic.ts';

const perspective = projectionMatrix(0.7, 1.5, 0.01, 1000);
const offAxis: Matrix4 = perspective.map((x, i) => (i === 2 ? 0.3 : i === 6 ? -0.2 : x));
/** A parallel projection, shifted, over a picture `reach` wide. */
const parallel = (reach: number): Matrix4 => [
  1 / reach,
  0,
  0,
  0.1,
  0,
  1.5 / reach,
  0,
  -0.3,
  0,
  0,
  -1e-3,
  0,
  0,
  0,
  0,
  1,
];

interface Setup {
  readonly spacing?: Vector3;
  readonly offset?: Vector3;
  /** Distance from eye to centre in diagonals. */
  readonly distance?: number;
  readonly projection?: Matrix4 | 'parallel';
}

function setUp(
  seed: number,
  { spacing = [1, 2, 0.5], offset = [3, 2, 1], distance = 1.7, projection = perspective }: Setup,
) {
  const random = randomNumbers(seed);
  const grid = cartesianGrid([30, 20, 40], obliqueAffine(random, spacing, offset));
  const diagonal = longestDiagonal(grid);
  const center = transformPoint(unitToWorld(grid), [0.5, 0.5, 0.5]);
  const camera = orbitCamera(
    { theta: random() * 6, phi: 0.2 + random() * 2.7, radius: distance * diagonal },
    center,
    1,
  );
  const view = viewMatrix(camera);
  const matrix = projection === 'parallel' ? parallel(diagonal) : projection;
  return { grid, view, projection: matrix, camera, diagonal, rays: setUpRays(grid, view, matrix)! };
}

/** Where a point of a ray is in the picture, and its depth. */
function reproject(
  { grid, view, projection: p, rays }: ReturnType<typeof setUp>,
  [x, y]: number[],
  t: number,
): number[] {
  const ray = rayThrough(rays, x, y);
  const [ex, ey, ez] = transformPoint(view, transformPoint(unitToWorld(grid), add(ray.point, scale(ray.direction, t))));
  const w = p[14] * ez + p[15];
  return [(p[0] * ex + p[2] * ez + p[3]) / w, (p[5] * ey + p[6] * ez + p[7]) / w, -ez];
}

/** Largest error in the picture (device coordinates) and in depth (diagonals) over pixels and depths near the volume. */
function worstError(set: ReturnType<typeof setUp>): number {
  let worst = 0;
  for (const pixel of [
    [0, 0],
    [1, 1],
    [-1, 0.4],
    [0.37, -0.9],
  ]) {
    for (const t of [-0.4, 0, 0.3]) {
      const [x, y, depth] = reproject(set, pixel, t);
      const depthError = (depth - set.rays.planeDepth - t * set.rays.diameter) / set.diagonal;
      worst = Math.max(worst, Math.abs(x - pixel[0]), Math.abs(y - pixel[1]), Math.abs(depthError));
    }
  }
  return worst;
}

describe('rays', () => {
  // Rounding of float64 is 1e-16 of the largest number involved: the offset or the distance, in diagonals.
  const cases: [string, Setup, number][] = [
    ['perspective', {}, 1e-12],
    ['off axis', { projection: offAxis }, 1e-12],
    ['parallel', { projection: 'parallel' }, 1e-12],
    ['flipped', { spacing: [-1, 2, -3] }, 1e-12],
    ['tiny spacing', { spacing: [1e-9, 2e-9, 1e-9], offset: [0, 0, 0] }, 1e-12],
    ['huge spacing', { spacing: [1e9, 2e9, 1e9] }, 1e-12],
    ['an offset of 1e7', { offset: [1e7, -1e7, 1e7] }, 1e-7],
    ['an eye 1e6 diagonals away', { distance: 1e6 }, 1e-9],
    ['an eye inside', { distance: 0.1 }, 1e-12],
    ['an eye that stands at the centre', { distance: 1e-9 }, 1e-12],
  ];
  for (const [name, setup, tolerance] of cases) {
    it(`go through their pixels: ${name}`, () => {
      for (let seed = 1; seed <= 20; seed++) expect(worstError(setUp(seed, setup))).to.be.below(tolerance);
    });
  }

  it('begin at the eye', () => {
    for (const [seed, distance] of [
      [1, 2],
      [2, 0.2],
      [3, 1e-3],
      [4, 1e4],
    ]) {
      const { grid, camera, rays, diagonal } = setUp(seed, { distance });
      for (const [x, y] of [
        [0, 0],
        [1, -1],
        [0.2, 0.8],
      ]) {
        const ray = rayThrough(rays, x, y);
        const eye = transformPoint(unitToWorld(grid), add(ray.point, scale(ray.direction, rays.eyeT)));
        expect(length(subtract(eye, camera.eye)) / diagonal).to.be.below(1e-12 * Math.max(1, distance));
      }
    }
    expect(setUp(1, { projection: 'parallel' }).rays.eyeT).to.equal(-Infinity);
  });

  it('know how long a unit of t is in the world', () => {
    const { grid, rays } = setUp(5, {});
    for (const [x, y] of [
      [0, 0],
      [1, 1],
      [-0.5, 0.9],
    ]) {
      const ray = rayThrough(rays, x, y);
      const ends = [0, 1].map((t) => transformPoint(unitToWorld(grid), add(ray.point, scale(ray.direction, t))));
      expect((ray.lengthPerT * rays.diameter) / length(subtract(ends[1], ends[0]))).to.be.closeTo(1, 1e-12);
    }
    expect(rayThrough(rays, 0, 0).lengthPerT).to.be.closeTo(1, 1e-12);
  });

  it('keep their numbers of order one, so that float32 is enough', () => {
    const largest = ({ point, direction }: RaySetup): number =>
      Math.max(...[...point, ...direction].flat().map(Math.abs));
    // The narrow view of a far eye; the picture as wide as one diagonal at any unit.
    const narrow = projectionMatrix(1e-6, 1, 1, 1e9);
    expect(largest(setUp(6, { distance: 1e6, projection: narrow }).rays)).to.be.below(20);
    for (const unit of [1e-9, 1e9]) expect(largest(setUp(6, { spacing: [unit, unit, unit] }).rays)).to.be.below(20);
  });

  it('there are none through a flat volume', () => {
    const flat = cartesianGrid([4, 4, 4], [1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1]);
    expect(
      setUpRays(flat, viewMatrix(orbitCamera({ theta: 0, phi: 1, radius: 9 }, [0, 0, 0], 1)), perspective),
    ).to.equal(null);
  });
});

describe('the crossing of the unit cube', () => {
  it('is where a line enters and leaves', () => {
    const [entry, exit] = intersectUnitCube([-1, 0.5, 0.5], [2, 0.1, -0.1]);
    expect([entry, exit]).to.deep.equal([0.5, 1]);
    const diagonal = intersectUnitCube([0.5, 0.5, 0.5], [1, 1, 1]);
    expect(diagonal).to.deep.equal([-0.5, 0.5]);
  });

  it('holds for lines parallel to one and to two axes, to and fro', () => {
    for (const zero of [0, -0, 1e-12, -1e-12]) {
      const one = intersectUnitCube([0.3, -1, 0.2], [zero, 1, 0.5]);
      expect(one).to.deep.equal([1, 1.6]);
      expect(intersectUnitCube([0.3, 2, 0.7], [zero, -1, -zero])).to.deep.equal([1, 2]);
    }
  });

  it('misses at the sides, before and between', () => {
    for (const [point, direction] of [
      [
        [2, 0, 0],
        [0, 1, 0],
      ],
      [
        [-0.001, 0.5, 0.5],
        [0, 0, 1],
      ],
      [
        [1.001, 0.5, 0.5],
        [0, -1, 0],
      ],
      [
        [-1, 0.5, 0],
        [1, 1, 0],
      ],
    ] as [Vector3, Vector3][]) {
      const [entry, exit] = intersectUnitCube(point, direction);
      expect(entry, `${point.join(' ')} along ${direction.join(' ')}`).to.be.above(exit);
    }
  });

  it('of a line that grazes an edge is a point, and next to it short', () => {
    const [entry, exit] = intersectUnitCube([-1, 1, 0.5], [1, 1, 0]);
    expect(exit - entry).to.be.at.most(0);
    const [shortEntry, shortExit] = intersectUnitCube([-1, -1e-6, 0.5], [1, 1, 0]);
    expect(shortExit - shortEntry).to.be.closeTo(1e-6, 1e-12);
    const [cornerEntry, cornerExit] = intersectUnitCube([-1e-3, 2e-3, 0.5], [1, -1, 0]);
    expect(cornerExit - cornerEntry).to.be.closeTo(1e-3, 1e-12);
  });

  it('of every so many pixels are those of the whole picture', () => {
    const { rays } = setUp(4, {});
    const picture = { width: 101, height: 67 };
    for (const lattice of [
      { stride: 4, first: [0, 0], width: 26, height: 17 },
      { stride: 9, first: [4, 2], width: 11, height: 7 },
      { stride: 1, first: [0, 0], ...picture },
    ] as const) {
      const own = raysOfLattice(rays, picture, lattice);
      for (const [i, j] of [
        [0, 0],
        [lattice.width - 1, 0],
        [3, 5],
        [lattice.width - 1, lattice.height - 1],
      ]) {
        const middle = (index: number, pixels: number): number => (2 * index + 1) / pixels - 1;
        const found = rayThrough(own, middle(i, lattice.width), middle(j, lattice.height));
        const [x, y] = [i, j].map((index, axis) => lattice.first[axis] + index * lattice.stride);
        const expected = rayThrough(rays, middle(x, picture.width), middle(y, picture.height));
        for (const axis of [0, 1, 2]) {
          expect(found.point[axis]).to.be.closeTo(expected.point[axis], 1e-12);
          expect(found.direction[axis]).to.be.closeTo(expected.direction[axis], 1e-12);
        }
      }
    }
  });

  for (const [name, setup] of [
    ['perspective', {}],
    ['parallel', { projection: 'parallel' }],
    ['near', { distance: 0.9 }],
    ['far', { distance: 300 }],
  ] as const) {
    it(`none outside of the bounds meets the volume, and the bounds are tight: ${name}`, () => {
      for (let seed = 1; seed < 6; seed++) {
        const { rays } = setUp(seed, setup);
        const [left, bottom, right, top] = rays.bounds;
        const met: number[][] = [];
        const size = Math.max(right - left, top - bottom);
        for (let i = 0; i < 100; i++) {
          for (let j = 0; j < 100; j++) {
            const [x, y] = [left + ((i / 99) * 1.4 - 0.2) * size, bottom + ((j / 99) * 1.4 - 0.2) * size];
            const ray = rayThrough(rays, x, y);
            const [entry, exit] = intersectUnitCube(ray.point, ray.direction);
            if (Math.max(entry, rays.eyeT) < exit && Math.abs(x) <= 1 && Math.abs(y) <= 1) met.push([x, y]);
          }
        }
        const [xs, ys] = [0, 1].map((axis) => met.map((place) => place[axis]));
        expect(Math.min(...xs)).to.be.within(left, left + 0.06 * size);
        expect(Math.max(...xs)).to.be.within(right - 0.06 * size, right);
        expect(Math.min(...ys)).to.be.within(bottom, bottom + 0.06 * size);
        expect(Math.max(...ys)).to.be.within(top - 0.06 * size, top);
      }
    });
  }

  it('have no bounds if the eye is in the volume', () => {
    expect(setUp(3, { distance: 0.1 }).rays.bounds).to.deep.equal([-1, -1, 1, 1]);
  });
});

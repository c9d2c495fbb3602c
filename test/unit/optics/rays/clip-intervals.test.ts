// What is cut away, in float64.
import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { castRay } from '../../../../src/optics/rays/cast-ray.ts';
import { clipInterval, cutoutInterval } from '../../../../src/optics/rays/clip-intervals.ts';
import { projectionGather } from '../../../../src/optics/rays/projection.ts';
import type { ProjectionKind } from '../../../../src/optics/rays/ray-style.ts';
import { storedField } from '../../../../src/optics/rays/ray-field.ts';
import type { IntervalStage } from '../../../../src/optics/rays/ray-stages.ts';
import { setUpRays } from '../../../../src/optics/rays/rays.ts';
import { stagesOf } from '../../../../src/optics/reference.ts';
import type { ReferenceScene } from '../../../../src/optics/reference.ts';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { longestDiagonal } from '../../../../src/volume/grid.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { cutRegion } from '../../../../src/volume/region.ts';
import { cutBox, keep, keepBox } from '../../../helpers/clips.ts';
import { castPixels } from '../../../helpers/pixel-rays.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

type Field = (x: number, y: number, z: number) => number;

const volume = syntheticVolume({ dimensions: [20, 18, 16], kind: 'float32' });
const { grid } = volume;
const diagonal = longestDiagonal(grid);
const camera = orbitCamera({ theta: 0.4, phi: 1.2, radius: 2 * diagonal }, [0, 0, 0], 0.5);
const rays = setUpRays(grid, viewMatrix(camera), projectionMatrix(0.5, 4 / 3, 1, 1e3))!;

/** Values that run straight, and one colour: segments of any length are exact. */
const ramp: Field = (x, y, z) => 0.2 + 0.5 * x - 0.1 * y + 0.3 * z;
const oneColor: TransferFunction = [
  { value: 0, color: [1, 0.5, 0.2], opacity: 0.01 },
  { value: 1, color: [1, 0.5, 0.2], opacity: 0.2 },
];

interface Look {
  readonly steps: number;
  readonly ends?: readonly IntervalStage[];
  /** The samples of the volume where absent. */
  readonly field?: Field | null;
  readonly colors?: TransferFunction;
  readonly projection?: ProjectionKind;
  readonly opacityFactor?: number;
  readonly setup?: typeof rays;
}

/** Channels of a small picture. */
function draw({
  steps,
  ends = [],
  field = ramp,
  colors = oneColor,
  projection,
  opacityFactor = 1,
  setup = rays,
}: Look): number[] {
  const scene: ReferenceScene = {
    ...volume,
    transferFunction: colors,
    referenceLength: 1,
    opacityFactor,
    lightFactor: 1,
    stepLength: diagonal / steps,
    ends,
    ...(field && { field: storedField(([x, y, z]) => field(x, y, z), { slope: 1, intercept: 0 }) }),
    ...(projection && { gather: projectionGather(projection) }),
  };
  const stages = stagesOf(scene, setup);
  return castPixels(setup, [16, 12], (ray) => castRay(stages, ray));
}

const worst = (a: readonly number[], b: readonly number[]): number => Math.max(...a.map((x, i) => Math.abs(x - b[i])));
/** One picture before another. */
const over = (front: readonly number[], back: readonly number[]): number[] =>
  front.map((x, i) => x + (1 - front[i - (i % 4) + 3]) * back[i]);
const channel = (picture: readonly number[], one: number): number[] => picture.filter((_, i) => i % 4 === one);

/** Roughly towards the eye: what is kept lies before what is not. */
const [, , , , , , , , ex, ey, ez] = viewMatrix(camera);
const toEye: Vector3 = [ex + 0.2, ey, ez - 0.3];
const front = clipInterval([keep(grid, toEye, 1.3)]);
const back = clipInterval([keep(grid, toEye.map((x) => -x) as unknown as Vector3, -1.3)]);
const [low, high]: [Vector3, Vector3] = [
  [-3, -12, -2],
  [6, 2, 30],
];

describe('a volume that is cut by a plane', () => {
  it('is, before what was cut off, the whole: to rounding at any step, where a segment is exact', () => {
    for (const steps of [2.2, 7.3, 60]) {
      const [whole, near, far] = [[], [front], [back]].map((ends) => draw({ steps, ends }));
      expect(worst(over(near, far), whole), `${steps} steps`).to.be.below(1e-13);
      expect(worst(near, whole)).to.be.above(0.05);
      expect(worst(far, whole)).to.be.above(0.05);
    }
  });

  it('is, of any field, the whole within the errors that their steps leave, and these vanish', () => {
    const colors: TransferFunction = [
      { value: 0.1, color: [0, 0, 0.4], opacity: 0 },
      { value: 0.5, color: [0.9, 0.3, 0.1], opacity: 0.1 },
      { value: 0.9, color: [1, 1, 0.8], opacity: 0.4 },
    ];
    const draws = (steps: number): number[][] =>
      [[], [front], [back]].map((ends) => draw({ steps, ends, field: null, colors }));
    const limit = draws(1000);
    for (const steps of [20, 60, 180]) {
      const [whole, near, far] = draws(steps);
      const errors = [whole, near, far]
        .map((picture, i) => worst(picture, limit[i]))
        .reduce((sum, error) => sum + error);
      expect(worst(over(near, far), whole), `${steps} steps`).to.be.at.most(errors);
      expect(errors).to.be.below(3 / steps);
    }
  });

  it('is, in six planes, its region', () => {
    const region = cutRegion(grid, [...low, ...high])!;
    const setup = setUpRays(grid, viewMatrix(camera), projectionMatrix(0.5, 4 / 3, 1, 1e3), region)!;
    expect(
      worst(draw({ steps: 40, ends: [clipInterval(keepBox(grid, low, high))] }), draw({ steps: 40, setup })),
    ).to.be.below(1e-12);
  });

  it('shows nothing where all is cut away', () => {
    expect(
      Math.max(...draw({ steps: 40, ends: [clipInterval([keep(grid, [1, 0, 0], 3), keep(grid, [-1, 0, 0], -2)])] })),
    ).to.equal(0);
  });
});

describe('a volume that a box is cut out of', () => {
  const cutout = cutoutInterval(cutBox(grid, low, high));

  it('and the box let together as much light through as the whole, at any step', () => {
    for (const steps of [2.2, 7.3, 60]) {
      const [whole, rest, box] = [[], [cutout], [clipInterval(keepBox(grid, low, high))]].map((ends) =>
        channel(draw({ steps, ends }), 3),
      );
      expect(
        worst(
          rest.map((alpha, i) => 1 - (1 - alpha) * (1 - box[i])),
          whole,
        ),
        `${steps} steps`,
      ).to.be.below(1e-13);
      expect(worst(rest, whole)).to.be.above(0.1);
    }
  });

  it('has two pieces of rays, before the box and behind it: both count for the largest value, the smallest and the mean', () => {
    // A bump that is all inside of the box: nothing of it may be found, however near to its sides a ray is refined.
    const bump: Field = (x, y, z) => Math.exp(-6 * ((x - 0.55) ** 2 + (y - 0.7) ** 2 + (z - 0.5) ** 2));
    const gray: TransferFunction = [
      { value: 0, color: [0, 0, 0], opacity: 1 },
      { value: 2, color: [1, 1, 1], opacity: 1 },
    ];
    const appearance = { field: bump, colors: gray } as const;
    const hole = cutoutInterval(cutBox(grid, [-6, -8, -5], [4, 1, 5]));
    const outside = Math.max(
      ...[-6, 4].map((x) => bump(0.5 - x / 20, 0.7, 0.5)),
      ...[-8, 1].map((y) => bump(0.55, 0.5 - y / 18, 0.5)),
      ...[-5, 5].map((z) => bump(0.55, 0.7, 0.5 + z / 16)),
    );
    for (const steps of [6, 30]) {
      const [max, inAll] = [[hole], []].map(
        (ends) => 2 * Math.max(...channel(draw({ ...appearance, steps, ends, projection: 'max' }), 0)),
      );
      expect(max, `${steps} steps`).to.be.within(outside - 0.1, outside + 1e-9);
      expect(inAll).to.be.above(outside + 0.1);
    }
    // The mean of a field that runs straight is that of both pieces, by their lengths.
    const along: Field = (x) => x;
    const means = draw({ field: along, colors: gray, steps: 5, ends: [cutout], projection: 'average' });
    expect(
      worst(means, draw({ field: along, colors: gray, steps: 377, ends: [cutout], projection: 'average' })),
    ).to.be.below(1e-12);
    expect(worst(means, draw({ field: along, colors: gray, steps: 5, projection: 'average' }))).to.be.above(0.01);
  });

  it('shows the values of its faces, and no blend', () => {
    const rainbow: TransferFunction = [
      { value: 0, color: [0, 0, 1], opacity: 0.9 },
      { value: 1, color: [1, 1, 0], opacity: 0.9 },
    ];
    // A plane at right angles to x, opaque from there on: red is the value.
    const at = 2;
    const value = (10 - at) / 20; // The volume's x runs against the world's.
    const looks = [
      [clipInterval([keep(grid, [-1, 0, 0], -at)])],
      [cutoutInterval(cutBox(grid, [at, -50, -50], [50, 50, 50]))],
    ];
    const sideways = orbitCamera({ theta: -Math.PI / 2, phi: Math.PI / 2, radius: 2 * diagonal }, [0, 0, 0], 0.2);
    const setup = setUpRays(grid, viewMatrix(sideways), projectionMatrix(0.2, 4 / 3, 1, 1e3))!;
    for (const ends of looks) {
      const appearance = { field: (x) => x, colors: rainbow, ends, setup } satisfies Partial<Look>;
      // The smallest value of a ray is that of the face, to the last bit but rounding, at any step; what is opaque shows the mean of its first substep.
      for (const [seen, slack] of [
        [draw({ ...appearance, steps: 3, projection: 'min' }), 1e-12],
        ...[10, 300].map(
          (steps) => [draw({ ...appearance, steps, opacityFactor: 1e6 }), diagonal / steps / 16 / 20] as const,
        ),
      ] as const) {
        const lit = seen.filter((_, i) => i % 4 === 0 && seen[i + 3] > 0.899);
        expect(lit.length).to.be.above(30);
        for (const red of lit) expect(red).to.be.closeTo(value, slack);
      }
    }
  });
});

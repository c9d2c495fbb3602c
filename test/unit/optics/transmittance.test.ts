// How much light of a place reaches the eye, against 1 - exp(-tau) in closed form.
import { expect } from '@esm-bundle/chai';
import { clipInterval, cutoutInterval } from '../../../src/optics/rays/clip-intervals.ts';
import { planeInterval } from '../../../src/optics/attachments/plane-slices.ts';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import type { FieldStage, IntervalStage } from '../../../src/optics/rays/ray-stages.ts';
import { setUpRays } from '../../../src/optics/rays/rays.ts';
import type { RaySetup } from '../../../src/optics/rays/rays.ts';
import { pointField } from '../../../src/optics/rays/lit.ts';
import { surfaceGather } from '../../../src/optics/surfaces/surfaces.ts';
import { stagesOf } from '../../../src/optics/reference.ts';
import { labelStages } from '../../../src/optics/attachments/labels.ts';
import { rayToPlace, transmittanceTo } from '../../../src/optics/transmittance.ts';
import type { Stop } from '../../../src/optics/transfer/transfer-function.ts';
import { boundingSphere, cartesianGrid, unitToWorld } from '../../../src/volume/grid.ts';
import { add, invertAffine, scale, transformPoint } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

/** The error that is allowed. */
const tolerance = 0.002;

/** A box of 100 along each side, from 0 to 100. */
const grid = cartesianGrid([100, 100, 100], [1, 0, 0, 0.5, 0, 1, 0, 0.5, 0, 0, 1, 0.5, 0, 0, 0, 1]);
const toUnit = invertAffine(unitToWorld(grid))!;
const straightDown = [1, 0, 0, -50, 0, 1, 0, -50, 0, 0, 1, -200, 0, 0, 0, 1];
const parallel = [0.01, 0, 0, 0, 0, 0.01, 0, 0, 0, 0, -0.001, 0, 0, 0, 0, 1];
const fromAbove = setUpRays(grid, straightDown, parallel)!;
const slanted = orbitCamera({ theta: 0.5, phi: 1.1, radius: 260 }, boundingSphere(grid).center, 0.6);
const inPerspective = setUpRays(grid, viewMatrix(slanted), projectionMatrix(0.6, 1.25, 1, 1000))!;

const color = [1, 1, 1] as const;
const opacity = 0.02;
/** Extinction per world unit of the value 1. */
const extinction = -Math.log(1 - opacity);
/** The opacity grows with the value, from 0 to 1. */
const stops: Stop[] = [
  { value: 0, color, opacity: 0 },
  { value: 1, color, opacity },
];
/** All values are equally opaque. */
const fog: Stop[] = [
  { value: 0, color, opacity },
  { value: 1, color, opacity },
];

const field = (valueAt: (place: Vector3) => number): FieldStage => ({
  sampleAt: (place) => ({ value: valueAt(place), valid: true }),
  isFolded: () => false,
});

function see(
  at: Vector3,
  {
    setup = fromAbove,
    transferFunction = fog,
    valueAt = () => 1,
    ends = [],
    more = {},
  }: {
    setup?: RaySetup;
    transferFunction?: readonly Stop[];
    valueAt?: (place: Vector3) => number;
    ends?: IntervalStage[];
    more?: object;
  } = {},
): number {
  const stages = stagesOf(
    {
      grid,
      samples: new Uint8Array(0),
      slope: 1,
      intercept: 0,
      transferFunction,
      referenceLength: 1,
      opacityFactor: 1,
      lightFactor: 1,
      stepLength: 1,
      field: field(valueAt),
      ends,
      ...more,
    },
    setup,
  );
  const to = rayToPlace(setup, transformPoint(toUnit, at))!;
  return transmittanceTo(stages, to.ray, to.t);
}

describe('the ray to a place', () => {
  for (const [name, setup] of [
    ['in parallel', fromAbove],
    ['in perspective', inPerspective],
  ] as const)
    it(`meets the place, ${name}`, () => {
      const random = randomNumbers(3);
      for (let n = 0; n < 40; n++) {
        const place: Vector3 = [random(), random(), random()];
        const { ray, t } = rayToPlace(setup, place)!;
        const met = add(ray.point, scale(ray.direction, t));
        expect(Math.max(...met.map((x, i) => Math.abs(x - place[i])))).to.be.below(1e-12);
      }
    });

  it('does not go behind the eye', () => {
    const behind = add(slanted.eye, scale(slanted.target, -0.5));
    const away = add(behind, scale(slanted.eye, 0.5));
    expect(rayToPlace(inPerspective, transformPoint(toUnit, away))).to.equal(null);
  });
});

describe('transmittance', () => {
  it('of a slab is exp(-tau) of the way from its face', () => {
    for (const depth of [0, 0.4, 3, 10.3, 25, 60, 99.9])
      expect(see([50, 50, 100 - depth])).to.be.closeTo(Math.exp(-extinction * depth), tolerance);
  });

  it('of a wedge is exp of minus the integral of its extinction', () => {
    // The opacity of a stop, and with it the value, is linear in depth: tau is the integral of -ln(1 - opacity x).
    for (const depth of [5, 20, 47.3, 80, 100]) {
      let tau = 0;
      for (let i = 0; i < 1e4; i++) tau -= (Math.log(1 - (opacity * (i + 0.5) * depth) / 1e6) * depth) / 1e4;
      const seen = see([50, 50, 100 - depth], { transferFunction: stops, valueAt: ([, , z]) => 1 - z });
      expect(seen).to.be.closeTo(Math.exp(-tau), tolerance);
    }
  });

  it('of slanted rays in perspective counts the way from where the ray enters', () => {
    const random = randomNumbers(8);
    for (let n = 0; n < 30; n++) {
      const at: Vector3 = [100 * random(), 100 * random(), 100 * random()];
      const [to, from] = [at, slanted.eye];
      // Where the line from the eye enters the box.
      const enter = Math.max(
        ...[0, 1, 2].map((axis) => {
          const way = to[axis] - from[axis];
          return way === 0 ? -Infinity : Math.min((0 - from[axis]) / way, (100 - from[axis]) / way);
        }),
      );
      const inside = (1 - enter) * Math.hypot(...to.map((x, i) => x - from[i]));
      expect(see(at, { setup: inPerspective })).to.be.closeTo(Math.exp(-extinction * inside), tolerance);
    }
  });

  it('is 1 in front of the volume, and that of all of it behind', () => {
    expect(see([50, 50, 130])).to.equal(1);
    expect(see([50, 50, -40])).to.be.closeTo(Math.exp(-extinction * 100), tolerance);
    expect(see([500, 50, 50])).to.equal(1);
  });

  it('counts nothing that a clip cuts away', () => {
    const ends = [clipInterval([{ kind: 'half-space', normal: [0, 0, -1], offset: -0.7 }])];
    expect(see([50, 50, 85], { ends })).to.equal(1);
    expect(see([50, 50, 70], { ends })).to.be.closeTo(1, 1e-9);
    expect(see([50, 50, 40], { ends })).to.be.closeTo(Math.exp(-extinction * 30), tolerance);
  });

  it('counts a cutout in front of the place as empty', () => {
    // Between 40 and 70 of the height nothing is left.
    const box = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 / 0.3, -0.4 / 0.3, 0, 0, 0, 1];
    const ends = [cutoutInterval({ kind: 'cutout', unitToBox: box })];
    expect(see([50, 50, 85], { ends })).to.be.closeTo(Math.exp(-extinction * 15), tolerance);
    expect(see([50, 50, 50], { ends })).to.be.closeTo(Math.exp(-extinction * 30), tolerance);
    expect(see([50, 50, 20], { ends })).to.be.closeTo(Math.exp(-extinction * 50), tolerance);
  });

  it('is 0 behind a slice; a place on the slice, or in front of it, is not hidden by it', () => {
    const plane = { kind: 'plane', normal: [0, 0, 1], offset: 0.6, slab: null, window: [0, 1] } as const;
    const ends = [
      planeInterval(
        [plane],
        field(() => 1),
        fog,
      ),
    ];
    const through = (z: number): number => see([50, 50, z], { ends });
    expect(through(50)).to.equal(0);
    expect(through(60)).to.be.closeTo(Math.exp(-extinction * 40), tolerance);
    expect(through(61)).to.be.closeTo(Math.exp(-extinction * 39), tolerance);
  });

  it('counts an iso-surface in front of the place with its opacity, and none behind it', () => {
    const surfaces = [{ value: 0.3, color: [1, 0, 0], opacity: 0.6 }] as const;
    const more = {
      moreFields: [pointField],
      gather: surfaceGather({ surfaces, isClear: true, light: null, toEye: () => [0, 0, 1], refinements: 40 }),
    };
    const through = (z: number): number => see([50, 50, z], { more, valueAt: ([, , at]) => 1 - at });
    expect(through(75)).to.be.closeTo(1, 1e-9);
    expect(through(65)).to.be.closeTo(0.4, tolerance);
  });

  it('counts labels with the opacity that they have', () => {
    // The upper half has label 1, which is hidden, the lower one label 2.
    const numbers = Uint8Array.from({ length: 8 }, (_, i) => (i >= 4 ? 1 : 2));
    const white = [1, 1, 1] as const;
    const styles = [0, 0, 1].map((opacityFactor) => ({ color: white, opacityFactor }));
    const labels = labelStages({ map: { dimensions: [2, 2, 2], numbers, ids: [0, 1, 2] }, styles }, false);
    expect(see([50, 50, 60], { more: labels })).to.equal(1);
    expect(see([50, 50, 20], { more: labels })).to.be.closeTo(Math.exp(-extinction * 30), tolerance);
  });
});

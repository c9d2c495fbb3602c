// Where a ray is picked, against closed forms.
import { expect } from '@esm-bundle/chai';
import { castRay } from '../../../src/optics/rays/cast-ray.ts';
import { clipInterval, cutoutInterval } from '../../../src/optics/rays/clip-intervals.ts';
import { findJump } from '../../../src/optics/pick-jump.ts';
import { planeInterval } from '../../../src/optics/attachments/plane-slices.ts';
import { pickRay } from '../../../src/optics/pick-ray.ts';
import { surfaceGather } from '../../../src/optics/surfaces/surfaces.ts';
import type { PickAt } from '../../../src/optics/pick-ray.ts';
import { pointField } from '../../../src/optics/rays/lit.ts';
import { projectionGather } from '../../../src/optics/rays/projection.ts';
import type { FieldStage } from '../../../src/optics/rays/ray-stages.ts';
import { shapeInterval } from '../../../src/optics/rays/ray-intervals.ts';
import { rayThrough, setUpRays } from '../../../src/optics/rays/rays.ts';
import { stagesOf } from '../../../src/optics/reference.ts';
import { transmittanceTo } from '../../../src/optics/transmittance.ts';
import type { ReferenceScene } from '../../../src/optics/reference.ts';
import type { Stop } from '../../../src/optics/transfer/transfer-function.ts';
import { cartesianGrid } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

/** A box of 100 along each side, looked at from above: z runs from 1 at the eye's side to 0. */
const grid = cartesianGrid([100, 100, 100], [1, 0, 0, 0.5, 0, 1, 0, 0.5, 0, 0, 1, 0.5, 0, 0, 0, 1]);
const straightDown = [1, 0, 0, -50, 0, 1, 0, -50, 0, 0, 1, -200, 0, 0, 0, 1];
const parallel = [0.01, 0, 0, 0, 0, 0.01, 0, 0, 0, 0, -0.001, 0, 0, 0, 0, 1];
const rays = setUpRays(grid, straightDown, parallel)!;

/** Values by the depth below the top of the box, 0..100. */
const byDepth = (valueAt: (depth: number) => number): FieldStage => ({
  sampleAt: ([, , z]: Vector3) => {
    const value = valueAt(100 * (1 - z));
    return { value, valid: !Number.isNaN(value) };
  },
  isFolded: () => false,
});

const color = [1, 1, 1] as const;
/** 0 is clear, 1 and 2 are as opaque as is said, with jumps between. */
const labels = (one: number, two: number): Stop[] => [
  { value: 0.5, color, opacity: 0 },
  { value: 0.5, color, opacity: one },
  { value: 1.5, color, opacity: one },
  { value: 1.5, color, opacity: two },
  { value: 3, color, opacity: two },
];

function stages(field: FieldStage, transferFunction: readonly Stop[], more: Partial<ReferenceScene> = {}) {
  return stagesOf(
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
      field,
      ...more,
    },
    rays,
  );
}

/** Depth of the place that is picked; null for none. */
function pick(
  scene: ReturnType<typeof stages>,
  at: PickAt,
  transferFunction: readonly Stop[],
  projection: 'max' | 'min' | 'average' | null = null,
): number | null {
  const found = pickRay(scene, rayThrough(rays, 0, 0), { at, look: { transferFunction, projection } });
  return found && 100 * (1 - found.place[2]);
}

/** Two shells of one step's length, of the values 1 and 2. */
const shells = byDepth((depth) => (depth >= 30 && depth < 33 ? 1 : depth >= 60 && depth < 63 ? 2 : 0));
const firstShell = byDepth((depth) => (depth >= 30 && depth < 33 ? 1 : 0));
const secondShell = byDepth((depth) => (depth >= 60 && depth < 63 ? 2 : 0));

describe('a pick', () => {
  it('goes from the first of two shells to the second just where (1 - a1) a2 = a1', () => {
    const ray = rayThrough(rays, 0, 0);
    for (const one of [0.05, 0.1, 0.15]) {
      const alpha = (field: FieldStage, two: number): number => castRay(stages(field, labels(one, two)), ray)[3];
      const a1 = alpha(firstShell, 0);
      // The opacity of the second one at which both jump as high, by bisection of the picture's own opacities.
      let [low, high] = [0, 0.9];
      for (let i = 0; i < 60; i++) {
        const middle = (low + high) / 2;
        if ((1 - a1) * alpha(secondShell, middle) > a1) high = middle;
        else low = middle;
      }
      expect((1 - a1) * alpha(secondShell, low)).to.be.closeTo(a1, 1e-12);
      const below = labels(one, low - 1e-9);
      const above = labels(one, high + 1e-9);
      expect(pick(stages(shells, below), 'jump', below), `below, ${one}`).to.be.within(30, 33);
      expect(pick(stages(shells, above), 'jump', above), `above, ${one}`).to.be.within(60, 63);
    }
  });

  it('is where half of the jump is reached, at any step', () => {
    // Of a uniform fog, L deep, half of its opacity is gathered at a depth of -log((1 + e^-L t) / 2) / t.
    const fog = byDepth(() => 1);
    for (const opacity of [0.01, 0.1, 0.5]) {
      const appearance = labels(opacity, 0);
      const t = -Math.log(1 - opacity);
      const half = -Math.log((1 + Math.exp(-100 * t)) / 2) / t;
      for (const stepLength of [0.3, 1, 2])
        expect(
          pick(stages(fog, appearance, { stepLength }), 'jump', appearance),
          `${opacity}, ${stepLength}`,
        ).to.be.closeTo(half, 1e-4 * half);
    }
  });

  it('at the surface is where the opacity passes a half, and nowhere if it never does', () => {
    const fog = byDepth(() => 1);
    for (const opacity of [0.01, 0.1, 0.5]) {
      const appearance = labels(opacity, 0);
      const depth = Math.log(0.5) / Math.log(1 - opacity);
      expect(pick(stages(fog, appearance), 'surface', appearance), `${opacity}`).to.be.closeTo(depth, 1e-4 * depth);
    }
    const thin = labels(0.004, 0); // 33 % in all.
    expect(pick(stages(fog, thin), 'surface', thin)).to.equal(null);
    expect(pick(stages(fog, thin), 'jump', thin)).to.be.above(20);
  });

  it('at the half is where half of the final opacity is reached, through a slab and a wedge, and half of the light is left', () => {
    const ray = rayThrough(rays, 0, 0);
    const toEye = (scene: ReturnType<typeof stages>, depth: number): number =>
      transmittanceTo(scene, ray, (1 - depth / 100 - ray.point[2]) / ray.direction[2]);
    // A slab from 20 to 60: T(d) = exp(-t (d - 20)), so half of A = 1 - exp(-40 t) is reached where T = 1 - A / 2.
    const slab = byDepth((depth) => (depth >= 20 && depth < 60 ? 1 : 0));
    for (const opacity of [0.005, 0.05, 0.3]) {
      const appearance = labels(opacity, 0);
      const t = -Math.log(1 - opacity);
      const half = 20 - Math.log((1 + Math.exp(-40 * t)) / 2) / t;
      for (const stepLength of [0.25, 1]) {
        const scene = stages(slab, appearance, { stepLength });
        expect(pick(scene, 'half', appearance), `slab of ${opacity}, ${stepLength}`).to.be.closeTo(half, stepLength);
      }
    }
    // A wedge: the opacity of a step of 1 grows as 0.04 depth / 100, by tau(d), the integral of -ln(1 - 0.0004 x).
    const wedge = byDepth((depth) => depth / 100);
    const ramp: Stop[] = [
      { value: 0, color, opacity: 0 },
      { value: 1, color, opacity: 0.04 },
    ];
    const tau = (depth: number): number => {
      const left = 1 - 0.0004 * depth;
      return (left * Math.log(left) - left + 1) / 0.0004;
    };
    const wanted = 1 - (1 - Math.exp(-tau(100))) / 2;
    let [low, high] = [0, 100];
    for (let i = 0; i < 60; i++) {
      const middle = (low + high) / 2;
      if (Math.exp(-tau(middle)) > wanted) low = middle;
      else high = middle;
    }
    for (const stepLength of [0.3, 1, 3]) {
      const scene = stages(wedge, ramp, { stepLength });
      const depth = pick(scene, 'half', ramp)!;
      expect(depth, `wedge, ${stepLength}`).to.be.closeTo(low, 0.02);
      expect(toEye(scene, depth), `light of the wedge, ${stepLength}`).to.be.closeTo(wanted, 0.002);
    }
  });

  it('at the half counts what ends the ray, and is where a projection shows its value', () => {
    const fog = byDepth(() => 1);
    const appearance = labels(0.01, 0);
    const behind = (alpha: number) =>
      stages(fog, appearance, { ends: [(_, interval) => ({ ...interval, exit: 0, behind: [1, 1, 1, alpha] })] });
    // 50 of fog hide 1 - 0.99^50 = 0.395: less than half of an opaque end, more than half with one of 0.1.
    expect(pick(behind(1), 'half', appearance)).to.be.closeTo(50, 1e-9);
    const all = 1 - 0.99 ** 50 * 0.9;
    expect(pick(behind(0.1), 'half', appearance)).to.be.closeTo(Math.log(1 - all / 2) / Math.log(0.99), 1e-3);
    const peak = byDepth((depth) => 0.5 + 0.3 * Math.exp(-(((depth - 70.37) / 8) ** 2)));
    const scene = stages(peak, appearance, { gather: projectionGather('max') });
    expect(pick(scene, 'half', appearance, 'max')).to.be.closeTo(70.37, 0.01);
    const clear = labels(0, 0);
    expect(pick(stages(shells, clear), 'half', clear)).to.equal(null);
  });

  it('at the maximum is at the largest value that shows and is not hidden', () => {
    // Peaks at 25 and 75, the second one higher; above 0.9 nothing shows.
    const peaks = byDepth((depth) => Math.max(0.6 - Math.abs(depth - 25.3) / 20, 0.8 - Math.abs(depth - 75.2) / 20, 0));
    const ramp: Stop[] = [
      { value: 0.1, color, opacity: 0 },
      { value: 1, color, opacity: 0.05 },
    ];
    expect(pick(stages(peaks, ramp), 'max', ramp)).to.be.closeTo(75.2, 1e-6);
    const band: Stop[] = [
      { value: 0.1, color, opacity: 0 },
      { value: 0.3, color, opacity: 0.05 },
      { value: 0.62, color, opacity: 0.05 },
      { value: 0.62, color, opacity: 0 },
    ];
    const at = pick(stages(peaks, band), 'max', band)!;
    expect(Math.abs(at - 75.2), 'where the second peak reaches 0.62').to.be.closeTo(3.6, 0.5);
    const dense: Stop[] = [
      { value: 0.1, color, opacity: 0 },
      { value: 0.5, color, opacity: 0.9 },
      { value: 1, color, opacity: 0.9 },
    ];
    expect(pick(stages(peaks, dense), 'max', dense)).to.be.below(26);
  });

  it('with a projection is where the value is that is shown', () => {
    const wave = byDepth(
      (depth) => 0.5 + 0.3 * Math.exp(-(((depth - 70.37) / 8) ** 2)) - 0.2 * Math.exp(-(((depth - 20.81) / 8) ** 2)),
    );
    const ramp: Stop[] = [
      { value: 0, color, opacity: 0 },
      { value: 1, color, opacity: 0.5 },
    ];
    const of = (kind: 'max' | 'min' | 'average'): number | null =>
      pick(stages(wave, ramp, { gather: projectionGather(kind) }), 'jump', ramp, kind);
    expect(of('max')).to.be.closeTo(70.37, 0.01);
    expect(of('min')).to.be.closeTo(20.81, 0.01);
    expect(of('average')).to.be.closeTo(70.37, 0.01);
  });

  it('shows what the picture shows, and is null where that is nothing', () => {
    const appearance = labels(0.2, 0.4);
    const scene = stages(shells, appearance);
    const ray = rayThrough(rays, 0, 0);
    expect(
      pickRay(scene, ray, { at: 'jump', look: { transferFunction: appearance, projection: null } })!.color,
    ).to.deep.equal(castRay(scene, ray));
    const clear = labels(0, 0);
    for (const at of ['jump', 'surface', 'max'] as const) {
      expect(pick(stages(shells, clear), at, clear), at).to.equal(null);
      expect(
        pickRay(scene, rayThrough(rays, 3, 0), { at, look: { transferFunction: appearance, projection: null } }),
        `${at}, beside the volume`,
      ).to.equal(null);
      expect(
        pickRay(scene, rayThrough(rays, NaN, 0), { at, look: { transferFunction: appearance, projection: null } }),
        `${at}, no place`,
      ).to.equal(null);
    }
  });

  it('stops where something ends the ray, and finds what stands there', () => {
    const appearance = labels(0.05, 0.9);
    const shape = shapeInterval(() => 0); // In the middle of the box, before the second shell.
    expect(pick(stages(shells, appearance), 'jump', appearance)).to.be.within(60, 63);
    expect(pick(stages(shells, appearance, { ends: [shape] }), 'jump', appearance)).to.be.within(30, 33);
    // A painted surface is as opaque as what it hides.
    const painted = (alpha: number) =>
      stages(shells, appearance, { ends: [(_, interval) => ({ ...interval, exit: 0, behind: [1, 1, 1, alpha] })] });
    expect(pick(painted(1), 'jump', appearance)).to.be.closeTo(50, 1e-9);
    expect(pick(painted(1), 'surface', appearance)).to.be.closeTo(50, 1e-9);
    expect(pick(painted(0.01), 'jump', appearance)).to.be.within(30, 33);
  });

  it('finds a slice that lies on a cut face, from both sides of it', () => {
    const fog = byDepth(() => 1);
    const appearance = labels(0.001, 0);
    const at = 0.613;
    const slice = planeInterval(
      [{ kind: 'plane', slab: null, window: [0, 2], normal: [0, 0, 1], offset: at }],
      fog,
      appearance,
    );
    for (const side of [1, -1]) {
      const ends = [clipInterval([{ kind: 'half-space', normal: [0, 0, side], offset: side * at }]), slice];
      for (const kind of [null, 'max'] as const)
        expect(
          pick(
            stages(fog, appearance, { ends, ...(kind && { gather: projectionGather(kind) }) }),
            'jump',
            appearance,
            kind,
          ),
          `${side} ${kind}`,
        ).to.be.closeTo(side < 0 || !kind ? 38.7 : 0, 1e-3);
    }
  });

  it('finds the largest value behind a gap where steps are longer than what is left', () => {
    const rising = byDepth((depth) => depth);
    const ramp: Stop[] = [
      { value: 0, color, opacity: 0 },
      { value: 100, color, opacity: 0.5 },
    ];
    const random = randomNumbers(3);
    for (let i = 0; i < 100; i++) {
      const [to, thick] = [0.9 * random(), 0.05 * random()];
      const ends = [
        cutoutInterval({
          kind: 'cutout',
          unitToBox: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 / thick, -to / thick, 0, 0, 0, 1],
        }),
        clipInterval([{ kind: 'half-space', normal: [0, 0, 1], offset: to * random() }]),
      ];
      expect(
        pick(stages(rising, ramp, { ends, stepLength: 300, gather: projectionGather('max') }), 'jump', ramp, 'max'),
      ).to.be.above(0);
    }
  });
});

describe('the highest of some rises', () => {
  const rise = (heights: readonly number[], spans: readonly number[] = []) =>
    findJump(heights.map((height, i) => ({ begin: i, span: spans[i] ?? 1, height })));

  it('goes from valley to valley', () => {
    expect(rise([0, 0.1, 0.2, 0.1, 0, 0.3, 0])).to.deep.equal({ first: 0, last: 4, height: 0.1 + 0.2 + 0.1 });
    expect(rise([0, 0.1, 0.2, 0.1, 0, 0.5, 0])!.height).to.equal(0.5);
    expect(rise([0, 0, 0])).to.equal(null);
    expect(rise([])).to.equal(null);
  });

  it('is not parted by what noise does, nor by where steps are cut into substeps', () => {
    expect(rise([0.1, 0.07, 0.1, 0.06, 0.1])!.height).to.be.closeTo(0.43, 1e-12);
    expect(rise([0.1, 0.02, 0.02, 0.02, 0.02, 0.02, 0.1], [1, 0.2, 0.2, 0.2, 0.2, 0.2, 1])!.height).to.be.closeTo(
      0.3,
      1e-12,
    );
  });

  it('is the one in front where two are as high', () => {
    expect(rise([0.2, 0, 0.2])!.first).to.equal(0);
  });
});

describe('a pick of surfaces', () => {
  const white = (value: number, opacity: number) => ({ value, color, opacity });
  const fog: Stop[] = [
    { value: -1, color, opacity: 0 },
    { value: 1, color, opacity: 0 },
    { value: 1, color, opacity: 0.02 },
    { value: 9, color, opacity: 0.02 },
  ];
  const bent = byDepth((depth) => (depth / 50) ** 3);
  const found = (surfaces: ReturnType<typeof white>[], at: PickAt, { isClear = true, transferFunction = fog } = {}) => {
    const scene = stages(bent, transferFunction, {
      stepLength: 3,
      moreFields: [pointField],
      gather: surfaceGather({ surfaces, isClear, light: null, toEye: () => [0, 0, 1], refinements: 40 }),
    });
    const one = pickRay(scene, rayThrough(rays, 0, 0), { at, look: { transferFunction, projection: null, isClear } });
    return one && { surface: one.surface, depth: 100 * (1 - one.place[2]) };
  };
  /** Depth at which there is a value. */
  const depthOf = (value: number): number => 50 * value ** (1 / 3);

  it('is where the surface is, to rounding, and has its value', () => {
    for (const at of ['jump', 'surface', 'max'] as const) {
      const { surface, depth } = found([white(0.5, 1), white(2, 1)], at)!;
      expect(surface, at).to.equal(0.5);
      expect(depth, at).to.be.closeTo(depthOf(0.5), 1e-9);
    }
  });

  it('takes the one that hides most, passes the half at the one that does, and sees the highest that is not hidden', () => {
    const surfaces = [white(0.5, 0.3), white(1.5, 0.6), white(3, 0.2), white(5, 0.5)];
    expect(found(surfaces, 'jump')!.surface).to.equal(1.5);
    expect(found(surfaces, 'surface')!.surface).to.equal(1.5);
    expect(found(surfaces, 'max')!.surface).to.equal(5);
    expect(found([white(20, 1)], 'jump'), 'a value that there is nowhere').to.equal(null);
  });

  it('in fog is a thing of its own, which hides less than the fog or more', () => {
    // What is behind value 1, from a depth of 50 on, hides 1 - 0.98 ** 50 = 0.64.
    expect(found([white(0.5, 0.2)], 'jump', { isClear: false })!.surface).to.equal(undefined);
    const { surface, depth } = found([white(0.5, 0.5)], 'jump', { isClear: false })!;
    expect(surface).to.equal(0.5);
    expect(depth).to.be.closeTo(depthOf(0.5), 1e-9);
    expect(found([white(2, 0.9)], 'jump', { isClear: false })!.surface, 'within the fog').to.equal(2);
  });
});

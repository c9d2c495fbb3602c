// Transfer functions of value and gradient against quadrature, and against what a linear field comes to.
import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { orbitCamera, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { castRay } from '../../../../src/optics/rays/cast-ray.ts';
import { contributionOf } from '../../../../src/optics/cells/empty-space-distance.ts';
import { parsePatches } from '../../../../src/optics/transfer/parse-patches.ts';
import {
  erf,
  gaussianReach,
  meanOfPatch,
  meanOverWay,
  outlinePatches,
  spanOfPatch,
} from '../../../../src/optics/transfer/patches.ts';
import type { Patch, ValueAndGradient } from '../../../../src/optics/transfer/patches.ts';
import { storedField } from '../../../../src/optics/rays/ray-field.ts';
import { rayThrough, setUpRays } from '../../../../src/optics/rays/rays.ts';
import { pointField } from '../../../../src/optics/rays/lit.ts';
import { patchClassify } from '../../../../src/optics/rays/patch-classify.ts';
import type { ClassifyStage } from '../../../../src/optics/rays/ray-stages.ts';
import { stagesOf } from '../../../../src/optics/reference.ts';
import { evaluate } from '../../../../src/optics/transfer/transfer-function.ts';
import { isUsual } from '../../../../src/optics/transfer/usual-columns.ts';
import { cartesianSlopes } from '../../../../src/optics/shading-twins.ts';
import { resolveAppearance } from '../../../../src/viewer/appearance/resolve-appearance.ts';
import { plainAppearance } from '../../../../src/viewer/model/plain-appearance.ts';
import { styleOf } from '../../../../src/viewer/model/volume-info.ts';
import { plainOptics } from '../../../helpers/picture.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const box: Patch = { kind: 'box', values: [40, 120], gradients: [5, 30], color: [1, 0.5, 0], opacity: 0.6 };
const bell: Patch = { kind: 'gaussian', value: 100, gradient: 20, widths: [15, 4], color: [0, 0.5, 1], opacity: 0.3 };
const both = [box, bell];

/** By its definition, at one place. */
function patchAt(patch: Patch, [value, gradient]: ValueAndGradient): number {
  if (patch.kind === 'box')
    return Number(
      value >= patch.values[0] &&
        value <= patch.values[1] &&
        gradient >= patch.gradients[0] &&
        gradient <= patch.gradients[1],
    );
  const r2 = ((value - patch.value) / patch.widths[0]) ** 2 + ((gradient - patch.gradient) / patch.widths[1]) ** 2;
  const end = Math.exp(-(gaussianReach ** 2) / 2);
  return Math.max(0, (Math.exp(-r2 / 2) - end) / (1 - end));
}

function quadrature(patch: Patch, from: ValueAndGradient, to: ValueAndGradient, count = 20_000): number {
  let sum = 0;
  for (let i = 0; i < count; i++) {
    const t = (i + 0.5) / count;
    sum += patchAt(patch, [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])]);
  }
  return sum / count;
}

const ways: readonly (readonly [ValueAndGradient, ValueAndGradient])[] = [
  [
    [20, 2],
    [140, 33],
  ],
  [
    [140, 33],
    [20, 2],
  ],
  [
    [60, 10],
    [100, 25],
  ],
  [
    [100, 20],
    [100, 20],
  ],
  [
    [100, 20],
    [101, 20.2],
  ],
  [
    [98, 0],
    [98, 40],
  ],
  [
    [0, 20],
    [300, 20],
  ],
  [
    [200, 1],
    [20, 12],
  ],
  [
    [90, 31],
    [120, 40],
  ],
  [
    [70, 20],
    [70, 20],
  ],
  [
    [55, 10],
    [58, 11.9],
  ],
  [
    [-900, 0],
    [900, 400],
  ],
];

describe('patches of value and gradient', () => {
  it('are their integrals along straight ways, by quadrature', () => {
    for (const [from, to] of ways) {
      expect(meanOfPatch(box, from, to), `box ${from.join()} to ${to.join()}`).to.be.closeTo(
        quadrature(box, from, to),
        1e-4,
      );
      expect(meanOfPatch(bell, from, to), `gaussian ${from.join()} to ${to.join()}`).to.be.closeTo(
        quadrature(bell, from, to),
        1e-5,
      );
    }
    expect(erf(0.5)).to.be.closeTo(0.5204998778130465, 1e-15); // Python 3.11, math.erf; so is the next
    expect(erf(-2.1)).to.be.closeTo(-0.9970205333436671, 1e-14);
  });

  it('add their extinctions, in their colours', () => {
    const [red, green, blue, density] = meanOverWay(both, [100, 20], [100, 20]);
    const [a, b] = [-Math.log(0.4), -Math.log(0.7)];
    expect(density).to.be.closeTo(a + b, 1e-12);
    expect(red).to.be.closeTo(a, 1e-12);
    expect(green).to.be.closeTo(0.5 * (a + b), 1e-12);
    expect(blue).to.be.closeTo(b, 1e-12);
    expect(meanOverWay([{ ...box, opacity: 1 }], [50, 10], [50, 10])[3]).to.equal(2000);
  });

  it('show by value alone no less than at any gradient, in a function that is no trouble to the table', () => {
    const outline = outlinePatches([...both, { ...bell, value: 400, widths: [1, 1] }]);
    expect(isUsual(outline)).to.equal(true);
    for (let value = 20; value < 410; value += 0.7) {
      const shown = Math.max(
        ...[6, 12, 20, 24, 29].map((gradient) => meanOverWay(both, [value, gradient], [value, gradient])[3]),
      );
      expect(-Math.log1p(-evaluate(outline, value)[3]) + 1e-9, `at ${value}`).to.be.at.least(Math.min(shown, 3));
    }
    const shows = contributionOf(outline);
    expect([shows(-50, 30), shows(180, 390), shows(410, 900)], 'nothing outside and in between').to.deep.equal([
      false,
      false,
      false,
    ]);
    expect([shows(30, 41), shows(399, 400)]).to.deep.equal([true, true]);
    expect(spanOfPatch(bell)).to.deep.equal([55, 145]);
    outlinePatches([{ ...box, opacity: 0 }]).forEach(({ color }) => expect(color).to.deep.equal([1, 0.5, 0]));
  });

  it('end with the data, and go on where they reach beyond them: "and more" is no wider scale', () => {
    const outline = outlinePatches([{ ...box, values: [40, 99_999] }, bell], [-20, 100]);
    expect(outline[0].value).to.be.within(38, 40);
    expect(outline[100].value).to.be.within(100, 101);
    expect(evaluate(outline, 500)[3], 'another scan has more').to.be.closeTo(1 - 0.4 * 0.7, 1e-3);
    expect(evaluate(outline, 30)[3]).to.equal(0);
    expect(isUsual(outline)).to.equal(true);
    for (const range of [
      [900, 1000],
      [50, 50],
    ] as const)
      expect(outlinePatches(both, range), 'no values of theirs').to.deep.equal(outlinePatches(both));
  });

  it('on a linear field are exact at any step: one gradient, and values that run straight', () => {
    const volume = syntheticVolume({
      dimensions: [20, 20, 20],
      kind: 'float32',
      field: (x, y, z) => 20 * (4 * x + 2 * y + 5 * z),
    });
    const camera = orbitCamera({ theta: 0.7, phi: 1, radius: 60 }, [0, 0, 0], 0.3);
    const setup = setUpRays(volume.grid, viewMatrix(camera), [
      2 / 8,
      0,
      0,
      0,
      0,
      2 / 8,
      0,
      0,
      0,
      0,
      -0.001,
      0,
      0,
      0,
      0,
      1,
    ])!;
    const steep = Math.hypot(4, 2, 5);
    const patches: Patch[] = [
      { kind: 'box', values: [60, 150], gradients: [steep - 1, steep + 1], color: [1, 1, 1], opacity: 0.05 },
      { kind: 'gaussian', value: 120, gradient: steep, widths: [10, 2], color: [1, 1, 1], opacity: 0.2 },
    ];
    // Known everywhere, so that gradients at the bounds are those inside.
    const field = storedField(([x, y, z]) => 20 * (4 * x + 2 * y + 5 * z), { slope: 1, intercept: 0 });
    const optics = { ...plainOptics, referenceLength: 2.5, opacityFactor: 1.3 };
    const slopes = cartesianSlopes(volume);
    const scene = {
      ...slopes,
      field: slopes,
      patches,
      grid: volume.grid,
      opticalScale: (setup.diameter / optics.referenceLength) * optics.opacityFactor,
    };
    const staged = { moreFields: [pointField], classifyBy: (usual: ClassifyStage) => patchClassify(usual, scene) };
    const ray = rayThrough(setup, 0.03, -0.02);
    const depths = [0.4, 1.1, 3].map((stepLength) => {
      const scene = { ...volume, ...optics, field, transferFunction: outlinePatches(patches), stepLength, ...staged };
      return -Math.log1p(-castRay(stagesOf(scene, setup), ray)[3]);
    });
    const slope = 20 * (4 * ray.direction[0] + 2 * ray.direction[1] + 5 * ray.direction[2]);
    const perValue = (ray.lengthPerT * setup.diameter * 1.3) / 2.5 / Math.abs(slope);
    const bellArea = (10 * (Math.sqrt(2 * Math.PI) * erf(3 / Math.SQRT2) - 6 * Math.exp(-4.5))) / (1 - Math.exp(-4.5));
    const expected = perValue * (-Math.log(0.95) * 90 - Math.log(0.8) * bellArea);
    depths.forEach((depth) => expect(depth).to.be.closeTo(expected, 2e-4 * expected));
  });

  it('are read as an author writes them: percentages of the window, and of it along a reference length', () => {
    const units = { window: [-100, 300] as const, steepest: 200 };
    expect(
      parsePatches('box 40 120 5 30 #f80 60%, Gaussian 50% 10% 5% 2% rgb(255 255 255 / 50%) 0.8', units),
    ).to.deep.equal([
      { kind: 'box', values: [40, 120], gradients: [5, 30], color: [1, 136 / 255, 0], opacity: 0.6 },
      { kind: 'gaussian', value: 100, gradient: 20, widths: [20, 4], color: [1, 1, 1], opacity: 0.4 },
    ]);
    expect(parsePatches(' ', units)).to.deep.equal([]);
  });

  for (const [text, words] of [
    [
      'circle 1 2 3',
      'part 1, "circle 1 2 3", got "circle"; expected a box, like "box 40 120 5 30 orange 60%", or a Gaussian',
    ],
    ['box 1 2 3 4 red 1,', 'part 2, "", got nothing'],
    [
      'box 1 2',
      'got 2 parts after "box"; expected the lowest and the highest value, the lowest and the highest gradient, a colour and an opacity',
    ],
    ['gaussian', 'got 0 parts after "gaussian"; expected a value, a gradient'],
    ['box 2 1 3 4 red 1', 'got values from 2 to 1; expected the lower one first'],
    ['box 1 2 4 4 red 1', 'got gradients from 4 to 4; expected the lower one first'],
    ['box 1 2 -4 4 red 1', 'got the gradient -4; expected 0 or more'],
    ['gaussian 1 -2 3 4 red 1', 'got the gradient -2; expected 0 or more'],
    ['gaussian 1 2 3 0 red 1', 'got the width 0; expected more than 0'],
    ['gaussian 1 2 wide 1 red 1', 'got the width "wide"; expected a number or a percentage'],
    ['box 1 2 3 4 read 1', 'got the colour "read"'],
    ['box 1 2 3 4 red 2', 'got the opacity "2"; expected 0 to 1'],
    ['box 1 2 3 4 red 1,'.repeat(9), 'got 10 boxes and Gaussians; expected at most 8'],
    [`box ${'1'.repeat(300)}`, 'of 300 characters; expected at most 200'],
    ['9'.repeat(20_000), 'got 20,000 characters; expected at most 12,800'],
  ]) {
    it(`refuse "${text.slice(0, 40)}" in words`, () => {
      expect(() => parsePatches(text, { window: [0, 1], steepest: 1 }))
        .to.throw(VolumeViewError, words)
        .with.property('code', 'transfer-function/syntax');
    });
  }

  it('stand in for the transfer function, but not in projections; with surfaces there is fog then', async () => {
    const volume = syntheticVolume({ dimensions: [8, 8, 8], kind: 'float32' });
    const appearance = {
      ...plainAppearance,
      window: [0, 100] as const,
      referenceLength: 2,
      transferFunction2d: 'box 10% 20% 0 10% red 1',
    };
    const optics = await resolveAppearance(appearance, volume);
    expect(optics.patches).to.deep.equal([
      { kind: 'box', values: [10, 20], gradients: [0, 5], color: [1, 0, 0], opacity: 1 },
    ]);
    expect(optics.transferFunction).to.deep.equal(outlinePatches(optics.patches!));
    const constant = await resolveAppearance(
      { ...appearance, window: null },
      { ...volume, window: undefined, range: [7, 7] },
    );
    expect(constant.patches, 'percentages of no window').to.deep.equal([
      { ...optics.patches![0], values: [6.6, 6.7], gradients: [0, 0.05] },
    ]);
    expect(styleOf(optics)).to.deep.equal({ lit: undefined, styles: undefined, patches: optics.patches });
    expect(await resolveAppearance({ ...appearance, projection: 'max' }, volume)).to.not.have.property('patches');
    expect(
      (await resolveAppearance({ ...appearance, surfaces: '50 red', shading: 'unlit' }, volume)).surfaces,
    ).to.deep.equal({ surfaces: [{ value: 50, color: [1, 0, 0], opacity: 1 }], plain: true });
  });
});

// What coarse bricks hide, said before they are loaded, against pictures of the float64 reference with and without them.
import { expect } from '@esm-bundle/chai';
import { chooseBricks, describeBrick } from '../../../src/bricks/choose-bricks.ts';
import { estimateDetail } from '../../../src/bricks/estimate-detail.ts';
import type { DetailEstimate } from '../../../src/bricks/estimate-detail.ts';
import { buildPyramid, countBricks, listBricks } from '../../../src/bricks/pyramid.ts';
import { detailField, residentField } from '../../../src/bricks/resident-field.ts';
import { hiddenByTable } from '../../../src/bricks/hidden-values.ts';
import type { HiddenValues } from '../../../src/bricks/hidden-values.ts';
import { measureResiduals } from '../../../src/bricks/residuals.ts';
import { sumSpans } from '../../../src/bricks/span-sums.ts';
import * as steepCode from '../../../src/optics/shading-twins.ts';
import { cartesianGradient, flatChange } from '../../../src/optics/rays/gradient.ts';
import { litShade, pointField } from '../../../src/optics/rays/lit.ts';
import { plainMaterial } from '../../../src/optics/transfer/lights.ts';
import { patchClassify } from '../../../src/optics/rays/patch-classify.ts';
import { styledShade } from '../../../src/optics/rays/styled.ts';
import { domainOf } from '../../../src/optics/transfer/emission.ts';
import { outlinePatches } from '../../../src/optics/transfer/patches.ts';
import type { Patch } from '../../../src/optics/transfer/patches.ts';
import type { VolumeStyle } from '../../../src/optics/transfer/volume-styles.ts';
import { isSteep, steepOf } from '../../../src/viewer/loading/brick-steep.ts';
import type { VolumeOptics } from '../../../src/viewer/model/volume-info.ts';
import { projectionGather } from '../../../src/optics/rays/projection.ts';
import { planeInterval } from '../../../src/optics/attachments/plane-slices.ts';
import type { PlaneSlice } from '../../../src/optics/attachments/plane-slices.ts';
import { framingDistance, orbitCamera, projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import type { RaySetup } from '../../../src/optics/rays/rays.ts';
import { setUpRays } from '../../../src/optics/rays/rays.ts';
import { renderReference } from '../../../src/optics/reference.ts';
import { parseTransferFunction } from '../../../src/optics/transfer/parse-transfer-function.ts';
import { evaluate, largestOpacity } from '../../../src/optics/transfer/transfer-function.ts';
import type { Premultiplied, TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { axialIndexToWorld, boundingSphere, cartesianGrid } from '../../../src/volume/grid.ts';
import { transformPoint } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { longestEdgeShare } from '../../../src/volume/reference-length.ts';
import { compareCovered } from '../../helpers/covered-error.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

const edge = 64;
const side = 16;
const grid = cartesianGrid([edge, edge, edge], axialIndexToWorld([edge, edge, edge], [1, 1, 1]));
const { center, radius } = boundingSphere(grid);
const camera = orbitCamera({ theta: 0.4, phi: 1.3, radius: framingDistance(radius, 0.6, 1) }, center, 0.6);
const whole = setUpRays(grid, viewMatrix(camera), projectionMatrix(0.6, 1, 1, 2))!;

/** Of a plane in grey. */
const painted = ([black, white]: readonly [number, number]): TransferFunction => [
  { value: black, color: [0, 0, 0], opacity: 1 },
  { value: white, color: [1, 1, 1], opacity: 1 },
];

const plane = (normal: Vector3, offset: number, window: PlaneSlice['window'] = [40, 220]): PlaneSlice => ({
  kind: 'plane',
  normal,
  offset,
  window,
  slab: null,
});

/** Of what a table says of voxels, so much is left between them, where rays sample: of noise (2/3)^(3/2) at most, of short waves less, of what is smooth all. */
const ofNoise = 0.5;
const betweenVoxels = (table: HiddenValues, left: number): HiddenValues => ({
  ...table,
  rms: (block, level) => left * table.rms(block, level),
});

/** A scene of whole numbers, with what is known beside it, and its true error at a level. */
function sceneOf(
  value: (i: number, j: number, k: number) => number,
  look: string,
  {
    rays = whole,
    planes = [],
    isLit = false,
    projection,
    threshold,
    styles,
    patches,
    left = ofNoise,
  }: {
    readonly rays?: RaySetup;
    readonly planes?: readonly PlaneSlice[];
    readonly isLit?: boolean;
    readonly projection?: 'max' | 'min';
    /** The first extreme from this value on. */
    readonly threshold?: number;
    readonly styles?: readonly VolumeStyle[];
    readonly patches?: readonly Patch[];
    readonly left?: number;
  } = {},
) {
  const samples = new Uint8Array(edge ** 3);
  let at = 0;
  for (let k = 0; k < edge; k++)
    for (let j = 0; j < edge; j++) for (let i = 0; i < edge; i++) samples[at++] = value(i, j, k);
  const pyramid = buildPyramid({ dimensions: [edge, edge, edge], samples }, side);
  const count = countBricks(pyramid, 0).reduce((a, b) => a * b);
  const table = measureResiduals(pyramid, side / 2);
  const transferFunction = patches ? outlinePatches(patches, [0, 255]) : parseTransferFunction(look, [0, 255]);
  const chains = styles && [{ weight: 1, styles }];
  const referenceLength = longestEdgeShare(grid);
  const scaling = { slope: 1, intercept: 0 };
  const optics: VolumeOptics = {
    transferFunction,
    window: [0, 255],
    referenceLength,
    opacityFactor: 1,
    lightFactor: 1,
    projection: projection ?? null,
    shading: isLit ? 'lit' : 'unlit',
    surfaces: null,
    styles: chains,
    patches,
  };
  const scale = { ...scaling, stepRatio: 1 / referenceLength };
  const estimate = (levelOf: Uint8Array): DetailEstimate =>
    estimateDetail(
      {
        field: detailField(pyramid, levelOf),
        rays,
        sums: sumSpans(transferFunction, [0, 255], scale),
        step: 1 / rays.diameter,
        hidden: betweenVoxels(hiddenByTable(table, grid.dimensions), left),
        across: 32,
        extreme: projection && {
          sign: projection === 'max' ? 1 : -1,
          threshold: threshold && (projection === 'max' ? threshold : -threshold),
          colorOf: (value) =>
            evaluate(transferFunction, value).map((x) => x / largestOpacity(transferFunction)) as Premultiplied,
        },
        steep: isSteep(optics)
          ? steepOf(steepCode, optics, { volume: { range: [0, 255] }, finest: grid, stored: [0, 255] }, scale)
          : undefined,
        light: isLit ? { diffuse: plainMaterial.diffuse, voxel: [1 / edge, 1 / edge, 1 / edge] } : undefined,
        planes: planes.map(({ normal, offset, window }) => ({
          normal,
          offset,
          sums: sumSpans(window ? painted(window) : transferFunction, [0, 255], { ...scaling, stepRatio: 1e6 }),
        })),
      },
      count,
    );
  const draw = (levelOf: Uint8Array): Float64Array => {
    const field = residentField(pyramid, levelOf, scaling);
    const gradient = cartesianGradient(field, grid);
    const lit = { grid, gradient, flat: flatChange(domainOf(transferFunction), [0, 255]) };
    const opticalScale = rays.diameter / referenceLength;
    return renderReference(
      {
        grid,
        samples,
        ...scaling,
        transferFunction,
        referenceLength,
        opacityFactor: 1,
        lightFactor: 1,
        stepLength: 1,
        field,
        moreFields: isLit || styles || patches ? [pointField] : [],
        shades: [
          ...(isLit ? [litShade(lit)] : []),
          ...(chains ? [styledShade({ ...lit, chains, referenceLength, opticalScale })] : []),
        ],
        classifyBy: patches && ((usual) => patchClassify(usual, { patches, grid, gradient, field, opticalScale })),
        gather: projection && projectionGather(projection, threshold),
        ends: [planeInterval(planes, field, transferFunction)],
      },
      rays,
      28,
      28,
    );
  };
  const atLevel = (level: number): Uint8Array => new Uint8Array(count).fill(level);
  const errorOf = (levelOf: Uint8Array): number => compareCovered(draw(levelOf), draw(atLevel(0)), 255).rms;
  /** The coarsest level with the bricks that the estimate asks for, until it says that all is there. */
  const loadAsked = (): Uint8Array => {
    const levelOf = atLevel(2);
    for (let turn = 0; turn < 4; turn++) {
      const { gains } = estimate(levelOf);
      for (let cell = 0; cell < levelOf.length; cell++) if (gains[cell * pyramid.levels.length] > 0) levelOf[cell] = 0;
    }
    return levelOf;
  };
  return { pyramid, estimate, errorOf, atLevel, loadAsked };
}

const random = randomNumbers(5);
const noise = Uint8Array.from({ length: edge ** 3 }, () => 255 * random());
const ball = (i: number, j: number, k: number): number => Math.hypot(i - 31.5, j - 31.5, k - 31.5) - 22;

describe('What coarse bricks hide in a picture', () => {
  const grain = (i: number, j: number, k: number): number => noise[i + edge * (j + edge * k)];
  const cases: Record<string, [(i: number, j: number, k: number) => number, string]> = {
    'noise in fog': [(i, j, k) => noise[i + edge * (j + edge * k)], '0 #247 0, 255 #fd8 12%'],
    'noise with a threshold': [
      (i, j, k) => noise[i + edge * (j + edge * k)],
      '0 #fd8 0, 180 #fd8 0, 220 #fd8 20%, 255 #fd8 20%',
    ],
    'an opaque ball': [
      (i, j, k) => 120 - 60 * Math.tanh(ball(i, j, k) / 2),
      '0 #247 0, 100 #247 2%, 130 #fd8 90%, 255 #fd8 100%',
    ],
    'a rough ball': [
      (i, j, k) =>
        Math.min(255, Math.max(0, 120 - 20 * ball(i, j, k) + 0.5 * (noise[i + edge * (j + edge * k)] - 127))),
      '0 #247 0, 60 #247 1%, 255 #fd8 40%',
    ],
  };
  for (const [name, [value, look]] of Object.entries(cases))
    it(`is estimated within a factor of three: ${name}`, () => {
      const { estimate, errorOf, atLevel } = sceneOf(value, look, { left: name === 'an opaque ball' ? 1 : ofNoise });
      for (const level of [1, 2]) {
        const said = estimate(atLevel(level)).rms;
        const true_ = errorOf(atLevel(level));
        expect(true_).to.be.above(0.5);
        expect(said / true_).to.be.within(1 / 3, 3, `level ${level}: ${said} was said, ${true_} is true`);
      }
    });

  const inLight: Record<string, [(i: number, j: number, k: number) => number, string]> = {
    'an opaque ball with noise': [
      (i, j, k) => Math.min(255, Math.max(0, 120 - 20 * ball(i, j, k) + 0.5 * (grain(i, j, k) - 127))),
      '0 #fd8 0, 100 #fd8 0, 110 #fd8 100%, 255 #fd8 100%',
    ],
    'an opaque ball with bumps': [
      (i, j, k) =>
        120 - 60 * Math.tanh(ball(i, j, k) / 6 + 0.15 * Math.sin(2 * i) * Math.sin(1.7 * j) * Math.sin(1.9 * k)),
      '0 #fd8 0, 100 #fd8 0, 110 #fd8 100%, 255 #fd8 100%',
    ],
    'noise in fog': [grain, '0 #247 0, 255 #fd8 12%'],
  };
  for (const [name, [value, look]] of Object.entries(inLight))
    it(`is estimated within a factor of three in light: ${name}`, () => {
      // From near: no ray passes a rim, where most would be missing without light too.
      const rays = setUpRays(grid, viewMatrix(camera), projectionMatrix(0.12, 1, 1, 2))!;
      const { estimate, errorOf, atLevel } = sceneOf(value, look, { isLit: true, rays });
      const unlit = sceneOf(value, look, { rays });
      expect(unlit.estimate(atLevel(1)).rms, 'without light there is nothing to see').to.be.below(1);
      for (const level of [1, 2]) {
        const said = estimate(atLevel(level)).rms;
        const true_ = errorOf(atLevel(level));
        expect(said / true_).to.be.within(1 / 3, 3, `level ${level}: ${said} was said, ${true_} is true`);
      }
    });

  const steep: Record<
    string,
    [Parameters<typeof sceneOf>[0], string, { readonly styles?: VolumeStyle[]; readonly patches?: Patch[] }]
  > = {
    'what is opaque where values change': [
      grain,
      '0 #247 0, 255 #fd8 25%',
      {
        styles: [
          {
            kind: 'gradient',
            stops: [
              [20, 0],
              [60, 1],
            ],
          },
        ],
      },
    ],
    'what is opaque where values do not change': [
      grain,
      '0 #247 0, 255 #fd8 25%',
      {
        styles: [
          {
            kind: 'gradient',
            stops: [
              [20, 1],
              [60, 0],
            ],
          },
        ],
      },
    ],
    'a silhouette': [
      (i, j, k) => Math.min(255, Math.max(0, 120 - 20 * ball(i, j, k) + 0.5 * (grain(i, j, k) - 127))),
      '0 #fd8 0, 80 #fd8 0, 160 #fd8 30%, 255 #fd8 30%',
      { styles: [{ kind: 'silhouette', retained: 0.02, boundary: 1, sharpness: 2 }] },
    ],
    'a cartoon': [
      (i, j, k) => Math.min(255, Math.max(0, 120 - 20 * ball(i, j, k) + 0.3 * (grain(i, j, k) - 127))),
      '0 #fd8 0, 100 #fd8 0, 110 #fd8 100%, 255 #fd8 100%',
      { styles: [{ kind: 'cartoon', parallel: [1, 0.9, 0.5], orthogonal: [0.2, 0, 0.5], steps: 4 }] },
    ],
    edges: [
      (i, j, k) => Math.min(255, Math.max(0, 120 - 20 * ball(i, j, k) + 0.3 * (grain(i, j, k) - 127))),
      '0 #fd8 0, 100 #fd8 0, 110 #fd8 100%, 255 #fd8 100%',
      { styles: [{ kind: 'edge', color: [0, 0, 0.2], threshold: 1 }] },
    ],
    'a box of values and gradients': [
      grain,
      '',
      { patches: [{ kind: 'box', values: [60, 160], gradients: [40, 90], color: [1, 0.8, 0.4], opacity: 0.3 }] },
    ],
    'a Gaussian of values and gradients': [
      grain,
      '',
      {
        patches: [{ kind: 'gaussian', value: 120, gradient: 20, widths: [40, 15], color: [1, 0.8, 0.4], opacity: 0.4 }],
      },
    ],
  };
  for (const [name, [value, look, style]] of Object.entries(steep))
    it(`is estimated within a factor of two where it depends on how values change: ${name}`, () => {
      const { estimate, errorOf, atLevel } = sceneOf(value, look, style);
      for (const level of [1, 2]) {
        const [said, true_] = [estimate(atLevel(level)).rms, errorOf(atLevel(level))];
        expect(true_).to.be.above(3);
        expect(said / true_).to.be.within(1 / 2, 2, `level ${level}: ${said} was said, ${true_} is true`);
      }
    });

  const black = '0 #000 100%, 255 #fff 100%';
  const white = '0 #fff 100%, 255 #000 100%';
  const extremes: Record<string, [Parameters<typeof sceneOf>[0], 'max' | 'min', string, PlaneSlice[]?]> = {
    'the largest of noise': [grain, 'max', black],
    'the largest of noise, where little shows': [grain, 'max', '0 #000 0, 200 #247 0, 255 #fd8 100%'],
    'the largest of specks in what is smooth': [
      (i, j, k) => (grain(i, j, k) > 253 ? 255 : 60 + 30 * Math.sin((i + j + k) / 20)),
      'max',
      '0 #000 0, 255 #fff 100%',
    ],
    'the smallest of noise': [(i, j, k) => 255 - grain(i, j, k), 'min', white],
    'the largest of values that end in the middle, before a plane': [
      (i, j, k) => (j < 30 ? grain(i, j, k) : 0),
      'max',
      '0 #000 0, 255 #fd8 50%',
      [plane([0, 1, 0], 0.3)],
    ],
  };
  for (const [name, [value, projection, look, planes]] of Object.entries(extremes))
    it(`is estimated within a factor of two: ${name}`, () => {
      const { estimate, errorOf, atLevel, loadAsked } = sceneOf(value, look, { projection, planes });
      for (const level of [1, 2]) {
        const [said, true_] = [estimate(atLevel(level)).rms, errorOf(atLevel(level))];
        expect(true_).to.be.above(5);
        expect(said / true_).to.be.within(1 / 2, 2, `level ${level}: ${said} was said, ${true_} is true`);
      }
      // What can't be the largest is not asked for.
      expect(errorOf(loadAsked())).to.be.below(3);
    });

  const firsts: Record<string, [Parameters<typeof sceneOf>[0], 'max' | 'min', number]> = {
    'in noise': [grain, 'max', 128],
    'in noise that seldom reaches it': [grain, 'max', 250],
    'in what rises slowly, with grain': [(i, j, k) => 1.5 * i + 1.5 * j + grain(i, j, k) / 12, 'max', 100],
    'before a higher one': [(i, j, k) => (j < 20 ? 0 : 60 + 2 * j + grain(i, j, k) / 8), 'max', 90],
    'of minima, in noise': [grain, 'min', 128],
  };
  for (const [name, [value, projection, threshold]] of Object.entries(firsts))
    it(`is estimated within a factor of two for the first extreme from a value on: ${name}`, () => {
      const { estimate, errorOf, atLevel, loadAsked } = sceneOf(value, black, { projection, threshold });
      for (const level of [1, 2]) {
        const [said, true_] = [estimate(atLevel(level)).rms, errorOf(atLevel(level))];

        expect(true_).to.be.above(3);
        expect(said / true_).to.be.within(1 / 2, 2, `level ${level}: ${said} was said, ${true_} is true`);
      }
      expect(errorOf(loadAsked())).to.be.below(3);
    });

  const onPlanes: Record<string, [string, PlaneSlice[]]> = {
    'a plane through a clear volume': ['0 #247 0, 255 #247 0', [plane([0, 0, 1], 0.47)]],
    'a plane between bricks': ['0 #247 0, 255 #247 0', [plane([0, 0, 1], 0.5)]],
    'oblique planes in fog': ['0 #247 0, 255 #fd8 1%', [plane([1, 2, 3], 3.1), plane([1, 0, -1], 0.2)]],
    'a plane in the colours of what is clear': ['0 #247 0.1%, 255 #fd8 0.1%', [plane([0, 1, 0], 0.3, null)]],
  };
  for (const [name, [look, planes]] of Object.entries(onPlanes))
    it(`is estimated within a factor of three on ${name}, and finer bricks there bring it to nothing`, () => {
      const { estimate, errorOf, atLevel, loadAsked } = sceneOf(grain, look, { planes });
      for (const level of [1, 2]) {
        const [said, true_] = [estimate(atLevel(level)).rms, errorOf(atLevel(level))];
        expect(true_).to.be.above(10);
        expect(said / true_).to.be.within(1 / 2, 3, `level ${level}: ${said} was said, ${true_} is true`);
      }
      const levelOf = loadAsked();
      expect(estimate(levelOf).rms).to.equal(0);
      // Fog needs them everywhere.
      if (look.endsWith(' 0')) expect(levelOf.filter((level) => level === 0).length).to.be.at.most(32);
      expect(errorOf(levelOf)).to.be.below(1);
    });

  it('is nothing behind a plane', () => {
    const { estimate, atLevel } = sceneOf(grain, '0 #247 0, 255 #fd8 12%', { planes: [plane([0, 1, 0], 0.001)] });
    const { gains } = estimate(atLevel(2));
    const inRow = (j: number): number =>
      gains.reduce((sum, gain, at) => sum + (Math.floor(at / 12) % 4 === j ? gain : 0), 0);
    expect(inRow(0)).to.be.above(0);
    expect(inRow(3)).to.be.below(inRow(0) / 100);
  });

  it('is nothing in a volume whose voxels are all equal, and no brick brings anything', () => {
    const { estimate, atLevel } = sceneOf(() => 100, '0 #247 0, 255 #fd8 12%');
    const { rms, gains } = estimate(atLevel(2));
    expect(rms).to.equal(0);
    expect(gains.some(Boolean)).to.equal(false);
  });

  it('is nothing where the finest level is resident', () => {
    const { estimate, atLevel } = sceneOf(...cases['noise in fog']);
    expect(estimate(atLevel(0)).rms).to.equal(0);
  });
});

describe('The next brick', () => {
  const speck: Vector3 = [41, 22, 37];
  const speckPlace = transformPoint(grid.indexToWorld, speck.map((n) => n + 0.5) as unknown as Vector3);

  it('is the finest one with the only speck, which no coarser level shows', () => {
    const look = '0 #fd8 0, 120 #fd8 0, 180 #fd8 100%, 255 #fd8 100%';
    const { pyramid, estimate, errorOf, atLevel } = sceneOf(
      (...at) => (at.every((n, axis) => n >= speck[axis] && n < speck[axis] + 2) ? 255 : 0),
      look,
      // From near, so that some rays of the small picture meet it.
      {
        rays: setUpRays(grid, viewMatrix({ ...camera, target: speckPlace }), projectionMatrix(0.1, 1, 1, 2))!,
      },
    );
    const levelOf = atLevel(2);
    const candidates = [0, 1].flatMap((level) =>
      listBricks(pyramid, level).map((brick) => describeBrick(pyramid, brick, 1000)),
    );
    const { gains } = estimate(levelOf);
    const [first] = chooseBricks(pyramid, candidates, { gains, levelOf, count: 1 });
    expect(first.brick).to.deep.equal({ level: 0, at: [2, 1, 2] });
    // With it, the picture is the true one.
    expect(errorOf(levelOf)).to.be.above(0.1);
    levelOf[2 + 4 * (1 + 4 * 2)] = 0;
    expect(errorOf(levelOf)).to.be.below(0.01);
  });

  it('is in front of what is opaque, not behind it', () => {
    // Two rough slabs across the view, both opaque: the camera looks along -y.
    const { pyramid, estimate, atLevel } = sceneOf(
      (i, j, k) => ((j > 6 && j < 14) || (j > 50 && j < 58) ? 100 + 0.5 * noise[i + edge * (j + edge * k)] : 0),
      '0 #247 0, 60 #247 0, 100 #247 80%, 255 #fd8 100%',
    );
    const { gains } = estimate(atLevel(2));
    const inRow = (j: number): number => {
      let sum = 0;
      // In the middle: from the sides, rays pass the slab in front.
      for (const k of [1, 2]) for (const i of [1, 2]) sum += gains[3 * (i + 4 * (j + 4 * k))];
      return sum;
    };
    expect(inRow(0)).to.be.above(20 * inRow(3));
    expect(pyramid.levels.length).to.equal(3);
  });

  it('costs few bytes where two bring the same, and is none that covers what another one covers', () => {
    const { pyramid, estimate, atLevel } = sceneOf(
      ...([(i, j, k) => noise[i + edge * (j + edge * k)], '0 #247 0, 255 #fd8 3%'] as Parameters<typeof sceneOf>),
    );
    const levelOf = atLevel(2);
    const candidates = [0, 1].flatMap((level) =>
      listBricks(pyramid, level).map((brick) =>
        describeBrick(pyramid, brick, brick.level === 1 && brick.at[0] === 1 ? 100 : 1000),
      ),
    );
    const { gains } = estimate(levelOf);
    const chosen = chooseBricks(pyramid, candidates, { gains, levelOf, count: 1000 });
    expect(chosen[0].brick.level).to.equal(1);
    expect(chosen[0].brick.at[0]).to.equal(1);
    const covered = chosen.flatMap(({ brick }) => describeBrick(pyramid, brick, 1).cells);
    expect(new Set(covered).size).to.equal(covered.length);
  });
});

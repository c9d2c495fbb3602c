// What modules say of their order of convergence, against what their formulas in float64 do: each in rays of which all else
// is exact at any step.
import { expect } from '@esm-bundle/chai';
import { fieldProviders } from '../../../components/internal/field-providers.ts';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import type { Camera } from '../../../src/optics/rays/camera.ts';
import { castRay } from '../../../src/optics/rays/cast-ray.ts';
import { ambientShade, measureAmbientLight } from '../../../src/optics/rays/ambient-light.ts';
import { uncut } from '../../../src/optics/rays/cut-fade.ts';
import { cartesianGradient } from '../../../src/optics/rays/gradient.ts';
import { litShade, pointField } from '../../../src/optics/rays/lit.ts';
import { cartesianOverlay, overlayStages } from '../../../src/optics/attachments/overlay.ts';
import { projectionKinds } from '../../../src/optics/rays/ray-style.ts';
import { boxInterval, shapeInterval } from '../../../src/optics/rays/ray-intervals.ts';
import { clipInterval, cutoutInterval } from '../../../src/optics/rays/clip-intervals.ts';
import type { Cutout } from '../../../src/optics/rays/clip-intervals.ts';
import { labelField, labelShade } from '../../../src/optics/attachments/labels.ts';
import { planeInterval } from '../../../src/optics/attachments/plane-slices.ts';
import type { PlaneSlice } from '../../../src/optics/attachments/plane-slices.ts';
import { patchClassify } from '../../../src/optics/rays/patch-classify.ts';
import { projectionGather } from '../../../src/optics/rays/projection.ts';
import { transferFunctionClassify } from '../../../src/optics/rays/ray-classify.ts';
import { compositeGather } from '../../../src/optics/rays/ray-gather.ts';
import { styledShade } from '../../../src/optics/rays/styled.ts';
import { jumpGather } from '../../../src/optics/surfaces/jump-gather.ts';
import { surfaceGather } from '../../../src/optics/surfaces/surfaces.ts';
import { polarField } from '../../../src/radar/polar-field.ts';
import { cartesianField, storedField } from '../../../src/optics/rays/ray-field.ts';
import type { FieldStage } from '../../../src/optics/rays/ray-stages.ts';
import { setUpRays } from '../../../src/optics/rays/rays.ts';
import { opticsOf, stagesOf } from '../../../src/optics/reference.ts';
import type { ReferenceScene } from '../../../src/optics/reference.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import type { Patch } from '../../../src/optics/transfer/patches.ts';
import type { StyleChain } from '../../../src/optics/transfer/volume-styles.ts';
import { sliceInterval, sliceMeeter } from '../../../src/radar/slices.ts';
import type { Slice } from '../../../src/radar/slices.ts';
import * as clip from '../../../src/renderer/ray/modules/clip.ts';
import * as cutout from '../../../src/renderer/ray/modules/cutout.ts';
import { labelFunctionsText } from '../../../src/renderer/ray/modules/label-functions-text.ts';
import * as planes from '../../../src/renderer/ray/modules/plane-slices.ts';
import * as sceneDepth from '../../../src/renderer/ray/modules/scene-depth.ts';
import type { RayModule } from '../../../src/renderer/ray/ray-module.ts';
import { VolumeLayer } from '../../../src/renderer/layers/volume-layer.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import { buildMacrocells } from '../../../src/volume/macrocells.ts';
import { scaleAndTranslate } from '../../../src/volume/matrix.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { fitOrder } from '../../accuracy/orders.ts';
import { createGl, releaseGl } from '../../helpers/gl.ts';
import { castPixels } from '../../helpers/pixel-rays.ts';
import { cloudCamera, cloudColors, cloudVolume } from '../../helpers/polar-cloud.ts';
import { blocks, mixedGroups, mixedAppearances } from '../../helpers/labels.ts';
import { overlayOf } from '../../helpers/overlays.ts';
import { cutIntoBricks } from '../../helpers/bricks.ts';
import { listLevels } from '../../helpers/ray-modules.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

type Field = (x: number, y: number, z: number) => number;

const [width, height] = [12, 9];

/** Steps along the diagonal, and what stands for the limit. */
const counts = [40, 60, 90, 135, 200];
const limitSteps = 4096;

/** What is left where steps do not matter: rounding in float64. */
const rounding = 1e-14;

const bump: Field = (x, y, z) => Math.exp(-11 * ((x - 0.45) ** 2 + (y - 0.52) ** 2 + (z - 0.5) ** 2)) + 0.1 * x;
const dent: Field = (x, y, z) => 1.1 - bump(x, y, z);
const ramp: Field = (x, y, z) => 0.2 + 0.5 * x - 0.1 * y + 0.3 * z;
/** Opaque from 0.5 on. */
const opaque: TransferFunction = [0, 0.5, 0.5, 1].map((value, i) => ({
  value,
  color: [1, 0.5, 0.2],
  opacity: i < 2 ? 0.01 : 1,
}));
/** Where values run straight, a function of one colour makes exact segments. */
const oneColor: TransferFunction = [
  { value: 0, color: [1, 0.5, 0.2], opacity: 0.01 },
  { value: 1, color: [1, 0.5, 0.2], opacity: 0.08 },
];

/** At a field that is known everywhere: no voxels. */
const known = (field: Field): FieldStage => storedField(([x, y, z]) => field(x, y, z), { slope: 1, intercept: 0 });

/** The bounds of rays, and where they are looked at from. */
type View = readonly [Volume, Camera];
const head = syntheticVolume({ dimensions: [24, 24, 24], kind: 'float32', field: bump });
const headView: View = [head, orbitCamera({ theta: 0.15, phi: 1.45, radius: 48 }, [0, 0, 0], 0.25)];
const storm = cloudVolume(1);
const stormView: View = [storm, cloudCamera];
const level: Slice = { kind: 'level', height: 9000 };
const plane: PlaneSlice = { kind: 'plane', slab: null, normal: [0.2, 1, 0.4], offset: 0.8, window: [0, 1] };
const hole: Cutout = { kind: 'cutout', unitToBox: scaleAndTranslate([2, 3, 2.5], [-0.5, -0.4, -0.9]) };
const plain = { referenceLength: 1, opacityFactor: 1, lightFactor: 1, maxSubsteps: 1 };
const exact = { transferFunction: oneColor, field: known(ramp) };
const colored = { ...plain, transferFunction: cloudColors };

const things = mixedAppearances(blocks(head.grid.dimensions, 6));
/** The same as a volume of its own. */
const named: Volume = {
  ...head,
  samples: things.map.numbers.map((number) => 51 * number),
  slope: 1 / 255,
  isDiscrete: true,
  macrocells: buildMacrocells(
    things.map.numbers.map((number) => 51 * number),
    head.grid.dimensions,
  ),
};

/** A larger head as a coarse volume, with all bricks of the finer level over it. */
const { volume: bricked } = cutIntoBricks(
  syntheticVolume({ dimensions: [40, 40, 40], kind: 'float32', field: bump }),
  2,
);

/** Light on a field, from the side and from the eye. */
const lightOf = (field: FieldStage): Pick<ReferenceScene, 'moreFields' | 'shades'> => ({
  moreFields: [pointField],
  shades: [litShade({ grid: head.grid, gradient: cartesianGradient(field, head.grid), flat: 0.02 })],
});

/** A second field over the head. */
const over = overlayOf(head, head, { transferFunction: cloudColors });
const overlaid = (field: FieldStage): Pick<ReferenceScene, 'moreFields' | 'shades'> =>
  overlayStages(over, field, { optics: plain, diameter: longestDiagonal(head.grid) });

/** Styles without an edge. */
const smoothStyles: readonly StyleChain[] = [
  {
    weight: 1,
    styles: [
      { kind: 'boundary', retained: 0.3, boundary: 0.6, power: 1 },
      { kind: 'silhouette', retained: 0.4, boundary: 0.6, sharpness: 2 },
      { kind: 'tone', cool: [0, 0, 1], warm: [1, 1, 0] },
    ],
  },
];

/** Of values by gradients, without an edge: rays that graze one have the order of a jump. */
const bells: readonly Patch[] = [
  { kind: 'gaussian', value: 0.5, gradient: 0.1, widths: [0.15, 0.04], color: [1, 0.5, 0.2], opacity: 0.05 },
  { kind: 'gaussian', value: 0.7, gradient: 0.09, widths: [0.1, 0.04], color: [0.2, 0.5, 1], opacity: 0.1 },
];

type Look = Pick<ReferenceScene, 'transferFunction'> & Partial<ReferenceScene> & { readonly field: FieldStage };

/** A ray in which only the module of this name may leave an error. */
const looks: Record<string, Look> = {
  box: exact,
  sceneDepth: { ...exact, ends: [shapeInterval(() => 0.1)] },
  slices: { ...exact, ends: [sliceInterval(sliceMeeter(storm, [level], colored))], referenceLength: 3000 },
  clip: { ...exact, ends: [clipInterval([{ kind: 'half-space', normal: [0.3, 1, -0.2], offset: 0.55 }])] },
  cutout: { ...exact, ends: [cutoutInterval(hole)] },
  planes: { ...exact, ends: [planeInterval([plane], known(ramp), oneColor)] },
  cartesian: { ...colored, field: cartesianField({ ...head, dimensions: head.grid.dimensions }) },
  bricks: { ...colored, field: cartesianField({ ...bricked, dimensions: bricked.grid.dimensions }) },
  discrete: { ...colored, field: cartesianField({ ...named, dimensions: head.grid.dimensions }) },
  polar: { ...colored, field: polarField(storm), referenceLength: 3000 },
  labels: { ...exact, moreFields: [labelField(things, true)], gather: projectionGather('average') },
  labelAppearances: { ...exact, moreFields: [labelField(things)], shades: [labelShade] },
  overlay: { ...exact, ...overlaid(cartesianOverlay(over)) },
  overlayAppearance: { ...exact, ...overlaid(known(bump)) },
  transferFunction: { ...colored, field: known(ramp) },
  columns: { ...colored, field: known(ramp) },
  columnMeans: { ...colored, field: known(ramp) },
  labelFunctions: { ...colored, field: known(ramp) },
  composite: exact,
  points: { ...exact, moreFields: [pointField] },
  lit: { ...colored, field: known(bump), ...lightOf(known(bump)) },
  ambient: {
    ...colored,
    field: known(bump),
    moreFields: [pointField],
    shades: [
      ambientShade(
        measureAmbientLight({ volume: head, ...plain, transferFunction: cloudColors, cuts: uncut }),
        head.grid,
        uncut,
      ),
    ],
  },
  styled: {
    ...colored,
    field: known(bump),
    moreFields: [pointField],
    shades: [
      styledShade({
        grid: head.grid,
        gradient: cartesianGradient(known(bump), head.grid),
        flat: 0.02,
        chains: smoothStyles,
        referenceLength: 1,
        opticalScale: longestDiagonal(head.grid),
      }),
    ],
  },
  patches: {
    ...colored,
    field: known(bump),
    moreFields: [pointField],
    classifyBy: (usual) =>
      patchClassify(usual, {
        patches: bells,
        grid: head.grid,
        gradient: cartesianGradient(known(bump), head.grid),
        field: known(bump),
        opticalScale: longestDiagonal(head.grid),
      }),
  },
  surfaces: {
    ...exact,
    field: known(bump),
    moreFields: [pointField],
    gather: surfaceGather({
      surfaces: [{ value: 0.5, color: [1, 1, 1], opacity: 0.5 }],
      isClear: true,
      light: null,
      toEye: () => [0, 0, 1],
    }),
  },
  jumps: {
    ...exact,
    moreFields: [pointField],
    maxSubsteps: 8,
    field: { ...known(ramp), kinksAlong: () => [] },
    gather: jumpGather([0.5], 0.05),
  },
  max: { ...colored, field: known(bump), gather: projectionGather('max') },
  min: { ...colored, field: known(dent), gather: projectionGather('min') },
  average: { ...colored, field: known(bump), gather: projectionGather('average') },
};

/** All modules, by name. */
async function listModules(): Promise<Map<string, RayModule>> {
  const test = createGl(2);
  const layer = new VolumeLayer(test.gl, test.device, fieldProviders);
  const found = new Map<string, RayModule>();
  try {
    layer.surfacesModule = sceneDepth.createSceneDepth(test.gl);
    const cuts = [
      { create: clip.createClip, items: [] },
      { create: cutout.createCutout, items: [hole] },
      { create: planes.createPlanes, items: [plane] },
    ];
    layer.plan = { ...layer.plan, slices: [level], cuts };
    await layer.setAttached((attached) => attached.setLabels(things));
    await layer.setAttached((attached) => attached.setOverlay(over));
    for (const volume of [head, bricked, named, storm]) {
      await layer.prepare(volume);
      layer.set(volume);
      await layer.setAppearance({ optics: { ...plain, transferFunction: oneColor } });
      for (const style of [
        null,
        { lit: true } as const,
        { lit: 'ambient-occlusion' } as const,
        { styles: smoothStyles },
        { patches: bells },
        { surfaces: [{ value: 0.5, color: [1, 1, 1], opacity: 1 }] } as const,
        ...projectionKinds.map((projection) => ({ projection })),
      ]) {
        await layer.setAppearance({ style });
        for (const module of layer.modules(true)) found.set(module.name, module);
      }
      await layer.setAppearance({ style: null });
      await layer.setAppearance({
        optics: { ...plain, transferFunction: [oneColor[0], { ...oneColor[1], value: 0 }] },
      });
      for (const module of layer.modules(true)) found.set(module.name, module);
    }
    layer.set(head);
    await layer.setAppearance({ optics: { ...plain, transferFunction: opaque } });
    for (const module of layer.modules(true, true)) found.set(module.name, module);
    await layer.setAttached((attached) => attached.setLabels(mixedGroups(things.map)));
    for (const module of layer.modules(true)) found.set(module.name, module);
  } finally {
    layer.dispose();
    releaseGl(test);
  }
  return found;
}

/** A small picture, with the twins that the modules name. */
function draw([volume, camera]: View, appearance: Look, steps: number): number[] {
  const rays = setUpRays(volume.grid, viewMatrix(camera), projectionMatrix(camera.fieldOfView, width / height, 1, 2))!;
  const scene: ReferenceScene = {
    ...plain,
    ...volume,
    ...appearance,
    stepLength: longestDiagonal(volume.grid) / steps,
  };
  const stages = {
    ...stagesOf(scene, rays),
    intervals: [boxInterval(rays), ...(scene.ends ?? [])],
    classify: (appearance.classifyBy ?? ((usual) => usual))(
      transferFunctionClassify(opticsOf(scene), appearance.field, rays.diameter / scene.referenceLength),
    ),
    gather: appearance.gather ?? compositeGather,
  };
  return castPixels(rays, [width, height], (ray) => castRay(stages, ray));
}

const rms = (a: readonly number[], b: readonly number[]): number =>
  Math.hypot(...a.map((x, i) => x - b[i])) / Math.sqrt(a.length);

describe('the order of convergence that a module states', () => {
  let modules: Map<string, RayModule>;
  before(async () => {
    modules = await listModules();
  });

  it('is measured of all modules', () => {
    const all = Object.values(listLevels(true))
      .flatMap((levels) => levels.flatMap((one) => (one ? [one.name] : [])))
      .concat(labelFunctionsText.name, 'patches');
    expect(Object.keys(looks)).to.have.members([...new Set(all)]);
    expect([...modules.keys()]).to.have.members(Object.keys(looks));
  });

  it('is that of a ray which each of them has a part of in float64, except one whose part another one has', () => {
    expect([...modules.values()].filter(({ twin }) => twin === null).map(({ name }) => name)).to.have.members([
      'columns',
    ]);
  });

  for (const [name, appearance] of Object.entries(looks)) {
    it(`${name}: is what its twin has`, () => {
      const { order } = modules.get(name)!;
      const view = name === 'polar' || name === 'slices' ? stormView : headView;
      const limit = draw(view, appearance, limitSteps);
      expect(Math.max(...limit), 'the picture shows something').to.be.above(0.1);
      if (appearance.ends)
        expect(rms(limit, draw(view, { ...appearance, ends: [] }, limitSteps)), 'rays end').to.be.above(0.01);
      const errors = counts.map((steps) => rms(draw(view, appearance, steps), limit));
      const measured = Math.max(...errors) < rounding ? Infinity : fitOrder(counts, errors);
      console.log(
        `${name}: states ${order}, measured ${measured.toFixed(2)}; ${errors.map((error) => error.toExponential(1)).join(' ')}`,
      );
      if (order === Infinity) expect(measured).to.equal(Infinity);
      else expect(measured).to.be.closeTo(order, 0.2);
    });
  }
});

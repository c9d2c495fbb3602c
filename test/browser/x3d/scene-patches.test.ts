// Transfer functions of value and gradient on the GPU against the twin in float64, alone and with light, styles and surfaces; which patches there are is in uniforms.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { outlinePatches } from '../../../src/optics/transfer/patches.ts';
import type { Patch } from '../../../src/optics/transfer/patches.ts';
import type { RayStyle } from '../../../src/optics/rays/ray-style.ts';
import { renderReference } from '../../../src/optics/reference.ts';
import type { ReferenceScene } from '../../../src/optics/reference.ts';
import { programKey } from '../../../src/renderer/ray/compose-ray.ts';
import { polarTapsOf } from '../../../src/radar/gpu/polar-taps.ts';
import { headlightAlone } from '../../../src/optics/transfer/lights.ts';
import { pointsModule } from '../../../src/renderer/ray/modules/points.ts';
import { cartesianTapsOf } from '../../../src/renderer/ray/modules/field-taps.ts';
import { createPatches } from '../../../src/renderer/ray/modules/patches.ts';
import { casesIn, takesAll } from '../../helpers/cases.ts';
import { quietGl } from '../../helpers/quiet-layer.ts';
import { boundingSphere, longestDiagonal } from '../../../src/volume/grid.ts';
import { buildMacrocells } from '../../../src/volume/macrocells.ts';
import { litStages } from '../../helpers/lit.ts';
import {
  comparePictures,
  drawPicture,
  height,
  plainOptics,
  raysOf,
  referenceOf,
  shareScene,
  width,
  walksOf,
} from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { cloudCamera, cloudVolume } from '../../helpers/polar-cloud.ts';
import { remember } from '../../helpers/remember.ts';
import { surfaceStages } from '../../helpers/surfaces.ts';
import { smoothField, syntheticVolume } from '../../helpers/synthetic.ts';

const box: Patch = { kind: 'box', values: [0.35, 0.6], gradients: [0.02, 0.06], color: [1, 0.5, 0.1], opacity: 0.12 };
const bell: Patch = {
  kind: 'gaussian',
  value: 0.7,
  gradient: 0.03,
  widths: [0.08, 0.02],
  color: [0.2, 0.7, 1],
  opacity: 0.3,
};
const narrow: Patch = {
  kind: 'gaussian',
  value: 0.3,
  gradient: 0.05,
  widths: [0.01, 0.006],
  color: [1, 1, 0.8],
  opacity: 0.8,
};

const looks: Record<string, { readonly patches: readonly Patch[]; readonly more?: RayStyle }> = {
  'a box': { patches: [box] },
  'a Gaussian': { patches: [bell] },
  eight: {
    patches: [
      bell,
      box,
      narrow,
      { ...bell, value: 0.5, color: [0, 1, 0] },
      { ...box, values: [0.1, 0.2], gradients: [0, 0.03] },
      { ...bell, gradient: 0.06 },
      { ...narrow, value: 0.55 },
      { ...box, values: [0.65, 0.9], opacity: 0.03 },
    ],
  },
  'numbers of any size': {
    patches: [
      { ...box, values: [-1e9, 0.6], gradients: [0.02, 1e30] },
      bell,
      { ...bell, value: 1e200, gradient: 1e299 },
      { ...bell, widths: [1e-200, 1e-200] },
      { ...box, values: [-3, -2], gradients: [0, 1e-299] },
    ],
  },
  lit: { patches: [box, bell], more: { lit: true } },
  'with surfaces': { patches: [box, bell], more: { surfaces: [{ value: 0.5, color: [1, 1, 0.9], opacity: 0.4 }] } },
};

/** The same of a cloud that is some kilometres wide. */
const ofCloud: readonly Patch[] = [
  { kind: 'box', values: [0.1, 0.5], gradients: [0.00005, 0.00013], color: [0.2, 0.5, 1], opacity: 0.3 },
  { kind: 'gaussian', value: 0.7, gradient: 0.0001, widths: [0.1, 0.00003], color: [1, 0.6, 0], opacity: 0.6 },
];

const hole = (x: number, y: number, z: number): number =>
  Math.hypot(x - 0.4, y - 0.5, z - 0.5) < 0.2 ? NaN : smoothField(x, y, z);

function cartesian(kind: 'uint16' | 'float32'): View {
  const dimensions = [24, 20, 16] as const;
  const made = syntheticVolume({
    dimensions,
    kind,
    spacing: [1, 1.2, 0.9],
    ...(kind === 'float32' && { field: hole }),
  });
  const volume =
    kind === 'float32' ? { ...made, hasNoData: true, macrocells: buildMacrocells(made.samples, dimensions) } : made;
  const diagonal = longestDiagonal(volume.grid);
  return {
    volume,
    camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, boundingSphere(volume.grid).center, 0.6),
    stepLength: diagonal / 45,
  };
}

const cloud = cloudVolume(1);
const views: Record<string, View> = {
  cartesian: cartesian('uint16'),
  'with a hole': cartesian('float32'),
  polar: { volume: cloud, camera: cloudCamera, stepLength: longestDiagonal(cloud.grid) / 100 },
};

type Look = (typeof looks)[string];

function appearancesOf(name: string): Record<string, Look> {
  if (name === 'polar') return { cloud: { patches: ofCloud } };
  return name === 'cartesian' ? looks : { eight: looks.eight };
}

/** With the optics of its patches. */
function viewOf(name: string, { patches, more }: Look): View {
  const lightFactor = more?.surfaces ? 1 : 1.2;
  const optics = {
    ...plainOptics,
    transferFunction: outlinePatches(patches, views[name].volume.range),
    opacityFactor: 0.8,
    lightFactor,
    ...(name === 'polar' && { referenceLength: 3000 }),
  };
  return { ...views[name], optics };
}

function render(view: View, { patches, more = {} }: Look): Float64Array {
  const { volume, optics = plainOptics } = view;
  const taps = volume.grid.kind === 'polar' ? polarTapsOf : cartesianTapsOf;
  const module = createPatches(quietGl(), patches).of(
    { taps, lights: false, cuts: false },
    { lights: headlightAlone, cuts: { halfSpaces: [], unitToCutout: null } },
  );
  const staged = referenceOf({ ...view, modules: [pointsModule, module] });
  const attached: Pick<ReferenceScene, 'shades' | 'gather'> = more.lit
    ? litStages(volume, optics.transferFunction)
    : more.surfaces
      ? surfaceStages(volume, more, optics.transferFunction)
      : {};
  return renderReference({ ...staged, ...attached, moreFields: staged.moreFields }, raysOf(view), width, height).map(
    (x) => x * 255,
  );
}

const expectationsOf = remember((name: string) =>
  Object.entries(appearancesOf(name)).flatMap(([appearance, shown], i) =>
    walksOf(viewOf(name, shown), i).map((view) => ({ look: appearance, shown, view, expected: render(view, shown) })),
  ),
);

for (const version of [2, 1] as const) {
  describe(`transfer functions of value and gradient in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    for (const name of casesIn(version, Object.keys(views), (one) => one !== 'with a hole')) {
      it(`are the twin's, without a program more: ${name}`, async function () {
        this.timeout(240_000);
        const layer = scene().layers[0];
        const keys = new Set<string>();
        for (const {
          look: appearance,
          shown: { patches, more },
          view,
          expected,
        } of expectationsOf(name)) {
          await scene().prepare(view.volume);
          await scene().setAppearance({ style: null });
          const plain = drawPicture(scene(), view);
          await scene().setAppearance({ style: { patches, ...more } });
          const got = drawPicture(scene(), view);
          if (!more) keys.add(programKey(layer.program(false)));
          const { worst, rmse } = comparePictures(got, expected);
          const other = comparePictures(got, plain);
          console.log(
            `WebGL ${version} ${name}: ${appearance}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}; to the picture by value alone ${other.worst}`,
          );
          expect(worst, `${appearance}: worst pixel`).to.be.at.most(2);
          expect(rmse, `${appearance}: RMSE`).to.be.at.most(0.5);
          expect(other.worst, `${appearance}: another picture than by value alone`).to.be.above(20);
          layer.skipping = false;
          expect(comparePictures(got, drawPicture(scene(), view)).worst, `${appearance}: skipping`).to.equal(0);
          layer.skipping = true;
        }
        expect(keys.size, 'programs, one for each walk').to.equal(takesAll || name === 'cartesian' ? 2 : 1);
      });
    }
  });
}

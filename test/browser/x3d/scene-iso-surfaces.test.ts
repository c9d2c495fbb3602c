// Pictures of surfaces of the GPU against the twin in float64.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { uncut } from '../../../src/optics/rays/cut-fade.ts';
import type { RayStyle } from '../../../src/optics/rays/ray-style.ts';
import type { SceneLights } from '../../../src/optics/transfer/lights.ts';
import { labelField } from '../../../src/optics/attachments/labels.ts';
import { renderReference } from '../../../src/optics/reference.ts';
import { allSubsteps } from '../../../src/optics/cells/substeps.ts';
import type { Substeps } from '../../../src/optics/cells/substeps.ts';
import { cutSteps } from '../../../src/quality/levels.ts';
import { autoSteps, stepLengthOf } from '../../../src/quality/steps.ts';
import { boundingSphere } from '../../../src/volume/grid.ts';
import type { ShownLabels } from '../../../src/volume/labels.ts';
import { casesIn } from '../../helpers/cases.ts';
import { changePlan } from '../../helpers/change-plan.ts';
import { cutBox, keep } from '../../helpers/clips.ts';
import { blocks, mixedAppearances } from '../../helpers/labels.ts';
import { lamp, litStages } from '../../helpers/lit.ts';
import {
  comparePictures,
  drawPicture,
  height,
  plainOptics,
  raysOf,
  referenceOf,
  shareScene,
  width,
  withScene,
  walksOf,
} from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { remember } from '../../helpers/remember.ts';
import { surfaceStages } from '../../helpers/surfaces.ts';
import { fieldWithHole, randomNumbers, smoothField, syntheticVolume } from '../../helpers/synthetic.ts';
import { viewOfCloud, smallView } from '../../helpers/views.ts';

interface Case {
  readonly name: string;
  readonly view: () => View;
  readonly style: RayStyle;
  readonly lights?: SceneLights;
  readonly labels?: (view: View) => ShownLabels;
}

const three: RayStyle = {
  surfaces: [
    { value: 0.35, color: [1, 0.4, 0.2], opacity: 0.3 },
    { value: 0.5, color: [0.2, 0.9, 0.5], opacity: 0.5 },
    { value: 0.65, color: [1, 1, 0.9], opacity: 1 },
  ],
};
const shell: RayStyle = { clear: true, surfaces: [{ value: 0.45, color: [1, 0.8, 0.6], opacity: 1 }] };
/** Oblique to the lattice. */
const mask = (x: number, y: number, z: number): number =>
  0.5 * x + 0.3 * y + 0.8 * z < 0.9 ? smoothField(x, y, z) : 0;
const sun: SceneLights = {
  headlight: false,
  lights: [lamp],
};

const cases: Case[] = [
  { name: 'one alone, 8 bit', view: () => smallView({}), style: shell },
  {
    name: 'three in lit fog of 16 bit, with a lamp, cut',
    lights: sun,
    style: { ...three, lit: true },
    view: () => {
      const view = smallView({ kind: 'uint16', spacing: [1, 0.8, 1.5], slope: 1 });
      const { grid } = view.volume;
      return {
        ...view,
        clips: { kept: [keep(grid, [1, -0.4, 0.3], -3)], cutout: cutBox(grid, [2, -4, -3], [9, 4, 20]) },
      };
    },
  },
  {
    name: 'three in their own colours, floats with a hole, brightened',
    style: { ...three, clear: true, plain: true },
    view: () => ({
      ...smallView({ kind: 'float32', field: fieldWithHole }),
      optics: { ...plainOptics, lightFactor: 1.5 },
    }),
  },
  {
    name: 'one beside a mask of zeros',
    view: () => smallView({ field: mask }),
    style: { clear: true, surfaces: [{ value: 0.5, color: [1, 0.8, 0.6], opacity: 1 }] },
  },
  {
    name: "in X3D's styles, with a lamp, cut",
    lights: sun,
    view: () => {
      const view = smallView({ spacing: [1, 0.8, 1.5] });
      return { ...view, clips: { kept: [keep(view.volume.grid, [1, -0.4, 0.3], -3)] } };
    },
    style: {
      ...three,
      clear: true,
      surfaceStyles: [
        { kind: 'tone', cool: [0.1, 0.2, 0.8], warm: [1, 0.8, 0.3] },
        {
          kind: 'shaded',
          material: {
            ambient: 0.3,
            diffuse: [1, 0.9, 0.8],
            specular: [0.4, 0.4, 0.4],
            emissive: [0, 0, 0],
            shininess: 20,
          },
        },
        { kind: 'edge', color: [0.1, 0, 0.2], threshold: 1.2 },
        { kind: 'silhouette', retained: 0.4, boundary: 1, sharpness: 2 },
      ],
    },
  },
  {
    name: 'labelled',
    style: { ...three, clear: true },
    view: () => smallView({}),
    labels: ({ volume }) => mixedAppearances(blocks(volume.grid.dimensions, 6)),
  },
  {
    name: 'polar',
    style: {
      clear: true,
      surfaces: [
        { value: 0.3, color: [0.3, 0.8, 1], opacity: 0.4 },
        { value: 0.6, color: [1, 0.6, 0.2], opacity: 1 },
      ],
    },
    view: viewOfCloud,
  },
];

const expectationOf = remember((one: Case) => {
  const { view: make, style, lights, labels: label } = one;
  const plain = make();
  const { volume, optics = plainOptics, clips } = plain;
  const cuts = { ...uncut, halfSpaces: clips?.kept ?? [], unitToCutout: clips?.cutout?.unitToBox ?? null };
  const brightened = {
    ...style,
    surfaces: style.surfaces!.map((one) => ({
      ...one,
      color: one.color.map((x) => Math.min(1, x * optics.lightFactor)) as unknown as typeof one.color,
    })),
  };
  const more = { cuts, ...(lights && { lights }) };
  const stages = surfaceStages(volume, brightened, optics.transferFunction, more);
  const labels = label?.(plain) ?? null;
  const lit = style.lit && { shades: litStages(volume, optics.transferFunction, more).shades };
  const moreFields = [...stages.moreFields!, ...(labels ? [labelField(labels)] : [])];
  const draw = (view: View): Float64Array =>
    renderReference({ ...referenceOf(view), ...stages, ...lit, moreFields }, raysOf(view), width, height).map(
      (x) => x * 255,
    );
  return walksOf(plain, cases.indexOf(one)).map((view) => ({ view, labels, expected: draw(view) }));
});

for (const version of [2, 1] as const) {
  describe(`surfaces in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    for (const one of casesIn(version, cases, ({ lights, name }) => lights !== undefined || name === 'polar')) {
      it(`are the twin's: ${one.name}; and skipping changes no byte`, async function () {
        this.timeout(180_000);
        for (const { view, labels, expected } of expectationOf(one)) {
          await scene().prepare(view.volume);
          await scene().setAppearance({ style: one.style });
          if (labels) await scene().setLabels(labels);
          scene().layers[0].lights = () => one.lights ?? null;
          const got = drawPicture(scene(), view);
          // A ray that grazes a surface may pass it here and not there.
          const off = new Set<number>();
          got.forEach((x, i) => Math.abs(x - expected[i]) > 2 && off.add(i >> 2));
          const { worst, rmse } = comparePictures(got, expected, (pixel) => off.has(pixel));
          await scene().setAppearance({ style: null });
          const without = comparePictures(got, drawPicture(scene(), view));
          console.log(
            `WebGL ${version} ${one.name}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}, ${off.size} grazing pixels; to the picture without ${without.worst} and ${without.rmse.toFixed(1)}`,
          );
          expect(rmse, 'RMSE').to.be.at.most(0.5);
          expect(off.size, 'pixels that differ').to.be.at.most(2);
          expect(without.worst, 'it is another picture than without surfaces').to.be.above(20);
          await scene().setAppearance({ style: one.style });
          scene().layers[0].skipping = false;
          expect(comparePictures(got, drawPicture(scene(), view)).worst, 'skipping').to.equal(0);
          scene().layers[0].skipping = true;
          if (labels) await scene().setLabels(null);
        }
      });
    }
  });
}

describe('specks of one voxel that stand above a value', () => {
  it('keep three quarters of their area at rest, and lose more with long steps', () =>
    withScene({}, async (scene) => {
      const random = randomNumbers(21);
      const volume = syntheticVolume({
        dimensions: [40, 36, 30],
        field: (x) => (random() < 0.002 ? 1 : 0.1 + 0.1 * x),
      });
      const { center, radius } = boundingSphere(volume.grid);
      changePlan(scene, { picture: { width: 120, height: 90 } });
      await scene.setAppearance({
        style: { clear: true, plain: true, surfaces: [{ value: 0.75, color: [1, 1, 1], opacity: 1 }] },
      });
      const one = autoSteps(volume.grid);
      const area = (steps: number, substeps: Substeps): number => {
        changePlan(scene, { substeps });
        const picture = drawPicture(scene, {
          volume,
          camera: orbitCamera({ theta: 0.7, phi: 1.1, radius: 3 * radius }, center, 0.6),
          stepLength: stepLengthOf(volume.grid, steps),
        });
        return picture.reduce((sum, x, i) => sum + (i % 4 === 3 ? x : 0), 0) / 255;
      };
      const all = area(16 * one, allSubsteps);
      const rest = area(one / 4, cutSteps({ steps: one / 4, substeps: 1 }, one, 1));
      const long = area(one / 4, allSubsteps);
      console.log(
        `specks: ${all.toFixed(0)} pixels, at rest ${rest.toFixed(0)}, with steps of four voxels ${long.toFixed(0)}`,
      );
      expect(all).to.be.above(40);
      expect(rest / all).to.be.within(0.75, 1.02);
      expect(long).to.be.below(0.9 * rest);
    }));
});

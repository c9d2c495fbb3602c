// Lit pictures of the GPU against the twin in float64.
import { expect } from '@esm-bundle/chai';
import { uncut } from '../../../src/optics/rays/cut-fade.ts';
import type { CutFaces } from '../../../src/optics/rays/cut-fade.ts';
import type { SceneLights } from '../../../src/optics/transfer/lights.ts';
import { renderReference } from '../../../src/optics/reference.ts';
import { unitToWorld } from '../../../src/volume/grid.ts';
import { invertAffine, multiply } from '../../../src/volume/matrix.ts';
import { cutRegion } from '../../../src/volume/region.ts';
import { casesIn } from '../../helpers/cases.ts';
import { cutBox, keep } from '../../helpers/clips.ts';
import { lamp, litStages } from '../../helpers/lit.ts';
import {
  bothWalks,
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
import { viewOfCloud, smallView } from '../../helpers/views.ts';
import { fieldWithHole } from '../../helpers/synthetic.ts';

interface Case {
  readonly name: string;
  readonly view: () => View;
  readonly lights?: SceneLights;
}

const many: SceneLights = {
  headlight: false,
  lights: [
    lamp,
    {
      ...lamp,
      kind: 'point',
      location: [9, -12, 8],
      color: [0.3, 1, 0.4],
      attenuation: [0.5, 0.05, 0.002],
      radius: 22,
    },
    {
      ...lamp,
      kind: 'spot',
      location: [2, -25, 12],
      direction: [0, 0.9, -0.436],
      color: [0.2, 0.3, 1],
      intensity: 1.5,
    },
  ],
};
const cases: Case[] = [
  { name: '8 bit', view: () => smallView({}) },
  {
    name: 'a region of 16 bit, with three lights',
    lights: many,
    view: () => {
      const view = smallView({ kind: 'uint16', spacing: [1, 0.8, 1.5] });
      return { ...view, region: cutRegion(view.volume.grid, [-8, -6, -9, 9, 5, 7]) };
    },
  },
  { name: 'floats with a hole', view: () => smallView({ kind: 'float32', field: fieldWithHole }) },
  {
    name: 'polar',
    view: viewOfCloud,
  },
];

function draw(one: Case): { view: View; expected: Float64Array }[] {
  const { view: make, lights } = one;
  const whole = make();
  const { volume, optics = plainOptics, region } = whole;
  const unitToRegion = region ? multiply(invertAffine(unitToWorld(region))!, unitToWorld(volume.grid)) : undefined;
  const cuts = unitToRegion && { unitToRegion, halfSpaces: [], unitToCutout: null };
  const lit = litStages(volume, optics.transferFunction, { ...(lights && { lights }), ...(cuts && { cuts }) });
  return walksOf(whole, cases.indexOf(one)).map((view) => ({
    view,
    expected: renderReference({ ...referenceOf(view), ...lit }, raysOf(view), width, height).map((x) => x * 255),
  }));
}

const expectationOf = remember(draw);

for (const version of [2, 1] as const) {
  describe(`light in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    for (const one of casesIn(version, cases, ({ lights, name }) => lights !== undefined || name === 'polar')) {
      it(`is the twin's: ${one.name}; and skipping changes no byte`, async function () {
        this.timeout(120_000);
        for (const { view, expected } of expectationOf(one)) {
          await scene().prepare(view.volume);
          await scene().setAppearance({ style: { lit: true } });
          scene().layers[0].lights = () => one.lights ?? null;
          const got = drawPicture(scene(), view);
          const { worst, rmse } = comparePictures(got, expected);
          await scene().setAppearance({ style: null });
          const unlit = comparePictures(got, drawPicture(scene(), view));
          console.log(
            `WebGL ${version} ${one.name}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}; to the unlit picture ${unlit.worst} and ${unlit.rmse.toFixed(1)}`,
          );
          expect(worst, 'worst pixel').to.be.at.most(2);
          expect(rmse, 'RMSE').to.be.at.most(0.5);
          expect(unlit.worst, 'it is another picture than without light').to.be.above(15);
          await scene().setAppearance({ style: { lit: true } });
          scene().layers[0].skipping = false;
          expect(comparePictures(got, drawPicture(scene(), view)).worst, 'skipping').to.equal(0);
          scene().layers[0].skipping = true;
        }
      });
    }
  });
}

describe('next to what cuts rays', () => {
  it("light fades as the twin's does, at planes and around a box that is cut out", () =>
    withScene({}, async (scene) => {
      const whole = smallView({});
      const { grid } = whole.volume;
      const kept = [keep(grid, [1, -0.4, 0.3], -3)];
      const cutout = cutBox(grid, [2, -4, -3], [9, 4, 20]);
      await scene.setAppearance({ style: { lit: true } });
      for (const view of bothWalks({ ...whole, clips: { kept, cutout } })) {
        const got = drawPicture(scene, view);
        const lit = (cuts: CutFaces) =>
          renderReference(
            { ...referenceOf(view), ...litStages(view.volume, plainOptics.transferFunction, { cuts }) },
            raysOf(view),
            width,
            height,
          ).map((x) => x * 255);
        const expected = lit({ ...uncut, halfSpaces: kept, unitToCutout: cutout.unitToBox });
        const { worst, rmse } = comparePictures(got, expected);
        console.log(`cuts: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}`);
        expect(worst).to.be.at.most(2);
        expect(comparePictures(lit(uncut), expected).worst, 'cuts show values').to.be.above(10);
      }
    }));
});

describe('the lights of a scene', () => {
  const children = `
    <navigationinfo headlight="false"></navigationinfo>
    <transform translation="1 2 3"><pointlight location="0 0 5" color="1 0.5 0" intensity="0.7"></pointlight></transform>
    <directionallight direction="0 3 4" ambientintensity="0.2"></directionallight>
    <spotlight on="false"></spotlight>
    <spotlight location="0 -50 0" direction="0 1 0" radius="70" beamwidth="0.2" cutoffangle="0.4"></spotlight>`;

  it("are the author's, where they stand; without a radius they reach everywhere", () =>
    withScene({ children }, (scene, host) => {
      drawPicture(scene, smallView({}));
      const { headlight, lights } = scene.layers[0].lights()!;
      expect(headlight).to.equal(false);
      expect(lights.map(({ kind }) => kind)).to.deep.equal(['point', 'directional', 'spot']);
      expect(lights[0]).to.deep.include({
        location: [1, 2, 8],
        intensity: 0.7,
        radius: Infinity,
        attenuation: [1, 0, 0],
      });
      expect(lights[0].color).to.deep.equal([1, 0.5, 0]);
      expect(lights[1].direction.map((x) => Math.round(x * 1e6) / 1e6)).to.deep.equal([0, 0.6, 0.8]);
      expect(lights[1].ambientIntensity).to.equal(0.2);
      expect(lights[2]).to.deep.include({ radius: 70, beamWidth: 0.2, cutOffAngle: 0.4 });
      host.querySelector('directionallight')!.setAttribute('on', 'false');
      return new Promise<void>((resolve) => setTimeout(resolve)).then(() => {
        expect(scene.layers[0].lights()!.lights.map(({ kind }) => kind)).to.deep.equal(['point', 'spot']);
      });
    }));

  it('are none but that at the eye where a scene has no shapes', () =>
    withScene({}, (scene) => {
      expect(scene.layers[0].lights()?.headlight ?? true).to.equal(true);
      expect(scene.layers[0].lights()?.lights ?? []).to.deep.equal([]);
    }));
});

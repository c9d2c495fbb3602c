// Pictures with ambient occlusion of the GPU against the twin in float64.
import { expect } from '@esm-bundle/chai';
import { ambientShade, measureAmbientLight } from '../../../src/optics/rays/ambient-light.ts';
import { uncut } from '../../../src/optics/rays/cut-fade.ts';
import type { CutFaces } from '../../../src/optics/rays/cut-fade.ts';
import { renderReference } from '../../../src/optics/reference.ts';
import { unitToWorld } from '../../../src/volume/grid.ts';
import { invertAffine, multiply } from '../../../src/volume/matrix.ts';
import { cutRegion } from '../../../src/volume/region.ts';
import { casesIn } from '../../helpers/cases.ts';
import { cutBox, keep } from '../../helpers/clips.ts';
import { litStages } from '../../helpers/lit.ts';
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
} from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { cloudCamera, cloudColors, cloudVolume } from '../../helpers/polar-cloud.ts';
import { remember } from '../../helpers/remember.ts';
import { smallView } from '../../helpers/views.ts';
import { fieldWithHole } from '../../helpers/synthetic.ts';

interface Case {
  readonly name: string;
  readonly view: () => View;
  readonly cuts?: (view: View) => CutFaces;
}

const style = { lit: 'ambient-occlusion' } as const;

const cases: Case[] = [
  { name: '8 bit', view: () => smallView({}) },
  { name: 'floats with a hole', view: () => smallView({ kind: 'float32', field: fieldWithHole }) },
  {
    name: 'a region of 16 bit, with more cells than the map',
    view: () => {
      const view = smallView({ kind: 'uint16', dimensions: [80, 40, 20], spacing: [0.3, 0.5, 0.8] });
      return { ...view, region: cutRegion(view.volume.grid, [-8, -6, -9, 9, 7, 6]) };
    },
    cuts: ({ volume, region }) => ({
      ...uncut,
      unitToRegion: multiply(invertAffine(unitToWorld(region!))!, unitToWorld(volume.grid)),
    }),
  },
  {
    name: 'a plane and a box that is cut out',
    view: () => {
      const view = smallView({});
      const { grid } = view.volume;
      return {
        ...view,
        optics: { ...plainOptics, opacityFactor: 12 },
        clips: { kept: [keep(grid, [1, -0.4, 0.3], -3)], cutout: cutBox(grid, [2, -4, -3], [9, 4, 20]) },
      };
    },
    cuts: ({ clips }) => ({ ...uncut, halfSpaces: clips!.kept!, unitToCutout: clips!.cutout!.unitToBox }),
  },
];

function draw({
  view: make,
  cuts: cutsOf = () => uncut,
}: Case): { view: View; expected: Float64Array; uncutMap: Float64Array }[] {
  const whole = make();
  const { volume, optics = plainOptics } = whole;
  const cuts = cutsOf(whole);
  const lit = litStages(volume, optics.transferFunction, { cuts });
  return bothWalks(whole).map((view) => {
    const render = (open: CutFaces): Float64Array => {
      const map = measureAmbientLight({ volume, ...optics, cuts: open });
      const shades = [...lit.shades!, ambientShade(map, volume.grid, cuts)];
      return renderReference({ ...referenceOf(view), ...lit, shades }, raysOf(view), width, height).map((x) => x * 255);
    };
    return { view, expected: render(cuts), uncutMap: render(uncut) };
  });
}

const expectationOf = remember(draw);

for (const version of [2, 1] as const) {
  describe(`ambient occlusion in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    for (const one of casesIn(version, cases, ({ cuts, name }) => cuts !== undefined || name.startsWith('floats'))) {
      it(`is the twin's: ${one.name}; and it is the same again`, async function () {
        this.timeout(120_000);
        for (const { view, expected, uncutMap } of expectationOf(one)) {
          await scene().prepare(view.volume);
          await scene().setAppearance({ style });
          const got = drawPicture(scene(), view);
          const { worst, rmse } = comparePictures(got, expected);
          expect(comparePictures(got, drawPicture(scene(), view)).worst, 'drawn again').to.equal(0);
          await scene().setAppearance({ style: { lit: true } });
          const lit = comparePictures(got, drawPicture(scene(), view));
          await scene().setAppearance({ style });
          expect(comparePictures(got, drawPicture(scene(), view)).worst, 'set again').to.equal(0);
          console.log(
            `WebGL ${version} ${one.name}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}; to the lit picture ${lit.worst} and ${lit.rmse.toFixed(1)}`,
          );
          expect(worst, 'worst pixel').to.be.at.most(2);
          expect(rmse, 'RMSE').to.be.at.most(0.5);
          expect(lit.worst, 'it is another picture than without').to.be.above(10);
          if (one.cuts) expect(comparePictures(uncutMap, expected).worst, 'cuts let light in').to.be.above(4);
        }
      });
    }

    it('follows the transfer function and the opacity, and comes back to the same picture', async () => {
      const view = smallView({});
      await scene().prepare(view.volume);
      await scene().setAppearance({ style });
      const first = drawPicture(scene(), view);
      const dense = drawPicture(scene(), { ...view, optics: { ...plainOptics, opacityFactor: 20 } });
      expect(comparePictures(first, dense).worst).to.be.above(10);
      expect(comparePictures(first, drawPicture(scene(), view)).worst).to.equal(0);
    });

    it('is left out of a radar scan, which is lit', async () => {
      const volume = cloudVolume(1);
      const optics = { ...plainOptics, transferFunction: cloudColors, referenceLength: 3000 };
      const view: View = { volume, camera: cloudCamera, stepLength: 300, optics };
      await scene().prepare(volume);
      await scene().setAppearance({ style });
      const got = drawPicture(scene(), view);
      await scene().setAppearance({ style: { lit: true } });
      expect(comparePictures(got, drawPicture(scene(), view)).worst).to.equal(0);
      expect(Math.max(...got.filter((_, i) => i % 4 < 3))).to.be.above(50);
    });
  });
}

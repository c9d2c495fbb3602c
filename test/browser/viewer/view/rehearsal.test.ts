// What is compiled for a radar before it is there.
import { expect } from '@esm-bundle/chai';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { wholeSteps } from '../../../../src/optics/cells/substeps.ts';
import { predictPolar } from '../../../../src/formats/radar/finish-polar.ts';
import { noCuts } from '../../../../src/viewer/cuts/cuts.ts';
import { readRings } from '../../../../src/viewer/cuts/read-rings.ts';
import { precompile } from '../../../../src/viewer/view/precompile.ts';
import type { Viewer } from '../../../../src/viewer/view/viewer.ts';
import type { VolumeOptics } from '../../../../src/viewer/model/volume-info.ts';
import type { Scene } from '../../../../src/viewer/model/scene.ts';
import type { VolumeScene } from '../../../../src/x3d/scene.ts';
import { comparePictures, withScene } from '../../../helpers/picture.ts';
import { readPixels } from '../../../helpers/read-pixels.ts';
import { polarScenes, radarVolume } from '../../../helpers/synthetic-radar.ts';
import { viewFromAbove } from '../../../helpers/views.ts';
import { fakeOf } from '../../../helpers/fake.ts';

const echoes: TransferFunction = [
  { value: -20, color: [0, 0.4, 1], opacity: 0 },
  { value: 17, color: [1, 0.6, 0.1], opacity: 0.1 },
  { value: 95, color: [1, 1, 1], opacity: 0.4 },
];
const volume = radarVolume(Object.values(polarScenes)[0]);
const optics: VolumeOptics = {
  transferFunction: echoes,
  window: [-20, 95],
  referenceLength: 2000,
  opacityFactor: 1,
  lightFactor: 1,
  projection: null,
  shading: 'unlit',
  surfaces: null,
};
const cuts = { ...noCuts, framed: volume.grid, rings: readRings(null, volume, null) };

/** Sources of the programs that cast rays and are linked meanwhile. */
function watchPrograms(): { readonly linked: string[]; readonly stop: () => void } {
  const prototype = WebGL2RenderingContext.prototype;
  const { linkProgram } = prototype;
  const linked: string[] = [];
  prototype.linkProgram = function (program) {
    const sources = (this.getAttachedShaders(program) ?? []).map((shader) => this.getShaderSource(shader) ?? '');
    linked.push(...sources.filter((source) => source.includes('walkRay')));
    linkProgram.call(this, program);
  };
  return { linked, stop: () => (prototype.linkProgram = linkProgram) };
}

/** Draw the radar with its rings. */
async function draw(scene: VolumeScene): Promise<ReturnType<typeof readPixels>> {
  const { camera, stepLength } = viewFromAbove(volume);
  await scene.prepare(volume, optics);
  scene.setVolume(volume);
  await scene.setAppearance({ optics });
  scene.apply({
    ...scene.plan,
    picture: { width: 60, height: 44 },
    camera,
    ground: cuts.rings,
    substeps: wholeSteps,
    stepLength,
  });
  scene.draw();
  return readPixels(scene);
}

describe("precompiling a radar's picture", () => {
  it('compiles all that casts rays, leaves nothing on the canvas, and the picture as it is', async () => {
    let alone: ReturnType<typeof readPixels>;
    await withScene({}, async (scene) => void (alone = await draw(scene)));
    await withScene({}, async (scene) => {
      const before = watchPrograms();
      const acts: Promise<void>[] = [];
      const controller = fakeOf<Viewer['controller']>('SceneController', {
        precompile: (act: (one: Scene) => Promise<void>) => void acts.push(act(scene)),
      });
      precompile(fakeOf<Viewer>('Viewer', { controller }), { volume: predictPolar(volume)!.volume, optics, cuts });
      await Promise.all(acts);
      expect(acts.length).to.equal(1);
      before.stop();
      expect(before.linked.length, 'one program casts rays').to.equal(1);
      expect(
        readPixels(scene).every((x) => x === 0),
        'nothing is left',
      ).to.equal(true);
      const after = watchPrograms();
      const picture = await draw(scene);
      after.stop();
      expect(after.linked.length).to.equal(0);
      expect(
        picture.some((x) => x > 100),
        'something is seen',
      ).to.equal(true);
      expect(comparePictures(picture, alone).worst).to.equal(0);
    });
  });

  it('is not missed where there is none: shapes are expected in the first picture, and no program is compiled in vain', () =>
    withScene({}, async (scene) => {
      const { linked, stop } = watchPrograms();
      await draw(scene);
      stop();
      expect(linked.length).to.equal(1);
    }));
});

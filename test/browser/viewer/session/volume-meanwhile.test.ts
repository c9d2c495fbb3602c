import { rotate } from '../../../../src/viewer/camera/camera-moves.ts';
import { expect } from '@esm-bundle/chai';
import { noCuts } from '../../../../src/viewer/cuts/cuts.ts';
import type { AuthorCamera, Scene } from '../../../../src/viewer/model/scene.ts';
import { SourceLoader } from '../../../../src/viewer/session/source-loader.ts';
import type { LoaderHost, LoaderParts } from '../../../../src/viewer/session/source-loader.ts';
import { Viewer } from '../../../../src/viewer/view/viewer.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { fakeOf, fakePlace, fakeScene } from '../../../helpers/fake.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';
import { greyOptics as optics } from '../../../helpers/view-settings.ts';

const coarse: Volume = { ...syntheticVolume({ dimensions: [4, 4, 4] }), coarse: true };
const whole = syntheticVolume({ dimensions: [8, 8, 8] });

const settle = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

async function turns(count: number): Promise<void> {
  for (let i = 0; i < count; i++) await Promise.resolve();
}

/** A viewer in sight, and the volumes that its scenes are given. @param author - the author's viewpoint */
function view(author: AuthorCamera | null = null): { viewer: Viewer; volumes: Volume[] } {
  const volumes: Volume[] = [];
  const create = async (): Promise<Scene> =>
    fakeScene({
      canvas: document.createElement('canvas'),
      prepare: () => turns(2),
      animating: false,
      setAppearance: async () => {},
      bringVolume: async (one: Volume, givenUp: () => boolean) => !givenUp() && volumes.push(one) > 0,
      authorCamera: () => author,
      dispose: () => {},
    });
  return {
    viewer: new Viewer(fakePlace(create), {
      rendered: () => {},
      cameraMoved: () => {},
      labelRing: () => '',
      drawingFailed: () => {},
    }),
    volumes,
  };
}

it('a scene that is just getting ready has the volume that the viewer shows, whenever that took the place of its stand-in', async () => {
  for (let later = 0; later < 16; later++) {
    const { viewer, volumes } = view();
    viewer.expect(true);
    await settle();
    void viewer.show(coarse, optics, () => noCuts);
    await turns(later);
    void viewer.show(whole, optics, () => noCuts);
    await settle();
    expect([viewer.volume === whole, volumes.at(-1) === whole], `${later} turns later`).to.deep.equal([true, true]);
    viewer.dispose();
  }
});

it('a person who turns a stand-in around the viewpoint of the author keeps what they see', async () => {
  const frame = {
    frame: [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ],
    target: [0, 0, 0],
    fieldOfView: 1,
    radius: 20,
  } as const;
  const { viewer } = view({
    camera: { eye: [0, 0, 20], target: [0, 0, 0], up: [0, 1, 0], fieldOfView: 1 },
    centerOfRotation: null,
    around: () => frame,
  });
  await viewer.show({ ...whole, coarse: true }, optics, () => noCuts);
  await settle();
  rotate(viewer.rig, 0.5, 0);
  viewer.rig.advance(0, true);
  await viewer.show(whole, optics, () => noCuts);
  expect([viewer.leftAttributes, viewer.rig.orbit.theta]).to.deep.equal([true, 0.5]);
  viewer.dispose();
});

it('nothing stays of a stand-in whose source is taken away', () => {
  const reported: string[] = [];
  const host = fakeOf<LoaderHost>('LoaderHost', {
    settings: { src: null },
    inPage: true,
    sourceGone: () => reported.push('gone'),
  });
  const presenter = fakeOf<LoaderParts['presenter']>('VolumePresenter', {
    volume: null,
    viewer: { volume: coarse },
    forgetModel: () => {},
    empty: () => reported.push('emptied'),
  });
  const parts = fakeOf<LoaderParts>('LoaderParts', {
    presenter,
    errors: { clear: () => {} },
    playback: { forget: () => {} },
  });
  new SourceLoader(host, parts).load();
  expect(reported).to.deep.equal(['emptied', 'gone']);
});

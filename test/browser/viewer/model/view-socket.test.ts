// A toy thing in the picture joins a view: it is in each scene, is placed after each picture, knows the volume, and leaves.
import { expect } from '@esm-bundle/chai';
import { noCuts } from '../../../../src/viewer/cuts/cuts.ts';
import { ErrorState } from '../../../../src/viewer/model/error-state.ts';
import type { Scene, View } from '../../../../src/viewer/model/scene.ts';
import { socketOf, standIn, ViewSocket } from '../../../../src/viewer/model/view-socket.ts';
import type { ViewPart } from '../../../../src/viewer/model/view-socket.ts';
import type { ShownSurface } from '../../../../src/renderer/layers/shown-surfaces.ts';
import { VolumePresenter } from '../../../../src/viewer/view/volume-presenter.ts';
import type { PresenterHost } from '../../../../src/viewer/view/volume-presenter.ts';
import { Viewer } from '../../../../src/viewer/view/viewer.ts';
import { fakeOf, fakePlace } from '../../../helpers/fake.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';
import { greyOptics as optics } from '../../../helpers/view-settings.ts';

const volume = syntheticVolume({ dimensions: [8, 8, 8] });
const wait = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

/** A view whose scenes draw nothing and note what parts do with them. */
function makeView() {
  const host = document.createElement('div');
  const did: string[] = [];
  const scenes: Scene[] = [];
  const create = async (): Promise<Scene> => {
    const scene = fakeOf<Scene & { name: string }>('Scene', {
      name: `scene ${scenes.length + 1}`,
      canvas: document.createElement('canvas'),
      prepare: async () => {},
      setAppearance: async () => {},
      bringVolume: async () => did.push('volume') > 0,
      authorCamera: () => null,
      getView: () => fakeOf<View>('View', {}),
      twins: () => null,
      dispose: () => {},
    });
    scenes.push(scene);
    return scene;
  };
  const place = fakePlace(create, host);
  const errors = new ErrorState({ file: '', changed: () => {}, failed: (_, error) => did.push(error.message) });
  const presenter = new VolumePresenter(
    fakeOf<PresenterHost>('PresenterHost', { host, settings: {}, awake: true, emit: () => {}, track: () => {} }),
    errors,
  );
  const viewer = (presenter.viewer = new Viewer(place, {
    rendered: () => {},
    cameraMoved: () => {},
    labelRing: () => '',
    drawingFailed: (error) => errors.report('scene', error),
  }));
  viewer.loop.end(); // Nothing here draws pictures.
  return { host, did, scenes, viewer };
}

const nameOf = (scene: Scene): string => (scene as Scene & { readonly name: string }).name;

class Toy implements ViewPart {
  readonly key = 'toy';
  at = 'here';

  constructor(readonly did: string[]) {}

  apply(scene: Scene): void {
    this.did.push(`${this.at} in ${nameOf(scene)}`);
  }

  remove(scene: Scene): void {
    this.did.push(`out of ${nameOf(scene)}`);
  }

  place(): void {
    this.did.push('placed');
  }
}

describe('a part of a view', () => {
  it('is in each scene before its volume, is put there again when it changes, and is gone from it when it leaves', async () => {
    const { host, did, scenes, viewer } = makeView();
    const socket = socketOf(host);
    const toy = new Toy(did);
    await socket.join(toy);
    expect([socket.volume, did], 'before there is a volume').to.deep.equal([null, []]);
    await viewer.show(volume, optics, () => noCuts);
    viewer.invalidate();
    while (!viewer.scene) await wait();
    expect(did).to.deep.equal(['here in scene 1', 'volume']);
    expect(socket.view!.viewer!.volume).to.equal(volume);
    toy.at = 'there';
    await socket.update(toy);
    expect(did.slice(2)).to.deep.equal(['placed', 'there in scene 1']);
    scenes[0].canvas.dispatchEvent(new Event('webglcontextlost'));
    while (!viewer.scene || viewer.scene === scenes[0]) await wait();
    expect(did.slice(4), 'a scene after a lost context').to.deep.equal(['there in scene 2', 'volume']);
    await socket.leave(toy);
    await socket.leave(toy);
    await socket.update(toy);
    expect([did.slice(6), socket.parts], 'it leaves once').to.deep.equal([['out of scene 2'], []]);
    viewer.dispose();
  });

  it('that changes while a scene is built is in it as it is then, and one that leaves meanwhile is not', async () => {
    const socket = new ViewSocket();
    const did: string[] = [];
    const [toy, other] = [new Toy(did), new Toy(did)];
    void socket.join(toy);
    void socket.join(other);
    const scene = fakeOf<Scene & { name: string }>('Scene', { name: 'a scene' });
    const before = socket.version;
    await socket.applyTo(scene);
    toy.at = 'there';
    void socket.update(toy);
    void socket.leave(other);
    expect(socket.version, 'who builds the scene looks again').to.be.above(before);
    await socket.applyTo(scene);
    await socket.applyTo(scene);
    expect(did).to.deep.equal(['here in a scene', 'here in a scene', 'out of a scene', 'there in a scene']);
  });

  it('is placed after each picture, in the order in which parts came, except the first; what one throws stops neither the others nor the frame', async () => {
    const socket = new ViewSocket();
    const did: string[] = [];
    const view = {} as View;
    void socket.join({ key: 'a', place: (one) => did.push(`a ${one === view}`) });
    void socket.join({
      key: 'b',
      place: () => {
        throw new Error('a defect');
      },
    });
    void socket.join({ key: 'c', place: () => did.push('c') }, true);
    const { error } = console;
    const said: unknown[] = [];
    console.error = (one: unknown) => said.push((one as Error).message);
    try {
      socket.place(view);
    } finally {
      console.error = error;
    }
    expect([did, said]).to.deep.equal([['c', 'a true'], ['a defect']]);
  });

  it('says what it has to who asks: of several the last one', () => {
    const host = document.createElement('div');
    const socket = socketOf(host);
    const surface = {} as ShownSurface;
    const legend = document.createElement('p');
    void socket.join({ key: 'volume-surface', surface, cursor: [1, 2, 3] });
    void socket.join({ key: 'volume-legend', element: legend, surface: null, cursor: [4, 5, 6] });
    expect([socket.last('surface'), socket.last('cursor'), socket.last('overlay')]).to.deep.equal([
      surface,
      [4, 5, 6],
      null,
    ]);
    void socket.join({ key: 'atlas', attribute: (property) => (property === 'src' ? 'ct.png' : null) });
    expect([standIn(host, 'src'), standIn(host, 'alt')]).to.deep.equal(['ct.png', null]);
    expect(socketOf(host), 'one for each element').to.equal(socket);
    expect(socketOf(document.createElement('div'))).not.to.equal(socket);
  });
});

import { expect } from '@esm-bundle/chai';
import { buildScene } from '../../../../src/viewer/scenes/build-scene.ts';
import type { SceneContents } from '../../../../src/viewer/scenes/build-scene.ts';
import { PresenterTarget } from '../../../../src/viewer/attachments/label-target.ts';
import type { Scene } from '../../../../src/viewer/model/scene.ts';
import type { ViewLabels } from '../../../../src/viewer/model/view-labels.ts';
import { ViewSocket } from '../../../../src/viewer/model/view-socket.ts';
import { fakeOf, fakeScene, fakeSocketView, fakeSocketViewer } from '../../../helpers/fake.ts';

/** Labels that are told from others by their ids. */
const labelsOf = (name: string): ViewLabels =>
  fakeOf<ViewLabels>('ViewLabels', {
    shown: { map: { ids: Array.from(name, (letter) => letter.charCodeAt(0)) } },
    nameOf: () => null,
  });

it('a new scene, such as one after a lost context, gets the labels, and what becomes of them while it is built', async () => {
  const [first, second] = ['one', 'two'].map(labelsOf);
  const socket = new ViewSocket();
  socket.view = fakeSocketView({ viewer: null, look: { attachmentsChanged: () => {} } });
  const target = new PresenterTarget(socket);
  await target.show(first);
  const reported: unknown[] = [];
  const scene = fakeScene({
    prepare: async () => {},
    setAppearance: async () => {},
    setLabels: async (labels: unknown) => void reported.push(labels),
    bringVolume: async () => {
      await target.show(second);
      return true;
    },
    dispose: () => reported.push('disposed'),
  });
  const contents = fakeOf<SceneContents>('SceneContents', {
    volume: {},
    optics: { projection: null },
    socket,
    givenUp: false,
  });
  let put: unknown = null;
  const build = (one: Scene): Promise<void> =>
    buildScene(
      async () => one,
      contents,
      async () => true,
      (built) => (put = built),
    );
  await build(scene);
  expect(put).to.equal(scene);
  expect(reported).to.deep.equal([first.shown, second.shown]);
  const gone = fakeScene({ ...scene, bringVolume: async () => (await target.show(null), true) });
  await build(gone);
  expect(reported.slice(2), 'nor does it keep those that are gone by then').to.deep.equal([second.shown, null]);
  await build(gone);
  expect(reported.slice(4), 'and where there are none nothing of them is loaded').to.deep.equal([]);
});

it('labels that come after a new scene has looked for them, and before it is in place, reach it', async () => {
  const reported: unknown[] = [];
  const scene = fakeScene({ setLabels: async (labels) => void reported.push(labels) });
  const given = { scene: null as Scene | null, invalidate: () => reported.push('drawn anew') };
  const socket = new ViewSocket();
  socket.view = fakeSocketView({ viewer: fakeSocketViewer(given), look: { attachmentsChanged: () => {} } });
  const labels = labelsOf('one');
  const applied = new PresenterTarget(socket).show(labels);
  await Promise.resolve();
  given.scene = scene;
  await applied;
  expect(reported).to.deep.equal([labels.shown, 'drawn anew']);
});

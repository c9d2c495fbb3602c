import { expect } from '@esm-bundle/chai';
import { contextPool, maxContexts } from '../../../../src/viewer/scenes/context-pool.ts';
import type { ContextHolder } from '../../../../src/viewer/scenes/context-pool.ts';
import type { Scene } from '../../../../src/viewer/model/scene.ts';
import { ViewSocket } from '../../../../src/viewer/model/view-socket.ts';
import { SceneController } from '../../../../src/viewer/scenes/scene-controller.ts';
import type { SceneUser } from '../../../../src/viewer/scenes/scene-controller.ts';
import type { VolumeOptics } from '../../../../src/viewer/model/volume-info.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { fakeOf, fakePlace, fakeScene } from '../../../helpers/fake.ts';
import type { Some } from '../../../helpers/fake.ts';

const settle = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

/** A keeper in sight whose scenes tell what happens to them. */
function keep(refusals = 0): {
  controller: SceneController;
  reported: string[];
  user: { volume: unknown; ready: boolean };
} {
  const reported: string[] = [];
  const notify = (what: string) => (): void => void reported.push(what);
  const create = async (): Promise<Scene> => {
    if (refusals-- > 0) throw new Error('no context');
    reported.push('made');
    const canvas = document.createElement('canvas');
    return fakeScene({
      canvas,
      prepare: async () => {},
      setAppearance: async () => {},
      bringVolume: async () => (reported.push('filled'), true),
      dispose: notify('gone'),
    });
  };
  const user = {
    volume: null as Some<Volume> | null,
    optics: null as Some<VolumeOptics> | null,
    ready: false,
    givenUp: false,
    socket: new ViewSocket(),
    loop: { unfinished: true, drawing: null, plan: notify('planned'), wake: () => {}, rest: () => {} },
    applyTo: () => {},
    entered: notify('entered'),
    failed: notify('failed'),
    invalidate: () => {},
    sceneChanged: () => {},
  };
  const controller = new SceneController(fakePlace(create), fakeOf<SceneUser>('SceneUser', user));
  return { controller, reported, user };
}

describe('a scene for a volume that is on its way', () => {
  it('is made meanwhile, and filled when the volume is there', async () => {
    const { controller, reported, user } = keep();
    await settle();
    expect(reported, 'nothing is expected yet').to.deep.equal([]);
    controller.expect(true);
    controller.expect(true);
    await settle();
    expect(reported).to.deep.equal(['made']);
    expect(controller.busy, 'it can be taken').to.equal(false);
    Object.assign(user, { ready: true, volume: {}, optics: {} });
    controller.expect(false);
    await settle();
    expect(reported).to.deep.equal(['made', 'filled', 'entered', 'planned']);
    controller.dispose();
  });

  it('goes where the volume does not come', async () => {
    const { controller, reported } = keep();
    controller.expect(true);
    await settle();
    controller.expect(false);
    await settle();
    expect(reported).to.deep.equal(['made', 'gone']);
    controller.expect(true);
    await settle();
    expect(reported, 'and the next one gets one of its own').to.deep.equal(['made', 'gone', 'made']);
    controller.dispose();
    await settle();
    expect(reported.at(-1)).to.equal('gone');
  });

  it('gives its context to whoever has something to show', async () => {
    const { controller, reported } = keep();
    controller.expect(true);
    await settle();
    let entered = 0;
    const others = Array.from({ length: maxContexts }, (): ContextHolder => ({
      inSight: true,
      asked: false,
      mayHold: true,
      need: 'picture',
      busy: true,
      enter: () => entered++,
      leave: () => {},
    }));
    others.forEach((other) => contextPool.add(other));
    await settle();
    expect(entered).to.equal(maxContexts);
    expect(reported).to.deep.equal(['made', 'gone']);
    others.forEach((other) => contextPool.remove(other));
    await settle();
    expect(reported, 'as soon as there is room').to.deep.equal(['made', 'gone', 'made']);
    controller.dispose();
  });

  it('is there whenever the next volume is expected after one that did not come', async () => {
    for (let later = 0; later < 12; later++) {
      const { controller, reported, user } = keep();
      controller.expect(true);
      await settle();
      controller.expect(false);
      for (let i = 0; i < later; i++) await Promise.resolve();
      controller.expect(true);
      await settle();
      Object.assign(user, { ready: true, volume: {}, optics: {} });
      controller.review();
      await settle();
      expect(
        reported.filter((what) => what === 'entered'),
        `${later} turns later: ${reported.join(' ')}`,
      ).to.deep.equal(['entered']);
      controller.dispose();
    }
  });

  it('is one scene, whenever the volume comes while others want the context', async () => {
    for (let later = 0; later < 12; later++) {
      const { controller, reported, user } = keep();
      controller.expect(true);
      await settle();
      const others = Array.from({ length: maxContexts }, (): ContextHolder => ({
        inSight: true,
        asked: false,
        mayHold: true,
        need: 'picture',
        busy: false,
        enter: () => {},
        leave: () => {},
      }));
      others.forEach((other) => contextPool.add(other));
      for (let i = 0; i < later; i++) await Promise.resolve();
      Object.assign(user, { ready: true, volume: {}, optics: {} });
      controller.review();
      await settle();
      others.forEach((other) => contextPool.remove(other));
      await settle();
      const count = (what: string): number => reported.filter((one) => one === what).length;
      expect(
        [count('entered'), count('made') - count('gone')],
        `${later} turns later: ${reported.join(' ')}`,
      ).to.deep.equal([1, 1]);
      controller.dispose();
    }
  });

  it('that can not be made is reported when the volume is there, and then once', async () => {
    const { controller, reported, user } = keep(2);
    controller.expect(true);
    await settle();
    expect([reported, controller.hasFailed]).to.deep.equal([[], true]);
    Object.assign(user, { ready: true, volume: {}, optics: {} });
    controller.clearErrors();
    controller.review();
    await settle();
    expect(reported).to.deep.equal(['failed']);
    controller.dispose();
  });
});

// When a surface is cut anew: with its volume, once a frame, and more rarely where it takes long; whole again without.
import { expect } from '@esm-bundle/chai';
import { ErrorState } from '../../../../src/viewer/model/error-state.ts';
import { SurfaceController } from '../../../../src/viewer/attachments/surface-controller.ts';
import { SurfaceTarget } from '../../../../src/viewer/attachments/surface-target.ts';
import { socketOf } from '../../../../src/viewer/model/view-socket.ts';
import type { Surface } from '../../../../src/volume/surface.ts';
import type { WorldCut } from '../../../../src/volume/world-cut.ts';
import type { GridFrame } from '../../../../src/volume/grid.ts';
import { fakeOf, fakeScene, fakeSocketView, fakeSocketViewer } from '../../../helpers/fake.ts';
import { ballPly, surfaceOf, trianglesOf } from '../../../helpers/meshes.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const nothing: WorldCut = { kept: [], removed: null };
const above = (at: number): WorldCut => ({ ...nothing, kept: [{ normal: [0, 0, 1], at }] });

/** A view without a picture, and a surface's place in it. */
function createView() {
  const host = document.createElement('div');
  const socket = socketOf(host);
  const volume = syntheticVolume({ dimensions: [20, 20, 20] });
  const shown = { cuts: { region: null as GridFrame | null, away: nothing } };
  const settings = { region: { value: null as readonly number[] | null } };
  const work: Promise<unknown>[] = [];
  const viewer = fakeSocketViewer({
    volume,
    shown,
    scene: fakeScene({ loadLines: async () => null }),
    invalidate: () => {},
    drawn: null,
    reframe: () => {},
  });
  socket.view = fakeSocketView({
    host,
    look: { attachmentsChanged: () => {} },
    awake: true,
    errors: new ErrorState({ file: '', changed: () => {}, failed: () => {} }),
    settings,
    viewer,
    volume,
    track: (one: Promise<unknown>) => work.push(one),
    fileNotices: new Map(),
    user: { changed: () => {} },
  });
  const target = new SurfaceTarget(socket, document.createElement('i'));
  return {
    socket,
    target,
    shown,
    settings,
    work,
    /** As the viewer does. */
    cut: (away: WorldCut): Promise<unknown> => {
      shown.cuts = { ...shown.cuts, away };
      for (const part of socket.parts) part.cutsChanged?.();
      return Promise.all(work);
    },
    /** The lowest place of what is in the picture; null where that is nothing. */
    get lowest(): number | null {
      const one = socket.last('surface');
      return one
        ? Math.min(
            ...trianglesOf(one.surface)
              .flat()
              .map(([, , z]) => z),
          )
        : null;
    },
  };
}

/** Runs a test with time that only passes where it says so, of the page's clock and timers. */
async function withClock(
  test: (clock: { now: number; pass: (ms: number) => Promise<void> }) => Promise<void>,
): Promise<void> {
  const [now, timeout] = [performance.now.bind(performance), globalThis.setTimeout.bind(globalThis)];
  let timers: { at: number; act: () => void }[] = [];
  const clock = {
    now: 1000,
    pass: async (ms: number): Promise<void> => {
      for (let left = ms; left > 0; left--) {
        clock.now++;
        const due = timers.filter(({ at }) => at <= clock.now);
        timers = timers.filter((one) => !due.includes(one));
        for (const { act } of due) act();
        await new Promise((resolve) => timeout(resolve));
      }
    },
  };
  performance.now = () => clock.now;
  globalThis.setTimeout = ((act: () => void, ms: number) =>
    timers.push({ at: clock.now + ms, act })) as unknown as typeof globalThis.setTimeout;
  try {
    await test(clock);
  } finally {
    [performance.now, globalThis.setTimeout] = [now, timeout];
  }
}

/** The clock of the page's frames has gone on. */
async function nextFrame(): Promise<void> {
  const before = document.timeline.currentTime;
  while (document.timeline.currentTime === before) await new Promise((resolve) => requestAnimationFrame(resolve));
}

describe('a surface that is cut with its volume', () => {
  it('is cut by what cuts it, region as well, is gone where nothing is left, and whole again without', async () => {
    const view = createView();
    const { socket, target, shown, settings, work } = view;
    let isCut = true;
    const controller = new SurfaceController({
      localName: 'volume-surface',
      wanted: () => ({
        request: { surface: 'mesh', url: `data:text/plain,${encodeURIComponent(ballPly([0, 0, 0], 5))}`, space: null },
        look: { color: [1, 0, 0], usesOwnColors: false, isCut },
      }),
      target: () => target,
      came: () => {},
      progress: () => {},
      failed: (error) => expect.fail(String(error)),
    });
    shown.cuts.away = above(1);
    controller.refresh();
    await Promise.all(work);
    expect(view.lowest).to.be.closeTo(1, 1e-6);
    const { places, cut } = socket.last('surface')!;
    expect(
      places!.some(([, , z]) => z < -4.9),
      'cameras frame the whole',
    ).to.equal(true);
    expect([cut!.away, cut!.whole]).to.deep.equal([above(1), controller.surface]);

    await view.cut(above(-2));
    expect(view.lowest).to.be.closeTo(-2, 1e-6);
    const before = socket.version;
    await view.cut(above(-2));
    expect(socket.version, 'nothing has changed').to.equal(before);
    await view.cut(above(6));
    expect(socket.last('surface')).to.equal(null);
    [shown.cuts.region, settings.region.value] = [fakeOf<GridFrame>('GridFrame', {}), [-9, -9, 3, 9, 9, 9]];
    await view.cut({
      ...nothing,
      removed: [
        [-9, 9],
        [-9, 9],
        [0, 4],
      ],
    });
    expect(view.lowest).to.be.closeTo(4, 1e-6);

    isCut = false;
    controller.refresh();
    await Promise.all(work);
    expect(socket.last('surface')!.surface).to.equal(controller.surface);
    await view.cut(above(0));
    expect(socket.last('surface')!.surface, 'nothing cuts it').to.equal(controller.surface);
    shown.cuts.away = {
      ...nothing,
      removed: [
        [-9, 9],
        [-9, 9],
        [0, 4],
      ],
    };
    isCut = true;
    controller.refresh();
    await Promise.all(work);
    expect(view.lowest).to.be.closeTo(4, 1e-6);
    controller.leave(target);
    expect(socket.parts).to.deep.equal([]);
  });

  it('follows once in a frame, and the last word holds', () =>
    withClock(async (clock) => {
      const view = createView();
      await view.target.prepareCuts();
      await view.target.show({
        surface: await surfaceOf(ballPly([0, 0, 0], 5)),
        color: [1, 1, 1],
        usesOwnColors: false,
        isCut: true,
      });
      await nextFrame();
      const before = view.socket.version;
      for (let i = 0; i < 10; i++) void view.cut(above(i / 10));
      expect(view.socket.version - before).to.equal(1);
      expect(view.lowest, 'the first at once').to.be.closeTo(0, 1e-6);
      await clock.pass(20);
      expect(view.socket.version - before).to.equal(2);
      expect(view.lowest).to.be.closeTo(0.9, 1e-6);
      // Frame by frame, though each change comes before another one would be due.
      for (let i = 1; i < 5; i++) {
        await nextFrame();
        void view.cut(above(-i));
        expect(view.lowest).to.be.closeTo(-i, 1e-6);
      }
      await Promise.all(view.work);
    }));

  it('that takes long is cut again when a drag pauses, or has gone on for ten times as long', () =>
    withClock(async (clock) => {
      const view = createView();
      const ball = await surfaceOf(ballPly([0, 0, 0], 5));
      let takes = 15;
      const slow: Surface = {
        ...ball,
        get parts() {
          clock.now += takes;
          return ball.parts;
        },
      };
      await view.target.prepareCuts();
      view.shown.cuts.away = above(0);
      await view.target.show({ surface: slow, color: [1, 1, 1], usesOwnColors: false, isCut: true });
      await clock.pass(5);
      for (let i = 1; i < 4; i++) {
        void view.cut(above(i));
        await clock.pass(30);
        expect(view.lowest, 'the last cut stays').to.be.closeTo(0, 1e-6);
      }
      await clock.pass(100);
      expect(view.lowest, 'not yet').to.be.closeTo(0, 1e-6);
      await clock.pass(25);
      expect(view.lowest, 'a pause').to.be.closeTo(3, 1e-6);
      await clock.pass(2000);
      void view.cut(above(-1));
      expect(view.lowest, 'after a long rest at once').to.be.closeTo(-1, 1e-6);
      const seen = new Set<number | null>();
      for (let i = 0; i < 100; i++) {
        void view.cut(above(i / 1000));
        seen.add(view.lowest);
        await clock.pass(10);
      }
      expect(seen.size, 'a drag without a pause').to.be.within(3, 6);
      await clock.pass(160);
      expect(view.lowest).to.be.closeTo(0.099, 1e-6);
      // One that takes no longer than a frame may follows in each frame again.
      takes = 0;
      void view.cut(above(2));
      await clock.pass(160);
      await nextFrame();
      void view.cut(above(3));
      expect(view.lowest).to.be.closeTo(3, 1e-6);
      await view.target.leave();
      await Promise.all(view.work);
    }));
});

import { expect } from '@esm-bundle/chai';
import { longestDiagonal } from '../../../../src/volume/grid.ts';
import type { Gl } from '../../../../src/renderer/device/device.ts';
import { GpuTimer } from '../../../../src/renderer/device/gpu-timer.ts';
import { changePlan, drawAt } from '../../../helpers/change-plan.ts';
import { fakeTimerQueries } from '../../../helpers/fake-timer-queries.ts';
import type { FakeTimes } from '../../../helpers/fake-timer-queries.ts';
import { plainOptics, withScene } from '../../../helpers/picture.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const extensionNames = { 1: 'EXT_disjoint_timer_query', 2: 'EXT_disjoint_timer_query_webgl2' } as const;

/** Use a context that is given back at once. */
function withContext<T>(version: 1 | 2, use: (gl: Gl) => T): T {
  const gl = document.createElement('canvas').getContext(version === 2 ? 'webgl2' : 'webgl') as Gl;
  try {
    return use(gl);
  } finally {
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
}

const nextTurn = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

for (const version of [1, 2] as const) {
  const start = (times: FakeTimes = {}) => {
    const fake = fakeTimerQueries(version, times);
    return { ...fake, timer: GpuTimer.create(fake.gl)! };
  };

  describe(`the GPU's time by timer queries, WebGL ${version}`, () => {
    it('is null where there are none, or none that count', () => {
      const withNone = Object.assign(fakeTimerQueries(version).gl, { getExtension: () => null });
      expect(GpuTimer.create(withNone)).to.equal(null);
      expect(GpuTimer.create(fakeTimerQueries(version, { bits: 0 }).gl)).to.equal(null);
    });

    for (const turns of [0, 1, 3]) {
      it(`is reported once, where its result is there after ${turns} turns of the loop`, async () => {
        const { timer, alive } = start({ turns, nanoseconds: 7_250_000 });
        timer.begin();
        timer.end();
        expect(await timer.read()).to.equal(7.25);
        expect(alive.size).to.equal(0);
        expect(await timer.read(), 'again').to.equal(null);
      });
    }

    it('is given up where no result comes', async () => {
      const { timer, alive } = start({ turns: Infinity });
      timer.begin();
      timer.end();
      expect(await timer.read()).to.equal(null);
      expect(alive.size).to.equal(0);
    });

    it('is void where the GPU was disjoint, and holds again for the drawing after', async () => {
      const { timer, alive } = start({ disjoint: true });
      for (const expected of [null, 5]) {
        timer.begin();
        timer.end();
        expect(await timer.read()).to.equal(expected);
        expect(alive.size).to.equal(0);
      }
    });

    it('is of the last drawing, and one query lives at most', async () => {
      const { timer, alive } = start();
      for (let drawing = 0; drawing < 3; drawing++) {
        timer.begin();
        timer.end();
        expect(alive.size).to.equal(1);
      }
      expect(await timer.read()).to.equal(5);
      timer.begin();
      timer.end();
      const interrupted = timer.read();
      timer.begin();
      timer.end();
      expect(await interrupted, 'of a drawing that another followed').to.equal(null);
      expect(await timer.read()).to.equal(5);
      expect(alive.size).to.equal(0);
    });

    it('leaves nothing behind when disposed, while a result is on its way too', async () => {
      const { timer, alive } = start();
      timer.begin();
      timer.end();
      const read = timer.read();
      await nextTurn();
      timer.dispose();
      expect(await read).to.equal(null);
      expect(alive.size).to.equal(0);
      timer.dispose();
    });

    it('takes no harm from a lost context, before a drawing, in it, and while a result is on its way', async () => {
      for (const when of ['before', 'in', 'after'] as const) {
        const { timer, lose } = start();
        if (when === 'before') lose();
        timer.begin();
        if (when === 'in') lose();
        timer.end();
        const read = timer.read();
        if (when === 'after') lose();
        expect(await read, when).to.equal(null);
        timer.begin();
        timer.end();
        expect(await timer.read(), `${when}, the drawing after`).to.equal(null);
        timer.dispose();
      }
    });
  });

  describe(`the GPU's time of a scene, WebGL ${version}`, () => {
    const volume = syntheticVolume({
      dimensions: [20, 24, 28],
      field: (x, y, z) => Math.exp(-8 * ((x - 0.4) ** 2 + (y - 0.5) ** 2 + (z - 0.6) ** 2)),
    });

    it("grows with the picture and is within the clock's, where this browser has timer queries; null where it has none", () =>
      withScene({ webgl1: version === 1 }, async (scene) => {
        scene.setVolume(volume);
        void scene.setAppearance({ optics: plainOptics });
        const measure = async (pixels: number, steps: number) => {
          changePlan(scene, { picture: { width: pixels, height: pixels } });
          const began = performance.now();
          drawAt(scene, longestDiagonal(volume.grid) / steps);
          await scene.finished();
          return { clock: performance.now() - began, gpu: await scene.gpuMs() };
        };
        // The scene loads its timer by itself, and draws without it until then.
        await import('../../../../src/renderer/device/gpu-timer.ts');
        await nextTurn();
        await measure(8, 8); // Compiles.
        const [small, large] = [await measure(8, 8), await measure(150, 150)]; // 6,600 times the samples.
        if (withContext(version, (gl) => gl.getExtension(extensionNames[version])) === null) {
          expect([small.gpu, large.gpu]).to.deep.equal([null, null]);
          return;
        }
        expect(small.gpu).to.be.a('number');
        expect(large.gpu!).to.be.above(small.gpu!);
        // Times of the GPU are rounded against attacks by time.
        expect(large.gpu!).to.be.at.most(large.clock + 1);
        expect(await scene.gpuMs(), 'again').to.equal(null);
      }));
  });
}

// The viewer with scenes that draw nothing: what it asks of them, and when.
import { expect } from '@esm-bundle/chai';
import { asVolumeViewError, VolumeViewError } from '../../../../src/core/errors.ts';
import { Visibility } from '../../../../src/viewer/scenes/visibility.ts';
import type { RayStyle } from '../../../../src/optics/rays/ray-style.ts';
import type { FramePlan } from '../../../../src/viewer/model/frame-plan.ts';
import type { RenderStats } from '../../../../src/viewer/model/render-stats.ts';
import type { Scene, SceneFactory } from '../../../../src/viewer/model/scene.ts';
import { noCuts } from '../../../../src/viewer/cuts/cuts.ts';
import { Viewer } from '../../../../src/viewer/view/viewer.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';
import { greyOptics as optics } from '../../../helpers/view-settings.ts';

const volume = syntheticVolume({ dimensions: [8, 8, 8] });

/** A scene without a picture, which counts what it is told. */
class FakeScene {
  readonly canvas = document.createElement('canvas');
  readonly device = { maxTextureSize: 4096, webgl2: true };
  readonly animating = false;
  readonly adaptive = false;
  readonly gatherable = false;
  readonly volumes: Volume[] = [];
  readonly widths: number[] = [];
  draws = 0;
  isDisposed = false;

  constructor(readonly factory: FakeFactory) {
    factory.made.push(this);
  }

  async prepare(): Promise<void> {}

  async bringVolume(one: Volume, givenUp: () => boolean): Promise<boolean> {
    await Promise.resolve();
    if (this.factory.loses > 0) {
      this.factory.loses--;
      return false;
    }
    if (givenUp()) return false;
    this.volumes.push(one);
    return true;
  }

  projections: (string | null)[] = [];

  async setAppearance({ style }: { style?: RayStyle | null }): Promise<void> {
    await Promise.resolve();
    const projection = style?.projection ?? null;
    if (projection !== this.projections.at(-1)) this.projections.push(projection);
  }
  async setLabels(): Promise<void> {}
  loadLines(): Promise<null> {
    return Promise.resolve(null);
  }
  async othersReady(): Promise<void> {}

  detail(): null {
    return null;
  }

  twins(): null {
    return null;
  }

  resetAuthorCamera(): void {}

  authorCamera(): null {
    return null;
  }

  apply({ picture: { width, height } }: FramePlan): void {
    [this.canvas.width, this.canvas.height] = [width, height];
  }

  getView(): object {
    return {};
  }

  getRays(): null {
    return null;
  }

  viewAt(): object {
    return {};
  }

  whatIsSeen(): null {
    return null;
  }

  draw(): void {
    this.draws++;
    this.widths.push(this.canvas.width);
    if (this.factory.failure) throw this.factory.failure;
  }

  readonly finished = (): Promise<unknown> => new Promise((resolve) => setTimeout(resolve, 1));

  async gpuMs(): Promise<number> {
    return 1;
  }

  probe(): null {
    return null;
  }

  readPicture(): object {
    const { width, height } = this.canvas;
    return { data: new Uint8Array(width * height * 4), width, height };
  }

  startReading(): () => object {
    return () => this.readPicture();
  }

  readVolume(): null {
    return null;
  }

  dispose(): void {
    this.isDisposed = true;
  }
}

class FakeFactory implements SceneFactory {
  readonly made: FakeScene[] = [];
  /** Contexts that are lost while a volume is on its way. */
  loses = 0;
  /** Thrown by drawing. */
  failure: Error | null = null;
  /** Thrown by making a scene. */
  refusal: Error | null = null;

  async create(): Promise<Scene> {
    if (this.refusal) throw this.refusal;
    return new FakeScene(this) as unknown as Scene;
  }

  warmUp(): void {}
}

/** A viewer in the page, that a script asks for. */
async function withViewer(
  use: (parts: { viewer: Viewer; scenes: FakeFactory; stats: RenderStats[]; failures: unknown[] }) => Promise<void>,
): Promise<void> {
  const host = document.createElement('div');
  host.style.cssText = 'width: 40px; height: 30px';
  const container = document.createElement('div');
  host.append(container);
  document.body.append(host);
  const scenes = new FakeFactory();
  const stats: RenderStats[] = [];
  const failures: unknown[] = [];
  const visibility = new Visibility(() => {});
  const viewer = new Viewer(
    { host, container, visibility, scenes },
    {
      rendered: (one) => stats.push(one),
      cameraMoved: () => {},
      labelRing: () => '',
      drawingFailed: (error) => failures.push(error),
    },
  );
  viewer.setQuality({ steps: 40, maxError: 1, isFree: false, targetFps: 30 });
  try {
    await visibility.ask(() => use({ viewer, scenes, stats, failures }));
  } finally {
    viewer.dispose();
    host.remove();
  }
}

describe('the viewer', () => {
  it('makes a scene when there is something to draw, draws until the picture is final, and then rests', () =>
    withViewer(async ({ viewer, scenes, stats }) => {
      await new Promise(requestAnimationFrame);
      expect(scenes.made, 'nothing to draw yet').to.have.lengthOf(0);
      await viewer.show(volume, optics, () => noCuts);
      await viewer.settled();
      const [scene] = scenes.made;
      expect(scene.volumes).to.deep.equal([volume]);
      expect(stats.at(-1)).to.include({ steps: 40, converged: true });
      expect([stats.at(-1)!.width / stats.at(-1)!.height, viewer.drawn]).to.deep.equal([4 / 3, volume]);
      const { draws } = scene;
      for (let i = 0; i < 5; i++) await new Promise(requestAnimationFrame);
      expect(scene.draws).to.equal(draws);
      viewer.invalidate();
      await viewer.settled();
      expect(scene.draws).to.equal(draws + 1);
    }));

  it('draws no picture of a first view that is smaller than the one before', () =>
    withViewer(async ({ viewer, scenes, stats }) => {
      viewer.setQuality({ steps: 'auto', maxError: 1, isFree: false, targetFps: 30 });
      await viewer.show(volume, optics, () => noCuts);
      await viewer.settled();
      const { widths } = scenes.made[0];
      expect(
        widths.every((width, i) => i === 0 || width >= widths[i - 1]),
        widths.join(' '),
      ).to.equal(true);
      expect([widths[0] < widths.at(-1)!, stats.at(-1)!.converged]).to.deep.equal([true, true]);
    }));

  it('shows the last of several volumes', () =>
    withViewer(async ({ viewer, scenes }) => {
      const others = [1, 2].map(() => syntheticVolume({ dimensions: [8, 8, 8] }));
      await viewer.show(volume, optics, () => noCuts);
      await viewer.settled();
      await Promise.all(others.map((one) => viewer.show(one, optics, () => noCuts)));
      await viewer.settled();
      expect([viewer.volume, viewer.drawn]).to.deep.equal([others[1], others[1]]);
      const aborted = viewer.show(volume, optics, () => noCuts, AbortSignal.abort());
      await aborted;
      expect(viewer.volume).to.equal(others[1]);
      expect(scenes.made).to.have.lengthOf(1);
    }));

  it('reports what drawing throws as it is, once, and draws again after a change', () =>
    withViewer(async ({ viewer, scenes, failures, stats }) => {
      const mistake = new TypeError('x is undefined');
      scenes.failure = mistake;
      await viewer.show(volume, optics, () => noCuts);
      await viewer.settled();
      for (let i = 0; i < 5; i++) await new Promise(requestAnimationFrame);
      expect(failures).to.deep.equal([mistake]);
      expect(asVolumeViewError(mistake, 'the picture of "a.nii"')).to.include({ code: 'internal' });
      scenes.failure = null;
      viewer.invalidate();
      await viewer.settled();
      expect([failures.length, stats.at(-1)!.converged]).to.deep.equal([1, true]);
    }));

  it('gives scenes the projection: a new one before its first picture, a present one where it changes', () =>
    withViewer(async ({ viewer, scenes }) => {
      await viewer.show(volume, { ...optics, projection: 'max' }, () => noCuts);
      await viewer.settled();
      const [scene] = scenes.made;
      expect(scene.projections).to.deep.equal(['max']);
      await Promise.all([
        viewer.setOptics({ ...optics, projection: 'min' }),
        viewer.setOptics({ ...optics, projection: 'average' }),
      ]);
      await viewer.setOptics({ ...optics, projection: 'average', lightFactor: 2 });
      expect(scene.projections).to.deep.equal(['max', 'min', 'average']);
      expect(viewer.optics?.projection).to.equal('average');
    }));

  it('says why there is no scene, and tries again when something changes', () =>
    withViewer(async ({ viewer, scenes, failures }) => {
      scenes.refusal = new VolumeViewError('webgl/unavailable', 'no WebGL');
      await viewer.show(volume, optics, () => noCuts);
      await viewer.settled();
      expect(failures).to.deep.equal([scenes.refusal]);
      expect(await viewer.redraw().catch((error: unknown) => error)).to.equal(scenes.refusal);
      scenes.refusal = null;
      viewer.invalidate();
      await viewer.settled();
      expect(viewer.drawn).to.equal(volume);
    }));

  it('takes another context for one that is lost while the volume is on its way, but not for ever', () =>
    withViewer(async ({ viewer, scenes, failures }) => {
      scenes.loses = 2;
      await viewer.show(volume, optics, () => noCuts);
      await viewer.settled();
      expect(scenes.made.map(({ isDisposed }) => isDisposed)).to.deep.equal([true, true, false]);
      expect([viewer.drawn, failures]).to.deep.equal([volume, []]);
    }));

  it('calls it a lost context where three in a row are', () =>
    withViewer(async ({ viewer, scenes, failures }) => {
      scenes.loses = 3;
      await viewer.show(volume, optics, () => noCuts);
      await viewer.settled();
      expect(failures.map((error) => (error as VolumeViewError).code)).to.deep.equal(['webgl/context-lost']);
      expect(scenes.made.every(({ isDisposed }) => isDisposed)).to.equal(true);
    }));

  it('builds the scene again where its context is lost, with what was shown', () =>
    withViewer(async ({ viewer, scenes, failures }) => {
      await viewer.show(volume, optics, () => noCuts);
      await viewer.settled();
      const [lost] = scenes.made;
      lost.canvas.dispatchEvent(new Event('webglcontextlost'));
      while (scenes.made.length < 2) await new Promise(requestAnimationFrame);
      await viewer.redraw();
      const [, next] = scenes.made;
      expect([lost.isDisposed, next.volumes, next.draws > 0, failures]).to.deep.equal([true, [volume], true, []]);
    }));

  it('leaves nothing behind', async () => {
    const made: FakeScene[] = [];
    let refused: unknown = null;
    await withViewer(async ({ viewer, scenes }) => {
      await viewer.show(volume, optics, () => noCuts);
      await viewer.settled();
      made.push(...scenes.made);
      viewer.dispose();
      refused = await viewer.redraw().catch((error: Error) => error.message);
    });
    expect(made.map(({ isDisposed }) => isDisposed)).to.deep.equal([true]);
    expect(refused).to.match(/taken out of the page/);
    expect(document.querySelectorAll('.labels')).to.have.lengthOf(0);
  });
});

// What stands beside a volume, in the course of its life: errors that come and go, and files that come late.
import { expect } from '@esm-bundle/chai';
import { childrenOf } from '../../../../src/page/page-children.ts';
import { AttachmentElement } from '../../../../components/internal/attachment-element.ts';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { colorsOf } from '../../../../src/viewer/attachments/color-moment.ts';
import type { ColoredView } from '../../../../src/viewer/attachments/color-moment.ts';
import { ErrorState } from '../../../../src/viewer/model/error-state.ts';
import { PaneTarget } from '../../../../src/viewer/attachments/pane-label-target.ts';
import { follow } from '../../../../src/x3d/nodes/read-atlas.ts';
import { SurfaceController } from '../../../../src/viewer/attachments/surface-controller.ts';
import { cartesianGrid } from '../../../../src/volume/grid.ts';
import { identity } from '../../../../src/volume/matrix.ts';
import { SurfaceTarget } from '../../../../src/viewer/attachments/surface-target.ts';
import { socketOf, standIn } from '../../../../src/viewer/model/view-socket.ts';
import type { SocketViewer } from '../../../../src/viewer/model/view-socket.ts';
import type { Scene, SceneLines } from '../../../../src/viewer/model/scene.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { withoutFrame } from '../../../../src/x3d/author-children.ts';
import { fakeOf, fakeScene, fakeSocketView, fakeSocketViewer } from '../../../helpers/fake.ts';
import type { Some } from '../../../helpers/fake.ts';
import { ballPly } from '../../../helpers/meshes.ts';

const wrong = (message: string): VolumeViewError => new VolumeViewError('format/corrupt', message);
const turn = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

describe('next to a volume', () => {
  it('the error of a surface that still has one is shown when another one is well again', () => {
    const errors = new ErrorState({ file: '', changed: () => {}, failed: () => {} });
    const socket = socketOf(document.createElement('div'));
    socket.view = fakeSocketView({
      errors,
      look: { attachmentsChanged: () => {} },
      viewer: null,
      volume: null,
    });
    const [first, second] = [0, 1].map(() => new SurfaceTarget(socket, document.createElement('i')));
    first.failed(wrong('one'));
    second.failed(wrong('two'));
    second.cleared();
    expect(errors.first?.message).to.equal('one');
    first.cleared();
    expect(errors.first).to.equal(null);
  });

  it('the next one takes the place of one that leaves, where there can be one', async () => {
    const joined: Element[] = [];
    const refused: Element[] = [];
    class OnlyOne extends AttachmentElement<Element> {
      protected override readonly controller = { refresh: () => {}, leave: () => {} };

      protected override refuse(around: HTMLElement | null): VolumeViewError | null {
        if (around?.localName === 'volume-view' && childrenOf(around, 'only-one')[0] === this) return null;
        refused.push(this);
        return wrong('the second one');
      }

      protected override join(): Element {
        joined.push(this);
        return this;
      }
    }
    customElements.define('only-one', OnlyOne);
    customElements.define('volume-view', class extends HTMLElement {});
    const around = document.createElement('volume-view');
    const [first, second] = [0, 1].map(() => document.createElement('only-one'));
    const deeper = document.createElement('p');
    deeper.append(first);
    around.append(deeper, second);
    document.body.append(around);
    await turn();
    expect([joined, refused], 'one in a paragraph counts').to.deep.equal([[first], [second]]);
    first.remove();
    await turn();
    expect(joined).to.deep.equal([first, second]);
    around.remove();
  });

  it('a surface that waits for a scene is reported once, whatever changes meanwhile, and holds up nothing where none comes', async () => {
    const host = document.createElement('div');
    const socket = socketOf(host);
    const given = { volume: {}, scene: null as Scene | null, invalidate: () => {}, drawn: null, reframe: () => {} };
    const viewer = fakeSocketViewer(given);
    const work: Promise<unknown>[] = [];
    const presenter = {
      host,
      settings: { source: null },
      look: { attachmentsChanged: () => {} },
      awake: true,
      errors: new ErrorState({ file: '', changed: () => {}, failed: () => {} }),
      viewer: viewer as SocketViewer | null,
      volume: { grid: cartesianGrid([9, 9, 9], identity) } as Some<Volume> | null,
      track: (one: Promise<unknown>) => work.push(one),
      fileNotices: new Map(),
      user: { changed: () => {} },
    };
    socket.view = fakeSocketView(presenter);
    const target = new SurfaceTarget(socket, document.createElement('i'));
    const shown = (): readonly number[] | undefined => socket.last('surface')?.color;
    const url = `data:text/plain,${encodeURIComponent(ballPly([0, 0, 0], 5, 4))}`;
    const reported: string[] = [];
    let red = 0;
    const surfaces = new SurfaceController({
      localName: 'volume-surface',
      wanted: () => ({
        request: { surface: 'mesh', url, space: null },
        look: { color: [red, 0, 0], usesOwnColors: false },
      }),
      target: () => target,
      came: () => reported.push('came'),
      progress: () => {},
      failed: (error) => reported.push(String(error)),
    });
    const until = async (isSo: () => boolean): Promise<void> => {
      while (!isSo()) await turn();
    };
    surfaces.refresh();
    await until(() => shown() !== undefined);
    red = 1;
    surfaces.refresh();
    surfaces.refresh();
    await turn();
    expect(reported, 'before there is a scene').to.deep.equal([]);
    let brought = 0;
    const scene = fakeScene({
      loadLines: async () => fakeOf<SceneLines>('SceneLines', { showSurface: async () => void brought++ }),
    });
    await socket.applyTo(scene);
    given.scene = scene;
    host.dispatchEvent(new Event('render'));
    await until(() => reported.length > 0);
    surfaces.refresh();
    await Promise.all(work);
    expect([reported, brought > 0, shown()]).to.deep.equal([['came'], true, [1, 0, 0]]);

    given.scene = null;
    red = 0.5;
    surfaces.refresh();
    await until(() => shown()![0] === 0.5);
    presenter.volume = null;
    host.dispatchEvent(new Event('optics-change'));
    await Promise.all(work);
    presenter.volume = {};
    red = 0.25;
    surfaces.refresh();
    await until(() => shown()![0] === 0.25);
    presenter.viewer = null;
    surfaces.leave(target);
    await Promise.all(work);
    expect([reported, shown()]).to.deep.equal([['came'], undefined]);
  });

  it('a view without color-moment keeps the error of its layer', async () => {
    const errors = new ErrorState({ file: '', changed: () => {}, failed: () => {} });
    const view = Object.assign(document.createElement('div'), {
      colorMoment: null as string | null,
      scan: null,
    }) as ColoredView & { colorMoment: string | null };
    socketOf(view).view = fakeSocketView({
      errors,
      look: { attachmentsChanged: () => {} },
      viewer: null,
      volume: null,
      track: () => {},
    });
    errors.report('overlay', wrong('a layer'));
    await colorsOf(view).refresh();
    expect(errors.first?.message).to.equal('a layer');
    view.colorMoment = 'VRADH';
    await colorsOf(view).refresh();
    view.colorMoment = null;
    await colorsOf(view).refresh();
    expect(errors.first).to.equal(null);
  });

  it('a pane is drawn again when the error of its labels is gone', () => {
    let drawn = 0;
    const target = new PaneTarget({ volume: () => null, file: () => '', changed: () => drawn++, take: () => {} });
    target.cleared();
    expect(drawn).to.equal(0);
    target.failed(wrong('one'));
    target.cleared();
    expect([drawn, target.error]).to.deep.equal([2, null]);
  });

  it('a material or a texture that is taken out of a shape is in nothing any more, and described as it is', () => {
    for (const name of ['material', 'imagetexture']) {
      const alone = document.createElement(name);
      expect(withoutFrame(alone)).to.deep.equal([alone]);
    }
  });

  it('of two atlases the one that is named last holds, whichever comes last; and a group takes its atlas along', async () => {
    const made: { src: string; onload?: () => void }[] = [];
    const { Image } = window;
    window.Image = class {
      readonly naturalWidth = 8;
      readonly naturalHeight = 8;
      src = '';
      constructor() {
        made.push(this);
      }
    } as unknown as typeof Image;
    try {
      const host = document.createElement('div');
      await follow(
        { user: { host }, look: { current: null, errors: { report: () => {}, clear: () => {} } } },
        () => {},
      );
      host.innerHTML =
        '<transform><VolumeData><ImageTextureAtlas url="slow.png" numberOfSlices="4" slicesOverX="2" slicesOverY="2"></ImageTextureAtlas></VolumeData></transform>';
      await turn();
      host.querySelector('imagetextureatlas')!.setAttribute('url', 'fast.png');
      await turn();
      expect(made.map(({ src }) => src.split('/').at(-1))).to.deep.equal(['slow.png', 'fast.png']);
      made[1].onload!();
      await turn();
      made[0].onload!();
      await turn();
      expect([standIn(host, 'src'), standIn(host, 'mosaic')]).to.deep.equal(['fast.png', '2x2']);
      expect(standIn(host, 'spacing'), 'dimensions of 1 1 1, by voxels').to.equal('-0.25 -0.25 0.25');
      host.innerHTML =
        '<transform scale="2 3 4"><group><transform scale="0.5 -1 1"><VolumeData dimensions="1 1 2"><ImageTextureAtlas url="scaled.png" numberOfSlices="4" slicesOverX="2" slicesOverY="2"></ImageTextureAtlas></VolumeData></transform></group></transform>';
      await turn();
      made[2].onload!();
      await turn();
      expect(standIn(host, 'spacing'), 'scaled by what stands around it; a scale that mirrors is none').to.equal(
        '-0.5 -0.75 2',
      );
      host.firstElementChild!.remove();
      await turn();
      expect(standIn(host, 'src')).to.equal(null);
    } finally {
      window.Image = Image;
    }
  });

  it('reports once voxels that are a file, where there is no src, and not where they are gone', async () => {
    const host = document.createElement('div');
    const reported: string[] = [];
    const errors = {
      report: (aspect: string, error: unknown) => reported.push(`${aspect}: ${(error as Error).message}`),
      clear: (aspect: string) => reported.push(`${aspect} is well`),
    };
    host.innerHTML =
      '<VolumeData><ImageTexture3D containerField="voxels" url=\'"a.nrrd" "b.nrrd"\'></ImageTexture3D></VolumeData>';
    await follow({ user: { host }, look: { current: null, errors } }, () => {});
    expect(reported).to.deep.equal([
      'optics: <volumedata> got an ImageTexture3D, "a.nrrd", and no src; expected an ImageTextureAtlas, or that file as the src of the volume-view.',
    ]);
    host.firstElementChild!.setAttribute('dimensions', '1 1 2');
    await turn();
    expect(reported).to.have.length(1);
    host.firstElementChild!.remove();
    await turn();
    expect(reported.slice(1)).to.deep.equal(['optics is well']);
    host.setAttribute('src', 'a.nrrd');
    host.innerHTML = '<VolumeData><ImageTexture3D containerField="voxels" url="a.nrrd"></ImageTexture3D></VolumeData>';
    await turn();
    expect(reported).to.have.length(2);
  });
});

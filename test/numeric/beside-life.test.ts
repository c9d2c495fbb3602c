// What stands beside a volume, in the course of its life: errors that come and go, and files that come late.
import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../src/errors.ts';
import { colorsOf } from '../../src/viewer/color-moment.ts';
import type { ColoredView } from '../../src/viewer/color-moment.ts';
import { ErrorBoard } from '../../src/viewer/error-board.ts';
import { PaneTarget } from '../../src/viewer/pane-label-target.ts';
import { follow } from '../../src/viewer/read-atlas.ts';
import { SurfaceTarget } from '../../src/viewer/surface-target.ts';
import type { VolumePresenter } from '../../src/viewer/volume-presenter.ts';
import { withoutFrame } from '../../src/x3d/author-children.ts';

const wrong = (message: string): VolumeViewError => new VolumeViewError('format/corrupt', message);
const turn = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

describe('beside a volume', () => {
  it('the error of a surface that still has one is shown when another one is well again', () => {
    const errors = new ErrorBoard({ file: '', changed: () => {}, failed: () => {} });
    const presenter = { user: { host: document.createElement('div'), awake: true }, errors, viewer: null, volume: null } as unknown as VolumePresenter;
    const [first, second] = [0, 1].map(() => new SurfaceTarget(presenter, document.createElement('i')));
    first.failed(wrong('one'));
    second.failed(wrong('two'));
    second.cleared();
    expect(errors.first?.message).to.equal('one');
    first.cleared();
    expect(errors.first).to.equal(null);
  });

  it('a view without color-moment keeps the error of its layer', async () => {
    const errors = new ErrorBoard({ file: '', changed: () => {}, failed: () => {} });
    const _presenter = { errors, viewer: null, volume: null, track: () => {} } as unknown as VolumePresenter;
    const view = Object.assign(document.createElement('div'), { colorMoment: null as string | null, scan: null, _presenter }) as ColoredView & { colorMoment: string | null };
    errors.report('overlay', wrong('a layer'));
    await colorsOf(view).refresh();
    expect(errors.first?.message).to.equal('a layer');
    view.colorMoment = 'VRADH';
    await colorsOf(view).refresh();
    view.colorMoment = null;
    await colorsOf(view).refresh();
    expect(errors.first).to.equal(null);
  });

  it('a pane is drawn anew when the error of its labels is gone', () => {
    let drawn = 0;
    const target = new PaneTarget({ volume: () => null, file: () => '', changed: () => drawn++, take: () => {} });
    target.cleared();
    expect(drawn).to.equal(0);
    target.failed(wrong('one'));
    target.cleared();
    expect([drawn, target.error]).to.deep.equal([2, null]);
  });

  it('a material or a texture that is taken out of a shape is in nothing any more, and told as it is', () => {
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
      const host = document.createElement('div') as HTMLDivElement & { _atlas?: (property: string) => string | null | undefined };
      await follow({ user: { host }, look: { current: null } }, () => {});
      host.innerHTML = '<transform><VolumeData><ImageTextureAtlas url="slow.png" numberOfSlices="4" slicesOverX="2" slicesOverY="2"></ImageTextureAtlas></VolumeData></transform>';
      await turn();
      host.querySelector('imagetextureatlas')!.setAttribute('url', 'fast.png');
      await turn();
      expect(made.map(({ src }) => src.split('/').at(-1))).to.deep.equal(['slow.png', 'fast.png']);
      made[1].onload!();
      await turn();
      made[0].onload!();
      await turn();
      expect([host._atlas!('src'), host._atlas!('mosaic')]).to.deep.equal(['fast.png', '2x2']);
      host.firstElementChild!.remove();
      await turn();
      expect(host._atlas!('src')).to.equal(undefined);
    } finally {
      window.Image = Image;
    }
  });
});

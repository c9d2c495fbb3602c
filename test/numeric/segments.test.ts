// X3D's SegmentedVolumeData: which segments are drawn, and with what; and what can't be drawn, in words.
import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../src/errors.ts';
import { ErrorBoard } from '../../src/viewer/error-board.ts';
import { leadOf, readEnabled, readIdentifiers, tellStyles } from '../../src/viewer/read-segments.ts';
import { readVolumeNodes, withVolumeNodes } from '../../src/viewer/read-volume-nodes.ts';
import { segmentOf } from '../../src/viewer/segment-keeper.ts';
import type { VolumePresenter } from '../../src/viewer/volume-presenter.ts';
import type { ViewLabels } from '../../src/viewer/view-labels.ts';
import type { VolumeOptics } from '../../src/viewer/volume-info.ts';
import { axialIndexToWorld, cartesianGrid } from '../../src/volume/grid.ts';

const look: VolumeOptics = { transferFunction: [], window: [0, 200], referenceLength: 1, opacityFactor: 1, lightFactor: 1, projection: null, shading: 'unlit', surfaces: null };

function viewOf(html: string): HTMLElement {
  const host = document.createElement('volume-view');
  host.innerHTML = html;
  return host;
}

const nodeOf = (attributes: string): Element => viewOf(`<SegmentedVolumeData ${attributes}></SegmentedVolumeData>`).firstElementChild!;

/** An image of one row: two slices of 2 x 1 pixels. */
function atlasOf(pixels: readonly number[]): string {
  const canvas = Object.assign(document.createElement('canvas'), { width: pixels.length, height: 1 });
  canvas.getContext('2d')!.putImageData(new ImageData(new Uint8ClampedArray(pixels.flatMap((x) => [x, x, x, 255])), pixels.length), 0, 0);
  return canvas.toDataURL();
}

const identifiers = (pixels: readonly number[]): string => `<ImageTextureAtlas containerField="segmentIdentifiers" url="${atlasOf(pixels)}" numberOfSlices="2" slicesOverX="2" slicesOverY="1"></ImageTextureAtlas>`;
const cartoon = '<CartoonVolumeStyle></CartoonVolumeStyle>';
const edge = '<EdgeEnhancementVolumeStyle></EdgeEnhancementVolumeStyle>';
const map = (pixels: string): string => `<OpacityMapVolumeStyle><PixelTexture image="2 1 4 ${pixels}"></PixelTexture></OpacityMapVolumeStyle>`;

/** A view that shows a volume of 2 x 1 x 2 voxels. */
function present(html: string): { host: HTMLElement; errors: ErrorBoard; shown: { labels: ViewLabels | null }; settled: () => Promise<void>; read: () => Promise<VolumeOptics> } {
  const host = viewOf(html);
  const work: Promise<unknown>[] = [];
  const shown = { labels: null as ViewLabels | null };
  const errors = new ErrorBoard({ file: 'ct.png', changed: () => {}, failed: () => {} });
  const volume = { grid: cartesianGrid([2, 1, 2], axialIndexToWorld([2, 1, 2], [1, 1, 1])), samples: new Uint8Array(4), slope: 1, intercept: 0, format: 'png mosaic', range: [0, 200] };
  const presenter = {
    user: { host, awake: true }, settings: { src: 'ct.png' }, errors, volume, look: { current: look, dress: null },
    viewer: { invalidate: () => {}, pictures: { parts: { shown, keeper: { scene: { setLabels: async () => {} } } } } },
    track: (one: Promise<unknown>) => work.push(one),
  } as unknown as VolumePresenter;
  const settled = async (): Promise<void> => {
    while (work.length > 0) await work.shift();
  };
  return { host, errors, shown, settled, read: () => withVolumeNodes(presenter, look) };
}

describe('X3D\'s segments', () => {
  it('are labels of the volume: some are not drawn, and some have colours and opacities of their own', async () => {
    const view = present(`<SegmentedVolumeData segmentEnabled="TRUE, true false">${identifiers([0, 1, 2, 7])}<OpacityMapVolumeStyle></OpacityMapVolumeStyle>${map('0x00000000 0xFF0000FF')}</SegmentedVolumeData>`);
    expect((await view.read()).styles, 'no style').to.equal(undefined);
    await view.settled();
    const { map: { ids, numbers }, styles, functions } = view.shown.labels!.shown!;
    expect([ids, [...numbers]]).to.deep.equal([[0, 1, 2, 7], [0, 1, 2, 3]]);
    expect(styles.map(({ color, opacityFactor, group = 0 }) => [...color, opacityFactor, group])).to.deep.equal([[1, 1, 1, 1, 0], [1, 1, 1, 1, 1], [1, 1, 1, 0, 0], [1, 1, 1, 1, 0]]);
    expect(functions!.map((stops) => stops.map(({ value, opacity, color }) => [value, opacity, ...color]))).to.deep.equal([[[0, 0, 0, 0, 0], [200, 1, 1, 0, 0]]]);
    expect(view.errors.first).to.equal(null);

    view.host.firstElementChild!.setAttribute('segmentEnabled', 'false');
    await view.read();
    await view.settled();
    expect(view.shown.labels!.shown!.styles.map(({ opacityFactor }) => opacityFactor)).to.deep.equal([0, 1, 1, 1]);

    view.host.replaceChildren();
    await view.read();
    await view.settled();
    expect(view.shown.labels, 'the node is gone').to.equal(null);
  });

  it('have one style, that of the first that is drawn, and others are told', async () => {
    const html = `<SegmentedVolumeData segmentEnabled="false">${identifiers([0, 1, 2, 2])}${edge}${cartoon}${cartoon}</SegmentedVolumeData>`;
    expect(readVolumeNodes(viewOf(html), look).styles!.flatMap(({ styles }) => styles.map(({ kind }) => kind))).to.deep.equal(['cartoon']);
    const same = present(html);
    await same.read();
    await same.settled();
    expect(same.errors.first).to.equal(null);

    const other = present(html.replace('"false"', '"true"'));
    expect((await other.read()).styles![0].styles.map(({ kind }) => kind)).to.deep.equal(['edge']);
    await other.settled();
    expect(other.errors.first).to.include({ code: 'attribute/invalid' });
    expect(other.errors.first!.message).to.match(/got <cartoonvolumestyle> for segment 1 and <edgeenhancementvolumestyle> for segment 0; .* All of them have that of segment 0/);
    expect(other.shown.labels, 'and drawn').to.not.equal(null);
  });

  it('without a style beside some with one are told where they are drawn', () => {
    const all = [{ node: 'a', key: '', texture: null }, { node: 'b', key: 'b', texture: null }];
    expect(leadOf(all, [])).to.equal(1);
    expect(leadOf(all, [true, false])).to.equal(-1);
    expect(tellStyles(all, [], [1])).to.equal(null);
    expect(tellStyles(all, [false], [0, 1])).to.equal(null);
    expect(tellStyles(all, [], [0, 1])!.message).to.match(/got <a> for segment 0 and <b> for segment 1/);
    expect(tellStyles(all, [false], [0, 1, 5])!.message).to.match(/got no style for segment 5/);
  });

  it('are spread over a pixel where X3DOM says how many there are', async () => {
    // 10 of them: segment n begins at (n + 1/2) / 10, as X3DOM 1.8.3 draws it.
    expect([0, 0.14, 0.16, 0.24, 0.26, 1].map((share) => segmentOf(share, 10))).to.deep.equal([0, 0, 1, 1, 2, 9]);
    const view = present(`<SegmentedVolumeData numberOfMaxSegments="10">${identifiers([0, 51, 77, 255])}</SegmentedVolumeData>`);
    await view.read();
    await view.settled();
    expect(view.shown.labels!.shown!.map.ids).to.deep.equal([0, 1, 2, 9]);
  });

  it('leave a page\'s own labels in their place', async () => {
    const view = present(`<volume-labels></volume-labels><SegmentedVolumeData>${identifiers([0, 1, 2, 2])}</SegmentedVolumeData>`);
    const error = await view.read().catch((thrown: unknown) => thrown);
    expect(error).to.be.instanceOf(VolumeViewError);
    expect((error as Error).message).to.match(/got <volume-labels> beside it.*The <volume-labels> is drawn/);
    view.host.firstElementChild!.remove();
    await view.read();
    await view.settled();
    expect(view.shown.labels!.shown!.map.ids).to.deep.equal([0, 1, 2]);
  });

  it('need identifiers for as many voxels as the volume has', async () => {
    const view = present(`<SegmentedVolumeData>${identifiers([0, 1, 2, 2, 1, 1])}</SegmentedVolumeData>`);
    await view.read();
    await view.settled();
    expect(view.errors.first!.message).to.match(/on a grid of 3 x 1 x 2 voxels and the volume on one of 2 x 1 x 2/);
  });

  for (const [what, act, message] of [
    ['no identifiers', () => readIdentifiers(nodeOf('')), /got no segment identifiers; expected an <ImageTextureAtlas containerField="segmentIdentifiers"/],
    ['words that are no booleans', () => readEnabled(nodeOf('segmentEnabled="true 0"')), /segmentEnabled of SegmentedVolumeData got "true 0"; expected "true" or "false" for each segment/],
    ['an atlas without slices', () => readIdentifiers(viewOf('<SegmentedVolumeData><ImageTextureAtlas containerField="segmentIdentifiers" url="a.png"></ImageTextureAtlas></SegmentedVolumeData>').firstElementChild!), /slicesOverX/],
  ] as const) {
    it(`refuses ${what} in words`, () => {
      expect(act).to.throw(message).with.property('code', 'attribute/invalid');
    });
  }
});

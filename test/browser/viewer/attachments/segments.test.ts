// X3D's SegmentedVolumeData: which segments are drawn, and with what; and what can't be drawn, in words.
import { expect } from '@esm-bundle/chai';
import { socketOf } from '../../../../src/viewer/model/view-socket.ts';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { leadOf, readEnabled, readIdentifiers, reportStyles } from '../../../../src/x3d/nodes/read-segments.ts';
import { readVolumeNodes } from '../../../../src/viewer/attachments/read-volume-nodes.ts';
import { segmentOf } from '../../../../src/viewer/attachments/segment-controller.ts';
import { atlasOf, fakeView, plainAppearance, viewOf } from '../../../helpers/fake-view.ts';

const nodeOf = (attributes: string): Element =>
  viewOf(`<SegmentedVolumeData ${attributes}></SegmentedVolumeData>`).firstElementChild!;

const identifiers = (pixels: readonly number[]): string => atlasOf('segmentIdentifiers', pixels);
const cartoon = '<CartoonVolumeStyle></CartoonVolumeStyle>';
const edge = '<EdgeEnhancementVolumeStyle></EdgeEnhancementVolumeStyle>';
const map = (pixels: string): string =>
  `<OpacityMapVolumeStyle><PixelTexture image="2 1 4 ${pixels}"></PixelTexture></OpacityMapVolumeStyle>`;

describe("X3D's segments", () => {
  it('are labels of the volume: some are not drawn, and some have colours and opacities of their own', async () => {
    const view = fakeView(
      `<SegmentedVolumeData segmentEnabled="TRUE, true false">${identifiers([0, 1, 2, 7])}<OpacityMapVolumeStyle></OpacityMapVolumeStyle>${map('0x00000000 0xFF0000FF')}</SegmentedVolumeData>`,
    );
    expect((await view.read()).styles, 'no style').to.equal(undefined);
    const {
      map: { ids, numbers },
      styles,
      functions,
    } = view.shown.labels!.shown!;
    expect([ids, [...numbers]]).to.deep.equal([
      [0, 1, 2, 7],
      [0, 1, 2, 3],
    ]);
    expect(styles.map(({ color, opacityFactor, group = 0 }) => [...color, opacityFactor, group])).to.deep.equal([
      [1, 1, 1, 1, 0],
      [1, 1, 1, 1, 1],
      [1, 1, 1, 0, 0],
      [1, 1, 1, 1, 0],
    ]);
    expect(
      functions!.map((stops) => stops.map(({ value, opacity, color }) => [value, opacity, ...color])),
    ).to.deep.equal([
      [
        [0, 0, 0, 0, 0],
        [200, 1, 1, 0, 0],
      ],
    ]);
    expect(view.errors.first).to.equal(null);

    view.host.firstElementChild!.setAttribute('segmentEnabled', 'false');
    await view.read();
    expect(view.shown.labels!.shown!.styles.map(({ opacityFactor }) => opacityFactor)).to.deep.equal([0, 1, 1, 1]);

    view.host.replaceChildren();
    await view.read();
    expect(view.shown.labels, 'the node is gone').to.equal(null);
  });

  it('that are gone before their part or their texture is there stay gone', async () => {
    const view = fakeView('');
    const html = `<SegmentedVolumeData>${identifiers([0, 1, 2, 2])}${map('0x00000000 0xFF0000FF')}</SegmentedVolumeData>`;
    for (const what of ['the part', 'the texture']) {
      view.host.innerHTML = html;
      const first = view.read();
      view.host.replaceChildren();
      await view.read();
      await first;
      expect(view.shown.labels === null, what).to.equal(true);
      view.host.innerHTML = html;
      await view.read();
      expect(view.shown.labels === null, what).to.equal(false);
    }
  });

  it('of an atlas have textures from black to white of it, unless the view says otherwise', async () => {
    const view = fakeView(
      `<SegmentedVolumeData>${identifiers([0, 1, 2, 2])}${map('0x00000000 0xFF0000FF')}</SegmentedVolumeData>`,
    );
    void socketOf(view.host).join({ key: 'atlas', attribute: () => 'ct.png' });
    const last = async (): Promise<number> => (await view.read(), view.shown.labels!.shown!.functions![0][1].value);
    expect(await last()).to.equal(255);
    view.host.setAttribute('value-window', '0 200');
    expect(await last()).to.equal(200);
  });

  it('have one style, that of the first that is drawn, and others are reported', async () => {
    const html = `<SegmentedVolumeData segmentEnabled="false">${identifiers([0, 1, 2, 2])}${edge}${cartoon}${cartoon}</SegmentedVolumeData>`;
    expect(
      readVolumeNodes(viewOf(html), plainAppearance).styles!.flatMap(({ styles }) => styles.map(({ kind }) => kind)),
    ).to.deep.equal(['cartoon']);
    const same = fakeView(html);
    await same.read();
    expect(same.errors.first).to.equal(null);

    const other = fakeView(html.replace('"false"', '"true"'));
    expect((await other.read()).styles![0].styles.map(({ kind }) => kind)).to.deep.equal(['edge']);
    expect(other.errors.first).to.include({ code: 'attribute/invalid' });
    expect(other.errors.first!.message).to.match(
      /got <cartoonvolumestyle> for segment 1 and <edgeenhancementvolumestyle> for segment 0; .* All of them have that of segment 0/,
    );
    expect(other.shown.labels, 'and drawn').to.not.equal(null);
  });

  it('without a style next to some with one are reported where they are drawn', () => {
    const all = [
      { node: 'a', key: '', texture: null },
      { node: 'b', key: 'b', texture: null },
    ];
    expect(leadOf(all, [])).to.equal(1);
    expect(leadOf(all, [true, false])).to.equal(-1);
    expect(reportStyles(all, [], [1])).to.equal(null);
    expect(reportStyles(all, [false], [0, 1])).to.equal(null);
    expect(reportStyles(all, [], [0, 1])!.message).to.match(/got <a> for segment 0 and <b> for segment 1/);
    expect(reportStyles(all, [false], [0, 1, 5])!.message).to.match(/got no style for segment 5/);
  });

  it('are spread over a pixel where X3DOM says how many there are', async () => {
    // 10 of them: segment n begins at (n + 1/2) / 10, as X3DOM 1.8.3 draws it.
    expect([0, 0.14, 0.16, 0.24, 0.26, 1].map((share) => segmentOf(share, 10))).to.deep.equal([0, 0, 1, 1, 2, 9]);
    const view = fakeView(
      `<SegmentedVolumeData numberOfMaxSegments="10">${identifiers([0, 51, 77, 255])}</SegmentedVolumeData>`,
    );
    await view.read();
    expect(view.shown.labels!.shown!.map.ids).to.deep.equal([0, 1, 2, 9]);
  });

  it("leave a page's own labels in their place", async () => {
    const view = fakeView(
      `<volume-labels></volume-labels><SegmentedVolumeData>${identifiers([0, 1, 2, 2])}</SegmentedVolumeData>`,
    );
    const error = await view.read().catch((thrown: unknown) => thrown);
    expect(error).to.be.instanceOf(VolumeViewError);
    expect((error as Error).message).to.match(/got <volume-labels>; .*The <volume-labels> is drawn/);
    view.host.firstElementChild!.remove();
    await view.read();
    expect(view.shown.labels!.shown!.map.ids).to.deep.equal([0, 1, 2]);
  });

  it('need identifiers for as many voxels as the volume has', async () => {
    const view = fakeView(`<SegmentedVolumeData>${identifiers([0, 1, 2, 2, 1, 1])}</SegmentedVolumeData>`);
    await view.read();
    expect(view.errors.first!.message).to.match(/on a grid of 3 x 1 x 2 voxels and the volume on one of 2 x 1 x 2/);
  });

  for (const [what, act, message] of [
    [
      'no identifiers',
      () => readIdentifiers(nodeOf('')),
      /got no segment identifiers; expected an <ImageTextureAtlas containerField="segmentIdentifiers"/,
    ],
    [
      'words that are no booleans',
      () => readEnabled(nodeOf('segmentEnabled="true 0"')),
      /segmentEnabled of SegmentedVolumeData got "true 0"; expected "true" or "false" for each segment/,
    ],
    [
      'an atlas without slices',
      () =>
        readIdentifiers(
          viewOf(
            '<SegmentedVolumeData><ImageTextureAtlas containerField="segmentIdentifiers" url="a.png"></ImageTextureAtlas></SegmentedVolumeData>',
          ).firstElementChild!,
        ),
      /slicesOverX/,
    ],
  ] as const) {
    it(`refuses ${what} in words`, () => {
      expect(act).to.throw(message).with.property('code', 'attribute/invalid');
    });
  }
});

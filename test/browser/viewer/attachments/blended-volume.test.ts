// A second volume in X3D's BlendedVolumeStyle: a layer over the first, by the weights of both; and what can't be blended, in words.
import { expect } from '@esm-bundle/chai';
import type { OverlaidSample } from '../../../../src/optics/attachments/overlay.ts';
import { extinction } from '../../../../src/optics/transfer/opacity.ts';
import { cartesianOverlay, isOver, overlayStages } from '../../../../src/optics/attachments/overlay.ts';
import { readVolumeNodes } from '../../../../src/viewer/attachments/read-volume-nodes.ts';
import { readVoxelTexture } from '../../../../src/x3d/nodes/volume-textures.ts';
import { atlasOf, fakeView, plainAppearance, viewOf } from '../../../helpers/fake-view.ts';

const voxels = atlasOf('voxels', [0, 0, 0, 0, 255, 255]);
const half =
  '<OpacityMapVolumeStyle><PixelTexture image="2 1 4 0xFF000080 0xFF000080"></PixelTexture></OpacityMapVolumeStyle>';
const blend = (attributes: string, inside: string): string =>
  `<BlendedVolumeStyle ${attributes}>${inside}</BlendedVolumeStyle>`;

describe('a second volume in BlendedVolumeStyle', () => {
  it('fills the box of the first, on a grid of its own, and extinctions add by their weights', async () => {
    const view = fakeView(blend('weightConstant1="0.4" weightConstant2="0.9"', voxels + half));
    const appearance = await view.read();
    expect(view.errors.first).to.equal(null);
    expect(appearance.transferFunction, "the texture is the second one's").to.equal(plainAppearance.transferFunction);
    const { shown, valueAt } = view.shown.overlay!;
    expect([shown.blend, shown.volume.grid.dimensions, isOver(shown, shown.over)]).to.deep.equal([
      'mix',
      [3, 1, 2],
      true,
    ]);
    // Its slices, one behind the other: 0 in the first, 255 in two of three pixels of the second.
    expect(
      [
        [0.5, 0.5, 0.25],
        [0.1, 0.5, 0.75],
        [0.9, 0.5, 0.75],
      ].map((place) => valueAt(place as [number, number, number])),
    ).to.deep.equal([0, 0, 255]);
    const {
      shades: [shade],
    } = overlayStages(shown, cartesianOverlay(shown), { optics: { ...appearance, referenceLength: 1 }, diameter: 3 });
    const sample = { value: 1, valid: true, overlay: 100 } as OverlaidSample;
    const first = 0.4 * 0.7 * 3 * 0.2; // The first volume's depth, of 0.7 a unit.
    const opacity = -Math.expm1(-first);
    const both = shade(
      { front: sample, back: sample, begin: 0, span: 0.2 },
      [0, 0, opacity, opacity],
      {} as Parameters<typeof shade>[2],
    );
    const depth = first + 0.9 * extinction(128 / 255) * 3 * 0.2;
    expect(both[3]).to.be.closeTo(-Math.expm1(-depth), 1e-6);
    expect(both[2] / both[3], 'light of both, by what each is of the depth').to.be.closeTo(first / depth, 1e-6);
    expect(appearance.opacityFactor).to.equal(0.4);

    view.host.replaceChildren();
    expect((await view.read()).opacityFactor).to.equal(1);
    expect(view.shown.overlay).to.equal(null);
  });

  it("is gray without colours of its own, and styles before it are the first one's", async () => {
    const view = fakeView('<CartoonVolumeStyle></CartoonVolumeStyle>' + blend('', voxels));
    const { styles } = await view.read();
    expect(styles!.map((chain) => [chain.weight, ...chain.styles.map(({ kind }) => kind)])).to.deep.equal([
      [1, 'cartoon'],
    ]);
    const { transferFunction, opacityFactor } = view.shown.overlay!.shown;
    expect(transferFunction.map(({ value, color, opacity }) => [value, ...color, opacity])).to.deep.equal([
      [0, 0, 0, 0, 0],
      [255, 1, 1, 1, 1],
    ]);
    expect(opacityFactor).to.equal(1);
  });

  it('may be composed with what is before it', async () => {
    const view = fakeView(
      `<ComposedVolumeStyle><OpacityMapVolumeStyle></OpacityMapVolumeStyle>${blend('weightConstant1="0.4"', voxels + half)}</ComposedVolumeStyle>`,
    );
    const appearance = await view.read();
    expect([
      view.errors.first,
      appearance.opacityFactor,
      appearance.transferFunction === plainAppearance.transferFunction,
    ]).to.deep.equal([null, 0.4, true]);
    expect(view.shown.overlay!.shown.volume.grid.dimensions).to.deep.equal([3, 1, 2]);
  });

  it('that is gone before its part is there stays gone', async () => {
    const view = fakeView(blend('', voxels));
    const first = view.read();
    view.host.replaceChildren();
    await view.read();
    await first;
    expect(view.shown.overlay === null).to.equal(true);
  });

  it("and images of segments are not asked for a spacing, as their place is the volume's", () => {
    expect(readVoxelTexture(viewOf(voxels).firstElementChild!).settings?.spacing).to.deep.equal([1, 1, 1]);
  });

  it("leaves a page's own layer in its place", async () => {
    const view = fakeView(`<volume-layer></volume-layer>${blend('', voxels)}`);
    expect(String(await view.read().catch((error: unknown) => error))).to.match(
      /got voxels and a <volume-layer>; .*The <volume-layer> is drawn/,
    );
    expect(view.shown.overlay).to.equal(null);
  });

  for (const [what, html, message] of [
    [
      'a style of its own',
      blend('', `${voxels}<CartoonVolumeStyle></CartoonVolumeStyle>`),
      /got another style for its voxels; expected an OpacityMapVolumeStyle/,
    ],
    [
      'nothing of the first',
      blend('weightConstant1="0"', voxels),
      /weightConstant1 of <blendedvolumestyle> got "0"; expected a number above 0/,
    ],
    [
      'weights by opacity',
      blend('weightFunction1="ONE_MINUS_ALPHA1"', voxels),
      /weightFunction1 of <blendedvolumestyle> got "ONE_MINUS_ALPHA1"; expected CONSTANT/,
    ],
    ['a projection', `<ProjectionVolumeStyle></ProjectionVolumeStyle>${blend('', voxels)}`, /expected it alone/],
    [
      'segments',
      `<SegmentedVolumeData>${blend('', voxels)}</SegmentedVolumeData>`,
      /got voxels in a <SegmentedVolumeData>/,
    ],
    [
      'a style after it',
      `${blend('', voxels)}<CartoonVolumeStyle></CartoonVolumeStyle>`,
      /expected that to be the last/,
    ],
  ] as const) {
    it(`refuses ${what} in words`, () => {
      expect(() => readVolumeNodes(viewOf(html), plainAppearance))
        .to.throw(message)
        .with.property('code', 'attribute/invalid');
    });
  }
});

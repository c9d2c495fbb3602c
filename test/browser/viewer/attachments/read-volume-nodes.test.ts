// What X3D's volume nodes in HTML say, as an author meant it; what X3D forbids, and what is not there, in words.
import { expect } from '@esm-bundle/chai';
import { socketOf } from '../../../../src/viewer/model/view-socket.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../../src/volume/grid.ts';
import { defaultReferenceLength } from '../../../../src/volume/reference-length.ts';
import type { VolumeStyle } from '../../../../src/optics/transfer/volume-styles.ts';
import { evaluate, largestOpacity } from '../../../../src/optics/transfer/transfer-function.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { readOpacityMap } from '../../../../src/x3d/nodes/read-opacity-map.ts';
import { readVolumeNodes, withVolumeNodes } from '../../../../src/viewer/attachments/read-volume-nodes.ts';

import type { VolumeOptics } from '../../../../src/viewer/model/volume-info.ts';

const plainAppearance: VolumeOptics = {
  transferFunction: [],
  window: [0, 1],
  referenceLength: 1,
  opacityFactor: 1,
  lightFactor: 1,
  projection: null,
  shading: 'unlit',
  surfaces: null,
};

function read(html: string, appearance: Partial<VolumeOptics> = {}): VolumeOptics {
  const host = document.createElement('volume-view');
  host.innerHTML = html;
  return readVolumeNodes(host, { ...plainAppearance, ...appearance });
}

const kinds = (html: string): string[] => read(html).styles!.flatMap(({ styles }) => styles.map(({ kind }) => kind));
const first = (html: string): VolumeStyle => read(html).styles![0].styles[0];

/** 100 x 50 x 1. */
const grid = cartesianGrid([100, 50, 1], axialIndexToWorld([100, 50, 1], [1, 1, 1]));

describe("X3D's volume nodes", () => {
  it("have the standard's defaults, and say nothing where there are none", () => {
    expect(read('<box></box>')).to.deep.equal(plainAppearance);
    expect(first('<BoundaryEnhancementVolumeStyle></BoundaryEnhancementVolumeStyle>')).to.deep.equal({
      kind: 'boundary',
      retained: 0.2,
      boundary: 0.9,
      power: 2,
    });
    expect(first('<SilhouetteEnhancementVolumeStyle></SilhouetteEnhancementVolumeStyle>')).to.deep.equal({
      kind: 'silhouette',
      retained: 1,
      boundary: 0,
      sharpness: 0.5,
    });
    expect(first('<EdgeEnhancementVolumeStyle></EdgeEnhancementVolumeStyle>')).to.deep.equal({
      kind: 'edge',
      color: [0, 0, 0],
      threshold: 0.4,
    });
    expect(first('<CartoonVolumeStyle></CartoonVolumeStyle>')).to.deep.equal({
      kind: 'cartoon',
      parallel: [0, 0, 0],
      orthogonal: [1, 1, 1],
      steps: 4,
    });
    expect(first('<ToneMappedVolumeStyle></ToneMappedVolumeStyle>')).to.deep.equal({
      kind: 'tone',
      cool: [0, 0, 1],
      warm: [1, 1, 0],
    });
    expect(read('<ShadedVolumeStyle></ShadedVolumeStyle>').styles, 'lighting is false').to.equal(undefined);
    expect(first('<ShadedVolumeStyle lighting="true"></ShadedVolumeStyle>')).to.deep.equal({
      kind: 'shaded',
      material: null,
    });
    expect(first('<ShadedVolumeStyle lighting="true"><Material></Material></ShadedVolumeStyle>')).to.deep.equal({
      kind: 'shaded',
      material: { ambient: 0.2, diffuse: [0.8, 0.8, 0.8], specular: [0, 0, 0], emissive: [0, 0, 0], shininess: 25.6 },
    });
    expect(read('<ProjectionVolumeStyle></ProjectionVolumeStyle>').projection).to.equal('max');
  });

  it('have their fields', () => {
    expect(
      first('<EdgeEnhancementVolumeStyle edgeColor="1 0.5 0 1" gradientThreshold="1.2"></EdgeEnhancementVolumeStyle>'),
    ).to.deep.equal({ kind: 'edge', color: [1, 0.5, 0], threshold: 1.2 });
    expect(first('<CartoonVolumeStyle colorSteps="8" parallelColor="0 0 1"></CartoonVolumeStyle>')).to.deep.equal({
      kind: 'cartoon',
      parallel: [0, 0, 1],
      orthogonal: [1, 1, 1],
      steps: 8,
    });
    expect(
      read('<ProjectionVolumeStyle type="average" intensityThreshold="0.5"></ProjectionVolumeStyle>'),
      'a mean has no threshold',
    ).to.deep.equal({ ...plainAppearance, projection: 'average' });
    expect(read('<ProjectionVolumeStyle type="max" intensityThreshold="0.5"></ProjectionVolumeStyle>')).to.deep.equal({
      ...plainAppearance,
      projection: 'max',
      intensityThreshold: 0.5,
    });
    expect(
      first('<ShadedVolumeStyle lighting="TRUE" shadows="TRUE"></ShadedVolumeStyle>'),
      'shadows are left out',
    ).to.deep.equal({ kind: 'shaded', material: null });
    expect(
      read('<ProjectionVolumeStyle type="AVERAGE"></ProjectionVolumeStyle>', { projection: 'min' }).projection,
      'the attribute goes first',
    ).to.equal('min');
    expect(read('<CartoonVolumeStyle enabled="false"></CartoonVolumeStyle>').styles).to.equal(undefined);
  });

  it('stand before what gradient-opacity says, in all chains', () => {
    const steep = {
      kind: 'gradient',
      stops: [
        [0, 0],
        [1, 1],
      ],
    } as const;
    const styles = [{ weight: 1, styles: [steep] }];
    expect(read('<box></box>', { styles }).styles).to.deep.equal(styles);
    const { styles: both } = read(
      '<CartoonVolumeStyle/><BlendedVolumeStyle><EdgeEnhancementVolumeStyle/></BlendedVolumeStyle>',
      { styles },
    );
    expect(both!.map((one) => one.styles.map(({ kind }) => kind))).to.deep.equal([
      ['cartoon', 'gradient'],
      ['edge', 'gradient'],
    ]);
  });

  it('act in their order, in ComposedVolumeStyle or not, and where a tag was not closed', () => {
    const three = ['edge', 'shaded', 'silhouette'];
    expect(
      kinds(
        '<EdgeEnhancementVolumeStyle></EdgeEnhancementVolumeStyle><ShadedVolumeStyle lighting="true"></ShadedVolumeStyle><SilhouetteEnhancementVolumeStyle></SilhouetteEnhancementVolumeStyle>',
      ),
    ).to.deep.equal(three);
    const unclosed =
      '<EdgeEnhancementVolumeStyle/><ShadedVolumeStyle lighting="true"><Material diffuseColor="1 0 0"/></ShadedVolumeStyle><SilhouetteEnhancementVolumeStyle/>';
    expect(kinds(unclosed)).to.deep.equal(three);
    expect(kinds(`<ComposedVolumeStyle>${unclosed}</ComposedVolumeStyle><CartoonVolumeStyle/>`)).to.deep.equal([
      ...three,
      'cartoon',
    ]);
    expect(
      kinds(
        `<x3d><scene><transform><VolumeData dimensions="1 1 1"><ComposedVolumeStyle>${unclosed}</ComposedVolumeStyle></VolumeData></transform></scene></x3d>`,
      ),
    ).to.deep.equal(three);
    expect(
      kinds(
        '<CartoonVolumeStyle id="one" enabled="true"></CartoonVolumeStyle><EdgeEnhancementVolumeStyle DEF="two"></EdgeEnhancementVolumeStyle><EdgeEnhancementVolumeStyle USE="two"></EdgeEnhancementVolumeStyle>',
      ),
    ).to.deep.equal(['cartoon', 'edge', 'edge']);
  });

  it('are found behind any node that was not closed, wherever it stands', () => {
    const styles =
      '<EdgeEnhancementVolumeStyle></EdgeEnhancementVolumeStyle><SilhouetteEnhancementVolumeStyle></SilhouetteEnhancementVolumeStyle>';
    const leaves = [
      'Viewpoint',
      'OrthoViewpoint',
      'Background',
      'NavigationInfo',
      'Environment',
      'Fog',
      'WorldInfo',
      'DirectionalLight',
      'PointLight',
      'SpotLight',
      'ClipPlane',
      'ImageTextureAtlas',
      'ImageTexture3D',
      'PixelTexture',
      'MetadataString',
      'TimeSensor',
      'ROUTE',
    ];
    for (const leaf of leaves) {
      expect(kinds(`<${leaf}/>${styles}`), leaf).to.deep.equal(['edge', 'silhouette']);
      expect(kinds(`<VolumeData><${leaf}/>${styles}</VolumeData>`), leaf).to.deep.equal(['edge', 'silhouette']);
      expect(
        kinds(
          `<x3d><scene><${leaf}/><Transform><${leaf}/><VolumeData><ComposedVolumeStyle>${styles}</ComposedVolumeStyle></VolumeData></Transform></scene></x3d>`,
        ),
        leaf,
      ).to.deep.equal(['edge', 'silhouette']);
    }
    expect(kinds(leaves.map((leaf) => `<${leaf}/>`).join('') + styles), 'one in the other').to.deep.equal([
      'edge',
      'silhouette',
    ]);
    expect(
      first('<ShadedVolumeStyle lighting="true"><MetadataString/><Material diffuseColor="1 0 0"/></ShadedVolumeStyle>'),
    )
      .to.deep.include({ kind: 'shaded' })
      .and.to.have.nested.property('material.diffuse[0]', 1);
    const { styles: chains } = read(
      '<ToneMappedVolumeStyle></ToneMappedVolumeStyle><BlendedVolumeStyle><MetadataString/><EdgeEnhancementVolumeStyle></EdgeEnhancementVolumeStyle></BlendedVolumeStyle>',
    );
    expect(chains!.map((chain) => chain.styles[0].kind)).to.deep.equal(['tone', 'edge']);
  });

  it('that project an atlas show its values as they are: 128 of 255 as 128, opaque', async () => {
    const host = document.createElement('volume-view');
    void socketOf(host).join({ key: 'atlas', attribute: () => 'atlas.png' });
    const seen = async (html: string, appearance: Partial<VolumeOptics> = {}): Promise<readonly number[]> => {
      host.innerHTML = html;
      const { transferFunction } = await withVolumeNodes(
        { user: { host } },
        { ...plainAppearance, ...appearance },
        { grid },
      );
      return evaluate(transferFunction, 128).map((x) => Math.round((255 * x) / largestOpacity(transferFunction)));
    };
    for (const type of ['MAX', 'MIN', 'AVERAGE'])
      expect(await seen(`<ProjectionVolumeStyle type="${type}"></ProjectionVolumeStyle>`), type).to.deep.equal([
        128, 128, 128, 255,
      ]);
    expect(
      await seen('<OpacityMapVolumeStyle></OpacityMapVolumeStyle>', { projection: 'max' }),
      'by the attribute',
    ).to.deep.equal([128, 128, 128, 255]);
    expect(
      (await seen('<OpacityMapVolumeStyle></OpacityMapVolumeStyle>'))[3],
      'without a projection opacity is the value',
    ).to.be.below(140);
    expect((await seen('<ProjectionVolumeStyle enabled="false"></ProjectionVolumeStyle>'))[3]).to.be.below(140);
  });

  it('that use themselves, or each other, are refused', () => {
    const composed = (name: string, inside: string): string =>
      `<ComposedVolumeStyle DEF="${name}">${inside}</ComposedVolumeStyle>`;
    const use = (name: string): string => `<ComposedVolumeStyle USE="${name}"></ComposedVolumeStyle>`;
    expect(() => read(composed('a', use('a')))).to.throw(/composedvolumestyle> got a USE of itself within it/);
    expect(() => read(composed('a', use('b')) + composed('b', use('a')))).to.throw(/got a USE of itself within it/);
    expect(kinds(composed('a', '<CartoonVolumeStyle></CartoonVolumeStyle>') + use('a'))).to.deep.equal([
      'cartoon',
      'cartoon',
    ]);
  });

  it('blend two styles of a volume by their weights', () => {
    const { styles } = read(
      '<ToneMappedVolumeStyle/><BlendedVolumeStyle weightConstant1="0.7" weightConstant2="0.3"><EdgeEnhancementVolumeStyle/></BlendedVolumeStyle>'.replace(
        'Style/>',
        'Style></ToneMappedVolumeStyle>',
      ),
    );
    expect(styles!.map((chain) => [chain.weight, chain.styles.map(({ kind }) => kind)])).to.deep.equal([
      [0.7, ['tone']],
      [0.3, ['edge']],
    ]);
  });

  it('may have their blend as the last of what is composed', () => {
    const chains = (html: string) =>
      read(html).styles!.map((chain) => [chain.weight, ...chain.styles.map(({ kind }) => kind)]);
    const blend =
      '<BlendedVolumeStyle weightConstant1="0.7" weightConstant2="0.3"><EdgeEnhancementVolumeStyle></EdgeEnhancementVolumeStyle></BlendedVolumeStyle>';
    const composed = (inside: string): string => `<ComposedVolumeStyle>${inside}</ComposedVolumeStyle>`;
    const tone = '<ToneMappedVolumeStyle></ToneMappedVolumeStyle>';
    const flat = chains(tone + blend);
    expect(chains(composed(tone + blend))).to.deep.equal(flat);
    expect(chains(tone + composed(composed(blend)))).to.deep.equal(flat);
    expect(() => read(composed(blend) + tone)).to.throw(/expected that to be the last/);
    expect(() => read(composed(blend + tone))).to.throw(/expected that to be the last/);
    expect(() =>
      read(
        blend.replace(
          '><Edge',
          '><ComposedVolumeStyle><BlendedVolumeStyle></BlendedVolumeStyle></ComposedVolumeStyle><Edge',
        ),
      ),
    ).to.throw(/blendedvolumestyle> stands in another style; expected it outside of that/);
  });

  it('have colours and opacities of textures', async () => {
    const textureOf = (html: string): Element => {
      const host = document.createElement('div');
      host.innerHTML = html;
      return host.firstElementChild!;
    };
    const canvas = Object.assign(document.createElement('canvas'), { width: 3, height: 1 });
    const context = canvas.getContext('2d')!;
    context.putImageData(
      new ImageData(new Uint8ClampedArray([0, 0, 0, 0, 255, 0, 0, 51, 255, 255, 255, 255]), 3),
      0,
      0,
    );
    for (const html of [
      '<PixelTexture image="3 1 4 0x00000000 0xFF000033 0xFFFFFFFF"></PixelTexture>',
      `<ImageTexture containerField="transferFunction" url='"${canvas.toDataURL()}"'></ImageTexture>`,
    ]) {
      const stops = parseTransferFunction(await readOpacityMap(textureOf(html)), [100, 300]);
      expect(stops.map(({ value, opacity }) => [value, opacity])).to.deep.equal([
        [100, 0],
        [200, 0.2],
        [300, 1],
      ]);
      expect(stops[1].color).to.deep.equal([1, 0, 0]);
    }
    expect(await readOpacityMap(textureOf('<PixelTexture image="2 1 1 0 255"></PixelTexture>'))).to.equal(
      '0% rgb(0 0 0) 0%, 100% rgb(255 255 255) 100%',
    );
    for (const html of [
      '<PixelTexture image="2 1 4 0"></PixelTexture>',
      '<ImageTexture url="/nothing.png"></ImageTexture>',
      '<MovieTexture></MovieTexture>',
    ]) {
      expect(await readOpacityMap(textureOf(html)).catch((error: { code: string }) => error.code)).to.equal(
        'attribute/invalid',
      );
    }
  });

  it('leave what attributes say of values and gradients', async () => {
    const host = document.createElement('volume-view');
    host.innerHTML = '<OpacityMapVolumeStyle><PixelTexture image="2 1 1 0 255"></PixelTexture></OpacityMapVolumeStyle>';
    const patches: VolumeOptics['patches'] = [
      { kind: 'box', values: [0, 1], gradients: [0, 1], color: [1, 0, 0], opacity: 0.5 },
    ];
    const ofTexture = await withVolumeNodes({ user: { host } }, plainAppearance, { grid });
    expect(ofTexture.transferFunction).to.have.length(2);
    expect(
      (await withVolumeNodes({ user: { host } }, { ...plainAppearance, patches }, { grid })).transferFunction,
    ).to.equal(plainAppearance.transferFunction);
  });

  it("of X3DOM's factor hold over 1 % of the longest edge of a thin volume, too", async () => {
    const host = document.createElement('volume-view');
    host.innerHTML = '<OpacityMapVolumeStyle opacityFactor="6"></OpacityMapVolumeStyle>';
    const appearance = { ...plainAppearance, referenceLength: defaultReferenceLength(grid) };
    expect(appearance.referenceLength).to.equal(0.05);
    expect((await withVolumeNodes({ user: { host } }, appearance, { grid })).referenceLength).to.equal(1);
    expect(
      (await withVolumeNodes({ user: { host } }, { ...appearance, referenceLength: 3 }, { grid })).referenceLength,
    ).to.equal(3);
    host.setAttribute('reference-length', '0.05');
    expect((await withVolumeNodes({ user: { host } }, appearance, { grid })).referenceLength).to.equal(0.05);
  });

  it("have opacities by X3DOM's factor where it is written", async () => {
    const opacitiesOf = async (fields: string, texture: string): Promise<number[]> => {
      const host = document.createElement('volume-view');
      host.innerHTML = `<OpacityMapVolumeStyle ${fields}>${texture}</OpacityMapVolumeStyle>`;
      return (await withVolumeNodes({ user: { host } }, plainAppearance, { grid })).transferFunction.map(
        ({ opacity }) => opacity,
      );
    };
    const texture = '<PixelTexture image="2 1 1 0 255"></PixelTexture>';
    expect(await opacitiesOf('', texture)).to.deep.equal([0, 1]);
    expect(await opacitiesOf('', ''), 'what is not written leaves a file its look').to.deep.equal([]);
    const [clear, max] = await opacitiesOf('opacityFactor="6"', texture);
    // 85 steps of 6/85 each are the square root of 2 edges long; a reference length is a hundredth of an edge.
    expect([clear, max]).to.deep.equal([0, max]);
    expect(max).to.be.closeTo(1 - Math.exp(-6 / (100 * Math.SQRT2)), 1e-9);
    const ramp = await opacitiesOf('opacityFactor="6"', '');
    expect(ramp).to.have.length(256);
    expect([ramp[0], ramp[255]]).to.deep.equal([0, max]);
  });

  it('have what is painted on a canvas', async () => {
    const texture = document.createElement('Texture');
    const canvas = Object.assign(document.createElement('canvas'), { width: 2, height: 1 });
    texture.append(canvas);
    expect(await readOpacityMap(texture).catch((error: Error) => error.message)).to.match(
      /got a canvas that is clear; expected one that has been painted/,
    );
    canvas.getContext('2d')!.putImageData(new ImageData(new Uint8ClampedArray([0, 0, 0, 0, 255, 0, 0, 255]), 2), 0, 0);
    expect(await readOpacityMap(texture)).to.equal('0% rgb(0 0 0) 0%, 100% rgb(255 0 0) 100%');
  });

  it('are surfaces in IsoSurfaceVolumeData', () => {
    const transferFunction = [
      { value: 0, color: [1, 0, 0], opacity: 0.5 },
      { value: 10, color: [1, 0, 0], opacity: 0.5 },
    ] as const;
    const shaded =
      '<ShadedVolumeStyle lighting="true"><Material diffuseColor="0 1 0" transparency="0.25"></Material></ShadedVolumeStyle>';
    const isoOf = (html: string) => read(html, { transferFunction, window: [0, 10] }).surfaces;
    expect(isoOf('<IsoSurfaceVolumeData surfaceValues="4 2"></IsoSurfaceVolumeData>')).to.deep.equal({
      clear: true,
      surfaces: [2, 4].map((value) => ({ value, color: [1, 0, 0], opacity: 1 })),
    });
    expect(
      isoOf(
        `<IsoSurfaceVolumeData surfaceValues="4 2"><OpacityMapVolumeStyle></OpacityMapVolumeStyle>${shaded}</IsoSurfaceVolumeData>`,
      )!.surfaces,
    ).to.deep.equal([
      { value: 2, color: [0, 1, 0], opacity: 0.75 },
      { value: 4, color: [1, 0, 0], opacity: 1 },
    ]);
    expect(
      isoOf('<IsoSurfaceVolumeData surfaceValues="4" contourStepSize="3"></IsoSurfaceVolumeData>')!.surfaces.map(
        ({ value }) => value,
      ),
    ).to.deep.equal([1, 4, 7, 10]);
    const composed = isoOf(
      '<IsoSurfaceVolumeData surfaceValues="4"><ComposedVolumeStyle><CartoonVolumeStyle colorSteps="32"></CartoonVolumeStyle><EdgeEnhancementVolumeStyle></EdgeEnhancementVolumeStyle></ComposedVolumeStyle></IsoSurfaceVolumeData>',
    )!;
    expect(composed.surfaceStyles!.map(({ kind }) => kind)).to.deep.equal(['cartoon', 'edge']);
    expect(composed.surfaces).to.deep.equal([{ value: 4, color: [1, 0, 0], opacity: 1 }]);
    expect(
      isoOf(
        '<IsoSurfaceVolumeData surfaceValues="4"><ShadedVolumeStyle lighting="false"></ShadedVolumeStyle></IsoSurfaceVolumeData>',
      )!.plain,
    ).to.equal(true);
  });

  for (const [what, html, message] of [
    [
      'surfaces without a value',
      '<IsoSurfaceVolumeData></IsoSurfaceVolumeData>',
      /surfaceValues of IsoSurfaceVolumeData got ""/,
    ],
    [
      'surfaces in several styles',
      '<IsoSurfaceVolumeData surfaceValues="1"><CartoonVolumeStyle></CartoonVolumeStyle><ShadedVolumeStyle></ShadedVolumeStyle></IsoSurfaceVolumeData>',
      /got <cartoonvolumestyle> and other styles; expected one style for all surfaces/,
    ],
    [
      'surfaces that are blended',
      '<IsoSurfaceVolumeData surfaceValues="1"><BlendedVolumeStyle></BlendedVolumeStyle></IsoSurfaceVolumeData>',
      /neither projected nor blended/,
    ],
    [
      'a projection among others',
      '<ProjectionVolumeStyle></ProjectionVolumeStyle><CartoonVolumeStyle></CartoonVolumeStyle>',
      /expected it alone/,
    ],
    [
      'a projection that is composed',
      '<ComposedVolumeStyle><ProjectionVolumeStyle></ProjectionVolumeStyle></ComposedVolumeStyle>',
      /X3D composes no projections/,
    ],
    [
      'a threshold that is none',
      '<ProjectionVolumeStyle intensityThreshold="-1"></ProjectionVolumeStyle>',
      /intensityThreshold of <projectionvolumestyle> got "-1"; expected a number from 0/,
    ],
    [
      'a number out of range',
      '<CartoonVolumeStyle colorSteps="65"></CartoonVolumeStyle>',
      /colorSteps of CartoonVolumeStyle got "65"; expected a number from 1 to 64/,
    ],
    [
      'no colour',
      '<EdgeEnhancementVolumeStyle edgeColor="red"></EdgeEnhancementVolumeStyle>',
      /edgeColor of EdgeEnhancementVolumeStyle got "red"/,
    ],
    [
      'normals of their own',
      '<CartoonVolumeStyle><ImageTexture3D containerField="surfaceNormals"></ImageTexture3D></CartoonVolumeStyle>',
      /surfaceNormals; expected none/,
    ],
    [
      'two lights',
      '<ShadedVolumeStyle lighting="true"></ShadedVolumeStyle><ShadedVolumeStyle lighting="true"></ShadedVolumeStyle>',
      /more than one ShadedVolumeStyle/,
    ],
    [
      "a style of X3DOM's own",
      '<StippleVolumeStyle></StippleVolumeStyle>',
      /<stipplevolumestyle> is no rendering style of X3D's/,
    ],
    ['two volumes', '<VolumeData></VolumeData><VolumeData></VolumeData>', /got 2 volume nodes/],
    [
      'a style after a blend',
      '<BlendedVolumeStyle></BlendedVolumeStyle><CartoonVolumeStyle></CartoonVolumeStyle>',
      /expected that to be the last/,
    ],
    [
      'a second volume without a file',
      '<BlendedVolumeStyle><ImageTexture3D containerField="voxels"></ImageTexture3D></BlendedVolumeStyle>',
      /url of <imagetexture3d> got ""/,
    ],
    [
      'weights that are not constant',
      '<BlendedVolumeStyle weightFunction2="ALPHA1"></BlendedVolumeStyle>',
      /weightFunction2 of <blendedvolumestyle> got "ALPHA1"; expected CONSTANT/,
    ],
    [
      'a table of weights',
      '<BlendedVolumeStyle><ImageTexture containerField="weightTransferFunction1" url="a.png"></ImageTexture></BlendedVolumeStyle>',
      /got a weightTransferFunction; expected none: weights are the numbers weightConstant1/,
    ],
    ['a name that nobody has', '<CartoonVolumeStyle USE="other"></CartoonVolumeStyle>', /USE="other"/],
  ] as const) {
    it(`refuses ${what} in words`, () => {
      expect(() => read(html))
        .to.throw(message)
        .with.property('code', 'attribute/invalid');
    });
  }
});

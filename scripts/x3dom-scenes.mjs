// Scenes like X3DOM's own examples for volumes: the same nodes, fields and numbers, with data of this project. X3DOM's examples with an
// ImageTexture3D name NRRD files, which X3DOM can't read: here they have an atlas instead.

/**
 * A volume as an image of slices.
 * @typedef {{ url: string, slices: number, across: number, down: number }} Atlas
 */

/**
 * @typedef {object} Data
 * @property {Atlas} brain
 * @property {Atlas} body
 * @property {Atlas} inside - of the body
 * @property {Atlas} halves - of the brain: each voxel has the number of its half
 * @property {string} colors - URL of a transfer function's image
 */

/**
 * @typedef {object} ExampleScene
 * @property {string} file - the path in X3DOM's repository
 * @property {string} title - the difference from the other scenes
 * @property {(data: Data) => string} html
 * @property {string} [code] - code of the error that the element reports; absent where there is none
 */

const functional = 'test/functional/volren';
const regression = 'test/regression-suite/test/cases';

/** @param {Atlas} atlas */
const atlasOf = ({ url, slices, across, down }, field = 'voxels') =>
  `<ImageTextureAtlas containerField='${field}' url='${url}' numberOfSlices='${slices}' slicesOverX='${across}' slicesOverY='${down}'></ImageTextureAtlas>`;

/**
 * The frame of the examples that other X3D programs have too: small, and seen from near.
 * @param {{ view: string, sky?: string, lamp?: string, scale: string }} frame
 * @param {string} volume
 */
const small = ({ view, sky, lamp = '', scale }, volume) => `<scene><group>
  <viewpoint ${view}></viewpoint><background ${sky ? `skyColor='${sky}'` : ''}></background>${lamp}
  <transform scale='${scale} ${scale} ${scale}'>${volume}</transform></group></scene>`;

/** The frame of X3DOM's own examples. @param {string} volume @param {string} sky */
const large = (volume, sky = '0 0 0') =>
  `<scene><background skyColor='${sky}'></background><viewpoint description='Default' zNear='0.0001' zFar='100'></viewpoint><transform>${volume}</transform></scene>`;

const backpack = {
  view: "orientation='-0.981013 -0.121179 -0.151425 4.93207' position='0.0469256 -0.208028 0.0503946'",
  sky: '1 1 1',
  scale: '0.117188',
};
const brain = {
  view: "orientation='-0.0212122 0.99986 0.012461 3.23009' position='-0.00920216 0.012033 -0.184913'",
  sky: '1 1 1',
  scale: '0.117188',
};
const skull = {
  view: "orientation='-0.675123 0.549845 0.491812 4.56937' position='-0.294435 -0.11334 0.0508642'",
  sky: '0 0 0',
  scale: '0.117188',
};
const inside = {
  view: "orientation='0.940022 0.208839 0.269711 1.71637' position='0.108923 -0.189725 -0.0135375'",
  scale: '0.000292969',
};
const ventricles = {
  view: "position='0 0 0.21'",
  lamp: "<pointlight intensity='0.4' location='1 0 1'></pointlight>",
  scale: '0.0651042',
};

/** @param {string} dimensions @param {string} inner */
const volume = (dimensions, inner) => `<VolumeData dimensions='${dimensions}'>${inner}</VolumeData>`;

/** @param {string} fields @param {string} [texture] */
const opacityMap = (fields, texture = '') => `<OpacityMapVolumeStyle ${fields}>${texture}</OpacityMapVolumeStyle>`;

/** @type {readonly ExampleScene[]} */
export const exampleScenes = [
  {
    file: `${functional}/volrenBasicBackpack.html`,
    title: 'No style',
    html: ({ body }) => small(backpack, volume('1 1 1', atlasOf(body))),
  },
  {
    file: `${functional}/volrenBasicInternals.html`,
    title: 'Tone-mapped',
    html: (data) =>
      small(inside, volume('512 512 452', `<ToneMappedVolumeStyle></ToneMappedVolumeStyle>${atlasOf(data.inside)}`)),
  },
  {
    file: `${functional}/volrenBlendedBodyInternals.html`,
    title: 'Blended',
    code: 'attribute/invalid',
    html: (data) =>
      small(
        inside,
        volume(
          '512 512 452',
          `<BlendedVolumeStyle weightConstant1='0.51'><ToneMappedVolumeStyle></ToneMappedVolumeStyle>${atlasOf(data.inside)}</BlendedVolumeStyle>${atlasOf(data.body)}`,
        ),
      ),
  },
  {
    file: `${functional}/volrenCartoonBackpack.html`,
    title: 'Cartoon',
    html: ({ body }) => small(backpack, volume('1 1 1', `<CartoonVolumeStyle></CartoonVolumeStyle>${atlasOf(body)}`)),
  },
  {
    file: `${functional}/volrenComposedBackpack.html`,
    title: 'Composed',
    html: ({ body }) =>
      small(
        backpack,
        volume(
          '1 1 1',
          `<ComposedVolumeStyle>
      <SilhouetteEnhancementVolumeStyle silhouetteBoundaryOpacity='1' silhouetteRetainedOpacity='.1' silhouetteSharpness='10'></SilhouetteEnhancementVolumeStyle>
      <EdgeEnhancementVolumeStyle edgeColor='.5 0 0' gradientThreshold='.8'></EdgeEnhancementVolumeStyle></ComposedVolumeStyle>${atlasOf(body)}`,
        ),
      ),
  },
  {
    file: `${functional}/volrenEdgeBrain.html`,
    title: 'Edges',
    html: (data) =>
      small(
        brain,
        volume('1.28 1.28 1.0', `<EdgeEnhancementVolumeStyle></EdgeEnhancementVolumeStyle>${atlasOf(data.brain)}`),
      ),
  },
  {
    file: `${functional}/volrenIsoSurfaceSkull.html`,
    title: 'Iso-surface',
    html: ({ body }) =>
      small(
        skull,
        `<IsoSurfaceVolumeData dimensions='1.28 1.28 1.28' surfaceValues='.15'><CartoonVolumeStyle colorSteps='32'></CartoonVolumeStyle>${atlasOf(body)}</IsoSurfaceVolumeData>`,
      ),
  },
  {
    file: `${functional}/volrenProjectionMaxVentricles.html`,
    title: 'Projection, whole ray',
    html: (data) =>
      small(
        ventricles,
        volume('2.304 2.304 1.116', `<ProjectionVolumeStyle type='MAX'></ProjectionVolumeStyle>${atlasOf(data.brain)}`),
      ),
  },
  {
    file: `${functional}/volrenSegmentedVentricles.html`,
    title: 'Segmented',
    code: 'attribute/invalid',
    html: (data) =>
      small(
        ventricles,
        `<SegmentedVolumeData dimensions='2.304 2.304 1.116'>${atlasOf(data.halves, 'segmentIdentifiers')}${atlasOf(data.brain)}
      <OpacityMapVolumeStyle></OpacityMapVolumeStyle><ToneMappedVolumeStyle></ToneMappedVolumeStyle></SegmentedVolumeData>`,
      ),
  },
  {
    file: `${functional}/volrenShadedBrain.html`,
    title: 'Shaded',
    html: (data) =>
      small(
        brain,
        volume(
          '1.28 1.28 1.0',
          `<ShadedVolumeStyle lighting='TRUE' shadows='TRUE'><Material ambientIntensity='0.8' diffuseColor='0 .5 1' shininess='0.08' specularColor='1 1 1'></Material></ShadedVolumeStyle>${atlasOf(data.brain)}`,
        ),
      ),
  },
  {
    file: `${functional}/volrenSilhouetteSkull.html`,
    title: 'Silhouette',
    html: ({ body }) =>
      small(
        skull,
        volume(
          '1.28 1.28 1.28',
          `<SilhouetteEnhancementVolumeStyle silhouetteBoundaryOpacity='1' silhouetteRetainedOpacity='.5' silhouetteSharpness='10'></SilhouetteEnhancementVolumeStyle>${atlasOf(body)}`,
        ),
      ),
  },
  {
    file: `${functional}/volrenOpacityTest_aorta.xhtml`,
    title: 'Opacity 0.4',
    html: ({ body }) =>
      large(volume('4.0 4.0 4.0', atlasOf(body) + opacityMap("lightFactor='0.1' opacityFactor='0.4'"))),
  },
  {
    file: `${functional}/volrenOpacityTest_skull.xhtml`,
    title: 'Opacity 0.8',
    html: ({ body }) => large(volume('4.0 4.0 4.0', atlasOf(body) + opacityMap("opacityFactor='0.8'"))),
  },
  {
    file: `${functional}/volrenOpacityTest_backpack.xhtml`,
    title: 'Opacity map',
    html: ({ body }) => large(volume('4.0 4.0 4.0', atlasOf(body) + opacityMap(''))),
  },
  {
    file: 'example/x3dom_volrenOpacityTestTF_aorta.xhtml',
    title: 'Light 0.02',
    html: ({ body, colors }) =>
      large(
        volume(
          '4.0 4.0 4.0',
          atlasOf(body) +
            opacityMap(
              "lightFactor='0.02' opacityFactor='0.4'",
              `<ImageTexture containerField='transferFunction' url='${colors}'></ImageTexture>`,
            ),
        ),
      ),
  },
  {
    file: `${regression}/volrenEdge/volrenEdge.html`,
    title: 'Edges, 1.8',
    html: ({ body }) =>
      large(
        volume(
          '4.0 4.0 4.0',
          `${atlasOf(body)}<EdgeEnhancementVolumeStyle edgeColor='0 0 1' gradientThreshold='1.8'></EdgeEnhancementVolumeStyle>`,
        ),
      ),
  },
  {
    file: `${regression}/volrenOpacity/volrenOpacity.html`,
    title: 'Opacity 6, texture',
    html: ({ body, colors }) =>
      large(
        volume(
          '4.0 4.0 4.0',
          atlasOf(body) +
            opacityMap(
              "lightFactor='1.2' opacityFactor='6.0'",
              `<ImageTexture containerField='transferFunction' url='${colors}'></ImageTexture>`,
            ),
        ),
      ),
  },
  {
    file: `${regression}/volrenProjection/volrenProjection.html`,
    title: 'Projection',
    html: ({ body }) =>
      large(
        volume(
          '4.0 4.0 4.0',
          `${atlasOf(body)}<ProjectionVolumeStyle intensityThreshold='1.0' type='max'></ProjectionVolumeStyle>`,
        ),
      ),
  },
  {
    file: `${regression}/depthVolren/depthVolren.html`,
    title: 'Depth-mapped',
    code: 'attribute/invalid',
    html: ({ body, colors }) =>
      `<scene><background transparency='0.0' skyColor='0 0 0'></background><viewpoint position='0 0 13' zNear='0.1' zFar='100.0' fieldOfView='0.5'></viewpoint>${volume(
        '4.0 4.0 4.0',
        `${atlasOf(body)}<DepthMappedVolumeStyle isoSurfaceCutoffValue='0.3' transparency='0.9' intensityLimits='0.0 1.0'><ImageTexture containerField='transferFunction' url='${colors}'></ImageTexture></DepthMappedVolumeStyle>`,
      )}</scene>`,
  },
];

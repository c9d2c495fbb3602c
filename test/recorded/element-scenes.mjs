// Scenes as pages write them: tags and attributes alone, so that they outlive any change inside of the package.

/**
 * @typedef {object} ElementScene
 * @property {string} name
 * @property {Record<string, string>} attributes
 * @property {string} [children] - X3D and slices, as HTML
 * @property {number} [width] - CSS pixels
 * @property {number} [height]
 * @property {number} [pixelRatio] - device pixels in a CSS pixel; where given, the picture has its own size
 * @property {boolean} [webgl1]
 */

const data = '/demos/data';
const fixtures = '/test/fixtures';

const brain = { src: `${data}/mni152-t1.nii.gz`, 'camera-orbit': '30deg 75deg 100%' };
const torso = { src: `${data}/ct-phantom.json`, 'camera-orbit': '30deg 80deg 110%' };
const storm = { src: `${data}/storm-synthetic.json`, 'camera-orbit': '30deg 55deg 80%' };

const jumps = '30% #4080c0 0, 30% #4080c0 3%, 55% #4080c0 3%, 55% #ffcc33 30%, 80% #ffcc33 30%, 80% white 90%';
const peaks =
  '19.5% #48c 0, 20% #48c 60%, 20.5% #48c 0, 44.5% #f93 0, 45% #f93 60%, 45.5% #f93 0, 69.5% white 0, 70% white 60%, 70.5% white 0';
/** One colour and one opacity for each range of values, as the editor of bands writes them. */
const bands = [
  [10, '#2266ff', '1%'],
  [20, '#22cc66', '4%'],
  [30, '#ffee33', '10%'],
  [40, '#ff8800', '25%'],
  [50, '#ee1122', '60%'],
]
  .map(([from, color, opacity]) => `${from} ${color} ${opacity}, ${Number(from) + 10} ${color} ${opacity}`)
  .join(', ');

/** @param {string} color @param {string} place @param {{ more?: string, shape?: string }} [what] */
const shape = (color, place, { more = '', shape: form = '<sphere radius="22"></sphere>' } = {}) => `
  <transform translation="${place}"><shape>
    <appearance><material diffusecolor="${color}" ${more}></material></appearance>${form}
  </shape></transform>`;

/** @type {ElementScene[]} */
const presets = [
  ...['mri', 'gray', 'viridis', 'inferno', 'magma', 'plasma', 'cividis', 'turbo'].map((preset, i) => ({
    name: `brain, ${preset}`,
    attributes: { ...brain, 'transfer-function': preset, 'camera-orbit': `${30 + 40 * i}deg ${80 - 5 * i}deg 100%` },
  })),
  ...['ct-bone', 'ct-soft-tissue', 'ct-angio', 'ct-lung'].map((preset, i) => ({
    name: `torso, ${preset}`,
    attributes: { ...torso, 'transfer-function': preset, 'camera-orbit': `${-20 + 30 * i}deg 80deg 105%` },
  })),
];

/** @type {ElementScene[]} */
const optics = [
  { name: 'brain, nothing said', attributes: { src: brain.src } },
  { name: 'brain, jumps', attributes: { ...brain, 'transfer-function': jumps } },
  { name: 'brain, three peaks', attributes: { ...brain, 'transfer-function': peaks } },
  { name: 'storm, bands', attributes: { ...storm, 'transfer-function': bands } },
  { name: 'storm', attributes: storm },
  { name: 'brain, opacity factor', attributes: { ...brain, 'opacity-factor': '0.15' } },
  { name: 'brain, light factor', attributes: { ...brain, 'light-factor': '2.5', 'transfer-function': 'gray' } },
  { name: 'brain, reference length', attributes: { ...brain, 'reference-length': '12' } },
  // The attribute has had two names; what is not known is not read.
  {
    name: 'brain, window',
    attributes: { ...brain, window: '60 140', 'value-window': '60 140', 'transfer-function': 'viridis' },
  },
  { name: 'brain, few steps', attributes: { ...brain, steps: '24' } },
];

/** @type {ElementScene[]} */
const views = [
  { name: 'brain, region', attributes: { ...brain, region: '-70 -90 -40 10 40 60' } },
  {
    name: 'brain, from inside',
    attributes: { ...brain, 'camera-orbit': '60deg 80deg 8%', 'field-of-view': '70deg', 'opacity-factor': '0.5' },
  },
  {
    name: 'brain, target and wide angle',
    attributes: { ...brain, 'camera-target': '30 10 40', 'field-of-view': '80deg', 'camera-orbit': '120deg 40deg 60%' },
  },
  { name: 'brain, from above', attributes: { ...brain, 'camera-orbit': '0deg 0deg 100%' } },
  { name: 'brain, wide picture', attributes: brain, width: 320, height: 110 },
  {
    name: 'torso, tall picture',
    attributes: { ...torso, 'transfer-function': 'ct-soft-tissue' },
    width: 110,
    height: 280,
  },
  {
    name: 'torso, two device pixels in one',
    attributes: { ...torso, 'transfer-function': 'ct-bone' },
    width: 131,
    height: 97,
    pixelRatio: 2,
  },
];

/** @type {ElementScene[]} */
const shapes = [
  {
    name: 'brain, opaque shapes',
    attributes: { ...brain, 'opacity-factor': '0.3' },
    children: shape('orange', '-26 -20 14') + shape('teal', '30 30 30', { shape: '<box size="40 30 50"></box>' }),
  },
  {
    name: 'brain, transparent shapes',
    attributes: { ...brain, 'opacity-factor': '0.3' },
    children:
      shape('orange', '-26 40 14', { more: 'transparency="0.5"' }) +
      shape('red', '60 60 30', { more: 'transparency="0.3"' }),
  },
  {
    name: 'brain, a light and an emissive box',
    attributes: { ...brain, 'opacity-factor': '0.2' },
    children: `<directionallight direction="0 -1 0" color="0.4 0.4 1"></directionallight>${shape('white', '0 0 20', { more: 'emissivecolor="0 0.4 0"', shape: '<cylinder radius="15" height="150"></cylinder>' })}`,
  },
  {
    name: "torso, the author's viewpoint",
    attributes: { ...torso, 'transfer-function': 'ct-lung' },
    children:
      '<viewpoint position="0 900 100" orientation="0 0.7071 0.7071 3.14159" fieldofview="0.6" centerofrotation="0 0 0"></viewpoint>',
  },
];

/** Few voxels of every kind: the fixtures, and a mosaic without a manifest. @type {ElementScene[]} */
const kinds = [
  {
    name: 'brain, mosaic with a manifest',
    attributes: { ...brain, src: `${data}/mni152-t1.json`, 'camera-orbit': '-60deg 70deg 100%' },
  },
  {
    name: 'brain, mosaic by attributes',
    attributes: { ...brain, src: `${data}/mni152-t1.png`, mosaic: '16x12', slices: '189', spacing: '1 1 1.4' },
  },
  ...['holes.nii', 'v1-le-f4.nii', 'v1-be-u1.nii', 'v2-be-u2.nii', 'v1-le-c8.nii', 'v1-le-qform.nii'].map(
    (file, i) => ({
      name: `fixture ${file}`,
      attributes: {
        src: `${fixtures}/nifti/${file}`,
        'transfer-function': 'turbo',
        'camera-orbit': `${25 + 15 * i}deg 65deg 100%`,
        'opacity-factor': '8',
      },
    }),
  ),
  {
    name: 'fixture gray16-3x2.png',
    attributes: {
      src: `${fixtures}/mosaic/gray16-3x2.png`,
      mosaic: '3x2',
      'transfer-function': 'plasma',
      'opacity-factor': '8',
    },
  },
];

const repeated = [
  'brain, mri',
  'brain, mosaic with a manifest',
  'brain, mosaic by attributes',
  'torso, ct-bone',
  'storm',
  'storm, bands',
  'brain, jumps',
  'brain, from inside',
  'brain, region',
  'brain, opaque shapes',
  'brain, transparent shapes',
  'fixture holes.nii',
  'fixture v1-le-f4.nii',
  'fixture gray16-3x2.png',
];

/** @param {readonly ElementScene[]} scenes @param {readonly string[]} names @returns {ElementScene[]} */
export function inWebGl1(scenes, names) {
  return names.map((name) => {
    const scene = scenes.find((one) => one.name === name);
    if (!scene)
      throw new Error(
        `a scene to be repeated in WebGL 1 got the name "${name}"; expected one of ${scenes.map((one) => one.name).join('; ')}`,
      );
    return { ...scene, name: `${name}, WebGL 1`, webgl1: true };
  });
}

const cartesian = [...presets, ...optics, ...views, ...shapes, ...kinds];

/** @type {readonly ElementScene[]} */
export const cartesianScenes = [...cartesian, ...inWebGl1(cartesian, repeated)];

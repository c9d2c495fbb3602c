import {
  makeChecker,
  makeLesions,
  makeMap,
  makeMesh,
  makePlate,
  makeShells,
  makeText,
  makeWaves,
  makeWires,
  scatter,
  smallFunctions,
  veilValue,
} from './small-volumes.ts';
import type { SmallVolume } from './small-volumes.ts';

/** How a scene is seen. */
export interface SceneView {
  /** Of the picture where the camera's target is. */
  readonly pixelsPerVoxel: number;
  /** Device pixels along each side. */
  readonly pixels: number;
  /** Device pixels of a CSS pixel. */
  readonly ratio: number;
  /** The first angle, degrees. */
  readonly theta: number;
  readonly phi: number;
}

/** A scene of small things. */
export interface SmallScene {
  readonly name: string;
  readonly view: SceneView;
  /** The attribute; data values are 0..255. null for the element's own choice. */
  readonly transferFunction: string | null;
  /** Things of less contrast in full rays do not count, 1/255. */
  readonly minContrast: number;
  /** Around a place its thing is looked for, voxels. */
  readonly reach: number;
  readonly make: () => SmallVolume;
}

/** A real volume, in which no small things are known. */
export interface RealScene extends Pick<SmallScene, 'name' | 'view' | 'transferFunction'> {
  readonly url: string;
}

const sight = (
  pixelsPerVoxel: number,
  pixels: number,
  ratio: number,
  [theta, phi]: readonly [number, number] = [30, 75],
): SceneView => ({ pixelsPerVoxel, pixels, ratio, theta, phi });

const usual = { transferFunction: smallFunctions.veil, minContrast: 8, reach: 1 };
const alone = { ...usual, transferFunction: smallFunctions.solid };
const ramp = '0 #234 0, 30 #48c 12%, 140 #c96 25%, 255 white 50%';

/** All scenes of known small things. */
export const smallScenes: readonly SmallScene[] = [
  {
    ...usual,
    name: 'Specks of 1 voxel in a veil, large',
    view: sight(2.5, 144, 1),
    make: () => scatter(64, veilValue, 60, 0),
  },
  {
    ...usual,
    name: 'Specks of 1 voxel in a veil, small',
    view: sight(1, 128, 2, [50, 60]),
    make: () => scatter(96, veilValue, 60, 0),
  },
  {
    ...alone,
    name: 'Specks of 1 voxel in empty space',
    view: sight(2, 160, 1, [200, 100]),
    make: () => scatter(64, 0, 60, 0),
  },
  {
    ...usual,
    name: 'Balls, radius 1.2 voxels, in a veil',
    view: sight(1.5, 112, 1, [120, 80]),
    make: () => scatter(80, veilValue, 60, 1.2),
  },
  {
    ...usual,
    name: 'Lesions of low contrast, radius 2',
    reach: 2,
    minContrast: 2,
    view: sight(2.2, 128, 1, [10, 80]),
    transferFunction: '0 #400 0, 60 #400 0, 80 #a64 1.5%, 170 #fda 6%, 255 white 10%',
    make: makeLesions,
  },
  { ...alone, name: 'Wires of 1 voxel', view: sight(1.2, 144, 3, [70, 70]), make: () => makeWires(96, 14) },
  { ...alone, name: 'Plate of 1 voxel', view: sight(2, 160, 1, [35, 25]), make: () => makePlate(64, 1, 10) },
  { ...alone, name: 'Plate of 2 voxels', view: sight(1.5, 128, 2, [110, 60]), make: () => makePlate(64, 2, 10) },
  {
    ...alone,
    name: 'Plate of 1 voxel, almost from its edge',
    view: sight(1, 96, 1, [20, 86]),
    make: () => makePlate(64, 1, 10),
  },
  { ...alone, name: 'Mesh of bars of 1 voxel', view: sight(3, 192, 1, [25, 40]), make: () => makeMesh(64) },
  { ...alone, name: 'The same mesh from far', view: sight(0.5, 64, 1, [25, 40]), make: () => makeMesh(128) },
  {
    ...alone,
    name: 'Threshold on a smooth map, zoomed in',
    view: sight(6, 192, 2, [60, 70]),
    reach: 1.5,
    transferFunction: '0 #a00 0, 150 #a00 0, 150 #f40 6%, 255 #ff0 60%',
    make: () => makeMap(64),
  },
  { ...alone, name: 'Text, strokes of 1 voxel', view: sight(2, 162, 3, [15, 35]), make: () => makeText(72) },
  {
    ...usual,
    name: 'Checkerboard, cells of 2 voxels',
    transferFunction: ramp,
    view: sight(1.5, 112, 0.5, [20, 30]),
    make: () => makeChecker(64),
  },
  {
    ...usual,
    name: 'Waves of 2 to 8 pixels',
    transferFunction: ramp,
    view: sight(1, 96, 1, [8, 20]),
    make: () => makeWaves(80),
  },
  {
    ...alone,
    name: 'Shells of about 1 voxel',
    transferFunction: '0 #8cf 0, 120 #8cf 0, 180 #8cf 15%, 220 white 30%',
    view: sight(1.8, 132, 1.5, [300, 110]),
    make: () => makeShells(72),
  },
];

/** Volumes of people and things, as the element shows them by itself. */
export const realScenes: readonly RealScene[] = [
  { name: 'MRI of a brain', url: '/demos/data/mni152-t1.nii.gz', transferFunction: null, view: sight(0.8, 192, 1) },
  { name: 'CT phantom', url: '/demos/data/ct-phantom.nii.gz', transferFunction: 'ct-bone', view: sight(1.2, 160, 2) },
];

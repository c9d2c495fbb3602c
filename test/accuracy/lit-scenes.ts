// Scenes with light, surfaces, X3D's styles, value and gradient, and radars.
import type { Camera } from '../../src/optics/rays/camera.ts';
import { framingDistance, orbitCamera } from '../../src/optics/rays/camera.ts';
import type { ShownOverlay } from '../../src/optics/attachments/overlay.ts';
import { outlinePatches } from '../../src/optics/transfer/patches.ts';
import type { Patch } from '../../src/optics/transfer/patches.ts';
import type { RayStyle } from '../../src/optics/rays/ray-style.ts';
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import type { VolumeStyle } from '../../src/optics/transfer/volume-styles.ts';
import { boundingSphere } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { litScenes, listVariants, loadScan } from '../bench/lit-scenes.ts';
import { cloudCamera, cloudColors, cloudVolume } from '../helpers/polar-cloud.ts';
import { errorScenes } from './error-scenes.ts';
import type { ErrorScene } from './error-scenes.ts';

/** A scene, and how it is drawn. */
export interface LitErrorScene extends ErrorScene {
  /** As the table names scenes of the kind. */
  readonly kind: string;
  readonly style: RayStyle;
  /** World length. */
  readonly referenceLength: number;
  /** Another moment of a radar. */
  readonly overlay?: ShownOverlay;
}

const steep: VolumeStyle = {
  kind: 'gradient',
  stops: [
    [0, 0.05],
    [0.02, 0.1],
    [0.06, 1],
  ],
};
const cartoon: VolumeStyle = { kind: 'cartoon', parallel: [1, 0.8, 0.3], orthogonal: [0.2, 0, 0.5], steps: 3 };
const boundary: VolumeStyle = { kind: 'boundary', retained: 0.2, boundary: 0.9, power: 2 };
const tone: VolumeStyle = { kind: 'tone', cool: [0.1, 0.2, 0.8], warm: [1, 0.7, 0.2] };

const patches: readonly Patch[] = [
  { kind: 'box', values: [0.3, 0.7], gradients: [0.01, 0.08], color: [1, 0.6, 0.3], opacity: 0.2 },
  { kind: 'gaussian', value: 0.55, gradient: 0.05, widths: [0.1, 0.02], color: [0.4, 0.7, 1], opacity: 0.5 },
];

const surfaces = [
  { value: 0.42, color: [1, 0.6, 0.4], opacity: 0.4 },
  { value: 0.62, color: [0.8, 0.9, 1], opacity: 1 },
] as const;

/** What is drawn of `errorScenes`: which of them, by number, and how. */
const kinds: readonly { readonly kind: string; readonly style: RayStyle; readonly scenes: readonly number[] }[] = [
  { kind: 'lit fog', style: { lit: true }, scenes: [0, 2, 4, 6, 8, 10, 12, 14, 17, 19, 21, 23, 25, 27, 29, 31] },
  {
    kind: '`gradient-opacity`, lit',
    style: { lit: true, styles: [{ weight: 1, styles: [steep] }] },
    scenes: [1, 5, 9, 13, 17, 21, 25, 29],
  },
  {
    kind: 'X3D styles',
    style: {
      styles: [
        { weight: 0.6, styles: [cartoon, boundary] },
        { weight: 0.4, styles: [tone] },
      ],
    },
    scenes: [2, 7, 12, 17, 22, 27],
  },
  { kind: 'surfaces in lit fog', style: { lit: true, surfaces }, scenes: [0, 5, 10, 15, 20, 25] },
  { kind: 'lit surfaces alone', style: { surfaces, clear: true }, scenes: [3, 8, 13, 18] },
  { kind: '`transfer-function-2d`, lit', style: { lit: true, patches }, scenes: [0, 1, 8, 9, 16, 17, 24, 25] },
];

/** Scenes of a short run: of each kind the first so many. */
const few = 2;

/** @param quick - whether some of each kind are enough */
export async function* eachLitScene(quick: boolean): AsyncGenerator<LitErrorScene> {
  const all = errorScenes();
  for (const { kind, style, scenes } of kinds) {
    for (const number of scenes.slice(0, quick ? few : Infinity)) {
      const scene = all[number];
      const transferFunction = style.patches
        ? outlinePatches(style.patches, scene.volume.range)
        : scene.transferFunction;
      yield { ...scene, kind, style, transferFunction, referenceLength: 1 };
    }
  }
  const radars = [...radarsOf(cloud()), ...radarsOf(await storm())];
  yield* quick ? radars.slice(0, few) : radars;
}

/** A radar from some sides, lit, without and with another moment as colour. */
interface Radar {
  readonly name: string;
  readonly volume: Volume;
  readonly transferFunction: TransferFunction;
  readonly referenceLength: number;
  readonly overlay: ShownOverlay;
  /** Each with steps of its own. */
  readonly views: readonly { readonly camera: Camera; readonly steps: number }[];
}

function* radarsOf({ name, views, overlay, ...common }: Radar): Generator<LitErrorScene> {
  for (const view of views) {
    const one = { ...common, ...view, style: { lit: true } as const };
    yield { ...one, kind: 'radar, lit', name: `${name}, ${view.steps} steps` };
    yield { ...one, kind: 'radar, lit, another moment as colour', name: `${name}, ${view.steps} steps`, overlay };
  }
}

const plainColors: TransferFunction = [
  { value: 0, color: [0.1, 0.3, 0.9], opacity: 1 },
  { value: 1, color: [0.9, 0.3, 0.1], opacity: 1 },
];

/** Its other moment has other gates. */
function cloud(): Radar {
  const volume = cloudVolume(1);
  return {
    name: 'cloud',
    volume,
    transferFunction: cloudColors,
    referenceLength: 3000,
    overlay: {
      volume: cloudVolume(1.3),
      over: volume,
      transferFunction: plainColors,
      blend: 'color',
      opacityFactor: 1,
      missing: [0.55, 0.55, 0.55],
    },
    views: [
      { camera: cloudCamera, steps: 60 },
      { camera: cloudCamera, steps: 200 },
    ],
  };
}

async function storm(): Promise<Radar> {
  const scan = litScenes.find(({ id }) => id === 'radar')!;
  const volume = await loadScan(scan.url);
  const { center, radius } = boundingSphere(volume.grid);
  const overlay = (await listVariants(scan, volume)).find((one) => one.overlay)!.overlay!;
  const view = (theta: number, phi: number, near: number): Camera =>
    orbitCamera({ theta, phi, radius: near * framingDistance(radius, 0.5, 1) }, center, 0.5);
  return {
    name: 'storm',
    volume,
    overlay,
    transferFunction: await resolveTransferFunction(scan.look, volume.range),
    referenceLength: scan.referenceLength * radius,
    views: [
      { camera: view(0.6, 1.2, 1), steps: 100 },
      { camera: view(2.9, 0.7, 0.6), steps: 300 },
    ],
  };
}

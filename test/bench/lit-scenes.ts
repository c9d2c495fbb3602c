// What is drawn beside each scene's plain picture: light, surfaces, a second field, labels.
import { loadVolume } from '../../src/worker/load.ts';
import type { ShownOverlay } from '../../src/optics/attachments/overlay.ts';
import type { RayStyle } from '../../src/optics/rays/ray-style.ts';
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import { summarize } from '../../src/volume/histogram.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import type { ShownLabels } from '../../src/volume/labels.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { listAtlases } from './atlases.ts';

export interface LitScene {
  readonly id: string;
  readonly name: string;
  readonly url: string;
  readonly look: string;
  /** World length, as a share of the radius. */
  readonly referenceLength: number;
  /** A surface that shows the same. */
  readonly surface?: number;
  /** A second field, and what it looks like; of a radar another moment. */
  readonly layer?: { readonly url: string; readonly look: string };
  readonly atlases?: boolean;
}

/** What a picture shows more than the plain one. */
export interface LitVariant {
  readonly name: string;
  readonly style?: RayStyle;
  readonly overlay?: ShownOverlay;
  readonly labels?: ShownLabels;
}

/** What is near 0 is clear. */
const bothSigns = '-12 #d8f6ff 60%, -3 #1c50b8 14%, -2 #163a80 0, 2 #7a1a10 0, 3 #c83018 14%, 12 #fff2a0 60%';

export const litScenes: readonly LitScene[] = [
  {
    id: 'mri',
    name: 'MRI of a brain, fog',
    url: '/demos/data/mni152-t1.nii.gz',
    look: 'mri',
    referenceLength: 0.01,
    layer: { url: '/demos/data/motor-synthetic.nii.gz', look: bothSigns },
    atlases: true,
  },
  {
    id: 'mri-surface',
    name: 'MRI of a brain, surface',
    url: '/demos/data/mni152-t1.nii.gz',
    look: '33% #d8a48f 0, 40% #e2b9a6 60%, 100% #f4e4d8 90%',
    referenceLength: 0.01,
    surface: 0.38,
  },
  {
    id: 'ct',
    name: 'CT of a torso, bones',
    url: '/demos/data/ct-phantom.nii.gz',
    look: 'ct-bone',
    referenceLength: 0.01,
  },
  {
    id: 'ct-skin',
    name: 'CT of a torso, skin',
    url: '/demos/data/ct-phantom.nii.gz',
    look: '-350 #d9a98c 0, -300 #d9a98c 90%, 200 #d9a98c 90%',
    referenceLength: 0.005,
    surface: -300,
  },
  {
    id: 'radar',
    name: 'Radar, synthetic storm',
    url: '/demos/data/storm-radar-1510.json',
    look: 'radar-dbz',
    referenceLength: 0.02,
    layer: { url: '/demos/data/storm-radar-1510-velocity.json', look: 'radar-velocity' },
  },
];

const limits = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 31 };

export function loadScan(url: string): Promise<Volume> {
  return loadVolume(
    { url, settings: { verticalExaggeration: 5 }, limits },
    { signal: new AbortController().signal, onProgress: () => {} },
  );
}

export async function listVariants({ surface, layer, atlases }: LitScene, volume: Volume): Promise<LitVariant[]> {
  const value =
    surface !== undefined && surface > 0 && surface < 1
      ? volume.range[0] + surface * (volume.range[1] - volume.range[0])
      : surface;
  return [
    { name: 'lit', style: { lit: true } },
    { name: 'ambient occlusion', style: { lit: 'ambient-occlusion' } },
    ...(value === undefined
      ? []
      : [
          {
            name: 'surfaces alone',
            style: { clear: true, surfaces: [{ value, color: [1, 0.9, 0.8], opacity: 1 }] } as const,
          },
        ]),
    ...(layer ? await listLayers(volume, layer) : []),
    ...(atlases ? listAtlases(volume) : []),
  ];
}

async function listLayers(
  over: Volume,
  { url, look: appearance }: { readonly url: string; readonly look: string },
): Promise<LitVariant[]> {
  const volume = await loadScan(url);
  const transferFunction = await resolveTransferFunction(appearance, volume.window ?? volume.range);
  const shown: ShownOverlay = { volume, over, transferFunction, blend: 'mix', opacityFactor: 1, missing: null };
  if (volume.grid.kind === 'polar') {
    const colors = transferFunction.map((stop) => ({ ...stop, opacity: 1 }));
    return [
      {
        name: 'colours of the velocity',
        overlay: { ...shown, transferFunction: colors, blend: 'color', missing: [0.55, 0.55, 0.55] },
      },
    ];
  }
  return [
    { name: 'layer, mix', overlay: shown },
    { name: 'layer, color', overlay: { ...shown, blend: 'color' } },
    { name: 'layer of floats with holes', overlay: { ...shown, volume: withHoles(volume) } },
  ];
}

/** As floats, which have no data where nothing was found, as maps of statistics outside of the brain. */
function withHoles(volume: Volume): Volume {
  const { slope, intercept, grid } = volume;
  const samples = Float32Array.from(volume.samples, (x) =>
    Math.abs(slope * x + intercept) < 0.5 ? NaN : slope * x + intercept,
  );
  return {
    ...volume,
    samples,
    slope: 1,
    intercept: 0,
    macrocells: buildMacrocells(samples, grid.dimensions),
    ...summarize(samples, 1, 0),
  };
}

import { parseTransferFunction } from '../../src/optics/transfer/parse-transfer-function.ts';
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { windowFromHistogram } from '../../src/optics/transfer/window.ts';
import { loadVolume } from '../../src/worker/load.ts';
import type { LoadRequest } from '../../src/worker/load.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** A volume of the study. */
export interface StudyScene {
  readonly id: string;
  readonly name: string;
  readonly url: string;
  /** The smooth transfer function. */
  readonly preset: 'mri' | 'ct-bone';
  readonly mosaic?: LoadRequest['settings'];
}

export const studyScenes: readonly StudyScene[] = [
  { id: 'mni152', name: 'MRI of a brain, 8 bit', url: '/demos/data/mni152-t1.nii.gz', preset: 'mri' },
  { id: 'ct-phantom', name: 'CT phantom (synthetic), 16 bit', url: '/demos/data/ct-phantom.nii.gz', preset: 'ct-bone' },
  {
    id: 'aorta',
    name: 'Aorta of the 2011 paper, 8 bit',
    url: '/shared-data/medical/aorta_mosaic/aorta4096.png',
    preset: 'mri',
    mosaic: { mosaic: { columns: 10, rows: 10 }, slices: 96, spacing: [0.8, 0.8, -1.2] },
  },
  {
    id: 'cranium',
    name: 'CT of a skull, 16 bit',
    url: '/shared-data/medical/cranium_ct/cranium_ct.nii.gz',
    preset: 'ct-bone',
  },
];

/** A transfer function of the study. */
export interface StudyFunction {
  readonly id: 'smooth' | 'peaks' | 'step';
  readonly name: string;
  readonly transferFunction: TransferFunction;
}

/** Three peaks, each 1 % of the window wide at its base, and nothing between them. */
const peaks =
  '19.5% #48c 0, 20% #48c 60%, 20.5% #48c 0, 44.5% #f93 0, 45% #f93 60%, 45.5% #f93 0, 69.5% #fff 0, 70% #fff 60%, 70.5% #fff 0';

/** A veil, so that depth is seen, and from the middle of the window on an opaque surface. */
const opaqueStep = '0% #2a4a7a 0, 50% #2a4a7a 4%, 50% #ffe8c0 100%, 100% white 100%';

/** The transfer functions that a volume is drawn with. */
export async function listFunctions(scene: StudyScene, volume: Volume): Promise<StudyFunction[]> {
  const window = volume.window ?? windowFromHistogram(volume.histogram);
  return [
    {
      id: 'smooth',
      name: `Smooth: ${scene.preset}`,
      transferFunction: await resolveTransferFunction(scene.preset, window),
    },
    { id: 'peaks', name: 'Three peaks of 1 %', transferFunction: parseTransferFunction(peaks, window) },
    { id: 'step', name: 'Opaque step', transferFunction: parseTransferFunction(opaqueStep, window) },
  ];
}

/** The volume of a scene, or null where this page has no such file. */
export async function loadScene(scene: StudyScene, signal: AbortSignal): Promise<Volume | null> {
  const there = await fetch(scene.url, { method: 'HEAD', signal });
  if (!there.ok) return null;
  const limits = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 1 << 30 };
  return loadVolume({ url: scene.url, settings: scene.mosaic, limits }, { signal, onProgress: () => {} });
}

// In the browser: lit frames against unlit ones.
import type { RayStyle } from '../../src/optics/ray-style.ts';
import { fieldProviders } from '../../components/field-providers.ts';
import { loadVolume } from '../../src/formats/load.ts';
import { framingDistance, orbitCamera } from '../../src/optics/camera.ts';
import { resolveTransferFunction } from '../../src/optics/resolve-transfer-function.ts';
import { stepLengthOf } from '../../src/quality/steps.ts';
import { boundingSphere } from '../../src/volume/grid.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { median } from './table.mjs';

export interface LitOptions {
  /** Pixels along each side. */
  readonly size: number;
  readonly steps: number;
  readonly turns: number;
}

export interface LitRow {
  readonly scene: string;
  /** Medians, ms. */
  readonly unlit: number;
  readonly lit: number;
  /** Median of those of each turn. */
  readonly ratio: number;
  /** Of surfaces alone, against the unlit picture; null where they are not asked for. */
  readonly surfaces: number | null;
}

interface BenchScene {
  readonly name: string;
  readonly url: string;
  readonly look: string;
  /** World length, as a share of the radius. */
  readonly referenceLength: number;
  /** A surface that shows the same. */
  readonly surface?: number;
}

const scenes: readonly BenchScene[] = [
  { name: 'MRI of a brain, fog', url: '/demos/data/mni152-t1.nii.gz', look: 'mri', referenceLength: 0.01 },
  { name: 'MRI of a brain, surface', url: '/demos/data/mni152-t1.nii.gz', look: '33% #d8a48f 0, 40% #e2b9a6 60%, 100% #f4e4d8 90%', referenceLength: 0.01, surface: 0.38 },
  { name: 'CT of a torso, bones', url: '/demos/data/ct-phantom.nii.gz', look: 'ct-bone', referenceLength: 0.01 },
  { name: 'CT of a torso, skin', url: '/demos/data/ct-phantom.nii.gz', look: '-350 #d9a98c 0, -300 #d9a98c 90%, 200 #d9a98c 90%', referenceLength: 0.005, surface: -300 },
  { name: 'Radar, synthetic storm', url: '/demos/data/storm-radar-1510.json', look: 'radar-dbz', referenceLength: 0.02 },
];

const limits = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 31 };

export async function compareLit(options: LitOptions): Promise<LitRow[]> {
  const rows: LitRow[] = [];
  for (const scene of scenes) rows.push(await compareScene(scene, options));
  return rows;
}

async function compareScene({ name, url, look, referenceLength, surface }: BenchScene, { size, steps, turns }: LitOptions): Promise<LitRow> {
  const volume = await loadVolume({ url, verticalExaggeration: 5, limits }, { signal: new AbortController().signal, onProgress: () => {} });
  const transferFunction = await resolveTransferFunction(look, volume.range);
  const { center, radius } = boundingSphere(volume.grid);
  const host = document.createElement('div');
  document.body.append(host);
  const scene = await VolumeScene.create(host, host, () => {}, fieldProviders);
  const optics = { transferFunction, referenceLength: referenceLength * radius, opacityFactor: 1, lightFactor: 1 };
  await scene.prepare(volume, optics);
  scene.setVolume(volume);
  await scene.setOptics(optics);
  scene.resize(size, size);
  scene.setCamera(orbitCamera({ theta: 0.6, phi: 1.2, radius: framingDistance(radius, 0.5, 1) }, center, 0.5));
  const time = async (style: RayStyle | null): Promise<number> => {
    await scene.setStyle(style);
    await scene.finished();
    const began = performance.now();
    scene.draw(stepLengthOf(volume.grid, steps));
    scene.readPicture();
    return performance.now() - began;
  };
  const surfaces: RayStyle | null = surface === undefined ? null : { clear: true, surfaces: [{ value: surface < 1 && surface > 0 ? volume.range[0] + surface * (volume.range[1] - volume.range[0]) : surface, color: [1, 0.9, 0.8], opacity: 1 }] };
  for (const style of [{ lit: true } as const, surfaces, null]) await time(style); // Compiles.
  const taken: { unlit: number; lit: number; surfaces: number }[] = [];
  for (let turn = 0; turn < turns; turn++) {
    const unlit = await time(null);
    taken.push({ unlit, lit: await time({ lit: true }), surfaces: surfaces ? await time(surfaces) : NaN });
  }
  scene.dispose();
  host.remove();
  return { scene: name, unlit: median(taken.map(({ unlit }) => unlit)), lit: median(taken.map(({ lit }) => lit)), ratio: median(taken.map(({ unlit, lit }) => lit / unlit)), surfaces: surfaces && median(taken.map((one) => one.surfaces / one.unlit)) };
}

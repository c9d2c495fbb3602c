// In the browser: what all renderers of `npm run bench -- starts` are given.
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import { finestSpacing } from '../../src/volume/grid.ts';
import { niftiBytes } from '../helpers/nifti-bytes.ts';
import { loadScan } from './lit-scenes.ts';
import { alignVolume, describeScene, findCamera } from './peer-scene.ts';
import type { PeerScene } from './peer-scene.ts';

/** A scene as it goes from page to page. */
export interface SentScene {
  /** Everything but the samples. */
  readonly scene: Omit<PeerScene, 'samples' | 'table'> & { readonly table: readonly number[] };
  readonly samples: string;
  /** The same volume as a file. */
  readonly file: string;
  /** One step a voxel. */
  readonly stepLength: number;
}

/** The MRI of the demos in a look. @param appearance - as an attribute has it */
export async function sendScene(url: string, appearance: string): Promise<SentScene> {
  const volume = alignVolume(await loadScan(url));
  const { samples, table, ...scene } = describeScene(
    volume,
    await resolveTransferFunction(appearance, volume.window ?? volume.range),
    findCamera(volume),
  );
  if (!(samples instanceof Uint8Array)) throw new TypeError('peers get bytes here');
  return {
    scene: { ...scene, table: [...table] },
    samples: toText(samples),
    file: toText(niftiBytes(volume)),
    stepLength: finestSpacing(volume.grid),
  };
}

function toText(bytes: Uint8Array): string {
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text);
}

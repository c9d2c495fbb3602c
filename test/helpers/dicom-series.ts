import { decodeFile } from '../../src/formats/decode.ts';
import type { DecodeContext } from '../../src/formats/decode.ts';
import type { DecodeSettings } from '../../src/formats/base/decoded-volume.ts';
import { finishVolume } from '../../src/formats/finish-volume.ts';
import { fetchInOrder } from '../../src/sources/fetch-files.ts';
import type { CartesianGrid } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { roomyLimits, urlOf } from './decode.ts';
import { dicomBytes } from './dicom-bytes.ts';
import type { DicomFields, DicomForm } from './dicom-bytes.ts';

/** A volume that is not a radar's. */
export type Scan = Volume & { readonly grid: CartesianGrid };

/** Decodes files of DICOM as one volume, on this thread. */
export async function decodeSeries(
  files: readonly Uint8Array<ArrayBuffer>[],
  settings: DecodeSettings = {},
): Promise<Scan> {
  const urls = files.map((_, i) => urlOf(`${i + 1}.dcm`));
  const fetchFile: DecodeContext['fetchFile'] = async (url) => ({
    bytes: files[urls.indexOf(url)].slice(),
    url,
    contentType: '',
  });
  const context: DecodeContext = {
    onProgress: () => undefined,
    fetchFile,
    fetchFiles: (some) =>
      fetchInOrder(
        some,
        (url) => fetchFile(url),
        () => undefined,
      ),
    ...(files.length > 1 ? { files: urls } : {}),
  };
  return (await finishVolume(await decodeFile(await fetchFile(urls[0]), settings, context), roomyLimits)) as Scan;
}

/** Decodes files of the given elements. */
export const decodeFields = (files: readonly DicomFields[], form?: DicomForm): Promise<Scan> =>
  decodeSeries(files.map((fields) => dicomBytes(fields, form)));

// Reads a volume of a file that holds several, by a part of that file, or of many files. Loaded when it is needed.
import type { DecodedVolume, DecodeInput, DecodeSettings } from '../formats/base/decoded-volume.ts';
import type { Budget } from '../formats/base/budget.ts';
import { checkGeometry } from '../formats/base/check-geometry.ts';
import { decodeFile } from '../formats/decode.ts';
import type { DecodeContext } from '../formats/decode.ts';
import { hasSweeps, isFrame } from '../formats/base/scan-data.ts';
import type { PlaceData, ScanData } from '../formats/base/scan-data.ts';
import type { LoadRequest } from '../formats/base/load-request.ts';
import type { ScanAccess } from '../formats/series/read-scan.ts';
import { readPlaceOverTime } from '../formats/series/read-place-over-time.ts';
import { readPlacedScan } from '../formats/read-placed-scan.ts';
import type { FileTree } from '../formats/zarr/file-tree.ts';
import { loadReader } from '../formats/base/load-reader.ts';
import type { FetchOptions } from '../sources/download.ts';
import { HttpStore } from '../sources/http-store.ts';
import { openLocal } from '../sources/open-local.ts';

/**
 * @param first - the start of the file, where it is opened; null where the page knows where the volume, or the numbers of one place in all volumes, lie
 * @throws {VolumeViewError} `format/…`, `source/…`
 */
export async function decodeScan(
  first: DecodeInput | null,
  settings: DecodeSettings,
  options: DecodeContext &
    Pick<FetchOptions, 'signal' | 'pageOrigin' | 'fetch'> & {
      readonly request: LoadRequest;
      readonly budget: Budget;
      readonly tree?: FileTree;
    },
): Promise<DecodedVolume> {
  if (options.tree) {
    const { readZarr } = await loadReader(() => import('../formats/zarr/read-zarr.ts'));
    const volume = await readZarr(options.tree, settings, { ...options, limits: await options.request.limits });
    checkGeometry(volume);
    return volume;
  }
  const fetchFile: DecodeContext['fetchFile'] = async (url, range) => {
    const { local } = options.request;
    const store = local && url.startsWith(local.base) ? await openLocal(local, options.signal) : new HttpStore(options);
    return store.read(url, { range, signal: options.signal });
  };
  if (first) return decodeFile(first, settings, { ...options, fetchFile });
  const data = options.request.data!;
  const fetchPixels: ScanAccess['fetchPixels'] = async (pixels) =>
    (await loadReader(() => import('../sources/open-dicomweb.ts'))).fetchPixels(pixels, options);
  const access = { fetchFile, fetchPixels, budget: options.budget, onProgress: options.onProgress };
  return isOfPlace(data) ? readPlaceOverTime(data, access) : readPlacedScan(data, settings, access);
}

const isOfPlace = (data: ScanData | PlaceData): data is PlaceData =>
  !hasSweeps(data) && !isFrame(data) && Array.isArray(data.from);

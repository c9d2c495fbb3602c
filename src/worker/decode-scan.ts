// Reads a volume of a file that holds several, by a part of that file, or of many files. Loaded when it is needed.
import type { DecodedVolume, DecodeInput, DecodeSettings } from '../formats/base/decoded-volume.ts';
import type { Budget } from '../formats/base/budget.ts';
import { checkGeometry } from '../formats/base/check-geometry.ts';
import { decodeFile } from '../formats/decode.ts';
import type { DecodeContext } from '../formats/decode.ts';
import { hasNumbers, hasSweeps, isFrame } from '../formats/base/scan-data.ts';
import type { PlaceData, ScanData } from '../formats/base/scan-data.ts';
import type { LoadRequest } from '../formats/base/load-request.ts';
import type { ScanAccess } from '../formats/series/read-scan.ts';
import { readPlaceOverTime } from '../formats/series/read-place-over-time.ts';
import { readPlacedScan } from '../formats/read-placed-scan.ts';
import { loadReader } from '../formats/base/load-reader.ts';
import type { FetchOptions } from '../sources/download.ts';
import { HttpStore } from '../sources/http-store.ts';
import type { OpenedFiles } from '../sources/opened-files.ts';

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
    } & Partial<Pick<OpenedFiles, 'tree' | 'read' | 'sourceOf'>>,
): Promise<DecodedVolume> {
  if (options.tree) {
    const { readZarr } = await loadReader(() => import('../formats/zarr/read-zarr.ts'));
    const volume = await readZarr(options.tree, settings, { ...options, limits: await options.request.limits });
    checkGeometry(volume);
    return volume;
  }
  const { read, sourceOf, onScans, signal } = options;
  const store = new HttpStore(options);
  const fetchFile: DecodeContext['fetchFile'] = (url, range) =>
    (read ?? store.read.bind(store))(url, { range, signal });
  if (first)
    return decodeFile(first, settings, {
      ...options,
      fetchFile,
      onScans: (times, scans) => onScans?.(times, sourceOf ? scans?.map((scan) => asKept(scan, sourceOf)) : scans),
    });
  const data = options.request.data!;
  const fetchPixels: ScanAccess['fetchPixels'] = async (pixels) =>
    (await loadReader(() => import('../sources/open-dicomweb.ts'))).fetchPixels(pixels, options);
  const access = { fetchFile, fetchPixels, budget: options.budget, onProgress: options.onProgress };
  return isOfPlace(data) ? readPlaceOverTime(data, access) : readPlacedScan(data, settings, access);
}

const isOfPlace = (data: ScanData | PlaceData): data is PlaceData =>
  !hasSweeps(data) && !isFrame(data) && Array.isArray(data.from);

/** A part of a chosen file is kept as a part of it: a page need not send the files again. */
function asKept(scan: ScanData, sourceOf: (url: string) => Blob | string | null): ScanData {
  if (!hasNumbers(scan) || scan.from instanceof Blob) return scan;
  const { url, start, end } = scan.from;
  const file = sourceOf(url);
  return file instanceof Blob ? { ...scan, from: file.slice(start, end) } : scan;
}

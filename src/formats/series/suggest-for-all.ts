import { summarize } from '../../volume/histogram.ts';
import type { ScanNumbers, SeriesInfo } from '../base/scan-data.ts';
import { storeSamples } from '../base/store-samples.ts';
import { suggestAppearance } from '../appearance/suggest-appearance.ts';
import { countBytes, readPart } from './read-scan.ts';
import type { ScanAccess } from './read-scan.ts';
import { scanTypes } from './scan-types.ts';

/** How many scans are looked at, evenly over the file. */
const lookedAt = 5;

/** Of a larger scan, so many parts of so many bytes are read. */
const [parts, partBytes] = [4, 2 ** 18];

/**
 * One window and one set of colours for all scans, from some values of some of them: which scan is shown first does not matter.
 * What the file itself says stays.
 */
export async function suggestForAll(scans: readonly ScanNumbers[], access: ScanAccess): Promise<SeriesInfo> {
  const [{ series }] = scans;
  return suggestByValues(series, await sampleValues(scans, access), scans.every(areBytes));
}

/** Whether values are bytes as they are stored, or turned, as where white is said to be 0. */
export const areBytes = ({ type, slope, intercept }: Pick<ScanNumbers, 'type' | 'slope' | 'intercept'>): boolean =>
  type === 'uint8' && (slope === 1 ? intercept === 0 : slope === -1 && intercept === 255);

/**
 * The same.
 * @param values - some of the values of some scans
 * @param asBytes - whether all of them are bytes: grays of a screen are known by it
 */
export async function suggestByValues(
  series: SeriesInfo,
  values: Float32Array<ArrayBuffer>,
  asBytes = false,
): Promise<SeriesInfo> {
  const samples = asBytes ? Uint8Array.from(values) : values;
  const { histogram } = summarize(samples, 1, 0);
  const { isDiscrete, window, transferFunction } = await suggestAppearance(
    { ...series, samples, slope: 1, intercept: 0 },
    histogram,
  );
  if (isDiscrete) return series;
  return { ...series, window, transferFunction, intent: undefined };
}

/** The numbers of the first, the last and some other scans. */
export function chooseLookedAt(count: number): number[] {
  return [...new Set(Array.from({ length: lookedAt }, (_, i) => Math.round((i * (count - 1)) / (lookedAt - 1))))];
}

async function sampleValues(scans: readonly ScanNumbers[], access: ScanAccess): Promise<Float32Array<ArrayBuffer>> {
  const reads = chooseLookedAt(scans.length).flatMap((i) =>
    listParts(scans[i]).map((start) => ({ scan: scans[i], start })),
  );
  const all: Float32Array[] = [];
  for (const { scan, start } of reads) {
    const end = Math.min(start + sizeOfPart(scan), countBytes(scan));
    const type = scanTypes.get(scan.type)!;
    const { samples, scale, offset } = storeSamples(await readPart(scan, start, end, access), type, scan.littleEndian, {
      ...scan,
      budget: access.budget,
    });
    const { slope, intercept } = type.complex ? { slope: 1, intercept: 0 } : scan;
    all.push(Float32Array.from(samples, (sample) => slope * (scale * sample + offset) + intercept));
    access.budget.giveBack(end - start);
  }
  return joinValues(all);
}

/** One after another. */
export function joinValues(all: readonly Float32Array[]): Float32Array<ArrayBuffer> {
  const values = new Float32Array(all.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const one of all) {
    values.set(one, at);
    at += one.length;
  }
  return values;
}

const sizeOfPart = (scan: ScanNumbers): number => (countBytes(scan) > parts * partBytes ? partBytes : countBytes(scan));

/** Where the parts of a scan begin that are read: the whole of a small one. */
function listParts(scan: ScanNumbers): number[] {
  const bytes = countBytes(scan);
  if (sizeOfPart(scan) === bytes) return [0];
  const { bytesPerSample } = scanTypes.get(scan.type)!;
  return Array.from({ length: parts }, (_, i) => {
    const start = ((i + 0.5) / parts) * bytes - partBytes / 2;
    return Math.floor(start / bytesPerSample) * bytesPerSample;
  });
}

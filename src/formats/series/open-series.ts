import { chooseScan } from '../base/choose-scan.ts';
import type { DecodedCartesianVolume, DecodeSettings } from '../base/decoded-volume.ts';
import type { ReadContext } from '../base/format.ts';
import type { ScanBytes, ScanNumbers, SeriesInfo } from '../base/scan-data.ts';
import { readScan } from './read-scan.ts';
import { suggestForAll } from './suggest-for-all.ts';

/** A file of several volumes, as its reader describes it. */
export interface Series extends Pick<ScanNumbers, 'type' | 'littleEndian'> {
  readonly info: SeriesInfo;
  /** Where each volume lies. */
  readonly volumes: readonly ScanBytes[];
  /** The number of volumes in the file, of which some may be left out. */
  readonly count: number;
  /** Value = slope * number + intercept, of each volume. */
  scaleOf(index: number): { readonly slope: number; readonly intercept: number };
  /** When a volume was measured: '12.5 s', or null. */
  timeOf(index: number): string | null;
}

/**
 * Reports the volumes of a file as scans, and reads the one that is wanted.
 * @param wanted - which one
 */
export async function openSeries(
  { info, volumes, count, type, littleEndian, scaleOf, timeOf }: Series,
  { scan: wanted = { index: 0 } }: Pick<DecodeSettings, 'scan'>,
  context: ReadContext,
): Promise<DecodedCartesianVolume> {
  const describe = (series: SeriesInfo): ScanNumbers[] =>
    volumes.map((from, i) => ({
      from,
      type,
      littleEndian,
      ...scaleOf(i),
      format: `${info.format}, volume ${i + 1} of ${count}`,
      series,
    }));
  const scans = describe(await suggestForAll(describe(info), context));
  const times = scans.map((_, i) => timeOf(i));
  context.onScans?.(times, scans);
  return readScan(scans[chooseScan(times, wanted).index], context);
}

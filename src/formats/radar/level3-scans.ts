// Several products of NEXRAD Level III, each a sweep. Those of one scan are its sweeps; other scans are later or earlier.
import { VolumeViewError } from '../../core/errors.ts';
import type { Budget } from '../base/budget.ts';
import { chooseScan } from '../base/choose-scan.ts';
import type { DecodedPolarVolume, DecodeSettings } from '../base/decoded-volume.ts';
import type { FormatReader, ReadContext } from '../base/format.ts';
import { readAhead } from '../base/read-ahead.ts';
import type { ScanOfSweeps } from '../base/scan-data.ts';
import { buildPolarVolume } from './build-polar-volume.ts';
import { chooseMoment } from './choose-sweeps.ts';
import { chooseRadar, codeOf, count, groupScans, mostOf, readHeads } from './level3-heads.ts';
import type { Product } from './level3-heads.ts';
import { level3Products } from './level3-products.ts';
import { readLevel3 } from './level3.ts';
import type { RadarFile, RadarMoment } from './radar-file.ts';

export { readLevel3 } from './level3.ts';

/**
 * Reads products of one radar: all of one scan are one volume, and several scans are scans in time. Only the heads of
 * the files are read for this, and then the products of the scan and of the quantity that are wanted.
 * @throws {VolumeViewError} `format/…`, `attribute/invalid`, and what fetching throws
 */
export const readLevel3Scans: FormatReader = async (input, settings, context) => {
  const urls = [input.url, ...context.further];
  const folder = context.folder ?? (await context.openList?.(input, urls));
  const { products, left } = chooseRadar(await readHeads(input, urls, { ...context, folder }));
  const codes = products.map(codeOf);
  const code = chooseCode(codes, settings.moment);
  const scans = groupScans(products).filter((scan) => scan.products.some((product) => codeOf(product) === code));
  const times = scans.map(({ time }) => time);
  const areShown = scans.length > 1 && settings.scan && !context.isPart;
  const sourceOf = ({ url, bytes }: Product): Blob | string =>
    bytes ? new Blob([bytes]) : (folder?.sourceOf(url) ?? url);
  if (areShown)
    context.onScans?.(
      times,
      scans.map((scan): ScanOfSweeps => ({ sweeps: scan.products.map((one) => [sourceOf(one), codeOf(one)]) })),
    );
  else if (scans.length > 1) left.push(`${count(scans.length - 1, 'later scan')} of the same radar`);
  const { products: all } = scans[areShown ? chooseScan(times, settings.scan).index : 0];
  const chosen = all.filter((product) => codeOf(product) === code);
  const wanted = chosen.map(({ url }) => url);
  folder?.expect(wanted);
  const read = async ({ url, bytes }: Product): Promise<Uint8Array<ArrayBuffer>> =>
    bytes ?? (await folder!.readWhole(url)).bytes;
  left.push(...describeOthers(codes, code));
  return showScan(readAhead(chosen, read, folder?.plan(wanted)), settings, { ...context, codes, left });
};

/**
 * Reads the products of one scan again, each from where it lies.
 * @throws {VolumeViewError} `format/…`, `attribute/invalid`, and what fetching throws
 */
export async function readScanOfSweeps(
  { sweeps }: ScanOfSweeps,
  settings: DecodeSettings,
  { fetchFile, budget }: Pick<ReadContext, 'fetchFile' | 'budget'>,
): Promise<DecodedPolarVolume> {
  const codes = sweeps.map(([, code]) => code);
  const code = chooseCode(codes, settings.moment);
  const read = async ([file]: ScanOfSweeps['sweeps'][number]): Promise<Uint8Array<ArrayBuffer>> => {
    if (typeof file === 'string') return (await fetchFile(file)).bytes;
    budget.addFile(file.size);
    return new Uint8Array(await file.arrayBuffer());
  };
  const chosen = sweeps.filter(([, one]) => one === code);
  return showScan(readAhead(chosen, read), settings, { budget, codes, left: describeOthers(codes, code) });
}

type Settled = PromiseSettledResult<Uint8Array<ArrayBuffer>>;

interface ShownScan {
  readonly budget: Budget;
  /** The products that the scan has, also those that are not read. */
  readonly codes: readonly number[];
  /** What is said of other files. */
  readonly left: readonly string[];
}

async function showScan(
  files: AsyncIterable<Settled>,
  settings: DecodeSettings,
  { budget, codes, left }: ShownScan,
): Promise<DecodedPolarVolume> {
  const read: RadarFile[] = [];
  const problems: unknown[] = [];
  for await (const one of files) {
    if (one.status === 'rejected') throw one.reason;
    try {
      read.push(await readLevel3(one.value, budget));
    } catch (cause) {
      if (!(cause instanceof VolumeViewError && cause.code !== 'format/too-large')) throw cause;
      problems.push(cause);
    }
  }
  if (read.length === 0) throw problems[0];
  const lost =
    problems.length > 0
      ? [`${problems.length} of ${problems.length + read.length} files of this scan can not be read`]
      : [];
  const partial = [...lost, ...read.flatMap((one) => one.partial ?? [])].join('; ');
  return buildPolarVolume(
    { ...joinSweeps(read), moments: momentsOf(codes), left, ...(partial && { partial }) },
    settings,
    budget,
  );
}

/** One radar file with the sweeps of several of one product. */
function joinSweeps(files: readonly RadarFile[]): RadarFile {
  return {
    ...files[0],
    sweeps: files.flatMap(({ sweeps }) => sweeps),
    details: [...new Set(files.flatMap(({ details = [] }) => details))],
  };
}

/** Each quantity once. */
function momentsOf(codes: readonly number[]): RadarMoment[] {
  const all = codes.map((code) => level3Products.get(code)!);
  return [...new Map(all.map(({ name, unit, kind, numbers }) => [name, { name, unit, kind, numbers }])).values()];
}

/**
 * The product to show: of the quantity that is wanted, else of the reflectivity that most files have. Old and new products
 * show the same quantity: the one that most files have is taken.
 * @throws {VolumeViewError} `attribute/invalid` where that quantity is not there
 */
function chooseCode(codes: readonly number[], moment: string | undefined): number {
  const nameOf = (code: number): string => level3Products.get(code)!.name;
  const sweeps = codes.map((code) => ({ moments: [nameOf(code)] }));
  const { name } = chooseMoment({ format: 'NEXRAD Level III', moments: momentsOf(codes), sweeps }, moment);
  return mostOf(codes.filter((code) => nameOf(code) === name))!;
}

/** Products of the same quantity that are not shown. */
function describeOthers(codes: readonly number[], shown: number): string[] {
  const { name } = level3Products.get(shown)!;
  const others = codes.filter((code) => code !== shown && level3Products.get(code)!.name === name);
  return others.length > 0 ? [`${count(others.length, 'file')} of another product of ${name}`] : [];
}

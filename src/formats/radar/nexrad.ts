import { VolumeViewError } from '../../core/errors.ts';
import { Budget } from '../base/budget.ts';
import { gunzip, isGzip } from '../codecs/gunzip.ts';
import { isoTime } from './cf-time.ts';
import { momentKindOf } from './moment-kind.ts';
import { readCuts } from './nexrad-cuts.ts';
import { readMessage1 } from './nexrad-message-1.ts';
import { readMessage31 } from './nexrad-message-31.ts';
import { splitMessages } from './nexrad-messages.ts';
import { radialStatus } from './nexrad-radial.ts';
import type { NexradRadial } from './nexrad-radial.ts';
import { splitRecords } from './nexrad-records.ts';
import { makeNexradSweep } from './nexrad-sweep.ts';
import type { RadarFile, RadarMoment } from './radar-file.ts';
import { refuseManySweeps } from './radar-limits.ts';
import { joinPieces } from '../base/join-pieces.ts';

/** Maximum bytes that a gzip file may unpack to. */
const maxBytes = 2 ** 30;

/** Degrees, of a WSR-88D: 0.96 at 2.7 GHz and 0.88 at 3 GHz. Source: Federal Meteorological Handbook 11, part B */
const beamWidth = 0.95;

/**
 * Memory for a radial and its part of the sweep; for each of its moments in addition to the gates; and the steps for
 * each message.
 */
const bytesPerRadial = 512;
const bytesPerMoment = 320;
const stepsPerMessage = 64;

/** Units of the moments. Source: ICD 2620002, table XVII-B */
const units: Readonly<Record<string, string>> = {
  REF: 'dBZ',
  VEL: 'm/s',
  SW: 'm/s',
  ZDR: 'dB',
  PHI: 'degrees',
  RHO: '',
  CFP: 'dB',
};

/** What the messages of a file hold, in its order. */
interface Contents {
  readonly radials: NexradRadial[];
  readonly station: string;
  /** Elevations of the volume coverage pattern, degrees. */
  cuts: number[];
  cut?: string;
}

/**
 * Reads a volume of NEXRAD Level II (Archive II), as WSR-88D radars send it: message 31 since 2008, message 1 before;
 * with or without bzip2 in the records and gzip around the file. Cuts stay as they were scanned: the lowest elevations
 * twice, once far (surveillance) and once for velocity (Doppler).
 * It is our own reader, because those on npm read only message 31 (nexrad-level-2-data 2.4).
 * A file may hold several volumes, because its radar restarted, with another header or in the middle. The first
 * complete one with the most radials is shown.
 * @returns `left` lists the volumes and radials that are not used; `partial` says what is missing in a file that was
 * cut short, or in a volume that its radar did not finish
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt`, `format/unsupported`, `format/too-large`
 * Sources: Interface Control Documents for the RDA/RPG, 2620002, and for the Archive II/User, 2620010
 */
export async function readNexrad(
  bytes: Uint8Array<ArrayBuffer>,
  budget = Budget.ofFile(bytes.length),
): Promise<RadarFile> {
  const unpacked = isGzip(bytes) ? await unpackGzip(bytes, budget) : { bytes };
  const volumes = splitRecords(unpacked.bytes, budget);
  const all = volumes.flatMap(({ station, records, cut }, i) => {
    const contents: Contents = {
      radials: [],
      station,
      cuts: [],
      cut: (i === volumes.length - 1 ? unpacked.cut : undefined) ?? cut,
    };
    for (const record of records) readRecord(record, contents, budget);
    return splitVolumes(contents);
  });
  if (all.length === 0) {
    const cut = unpacked.cut ?? volumes.find((volume) => volume.cut)?.cut;
    throw new VolumeViewError(
      'format/corrupt',
      `the NEXRAD file holds no radials${cut ? `: ${cut}` : ''}; expected messages 31 or 1. Fetch it again`,
    );
  }
  const contents = all.reduce((best, one) => (isMoreComplete(one, best) ? one : best));
  const { radials, station } = contents;
  const sweeps = groupByCut(radials).map((radials) => makeNexradSweep(radials, contents.cuts[radials[0].cut - 1]));
  const site = radials.find((radial) => radial.site)?.site ?? {};
  const time = isoTime(radials[0].time);
  const partial = describeMissing(contents);
  return {
    format: 'NEXRAD Level II',
    beamWidth,
    site: { ...(station ? { name: station } : {}), ...site },
    ...(time ? { time } : {}),
    moments: [...new Set(sweeps.flatMap(({ moments }) => moments))].map(describeMoment),
    sweeps,
    left: [...describeOthers(all, contents), ...describeBad(radials)],
    ...(partial ? { partial } : {}),
  };
}

/** Unpacks a gzip file as far as it is complete. */
async function unpackGzip(
  packed: Uint8Array<ArrayBuffer>,
  budget: Budget,
): Promise<{ bytes: Uint8Array<ArrayBuffer>; cut?: string }> {
  const pieces: Uint8Array<ArrayBuffer>[] = [];
  let length = 0;
  let cut: string | undefined;
  try {
    for await (const piece of gunzip(packed)) {
      budget.take(piece.length, 'the gzip file');
      pieces.push(piece);
      length += piece.length;
      if (length > maxBytes) {
        throw new VolumeViewError(
          'format/too-large',
          `the gzip file unpacks to more than ${maxBytes.toLocaleString('en')} bytes; expected a NEXRAD file`,
        );
      }
    }
  } catch (error) {
    const isBroken = error instanceof VolumeViewError && error.code === 'format/corrupt';
    if (!isBroken || length === 0) throw error;
    cut = 'the gzip file ends early or is damaged';
  }
  budget.take(length, 'the gzip file');
  const bytes = joinPieces(pieces);
  budget.giveBack(length);
  return cut === undefined ? { bytes } : { bytes, cut };
}

function readRecord(record: Uint8Array<ArrayBuffer>, contents: Contents, budget: Budget): void {
  const onCut = (missing: number): void => {
    contents.cut ??= `its last message lacks ${missing} bytes`;
  };
  for (const { type, segment, body } of splitMessages(record, onCut)) {
    budget.step(stepsPerMessage, 'a record of the NEXRAD file');
    const radial = type === 31 ? readMessage31(body) : type === 1 ? readMessage1(body) : null;
    if (radial) {
      budget.take(bytesPerRadial + bytesPerMoment * radial.moments.size, 'the radials of the NEXRAD file');
      contents.radials.push(radial);
    } else if ((type === 5 || type === 7) && segment === 1 && contents.cuts.length === 0)
      contents.cuts = readCuts(body);
  }
}

/** Splits the contents at each radial that starts a volume; empty if there are no radials. */
function splitVolumes({ radials, ...of }: Contents): Contents[] {
  const parts: NexradRadial[][] = [];
  radials.forEach((radial, i) => {
    const begins = radial.status === radialStatus.volumeStarts && radials[i - 1]?.status !== radialStatus.volumeStarts;
    if (i === 0 || begins) parts.push([]);
    parts.at(-1)!.push(radial);
  });
  // What is missing at the end of the file is missing in the last volume.
  return parts.map((part, i) => ({ ...of, radials: part, cut: i === parts.length - 1 ? of.cut : undefined }));
}

/** Whether a volume is complete and the other one is not; if both are or both are not: whether it has more radials. */
function isMoreComplete(one: Contents, other: Contents): boolean {
  const [isWhole, isOtherWhole] = [one, other].map((volume) => describeMissing(volume) === undefined);
  return isWhole === isOtherWhole ? one.radials.length > other.radials.length : isWhole;
}

/** Notes about the other volumes of a file. */
function describeOthers(all: readonly Contents[], shown: Contents): string[] {
  if (all.length === 1) return [];
  const describe = ({ radials }: Contents): string =>
    `that of ${isoTime(radials[0].time) ?? 'no time'} with ${groupByCut(radials).length} sweeps`;
  return all
    .filter((volume) => volume !== shown)
    .map(
      (volume) =>
        `of the ${all.length} volumes of the file, the radar having begun again, ${describe(volume)} is left out; ${describe(shown)}, the more complete one, is shown`,
    );
}

function describeBad(radials: readonly NexradRadial[]): string[] {
  const bad = radials.filter(({ isBad }) => isBad).length;
  return bad > 0
    ? [`${bad} of ${radials.length} radials are left out: the radar marks them as bad, or as not sent (spot blanking)`]
    : [];
}

/** @throws {VolumeViewError} `format/too-large` */
function groupByCut(radials: readonly NexradRadial[]): NexradRadial[][] {
  const { cutStarts, volumeStarts, lastCutStarts } = radialStatus;
  const groups: NexradRadial[][] = [];
  let before: NexradRadial | undefined;
  for (const radial of radials) {
    const starts = [cutStarts, volumeStarts, lastCutStarts].some((status) => status === radial.status);
    if (starts || radial.cut !== before?.cut) groups.push([]);
    groups.at(-1)!.push(radial);
    before = radial;
  }
  refuseManySweeps(groups.length);
  return groups;
}

function describeMissing({ radials, cut }: Contents): string | undefined {
  const { azimuth, elevation, status } = radials.at(-1)!;
  if (!cut && status === radialStatus.volumeEnds) return undefined;
  const where = `the volume ends at elevation ${elevation.toFixed(1)}°, azimuth ${azimuth.toFixed(0)}°`;
  return cut ? `the file was cut short (${cut}): ${where}` : `${where}, before its radar says that it is over`;
}

function describeMoment(name: string): RadarMoment {
  const unit = units[name] ?? '';
  return { name, unit, kind: momentKindOf({ name, unit }) };
}

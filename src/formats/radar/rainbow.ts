import { Budget } from '../base/budget.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { gunzipAll } from '../codecs/gunzip-all.ts';
import { isGzip } from '../codecs/gunzip.ts';
import type { MomentKind, RadarFile, RadarMoment, RadarSweep, SweepData, SweepGates } from './radar-file.ts';
import { refuseManySweeps, refuseSweep } from './radar-limits.ts';
import { listBlobs, readBlob } from './rainbow-blobs.ts';
import type { RainbowBlobs } from './rainbow-blobs.ts';
import { attributeOf, childOf, childrenOf, numberIn, readRainbowHeader, what } from './rainbow-header.ts';
import type { RainbowNode } from './rainbow-header.ts';

/** Quantities by Rainbow's names; others have no unit. Source: xradar 0.12, `rainbow.py`, and the files' own names */
const kinds: Readonly<Record<string, readonly [MomentKind, string]>> = {
  dBZ: ['reflectivity', 'dBZ'],
  dBuZ: ['reflectivity', 'dBZ'],
  dBZv: ['reflectivity', 'dBZ'],
  dBuZv: ['reflectivity', 'dBZ'],
  V: ['velocity', 'm/s'],
  W: ['spectrum-width', 'm/s'],
  ZDR: ['differential-reflectivity', 'dB'],
  PhiDP: ['differential-phase', 'degrees'],
  RhoHV: ['correlation', ''],
  KDP: ['other', 'degrees/km'],
  SNR: ['other', 'dB'],
};

/**
 * Reads a volume (`.vol`) or a single sweep (`.azi`) of Rainbow 5: a header of XML, and numbers packed by zlib.
 * It is our own reader: there is none on npm, and the whole is XML, zlib and one rule of scale.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 * Sources: the files of wradlib-data, whose headers name all that is used here; wradlib 2.9 and xradar 0.12, `rainbow.py`, for what the
 * numbers mean
 */
export async function readRainbow(
  given: Uint8Array<ArrayBuffer>,
  budget = Budget.ofFile(given.length),
): Promise<RadarFile> {
  const bytes = isGzip(given) ? await gunzipAll(given, budget, what) : given;
  const { volume, end } = readRainbowHeader(bytes);
  const type = volume.attributes.get('type') ?? '';
  if (type !== 'vol' && type !== 'azi')
    throw unsupportedFile(
      what,
      `holds a scan of the type "${type.slice(0, 20)}"; expected "vol" or "azi", sweeps of constant elevation. Convert others to CfRadial, with xradar`,
    );
  const { blobs, isCut } = listBlobs(bytes, end);
  const scan = childOf(volume, 'scan');
  const slices = childrenOf(scan, 'slice');
  refuseManySweeps(slices.length);
  const moments = new Map<string, RadarMoment>();
  const whole = slices.filter((slice) => listParts(slice).every((id) => blobs.has(id)));
  if (whole.length === 0)
    throw corruptFile(what, `holds none of its ${slices.length} sweeps as a whole; the file is cut short`);
  // What a sweep does not say is as in the first one, or for all.
  const sweeps = whole.map((slice) => readSlice([slice, slices[0], childOf(scan, 'pargroup')], blobs, moments, budget));
  const sensor = childOf(volume, 'sensorinfo') ?? childOf(volume, 'radarinfo');
  const [latitude, longitude, height, beamWidth] = ['lat', 'lon', 'alt', 'beamwidth'].map((name) =>
    numberIn([sensor], name),
  );
  const name = sensor?.attributes.get('name')?.slice(0, 80);
  const { time } = sweeps[0];
  return {
    format: `Rainbow ${(volume.attributes.get('version') ?? '5').slice(0, 20)}`,
    site: {
      ...(name && { name }),
      ...(latitude !== undefined && { latitude }),
      ...(longitude !== undefined && { longitude }),
      ...(height !== undefined && { height }),
    },
    ...(beamWidth !== undefined && { beamWidth }),
    ...(time && { time }),
    moments: [...moments.values()],
    sweeps,
    ...((isCut || whole.length < slices.length) && {
      partial: `the file was cut short: ${whole.length} of ${slices.length} sweeps are whole`,
    }),
  };
}

/** What is said of a sweep: its own slice, and where that does not say it. */
type Said = readonly (RainbowNode | undefined)[];

const rawOf = (slice: RainbowNode | undefined): RainbowNode[] => childrenOf(childOf(slice, 'slicedata'), 'rawdata');
const raysOf = (slice: RainbowNode | undefined): RainbowNode[] =>
  childrenOf(childOf(slice, 'slicedata'), 'rayinfo').filter(({ attributes }) =>
    ['startangle', 'stopangle'].includes(attributes.get('refid') ?? ''),
  );

/** The parts that hold a sweep's numbers. */
const listParts = (slice: RainbowNode): number[] =>
  [...raysOf(slice), ...rawOf(slice)].map((part) => attributeOf(part, 'blobid'));

/** @throws {VolumeViewError} `format/corrupt`, `format/too-large` */
function readSlice(said: Said, blobs: RainbowBlobs, moments: Map<string, RadarMoment>, budget: Budget): RadarSweep {
  const [slice] = said;
  const raw = new Map(rawOf(slice).map((one) => [(one.attributes.get('type') ?? '').slice(0, 40), one]));
  const elevation = numberIn(said, 'posangle');
  const step = numberIn(said, 'rangestep');
  const [first] = raw.values();
  if (elevation === undefined || !(step !== undefined && step > 0) || !first)
    throw corruptFile(what, 'has a sweep without its elevation (posangle), its gates (rangestep), or data');
  const radials = attributeOf(first, 'rays');
  for (const [name, one] of raw) {
    if (attributeOf(one, 'rays') !== radials)
      throw corruptFile(what, `got ${attributeOf(one, 'rays')} and ${radials} radials in one sweep`);
    refuseSweep(what, radials, attributeOf(one, 'bins'));
    const [kind, unit] = kinds[name] ?? ['other', ''];
    if (!moments.has(name)) moments.set(name, { name, kind, unit });
  }
  const gateLength = 1000 * step;
  const start = 1000 * (numberIn(said, 'startrange') ?? numberIn(said, 'start_range') ?? 0);
  const gridOf = (moment: string): SweepGates | null => {
    const one = raw.get(moment);
    return one ? { firstGate: start + gateLength / 2, gateLength, gates: attributeOf(one, 'bins') } : null;
  };
  const time = readTime(childOf(slice, 'slicedata'));
  // Velocities have the range in which they are not ambiguous.
  const nyquist = numberIn([childOf(slice, 'dynv')], 'max');
  return {
    elevation,
    azimuths: readAzimuths(said, radials, blobs, budget),
    ...(time && { time }),
    ...(nyquist !== undefined && nyquist > 0 && { nyquist }),
    moments: [...raw.keys()],
    gridOf,
    read: (moment) => {
      const grid = gridOf(moment);
      return grid && { ...grid, ...readValues(raw.get(moment)!, radials * grid.gates, blobs, budget) };
    },
  };
}

function readTime(data: RainbowNode | undefined): string | undefined {
  const [date, time] = ['date', 'time'].map((name) => data?.attributes.get(name) ?? '');
  return /^\d{4}-\d\d-\d\d$/.test(date) && /^\d\d:\d\d:\d\d/.test(time) ? `${date}T${time.slice(0, 8)}Z` : undefined;
}

/** Middles of the radials: between start and stop, or half a step after the start. */
function readAzimuths(said: Said, radials: number, blobs: RainbowBlobs, budget: Budget): Float64Array<ArrayBuffer> {
  budget.take(32 * radials, what);
  const [starts, stops] = ['startangle', 'stopangle'].map((refid) => {
    const info = raysOf(said[0]).find(({ attributes }) => attributes.get('refid') === refid);
    return info && readAngles(info, radials, blobs, budget);
  });
  const step = numberIn(said, 'anglestep');
  if (!starts || (!stops && step === undefined))
    throw corruptFile(what, 'has a sweep without the angles of its radials (startangle and stopangle or anglestep)');
  const half = (numberIn(said, 'antdirection') ? -1 : 1) * ((step ?? 0) / 2);
  return starts.map((start, radial) => {
    const turn = stops ? ((((stops[radial] - start + 180) % 360) + 360) % 360) - 180 : 2 * half;
    return (((start + turn / 2) % 360) + 360) % 360;
  });
}

function readAngles(
  info: RainbowNode,
  radials: number,
  blobs: RainbowBlobs,
  budget: Budget,
): Float64Array<ArrayBuffer> {
  const depth = attributeOf(info, 'depth');
  if (depth !== 16) throw corruptFile(what, `got angles of ${depth} bits; expected 16`);
  if (attributeOf(info, 'rays') < radials) throw corruptFile(what, 'has fewer angles than radials');
  const bytes = readBlob(blobs, attributeOf(info, 'blobid'), 2 * radials, budget);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  return Float64Array.from({ length: radials }, (_, radial) => (view.getUint16(2 * radial) * 360) / 65536);
}

/** 0 is no data; the other numbers go from the least value to the greatest. */
function readValues(
  raw: RainbowNode,
  count: number,
  blobs: RainbowBlobs,
  budget: Budget,
): Pick<SweepData, 'samples' | 'slope' | 'intercept'> {
  const [depth, min, max] = ['depth', 'min', 'max'].map((key) => attributeOf(raw, key));
  if (depth !== 8 && depth !== 16)
    throw unsupportedFile(
      what,
      `holds numbers of ${depth} bits; expected 8 or 16. Convert it to CfRadial, with xradar`,
    );
  const bytes = readBlob(blobs, attributeOf(raw, 'blobid'), (count * depth) / 8, budget);
  const slope = (max - min) / (2 ** depth - 2);
  const scale = { slope, intercept: min - slope };
  if (depth === 8) return { samples: bytes.slice(), ...scale };
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  return { samples: Uint16Array.from({ length: count }, (_, gate) => view.getUint16(2 * gate)), ...scale };
}

// What a stranger's DICOMweb server answers: a list in JSON, and frames in answers of several parts. Source: DICOM PS3.18, 8.6 and annex F
import { ctSlice, dicomJson, packRle } from '../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../helpers/dicom-bytes.ts';
import { j2kStreams } from '../../helpers/j2k-streams.ts';
import { jpegStreams } from '../../helpers/jpeg-streams.ts';
import { damage } from '../fuzz-case.ts';
import type { FuzzFile, Grammar, WebCase } from '../fuzz-case.ts';
import type { Random } from '../random.ts';

/** How all frames of a case are packed. */
interface Packing {
  readonly type: string;
  readonly syntax: string | null;
  readonly bits: number;
  readonly size: readonly [columns: number, rows: number];
  frame(random: Random): Uint8Array<ArrayBuffer>;
}

const root = '1.2.840.10008.1.2';
const unpacked = (bits: number): Packing => ({
  type: 'application/octet-stream',
  syntax: null,
  bits,
  size: [4, 3],
  frame: (random) => random.bytes((12 * bits) / 8),
});
const runs: Packing = {
  type: 'image/dicom-rle',
  syntax: `${root}.5`,
  bits: 16,
  size: [4, 3],
  frame: (random) => packRle(new Uint16Array(random.bytes(24).buffer)),
};
const streamOf = (stream: string, bits: number, syntax: string, type: string): Packing => ({
  type,
  syntax: `${root}${syntax}`,
  bits: bits > 8 ? 16 : 8,
  size: [10, 9],
  frame: () => Uint8Array.from(atob(stream), (c) => c.charCodeAt(0)),
});
const packings: readonly Packing[] = [
  unpacked(16),
  unpacked(8),
  unpacked(32),
  runs,
  ...jpegStreams.map(({ stream, bits }) => streamOf(stream, bits, '.4.80', 'image/jls')),
  ...j2kStreams.map(({ stream, bits, isHt }) =>
    streamOf(stream, bits, isHt ? '.4.203' : '.4.91', isHt ? 'image/jphc' : 'image/jp2'),
  ),
];

export const dicomWeb: Grammar = (random) => {
  const packing = random.pick(packings);
  const [times, slices] = [random.int(1, 3), random.chance(0.1) ? random.int(32, 36) : random.int(1, 5)];
  const hasFrames = random.chance(0.5);
  const files: FuzzFile[] = [];
  const sets: unknown[] = [];
  const count = hasFrames ? random.int(1, 2) : times * slices;
  for (let n = 0; n < count; n++) {
    const uid = random.or(`1.3.${n}`, '1.3.0', '../../x', '');
    const frames = hasFrames ? times * slices : 1;
    const fields = hasFrames
      ? ofFrames(random, packing, { times, slices, uid })
      : ofSlice(random, packing, { time: n % times, slice: Math.floor(n / times), uid });
    const json = dicomJson(fields, (tag) =>
      random.or(`http://other.invalid/x/studies/1/bulk/${tag}`, 'x', '/studies/'),
    );
    if (random.chance(0.1)) writeFloats(random, json, uid, files);
    sets.push(makeOdd(random, json, 0));
    for (let frame = 1; frame <= frames && !random.isWild(); frame++)
      files.push({ name: `${uid}/${frame}`, bytes: damage(random, packing.frame(random)) });
  }
  if (random.isHostile()) sets.push(...listMore(random, sets[0]));
  const list = new TextEncoder().encode(JSON.stringify(random.or(sets, { sets }, null, [sets], sets[0], [7])));
  return {
    files: [{ name: 'metadata', bytes: damage(random, list) }, ...files],
    web: chooseAnswers(random, packing),
  };
};

/** The same instance again and again, under other numbers, of which the server has no frames. */
function listMore(random: Random, set: unknown): unknown[] {
  const bytes = JSON.stringify(set).length;
  return Array.from({ length: Math.min(500, Math.floor(3e5 / bytes)) }, (_, n) =>
    typeof set === 'object' && random.chance(0.9) ? { ...set, '00080018': { vr: 'UI', Value: [`1.4.${n}`] } } : set,
  );
}

interface Wish {
  readonly uid: string;
}

function ofSlice(
  random: Random,
  packing: Packing,
  { time, slice, uid }: Wish & { readonly time: number; readonly slice: number },
): DicomFields {
  return {
    ...ctSlice(random.number(5 * slice)),
    ...pixelsOf(random, packing),
    SOPInstanceUID: uid,
    TriggerTime: String(random.number(40 * time)),
    InstanceNumber: String(random.size(slice)),
    RescaleSlope: [random.number(1)],
    ...(random.isWild() && {
      ImageType: 'ORIGINAL\\PRIMARY\\M\\MOSAIC',
      NumberOfImagesInMosaic: [random.size(4) & 0xffff],
    }),
  };
}

function ofFrames(
  random: Random,
  packing: Packing,
  { times, slices, uid }: Wish & { readonly times: number; readonly slices: number },
): DicomFields {
  const groups = Array.from({ length: times * slices }, (_, i): DicomFields => ({
    FrameContentSequence: [{ TemporalPositionIndex: [random.size((i % times) + 1) % 2 ** 32] }],
    PlanePositionSequence: [{ ImagePositionPatient: [0, 0, random.number(3 * Math.floor(i / times))] }],
  }));
  return {
    ...ctSlice(0),
    ...pixelsOf(random, packing),
    SOPInstanceUID: uid,
    SOPClassUID: random.or(
      '1.2.840.10008.5.1.4.1.1.4.1',
      '1.2.840.10008.5.1.4.1.1.66.4',
      '1.2.840.10008.5.1.4.1.1.481.3',
    ),
    NumberOfFrames: String(random.size(times * slices)),
    SpacingBetweenSlices: [random.number(3)],
    PerFrameFunctionalGroupsSequence: random.shuffle(groups),
  };
}

function pixelsOf(random: Random, { bits, size: [columns, rows] }: Packing): DicomFields {
  return {
    Rows: [random.size(rows) & 0xffff],
    Columns: [random.size(columns) & 0xffff],
    BitsAllocated: [random.size(bits) & 0xffff],
    BitsStored: [random.size(bits) & 0xffff],
    HighBit: [random.size(bits - 1) & 0xffff],
    SamplesPerPixel: [random.or(1, 3)],
    PhotometricInterpretation: random.or(
      'MONOCHROME2',
      'MONOCHROME1',
      'RGB',
      'YBR_RCT',
      'YBR_FULL_420',
      'PALETTE COLOR',
    ),
    PixelData: new Uint8Array(),
    ...(random.isWild() && {
      RedPaletteColorLookupTableDescriptor: [random.size(256) & 0xffff, 0, 16],
      RedPaletteColorLookupTableData: new Uint8Array(),
    }),
  };
}

/** Pixels that are floats stand at an address of their own. */
function writeFloats(random: Random, json: Record<string, unknown>, uid: string, files: FuzzFile[]): void {
  const tag = random.pick(['7FE00008', '7FE00009']);
  Reflect.deleteProperty(json, '7FE00010');
  json[tag] = { vr: 'OF', BulkDataURI: random.or(`http://other.invalid/studies/1/${uid}/${tag}`, '/x') };
  files.push({ name: `${uid}/${tag}`, bytes: damage(random, random.bytes(random.size(12) % 4096)) });
}

/** What stands where a server's list has something else. */
function oddThings(random: Random): unknown {
  return random.pick<() => unknown>([
    () => null,
    () => 'x',
    () => 7,
    () => [],
    () => ({}),
    () => ({ vr: random.pick(['UL', 'FD', 'SQ', 'AT', 'UN', 'US', 'q', 5]), Value: [random.number(3)] }),
    () => ({ vr: 'DS', Value: random.pick<unknown>([null, 'x', 7, {}, [null], [{}], [[1]], ['1\\2\\3'], [true], []]) }),
    () => ({ vr: 'SQ', Value: [random.pick<unknown>([null, 7, 'x', [], {}])] }),
    () => ({ vr: 'OB', InlineBinary: random.pick<unknown>(['***', 'AAAA', '', 7, 'A'.repeat(10_000)]) }),
    () => ({
      BulkDataURI: random.pick<unknown>(['/studies/', 'x', '', 7, 'https://other.invalid/studies/1?a=/studies/2']),
    }),
    () => ({ vr: 'DS', Value: Array<number>(5000).fill(random.number(1)) }),
    () => ({ vr: 'LO', Value: ['x'.repeat(100_000)] }),
    () => nest(random.pick([9, 40, 2000])),
  ])();
}

/** Sequences in each other. */
function nest(depth: number): unknown {
  let inner: unknown = {};
  for (let n = 0; n < depth; n++) inner = { vr: 'SQ', Value: [{ 52009230: inner }] };
  return inner;
}

/** The same with some elements that are odd, missing, or named in another way. */
function makeOdd(random: Random, json: Record<string, unknown>, depth: number): unknown {
  if (random.isWild()) return oddThings(random);
  const odd: Record<string, unknown> = {};
  for (const [tag, element] of Object.entries(json)) {
    if (random.isWild()) continue;
    const name = random.or(tag, tag.toLowerCase(), `0x${tag}`, '__proto__', '7FE00008');
    odd[name] = random.isWild() ? oddThings(random) : makeOddItems(random, element, depth);
  }
  return odd;
}

function makeOddItems(random: Random, element: unknown, depth: number): unknown {
  const { vr, Value } = element as { readonly vr: string; readonly Value?: readonly unknown[] };
  if (vr !== 'SQ' || !Value || depth > 2) return element;
  return { vr, Value: Value.map((item) => makeOdd(random, item as Record<string, unknown>, depth + 1)) };
}

function chooseAnswers(random: Random, { type, syntax }: Packing): WebCase {
  const boundary = random.or('part-of-it', '-', 'a b', 'x'.repeat(5000), '');
  const stated = random.or(boundary, 'another');
  const some = (): { readonly every: number; readonly at: number } => ({
    every: random.pick([1, 1, 3, 7]),
    at: random.unit(),
  });
  const suffix = syntax === null ? '' : `; transfer-syntax=${random.or(syntax, '9.9', `${root}.5`, '')}`;
  return {
    listType: random.or('application/dicom+json', 'text/html', ''),
    type: random.or(
      `multipart/related; type="${type}"; boundary=${random.or(`"${stated}"`, stated)}`,
      'multipart/related',
      type,
      'multipart/related; boundary=',
      'application/json',
    ),
    partType: random.or(`${type}${random.chance(0.7) ? suffix : ''}`, 'image/jpeg', 'text/html', '', 'image/jp2'),
    boundary,
    header: random.isWild() ? random.pick(['', `X: ${'y'.repeat(5000)}`, 'Content-Type', ':']) : null,
    lineEnd: random.or('\r\n', '\n', '\r'),
    preamble: random.or('', 'x', `--${boundary}`, '\r\n\r\n', 'x'.repeat(3000)),
    moreParts: random.or(0, 1, -1, 5),
    cuts: random.isWild() ? some() : null,
    breaks: random.isWild() ? some() : null,
    status: random.isWild()
      ? { every: random.pick([1, 2, 5]), code: random.pick([206, 301, 400, 401, 404, 406, 415, 429, 500, 501, 503]) }
      : null,
    pieceBytes: random.or(2 ** 16, 1, 100),
    liesBy: random.or<number | null>(0, null, 100, -20, 2 ** 40),
    isPlain: random.isWild(),
  };
}

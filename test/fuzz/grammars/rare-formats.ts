import { deflateSync, gzipSync } from 'node:zlib';
import { big, concat, latin1, little } from '../bytes.ts';
import { damage, oneFile } from '../fuzz-case.ts';
import type { FilesCase, Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';

/** A file that may be packed with gzip, and then may swell. */
function mayPack(
  random: Random,
  whole: Uint8Array<ArrayBuffer>,
  [plain, packed]: readonly [string, string],
): FilesCase {
  const bytes = damage(random, whole);
  if (!random.chance(0.4)) return oneFile(random.or(plain, 'a'), bytes);
  const swollen = random.isWild() ? concat([bytes, new Uint8Array(random.pick([1e5, 2e7]))]) : bytes;
  return oneFile(random.or(packed, 'a.gz', 'a'), damage(random, new Uint8Array(gzipSync(swollen))));
}

const product = (sizes: readonly number[]): number => sizes.reduce((all, n) => all * n, 1);

/** MGH and MGZ: sizes, types and places that lie. Source: FreeSurfer wiki, FsTutorial/MghFormat */
export const mgh: Grammar = (random) => {
  const [code, bytes] = random.pick([
    [0, 1],
    [1, 4],
    [3, 4],
    [4, 2],
    [10, 2],
  ] as const);
  const size = [random.int(1, 9), random.int(1, 9), random.int(1, 9), random.or(1, 2, 5)];
  const out = big().u32(
    random.or(1, 0x201, 2),
    ...size.map((n) => random.size(n)),
    random.or<number>(code, 2, 5, 9, 99),
  );
  out.u32(random.size(0)).u16(random.or(1, 0, 0xffff));
  out.f32(...[1, 1.5, 2, -1, 0, 0, 0, 0, -1, 0, 1, 0, 5, 6, 7].map((entry) => random.number(entry)));
  out.zeros(284 - out.length).put(random.bytes(bytes * product(size)));
  return mayPack(random, concat([out.finish(), random.chance(0.3) ? random.bytes(20) : new Uint8Array()]), [
    'a.mgh',
    'a.mgz',
  ]);
};

/** MRC: sizes, modes, cells, stacks and byte orders that lie; packed with gzip or not. Source: MRC2014 */
export const mrc: Grammar = (random) => {
  const [mode, bytes] = random.pick([
    [0, 1],
    [1, 2],
    [2, 4],
    [6, 2],
    [12, 2],
  ] as const);
  const size = [random.int(1, 9), random.int(1, 9), random.int(1, 9)];
  const isLittle = random.chance(0.7);
  const out = isLittle ? little() : big();
  const extended = random.pick([0, 0, 80]);
  out.u32(...size.map((n) => random.size(n)), random.or<number>(mode, 3, 4, 16, 101, 77));
  out.u32(...size.map(() => random.size(0)), ...size.map((n) => random.size(n)));
  out.f32(...[10, 20, 30, 90, 90, 100].map((entry) => random.number(entry)));
  out
    .u32(
      ...random.pick([
        [1, 2, 3],
        [3, 1, 2],
        [0, 0, 0],
        [random.size(1), 2, 3],
      ]),
    )
    .f32(0, 1, 0.5);
  out.u32(random.or(1, 0, 401), random.size(extended)).zeros(56);
  out.u32(random.or(0, 1_146_047_817), random.or(0, 1)).zeros(36);
  out.f32(...[0, 0, 5].map((entry) => random.number(entry))).text(random.or('MAP ', 'MAP\0'));
  const stamp = random.or(isLittle ? 0x44 : 0x11, 0, 0x11, 0x44);
  out.u8(stamp, stamp, 0, 0).zeros(1024 - out.length);
  out.put(random.bytes(extended + bytes * product(size)));
  return mayPack(random, out.finish(), ['a.mrc', 'a.map.gz']);
};

/** Analyze and NIfTI pairs: a header that lies, samples in another file or not there. Sources: nifti1.h, Mayo's dbh.h */
export const analyze: Grammar = (random) => {
  const [code, bytes] = random.pick([
    [2, 1],
    [4, 2],
    [8, 4],
    [16, 4],
    [32, 8],
    [64, 8],
    [132, 2],
  ] as const);
  const size = [random.int(1, 9), random.int(1, 9), random.int(1, 9), random.or(1, 2, 5)];
  const short = (sound: number): number => random.size(sound) & 0xffff;
  const out = random.chance(0.7) ? little() : big();
  out
    .u32(random.or(348, 540))
    .zeros(36)
    .u16(random.or(4, 0, 3, 8), ...size.map(short), 1, 1, 1)
    .zeros(14);
  out.u16(random.or<number>(code, 0, 1, 128, 9999), short(8 * bytes), 0);
  out.f32(random.or(1, 0), ...[1, 1.5, 2, 1, 1, 1, 1].map((entry) => random.number(entry)));
  out.f32(random.isWild() ? random.size(0) : 0, random.number(random.pick([0, 1])), random.number(0)).zeros(4);
  out
    .f32(random.number(random.pick([0, 100])), random.number(0))
    .zeros(8)
    .u32(random.size(1000), random.size(0));
  out.zeros(252 - out.length).u8(random.or(0, 1, 5, 200));
  for (let axis = 0; axis < 3; axis++) out.u16(short(random.pick([0, 2])));
  out.zeros(344 - out.length).text(random.pick(['\0\0\0\0', '\0\0\0\0', 'ni1\0']));
  const header = { name: random.or('a.hdr', 'a'), bytes: damage(random, out.finish()) };
  const samples = {
    name: random.or('a.img', 'a.img.gz', 'b.img'),
    bytes: damage(random, random.bytes(bytes * product(size))),
  };
  const files = random.chance(0.5) ? [header, samples] : [samples, header];
  return { files, ...(random.isWild() ? { stack: true as const } : {}) };
};

/** NPY: descriptions and shapes that lie. Source: numpy.lib.format */
export const npy: Grammar = (random) => {
  const [code, bytes] = random.pick([
    ['|b1', 1],
    ['<i2', 2],
    ['>i2', 2],
    ['<f2', 2],
    ['<f4', 4],
    ['>u8', 8],
    ['<c16', 16],
  ] as const);
  const size = Array.from({ length: random.or(3, 1, 2, 4, 5) }, () => random.int(1, 7));
  const shape = size.map((n) => random.size(n)).join(', ');
  const description = `{'descr': ${random.or(`'${code}'`, "'|O'", "[('a', '<f4')]", "'".repeat(3000))}, 'fortran_order': ${random.pick(['True', 'False'])}, 'shape': (${random.or(shape, '', '1, '.repeat(9000))}), }\n`;
  const version = random.or(1, 2, 3, 9);
  const out = little().text('\x93NUMPY').u8(version, 0);
  const length = random.size(description.length);
  if (version === 1) out.u16(length & 0xffff);
  else out.u32(length);
  out.text(description).put(random.bytes(bytes * product(size)));
  return mayPack(random, out.finish(), ['a.npy', 'a.npy.gz']);
};

/** Base64 of bytes, as VTK writes it. */
const base64 = (bytes: Uint8Array): string => Buffer.from(bytes).toString('base64');

/** VTI: extents, offsets, headers and blocks that lie. Source: VTK XML formats */
export const vti: Grammar = (random) => {
  const [type, bytes] = random.pick([
    ['UInt8', 1],
    ['Int16', 2],
    ['Float32', 4],
    ['Float64', 8],
    ['Int64', 8],
  ] as const);
  const size = [random.int(2, 7), random.int(2, 7), random.int(2, 7)];
  const samples = random.bytes(bytes * product(size));
  const isWide = random.chance(0.3);
  const isPacked = random.chance(0.5);
  const form = random.pick(['ascii', 'binary', 'base64', 'raw']);
  const head = (...values: number[]): Uint8Array<ArrayBuffer> => {
    const out = little();
    for (const value of values) {
      if (isWide) out.u64(random.size(value));
      else out.u32(random.size(value) % 2 ** 32);
    }
    return out.finish();
  };
  const block = isPacked
    ? new Uint8Array(deflateSync(random.isWild() ? concat([samples, new Uint8Array(2e7)]) : samples))
    : samples;
  const header = isPacked ? head(1, samples.length, 0, block.length) : head(samples.length);
  const text = isPacked ? base64(header) + base64(block) : base64(concat([header, block]));
  const inline =
    form === 'ascii' ? Array.from(samples.subarray(0, product(size))).join(' ') : form === 'binary' ? text : '';
  const isAppended = form === 'base64' || form === 'raw';
  const numbers = (...values: number[]): string => values.map((value) => random.number(value)).join(' ');
  const extent = size.map((n) => `0 ${random.size(n - 1)}`).join(' ');
  const xml =
    `${random.or('<?xml version="1.0"?>\n', '', '<!-- x -->')}<VTKFile type="ImageData" header_type="${isWide ? 'UInt64' : 'UInt32'}" ` +
    `byte_order="${random.or('LittleEndian', 'BigEndian')}" ${isPacked && form !== 'ascii' ? 'compressor="vtkZLibDataCompressor"' : ''}>` +
    `<ImageData WholeExtent="${extent}" Origin="${numbers(0, 0, 0)}" Spacing="${numbers(1, 1.5, 2)}" Direction="${numbers(1, 0, 0, 0, 1, 0, 0, 0, 1)}">` +
    `${'<Piece>'.repeat(random.or(1, 0, 3))}<${random.or('PointData', 'CellData')}>` +
    `<DataArray type="${random.or<string>(type, 'String', '')}" Name="a" NumberOfComponents="${random.size(1)}" format="${isAppended ? 'appended' : form}" ${isAppended ? `offset="${random.size(0)}"` : ''}>${inline}</DataArray>` +
    `</PointData></Piece></ImageData>`;
  const appended = isAppended
    ? [
        latin1(`<AppendedData encoding="${form}">_`),
        form === 'raw' ? concat([header, block]) : latin1(text),
        latin1('</AppendedData>'),
      ]
    : [];
  return oneFile(random.or('a.vti', 'a'), damage(random, concat([latin1(xml), ...appended, latin1('</VTKFile>')])));
};

/** AFNI: attributes that lie, are missing or come twice; samples in another file. Source: AFNI, README.attributes */
export const afni: Grammar = (random) => {
  const [code, bytes] = random.pick([
    [0, 1],
    [1, 2],
    [3, 4],
    [5, 8],
  ] as const);
  const size = [random.int(1, 7), random.int(1, 7), random.int(1, 7)];
  const volumes = random.pick([1, 1, 3]);
  const list = (values: readonly number[]): string => ` ${values.join(' ')}`;
  const place = [1.5, 0, 0, -5, 0, 1.5, 0, -5, 0, 0, 2, -5].map((entry) => random.number(entry));
  const attributes = random.shuffle([
    ['integer', 'DATASET_DIMENSIONS', list(size.map((n) => random.size(n)))],
    ['integer', 'DATASET_RANK', list([3, random.size(volumes)])],
    ['integer', 'BRICK_TYPES', list([random.or<number>(code, 2, 4, 6, 99)])],
    ['float', 'BRICK_FLOAT_FACS', list([random.number(random.pick([0, 0.5]))])],
    ['string', 'BYTEORDER_STRING', `'${random.or('LSB_FIRST', 'MSB_FIRST')}~`],
    random.chance(0.7)
      ? ['float', 'IJK_TO_DICOM_REAL', list(place)]
      : ['integer', 'ORIENT_SPECIFIC', list([random.or(0, 9), 3, 4])],
    ['float', 'ORIGIN', list([random.number(1), 2, 3])],
    ['float', 'DELTA', list([random.number(1), 2, 3])],
  ]);
  const text = attributes
    .map(([kind, name, value]) => `\ntype = ${kind}-attribute\nname = ${name}\ncount = ${random.size(3)}\n${value}\n`)
    .join('');
  const header = {
    name: random.or('a+orig.HEAD', 'a'),
    bytes: damage(random, latin1(text + random.or('', ' 1'.repeat(50_000)))),
  };
  const samples = {
    name: random.or('a+orig.BRIK', 'b.BRIK'),
    bytes: damage(random, random.bytes(bytes * volumes * product(size))),
  };
  return { files: random.chance(0.6) ? [header, samples] : [samples, header] };
};

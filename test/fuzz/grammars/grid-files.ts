import { deflateSync, gzipSync } from 'node:zlib';
import { concat, latin1 } from '../bytes.ts';
import { damage } from '../fuzz-case.ts';
import type { FilesCase, Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';
import { bzip2 } from './bzip2-writer.ts';

/** A line of a header, which may be longer, emptier or other than it should. */
function line(random: Random, name: string, value: string, separator: string): string {
  const others = [
    '',
    value.repeat(2),
    value.replace(/\d+/, String(random.size(7))),
    value.replace(/[-\d.]+/, String(random.number(1))),
    ' '.repeat(5000),
    '('.repeat(2000),
    '9'.repeat(400),
    '"'.repeat(3000),
  ];
  return `${random.or(name, name.toUpperCase(), '', `${name} ${name}`)}${random.or(separator, '')}${random.or(value, ...others)}\n`;
}

/** Lengths of some axes; where they are many, short ones. */
function chooseSizes(random: Random): number[] {
  const axes = random.or(3, 1, 2, 4, 10);
  return Array.from({ length: axes }, () => random.int(1, axes > 4 ? 2 : 7));
}

const packers: Readonly<Record<string, (bytes: Uint8Array) => Uint8Array>> = {
  raw: (bytes) => bytes,
  gzip: gzipSync,
  bzip2: (bytes) => bzip2(bytes.subarray(0, 2000)),
  ascii: (bytes) => latin1(Array.from(bytes).join(' ')),
};

/** What data are in, now and then swollen. */
function pack(random: Random, encoding: string, samples: Uint8Array): Uint8Array {
  const bytes = random.isWild() ? concat([samples, new Uint8Array(random.pick([1, 1e5, 2e7]))]) : samples;
  return packers[encoding](encoding === 'ascii' || encoding === 'bzip2' ? samples : bytes);
}

/** Header and data, in one file or in several. */
function join(random: Random, header: string, data: Uint8Array, names: readonly string[]): FilesCase {
  if (names.length < 2) return { files: [{ name: names[0], bytes: damage(random, concat([latin1(header), data])) }] };
  const share = Math.ceil(data.length / (names.length - 1));
  const files = names.slice(1).map((name, i) => ({ name, bytes: data.slice(i * share, (i + 1) * share) }));
  return {
    files: [{ name: names[0], bytes: damage(random, latin1(header)) }, ...random.shuffle(files)],
    ...(random.isWild() ? { stack: true as const } : {}),
  };
}

/** NRRD: fields in another order, twice or not at all, numbers that lie, data elsewhere. Source: teem.sourceforge.net/nrrd/format.html */
export const nrrd: Grammar = (random) => {
  const [type, bytes] = random.pick([
    ['uchar', 1],
    ['short', 2],
    ['float', 4],
    ['double', 8],
    ['uint64', 8],
    ['int', 4],
  ] as const);
  const encoding = random.pick(['raw', 'raw', 'gzip', 'bzip2', 'ascii']);
  const sizes = chooseSizes(random);
  const samples = random.bytes(bytes * sizes.reduce((product, n) => product * n, 1));
  const axes = (values: readonly string[]): string => sizes.map((_, i) => values[i] ?? values[0]).join(' ');
  const detached = random.chance(0.2) ? random.pick(['data.raw', 'LIST', 'slice%03d.raw 1 3 1']) : null;
  const isPlaced = random.chance(0.6);
  const fields = random.shuffle([
    ['type', type],
    ['dimension', String(random.size(sizes.length))],
    ['sizes', sizes.map((n) => random.size(n)).join(' ')],
    ['encoding', encoding],
    ...(bytes > 1 ? [['endian', random.or('little', 'big', 'middle')]] : []),
    ...(isPlaced
      ? [
          ['space', random.or('left-posterior-superior', 'RAS', 'scanner-xyz', '3D-left-handed', 'x')],
          ['space directions', axes(['(1,0,0)', `(0,${random.number(1.5)},0)`, `(0,0,${random.number(2)})`, 'none'])],
          ['space origin', `(0,${random.number(0)},0)`],
        ]
      : [['spacings', axes([String(random.number(1.5)), '1', 'nan'])]]),
    ...(random.chance(0.3)
      ? [['kinds', axes(['domain', 'space', random.or('domain', 'list', '3-color', 'vector')])]]
      : []),
    ...(random.isWild()
      ? [
          ['line skip', String(random.size(1))],
          ['byte skip', String(random.pick([-1, -2, 1, 1e9]))],
        ]
      : []),
    ...(random.chance(0.2) ? [['sample units', random.or('"HU"', '"'.repeat(3000))]] : []),
    ...(detached === 'LIST' || detached === null
      ? []
      : [
          [
            'data file',
            random.or(
              detached,
              'slice%099999999d.raw 1 3 1',
              'a%d 0 1000000 1',
              '../../x',
              '/etc/passwd',
              'http://other.test/x',
              'a%d 1 3 0',
            ),
          ],
        ]),
  ]);
  const lines = fields.map(([name, value]) => line(random, name, value, ': ')).join('');
  const names =
    detached === null
      ? ['a.nrrd']
      : ['a.nhdr', ...(detached === 'data.raw' ? ['data.raw'] : ['slice001.raw', 'slice002.raw', 'slice003.raw'])];
  const list =
    detached === 'LIST' ? `data file: LIST\n${names.slice(1).join('\n')}${random.or('', '\nx'.repeat(10_000))}` : '';
  const header = `${random.or('NRRD0004', 'NRRD0009', 'NRRD00')}\n${random.or('', '# words\nkey:=value\n')}${lines}${list}${random.or('\n', '')}`;
  return join(random, header, pack(random, encoding, samples), names);
};

/** MetaImage: as NRRD. Source: MetaIO's metaObject.cxx and metaImage.cxx */
export const metaImage: Grammar = (random) => {
  const [type, bytes] = random.pick([
    ['MET_UCHAR', 1],
    ['MET_SHORT', 2],
    ['MET_FLOAT', 4],
    ['MET_DOUBLE', 8],
    ['MET_LONG_LONG', 8],
  ] as const);
  const form = random.pick(['raw', 'raw', 'zlib', 'ascii']);
  const sizes = chooseSizes(random);
  const samples = random.bytes(bytes * sizes.reduce((product, n) => product * n, 1));
  const data =
    form === 'zlib'
      ? new Uint8Array(deflateSync(random.isWild() ? concat([samples, new Uint8Array(2e7)]) : samples))
      : pack(random, form, samples);
  const each = (value: () => number): string => sizes.map(value).join(' ');
  const detached = random.chance(0.2) ? random.pick(['data.raw', 'LIST', 'slice%03d.raw 1 3 1']) : null;
  const fields = random.shuffle([
    ['ObjectType', 'Image'],
    ['NDims', String(random.size(sizes.length))],
    ['DimSize', sizes.map((n) => random.size(n)).join(' ')],
    ['ElementType', random.or<string>(type, 'MET_OTHER', 'MET_STRING', 'x')],
    ['BinaryData', form === 'ascii' ? 'False' : 'True'],
    ['BinaryDataByteOrderMSB', random.or('False', 'True', '2')],
    ['CompressedData', form === 'zlib' ? 'True' : 'False'],
    ...(form === 'zlib' ? [['CompressedDataSize', String(random.size(data.length))]] : []),
    ...(random.chance(0.5)
      ? [
          [
            'TransformMatrix',
            sizes.map((_, i) => sizes.map((_, j) => random.number(Number(i === j))).join(' ')).join(' '),
          ],
          ['Offset', each(() => random.number(0))],
        ]
      : []),
    ['ElementSpacing', each(() => random.number(1.5))],
    ...(random.isWild()
      ? [
          ['HeaderSize', String(random.pick([-1, -2, 0, 1, 1e9, NaN]))],
          ['ElementNumberOfChannels', String(random.size(1))],
        ]
      : []),
  ]);
  const names =
    detached === null
      ? ['a.mha']
      : ['a.mhd', ...(detached === 'data.raw' ? ['data.raw'] : ['slice001.raw', 'slice002.raw', 'slice003.raw'])];
  const place =
    detached === null
      ? 'LOCAL'
      : detached === 'LIST'
        ? `LIST\n${names.slice(1).join('\n')}${random.or('', '\nx'.repeat(10_000))}`
        : random.or(detached, 'a%d 0 1000000 1', 'a%099999999d 1 3 1');
  const header =
    fields.map(([name, value]) => line(random, name, value, ' = ')).join('') + `ElementDataFile = ${place}\n`;
  return join(random, header, data, names);
};

import { expect } from '@esm-bundle/chai';
import { zlibSync } from 'fflate';
import { decodeFile } from '../../../src/formats/decode.ts';
import { fetchInOrder } from '../../../src/sources/fetch-files.ts';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { decodeBytes, expectError, fetchFixture, fixtureContext, urlOf, valuesOf } from '../../helpers/decode.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

// Headers with samples after them or beside them that are damaged, hostile, or hold what can not be shown.

const encode = (text: string): Uint8Array<ArrayBuffer> => new TextEncoder().encode(text);
const join = (...parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> =>
  Uint8Array.from(parts.flatMap((part) => Array.from(part)));
const data = Uint8Array.from({ length: 48 }, (_, i) => i);

type Fields = Readonly<Record<string, string | null>>;

/** A header with other fields; null leaves one out. */
function makeNrrd(fields: Fields = {}, body: Uint8Array = data): Uint8Array<ArrayBuffer> {
  const all: Fields = { type: 'short', dimension: '3', sizes: '3 2 4', endian: 'little', encoding: 'raw', ...fields };
  const lines = Object.entries(all).flatMap(([name, value]) => (value === null ? [] : [`${name}: ${value}\n`]));
  return join(encode(`NRRD0005\n${lines.join('')}\n`), body);
}

function makeMeta(fields: Fields = {}, body: Uint8Array = data): Uint8Array<ArrayBuffer> {
  const { ElementDataFile = 'LOCAL', ...others } = fields;
  const all: Fields = {
    ObjectType: 'Image',
    NDims: '3',
    DimSize: '3 2 4',
    ElementType: 'MET_SHORT',
    ...others,
    ElementDataFile,
  };
  const lines = Object.entries(all).flatMap(([name, value]) => (value === null ? [] : [`${name} = ${value}\n`]));
  return join(encode(lines.join('')), body);
}

/** What headers with these fields are refused with. */
type Refused = readonly [code: string, words: string, fields: Fields];

const refusedNrrd: Refused[] = [
  ['format/corrupt', 'lacks the field "type"', { type: null }],
  ['format/corrupt', 'lacks the field "sizes"', { sizes: null }],
  ['format/corrupt', 'lacks the field "encoding"', { encoding: null }],
  ['format/corrupt', 'got the type "shorts"', { type: 'shorts' }],
  ['format/unsupported', '"block"', { type: 'block' }],
  ['format/unsupported', 'got the encoding "hex"', { encoding: 'hex' }],
  ['format/corrupt', 'expected little or big', { endian: 'middle' }],
  ['format/corrupt', 'expected a whole number from 1', { dimension: '0' }],
  ['format/corrupt', 'expected 1 to 16', { dimension: '17' }],
  ['format/corrupt', 'got 2 sizes', { sizes: '3 2' }],
  ['format/corrupt', 'got the size "-2"', { sizes: '3 -2 4' }],
  ['format/corrupt', 'got the size "1e3"', { sizes: '3 1e3 4' }],
  ['format/corrupt', 'ends early', { sizes: '3 2 5' }],
  ['format/too-large', '100000 x 100000 x 100000', { sizes: '100000 100000 100000' }],
  ['format/corrupt', 'got the spacing "0"', { spacings: '1 0 1' }],
  ['format/corrupt', 'lie in one plane', { space: 'LPS', 'space directions': '(1,0,0) (2,0,0) (0,0,1)' }],
  ['format/corrupt', 'got the vector "(1,x,0)"', { space: 'LPS', 'space directions': '(1,x,0) (0,1,0) (0,0,1)' }],
  ['format/unsupported', 'colours', { kinds: 'RGB-color domain domain' }],
  ['format/unsupported', '3-vector', { kinds: '3-vector domain domain' }],
  ['format/corrupt', 'no axis that lies in space', { kinds: 'list list list' }],
  ['format/corrupt', 'byte skip -1 with data that are packed', { encoding: 'gzip', 'byte skip': '-1' }],
  ['format/corrupt', 'as byteskip', { 'byte skip': '-2' }],
  ['format/corrupt', 'skip 9 lines', { 'line skip': '9' }],
  ['format/corrupt', 'names no data file', { 'data file': '' }],
  ['format/corrupt', 'a control character', { 'data file': 'a\u0000.raw' }],
  ['format/unsupported', 'absolute path', { 'data file': '/etc/scan.raw' }],
  ['format/unsupported', 'absolute path', { 'data file': 'C:\\scans\\scan.raw' }],
  ['format/unsupported', 'absolute path', { 'data file': 'file:///etc/passwd' }],
  ['format/unsupported', 'absolute path', { 'data file': 'https://other.example/scan.raw' }],
  ['format/unsupported', 'absolute path', { 'data file': '//other.example/scan.raw' }],
  ['format/unsupported', 'absolute path', { 'data file': '\\\\other.example\\scan.raw' }],
  ['format/too-large', '1,000,000,001 files', { 'data file': 'a%d.raw 0 1000000000 1' }],
  ['format/corrupt', 'other than 0', { 'data file': 'a%d.raw 0 10 0' }],
  ['format/corrupt', 'got no files', { 'data file': 'a%d.raw 10 0 1' }],
  ['format/corrupt', 'got no files', { 'data file': 'LIST' }],
  ['format/corrupt', 'equal parts', { 'data file': 'a%d.raw 1 5 1' }],
  ['format/corrupt', 'expected 32 at most', { 'data file': 'a%0999999999d.raw 1 4 1' }],
];

const refusedMeta: Refused[] = [
  ['format/corrupt', 'lacks NDims', { NDims: null }],
  ['format/corrupt', 'lacks DimSize', { DimSize: null }],
  ['format/corrupt', 'expected "name = value"', { ElementDataFile: null }],
  ['format/corrupt', 'names no data file', { ElementDataFile: '' }],
  ['format/corrupt', 'got the type "MET_BIT"', { ElementType: 'MET_BIT' }],
  ['format/unsupported', 'MET_FLOAT_ARRAY', { ElementType: 'MET_FLOAT_ARRAY' }],
  ['format/unsupported', 'holds 3 numbers per voxel', { ElementNumberOfChannels: '3' }],
  ['format/corrupt', 'expected whole numbers from 1', { DimSize: '3 0 4' }],
  ['format/corrupt', 'expected 3 numbers', { DimSize: '3 2' }],
  ['format/corrupt', 'ends early', { DimSize: '3 2 5' }],
  ['format/too-large', '100000 x 100000 x 100000', { DimSize: '100000 100000 100000' }],
  ['format/corrupt', 'expected finite lengths', { ElementSpacing: '1 0 1' }],
  ['format/corrupt', 'got HeaderSize', { HeaderSize: '-2' }],
  ['format/corrupt', 'expected CompressedData = False', { HeaderSize: '-1', CompressedData: 'True' }],
  ['format/corrupt', 'expected True or False', { CompressedData: 'perhaps' }],
  ['format/corrupt', 'neither as gzip nor as zlib', { CompressedData: 'True' }],
  ['format/corrupt', 'its header says 99', { CompressedData: 'True', CompressedDataSize: '99' }],
  ['format/unsupported', 'absolute path', { ElementDataFile: '/home/scan.raw' }],
  ['format/corrupt', 'as number 1;', { BinaryData: 'False' }],
];

/** Each kind of header: how one is made, where its files lie, and what is refused. */
const kinds = {
  NRRD: { make: makeNrrd, path: 'nrrd/x.nrrd', refused: refusedNrrd },
  MetaImage: { make: makeMeta, path: 'metaimage/x.mha', refused: refusedMeta },
};

/** The error for a header with these fields. */
function refuse(kind: keyof typeof kinds, fields: Fields, body?: Uint8Array) {
  const { make, path } = kinds[kind];
  return expectError(decodeBytes(make(fields, body), path));
}

for (const kind of ['NRRD', 'MetaImage'] as const) {
  const { make, path, refused } = kinds[kind];
  describe(`${kind} headers that are refused`, () => {
    for (const [code, words, fields] of refused) {
      it(`${JSON.stringify(fields)}: ${words}`, async () => {
        const error = await refuse(kind, fields);
        expect(error.message).to.contain(words);
        expect(error.code).to.equal(code);
      });
    }

    it('but others are taken', async () => {
      expect(valuesOf(await decodeBytes(make(), path))[1]).to.equal(0x0302);
    });
  });
}

describe('headers that are refused', () => {
  it('NRRD of another version', async () => {
    const bytes = makeNrrd();
    bytes[7] = '9'.charCodeAt(0);
    expect((await expectError(decodeBytes(bytes, 'x.nrrd'))).message).to.contain('NRRD0001 to NRRD0005');
  });

  it('MetaImage that ends before it says where the data are', async () => {
    expect((await refuse('MetaImage', { ElementDataFile: null }, new Uint8Array())).message).to.contain(
      'ends without ElementDataFile',
    );
  });
});

describe('units of an NRRD file', () => {
  const spacingOf = async (fields: Fields) =>
    Array.from((await decodeBytes(makeNrrd(fields), 'x.nrrd')).grid.spacing, (s) => Math.round(1e6 * s) / 1e6);

  it('become millimetres, of the space or of each axis', async () => {
    expect(
      await spacingOf({ space: 'RAS', 'space directions': '(1,0,0) (0,2,0) (0,0,3)', 'space units': '"m" "cm" "um"' }),
    ).to.deep.equal([1000, 20, 0.003]);
    expect(await spacingOf({ spacings: '1 2 3', units: '"mm" "micrometers" "furlong"' })).to.deep.equal([1, 0.002, 3]);
    expect((await decodeBytes(makeNrrd({ 'sample units': '"HU"' }), 'x.nrrd')).unit).to.equal('HU');
  });
});

describe('packed data that swell', () => {
  const bomb = zlibSync(new Uint8Array(2 ** 26), { level: 9 });

  it('stop at the size that the header says', async () => {
    expect(bomb.length).to.be.lessThan(2 ** 17);
    for (const [error, what] of [
      [await refuse('MetaImage', { CompressedData: 'True' }, bomb), 'MetaImage'],
      [await refuse('NRRD', { encoding: 'gzip' }, bomb), 'NRRD'],
    ] as const) {
      expect(error.code, what).to.equal('format/corrupt');
      expect(error.message, what).to.contain('unpacks to more than the 48 bytes');
    }
  });

  it('of bzip2 do too', async () => {
    const bytes = await fetchFixture('nrrd/bzip2.nrrd');
    const smaller = Uint8Array.from(String.fromCharCode(...bytes).replace('sizes: 3 2 4', 'sizes: 3 2 3'), (c) =>
      c.charCodeAt(0),
    );
    expect((await expectError(decodeBytes(smaller, 'x.nrrd'))).code).to.equal('format/too-large');
  });

  it('take no memory where the header asks for more than they can hold', async () => {
    for (const error of [
      await refuse('MetaImage', { CompressedData: 'True', DimSize: '1000 1000 500' }, zlibSync(data)),
      await refuse('NRRD', { encoding: 'ascii', sizes: '1000 1000 500' }, encode('1 2 3')),
    ]) {
      expect(error.code).to.equal('format/corrupt');
    }
  });
});

describe('NRRD and MetaImage files that are damaged', () => {
  for (const path of [
    'nrrd/gzip.nrrd',
    'nrrd/bzip2.nrrd',
    'nrrd/ascii.nrrd',
    'nrrd/f8-big.nrrd',
    'metaimage/zlib.mha',
    'metaimage/i2-big.mha',
    'metaimage/text.mha',
  ]) {
    it(`${path}: cut anywhere, an error with a code`, async () => {
      const bytes = await fetchFixture(path);
      const isText = /ascii|text/.test(path);
      for (let length = 0; length < bytes.length - (isText ? 8 : 0); length++) {
        const error = await expectError(decodeBytes(bytes.slice(0, length), path));
        // A header that is cut in the name of its data file asks for another one.
        const isNamed = /ElementDataFile = (?!LOCAL$)\w+$/.test(String.fromCharCode(...bytes.subarray(0, length)));
        expect(error.code, `${length} of ${bytes.length} bytes`).to.equal(
          length === 0 ? 'format/unknown' : isNamed ? 'source/not-found' : 'format/corrupt',
        );
      }
    });

    it(`${path}: bytes written over, a volume or an error with a code`, async () => {
      const bytes = await fetchFixture(path);
      const random = randomNumbers(bytes.length);
      let refused = 0;
      for (let run = 0; run < 150; run++) {
        const damaged = bytes.slice();
        for (let n = 0; n <= run % 6; n++) damaged[Math.floor(random() * bytes.length)] = Math.floor(random() * 256);
        await decodeBytes(damaged, path).catch((error: unknown) => {
          if (!(error instanceof VolumeViewError) || error.code === 'internal')
            throw new Error(`run ${run}: ${String(error)}`, { cause: error });
          refused++;
        });
      }
      expect(refused).to.be.greaterThan(10);
    });
  }

  it('a wrong checksum is corrupt', async () => {
    for (const path of ['nrrd/gzip.nrrd', 'metaimage/zlib.mha', 'nrrd/bzip2.nrrd']) {
      const bytes = await fetchFixture(path);
      bytes[bytes.length - (path.includes('gzip') ? 6 : 2)] ^= 1;
      expect((await expectError(decodeBytes(bytes, path))).code, path).to.equal('format/corrupt');
    }
  });

  it('a data file that is too short is corrupt, and one that is not there is named', async () => {
    const header = new TextDecoder().decode(await fetchFixture('nrrd/detached.nhdr'));
    const short = await expectError(decodeBytes(encode(header.replace('data.raw', 'slice_01#.raw')), 'nrrd/x.nhdr'));
    expect(short.code).to.equal('format/corrupt');
    expect(short.message).to.contain('12 bytes');
    const list = header.replace('data file: data.raw', 'data file: LIST\ndata.raw\nslice_01#.raw');
    expect(
      (await expectError(decodeBytes(encode(list.replace('sizes: 3 2 4', 'sizes: 3 2 8')), 'nrrd/x.nhdr'))).message,
    ).to.contain('ends early');
  });
});

describe('data files that a header names', () => {
  /** The URLs that a header leads to, and the volume. */
  const follow = async (fields: Fields, url: string) => {
    const asked: string[] = [];
    const fetchFile = async (one: string) => {
      asked.push(one);
      return { bytes: data.slice(), url: one, contentType: '' };
    };
    const fetchFiles = (urls: readonly string[]) => fetchInOrder(urls, fetchFile, () => undefined);
    const volume = await decodeFile(
      { bytes: makeMeta(fields, new Uint8Array()), url, contentType: '' },
      {},
      { ...fixtureContext(), fetchFile, fetchFiles },
    );
    return { asked, volume };
  };

  for (const [name, url] of [
    ['a b#1?.raw', 'https://example.org/scans/head/a%20b%231%3F.raw'],
    ['..\\data\\100%.raw', 'https://example.org/scans/data/100%25.raw'],
    ['../../../../scan.raw', 'https://example.org/scan.raw'],
  ]) {
    it(`are names in its folder, not URLs, and stay on its server: ${name}`, async () => {
      const { asked } = await follow({ ElementDataFile: name }, 'https://example.org/scans/head/scan.mhd?key=1');
      expect(asked).to.deep.equal([url]);
    });
  }

  for (const url of ['data:text/plain,x', 'blob:https://example.org/1']) {
    it(`can not be found from a ${url.slice(0, 5)} URL`, async () => {
      const error = await expectError(follow({ ElementDataFile: 'a.raw' }, url));
      expect(error.code).to.equal('format/unsupported');
      expect(error.message).to.contain('stack');
    });
  }

  it('are no more than are shown', async () => {
    const { asked, volume } = await follow(
      { NDims: '4', DimSize: '3 2 4 6', ElementDataFile: 'time%d.raw 1 6 1' },
      urlOf('x.mhd'),
    );
    expect(asked).to.deep.equal([urlOf('time1.raw')]);
    expect(volume.format).to.equal('MetaImage, volume 1 of 6');
  });
});

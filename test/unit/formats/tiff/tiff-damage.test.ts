import { expect } from '@esm-bundle/chai';
import { zlibSync } from 'fflate';
import { decodeBytes, expectError, valuesOf } from '../../../helpers/decode.ts';
import { decodeSeries } from '../../../helpers/dicom-series.ts';
import { openScans } from '../../../helpers/scans-of.ts';
import { firstStrip, grayPage, tiffBytes } from '../../../helpers/tiff-bytes.ts';
import type { TiffEntry, TiffPageBytes } from '../../../helpers/tiff-bytes.ts';

const strip = (from: number, count = 6): Uint8Array => Uint8Array.from({ length: count }, (_, i) => from + i);
const pages = (...starts: number[]): TiffPageBytes[] => starts.map((from) => grayPage(3, 2, strip(from)));
const text = (value: string): Record<number, TiffEntry> => ({ 270: [2, value] });
const zeros = [0, 0, 0, 0, 0, 0];
const valuesFrom = (...starts: number[]): number[] => starts.flatMap((from) => [...strip(from)]);

/** OME-XML of pages of 3 x 2 pixels. */
const ome = (sizes: { C?: number; Z?: number; T?: number }, inside = '', order = 'XYZCT', more = ''): string =>
  `<?xml version="1.0" encoding="UTF-8"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06" UUID="urn:uuid:a"><Image ID="Image:0"><Pixels ID="Pixels:0" DimensionOrder="${order}" Type="uint8" SizeX="3" SizeY="2" SizeC="${sizes.C ?? 1}" SizeZ="${sizes.Z ?? 1}" SizeT="${sizes.T ?? 1}" ${more}>${inside}</Pixels></Image></OME>`;
const omeFile = (xml: string, starts: readonly number[]): Uint8Array<ArrayBuffer> =>
  tiffBytes(starts.map((from, i) => grayPage(3, 2, strip(from), i === 0 ? text(xml) : {})));

describe('the pages of an OME-TIFF', () => {
  it('are where each TiffData says, in any order', async () => {
    const parts = [2, 0, 1].map(
      (z, page) =>
        `<TiffData IFD="${page}" FirstZ="${z}" FirstC="0" FirstT="0" PlaneCount="1"><UUID FileName="a.ome.tif">urn:uuid:a</UUID></TiffData>`,
    );
    const volume = await decodeBytes(omeFile(ome({ Z: 3 }, parts.join('')), [10, 20, 30]), 'a.ome.tif');
    expect(valuesOf(volume)).to.deep.equal(valuesFrom(20, 30, 10));
  });

  it('follow each other where TiffData counts them, or is not there', async () => {
    for (const inside of [
      '',
      '<TiffData/>',
      '<TiffData IFD="0" PlaneCount="4"/>',
      '<TiffData PlaneCount="2"/><TiffData FirstC="1" PlaneCount="2"/>',
    ])
      expect(
        valuesOf(await decodeBytes(omeFile(ome({ Z: 2, C: 2 }, inside), [10, 20, 30, 40]), 'x.tif')),
        inside,
      ).to.deep.equal(valuesFrom(10, 20));
    expect(
      valuesOf(await decodeBytes(omeFile(ome({ Z: 2, C: 2 }, '', 'XYCZT'), [10, 20, 30, 40]), 'x.tif')),
    ).to.deep.equal(valuesFrom(10, 30));
  });

  it('that a stopped acquisition does not have are 0, and that is said', async () => {
    const parts = (...names: readonly string[]): string =>
      names.map((name, page) => `<TiffData IFD="${page}" ${name} PlaneCount="1"/>`).join('');
    const volume = await decodeBytes(omeFile(ome({ Z: 4 }, parts('FirstZ="1"', 'FirstZ="3"')), [10, 20]), 'x.tif');
    expect(valuesOf(volume)).to.deep.equal([...zeros, ...strip(10), ...zeros, ...strip(20)]);
    expect(volume.left).to.deep.equal(['2 of 4 slices, which the file does not hold: they are shown as 0']);
    const times = omeFile(ome({ Z: 2, T: 2 }, parts('', 'FirstZ="1"', 'FirstT="1"')), [1, 11, 21]);
    const { first, read } = await openScans(times, 'x.ome.tif', { scan: { index: 0 } });
    expect(valuesOf(await read(1))).to.deep.equal([...strip(21), ...zeros]);
    expect(first.left).to.deep.equal(['1 of 4 slices, which the file does not hold: they are shown as 0']);
  });

  it('of several times are scans, with their times in seconds', async () => {
    const file = omeFile(
      ome({ Z: 2, T: 3 }, '', 'XYZCT', 'TimeIncrement="500" TimeIncrementUnit="ms"'),
      [1, 11, 21, 31, 41, 51],
    );
    const { first, times, read } = await openScans(file, 'x.ome.tif', { scan: { index: 0 } });
    expect(times).to.deep.equal(['0 s', '0.5 s', '1 s']);
    expect(valuesOf(first)).to.deep.equal(valuesFrom(1, 11));
    expect(valuesOf(await read(2))).to.deep.equal(valuesFrom(41, 51));
    expect(first.left).to.equal(undefined);
  });

  for (const [words, xml, code] of [
    [
      'in other files',
      ome({ Z: 2 }, '<TiffData IFD="0"><UUID FileName="b.tif">urn:uuid:b</UUID></TiffData>'),
      'format/unsupported',
    ],
    ['BinaryOnly', '<OME><BinaryOnly MetadataFile="a.companion.ome" UUID="urn:uuid:a"/></OME>', 'format/unsupported'],
    ['none for slice 3', ome({ Z: 3 }), 'format/corrupt'],
    ['none for slice 3', ome({ Z: 3 }, '<TiffData/>'), 'format/corrupt'],
    ['none for slice 3', ome({ Z: 3 }, '<TiffData IFD="0" PlaneCount="3"/>'), 'format/corrupt'],
    ['none for slice 1', ome({ Z: 3 }, '<TiffData IFD="7" PlaneCount="1"/>'), 'format/corrupt'],
    ['none for slice 2', ome({ Z: 2 ** 12 }, '<TiffData IFD="0" PlaneCount="1"/>'), 'format/corrupt'],
    ['without Pixels', '<OME></OME>', 'format/corrupt'],
    ['can not be read', '<OME><Image><Pixels', 'format/corrupt'],
    ['0 slices', ome({ Z: 0 }), 'format/corrupt'],
    ['9000000000 slices', ome({ Z: 9e9 }), 'format/corrupt'],
    ['4096 slices', ome({ Z: 4096, C: 4096, T: 4096 }), 'format/corrupt'],
    ['DimensionOrder', ome({}, '', 'XYZ'), 'format/corrupt'],
    ['100 elements deep', `<OME>${'<a>'.repeat(200)}`, 'format/corrupt'],
  ] as const)
    it(`are refused in words: ${words}`, async () => {
      const error = await expectError(decodeBytes(omeFile(xml, [1, 2]), 'x.ome.tif'));
      expect(error.message).to.contain(words);
      expect(error.code).to.equal(code);
    });

  it('have no entities that the text defines itself', async () => {
    const bomb = `<?xml version="1.0"?><!DOCTYPE OME [<!ENTITY a "${'b'.repeat(1000)}"><!ENTITY z "&a;&a;">]>`;
    const volume = await decodeBytes(omeFile(bomb + ome({ Z: 2 }), [1, 2]), 'x.tif');
    expect(volume.format).to.equal('TIFF');
  });
});

describe('several TIFF files', () => {
  it('are one volume, in their order', async () => {
    const volume = await decodeSeries([tiffBytes(pages(30)), tiffBytes(pages(10)), tiffBytes(pages(20, 40))]);
    expect(volume.grid.dimensions).to.deep.equal([3, 2, 4]);
    expect(valuesOf(volume)).to.deep.equal(valuesFrom(30, 10, 20, 40));
  });

  it('of other sizes are refused', async () => {
    const error = await expectError(decodeSeries([tiffBytes(pages(30)), tiffBytes([grayPage(2, 2)])]));
    expect(error.message).to.match(/got 2\.dcm of 2 x 2 pixels of uint8; expected 3 x 2 pixels of uint8/);
  });
});

describe('a TIFF file', () => {
  it('may be packed with gzip', async () => {
    const stream = new Blob([tiffBytes(pages(1, 2))]).stream().pipeThrough(new CompressionStream('gzip'));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    expect(valuesOf(await decodeBytes(bytes, 'x.tif.gz'))).to.deep.equal(valuesFrom(1, 2));
  });

  it('may have numbers of 2 and 4 bits, and pieces of zeros without bytes', async () => {
    const four = grayPage(3, 2, Uint8Array.of(0x12, 0x30, 0xab, 0xc0), { 258: [3, 4] });
    expect(valuesOf(await decodeBytes(tiffBytes([four]), 'x.tif'))).to.deep.equal([1, 2, 3, 10, 11, 12]);
    const two = grayPage(3, 2, Uint8Array.of(0b00011011, 0b11100100), { 258: [3, 2] });
    expect(valuesOf(await decodeBytes(tiffBytes([two]), 'x.tif'))).to.deep.equal([0, 1, 2, 3, 2, 1]);
    const empty = grayPage(3, 2, strip(5), { 273: [4, firstStrip, 0], 279: [4, 3, 0], 278: [4, 1] });
    expect(valuesOf(await decodeBytes(tiffBytes([empty]), 'x.tif'))).to.deep.equal([5, 6, 7, 0, 0, 0]);
  });
});

const many = 2 ** 30;
/** What each case is called, the file, the code of its error, and words of its message. */
const damaged: readonly (readonly [string, Uint8Array<ArrayBuffer>, string, RegExp])[] = [
  ['pages in a circle', tiffBytes([{ ...pages(1)[0], next: { page: 0 } }]), 'format/corrupt', /lead back/],
  ['a page beyond the end', tiffBytes([{ ...pages(1)[0], next: { address: 1e9 } }]), 'format/corrupt', /ends early/],
  ['no page', tiffBytes([]), 'format/corrupt', /no pages/],
  [
    'a count beyond the end',
    tiffBytes([grayPage(3, 2, strip(1), { 273: [4, ...strip(0)] })]).slice(0, 60),
    'format/corrupt',
    /ends early/,
  ],
  ['huge pages', tiffBytes([grayPage(100_000, 20_000, strip(1))]), 'format/too-large', /asks for .* of memory/],
  ['pages beyond any size', tiffBytes([grayPage(4e9, 4e9, strip(1))]), 'format/too-large', /GiB/],
  [
    'huge tiles',
    tiffBytes([grayPage(3, 2, strip(1), { 322: [4, many], 323: [4, many], 324: [4, 8], 325: [4, 6] })]),
    'format/too-large',
    /GiB/,
  ],
  [
    'tiles without size',
    tiffBytes([grayPage(3, 2, strip(1), { 322: [4, 0], 323: [4, 0], 324: [4, 8], 325: [4, 6] })]),
    'format/corrupt',
    /0 x 0/,
  ],
  [
    'a strip that is cut',
    tiffBytes([grayPage(3, 2, strip(1, 4))]),
    'format/corrupt',
    /got 4 bytes of a piece of a page; expected 6/,
  ],
  [
    'a strip beyond the end',
    tiffBytes([grayPage(3, 2, strip(1), { 273: [4, 5000] })]),
    'format/corrupt',
    /needs 6 from 5,000 on/,
  ],
  [
    'fewer strips than rows',
    tiffBytes([grayPage(3, 2, strip(1), { 278: [4, 1] })]),
    'format/corrupt',
    /lists 1 pieces of a page; expected 2/,
  ],
  [
    'damaged LZW',
    tiffBytes([grayPage(3, 2, Uint8Array.of(0xff, 0xff, 0xff), { 259: [3, 5] })]),
    'format/corrupt',
    /LZW\) that are damaged/,
  ],
  [
    'damaged Deflate',
    tiffBytes([grayPage(3, 2, strip(1), { 259: [3, 8] })]),
    'format/corrupt',
    /Deflate\) that are damaged/,
  ],
  [
    'an unknown packing',
    tiffBytes([grayPage(3, 2, strip(1), { 259: [3, 34887] })]),
    'format/unsupported',
    /LERC.* bfconvert/,
  ],
  ['numbers of 12 bits', tiffBytes([grayPage(3, 2, strip(1), { 258: [3, 12] })]), 'format/unsupported', /12 bits/],
  ['other colours', tiffBytes([grayPage(3, 2, strip(1), { 262: [3, 5] })]), 'format/unsupported', /kind 5/],
  ['MetaMorph', tiffBytes([grayPage(3, 2, strip(1), { 33629: [4, 1] })]), 'format/unsupported', /bfconvert/],
  ['a type that is none', tiffBytes([grayPage(3, 2, strip(1), { 258: [99, 8] })]), 'format/corrupt', /the type 99/],
  [
    'a slice of another size',
    tiffBytes([grayPage(3, 2, strip(1), text(ome({ Z: 2 }))), grayPage(2, 2)]),
    'format/corrupt',
    /page 2 of another size/,
  ],
  [
    'ImageJ pages that are missing',
    tiffBytes([grayPage(3, 2, strip(1), text('ImageJ=1.54\nimages=9000000\nslices=9000000\n'))]),
    'format/too-large',
    /slices of the TIFF file takes more than/,
  ],
];

describe('TIFF files that are damaged or hostile', () => {
  for (const [name, bytes, code, words] of damaged)
    it(`are refused in words: ${name}`, async () => {
      const error = await expectError(decodeBytes(bytes, 'x.tif'));
      expect(error.message).to.match(words);
      expect(error.code).to.equal(code);
    });

  it('of 8 MB in a strip of six pixels are not unpacked', async () => {
    const file = tiffBytes([grayPage(3, 2, zlibSync(new Uint8Array(2 ** 23)), { 259: [3, 8] })]);
    expect((await expectError(decodeBytes(file, 'x.tif'))).message).to.match(/Deflate\) that are damaged/);
  });

  it('cut anywhere end in a message', async () => {
    const whole = omeFile(ome({ Z: 2 }), [1, 2]);
    for (let length = 9; length < whole.length; length += 7) {
      const error = await expectError(decodeBytes(whole.slice(0, length), 'x.tif'));
      expect(error.code, String(length)).to.equal('format/corrupt');
    }
  });
});

describe('the generator of TIFF files', () => {
  it('makes the bytes that tifffile 2026.3.3 reads as [[1, 2, 3], [4, 5, 6]], little and big, of 32 and 64 bits', () => {
    const sums = [false, true].flatMap((isBig) =>
      [true, false].map((littleEndian) =>
        tiffBytes(pages(1), { isBig, littleEndian }).reduce((sum, byte, i) => (sum * 31 + byte + i) % 65521, 0),
      ),
    );
    expect(sums).to.deep.equal([922, 55601, 17511, 48732]);
  });
});

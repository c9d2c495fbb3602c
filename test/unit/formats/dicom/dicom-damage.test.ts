import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { ctSlice, dicomBytes, packRle } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields, DicomForm, DicomValue, RawElement } from '../../../helpers/dicom-bytes.ts';
import { decodeFields, decodeSeries } from '../../../helpers/dicom-series.ts';
import { expectError, valuesOf } from '../../../helpers/decode.ts';

const expected = Array.from({ length: 12 }, (_, i) => 100 + i - 1024);
const raw = (tag: number, vr: string, value: DicomValue, length?: number): RawElement => ({ tag, vr, value, length });

describe('unusual DICOM files are read', () => {
  const item = [0xfe, 0xff, 0, 0xe0, 0xff, 0xff, 0xff, 0xff];
  const ends = [0xfe, 0xff, 0x0d, 0xe0, 0, 0, 0, 0, 0xfe, 0xff, 0xdd, 0xe0, 0, 0, 0, 0];
  /** In an item: an element with an implicit representation. */
  const inner = [0x11, 0, 0x10, 0x10, 2, 0, 0, 0, 0x41, 0x20];
  const unknown = Uint8Array.from([...item, ...inner, ...ends]);
  /** A picture of JPEG, as far as its first marks, in pieces: the list of frames is empty. */
  const packed = Uint8Array.from([
    ...[0xfe, 0xff, 0, 0xe0, 0, 0, 0, 0],
    ...[0xfe, 0xff, 0, 0xe0, 8, 0, 0, 0, 0xff, 0xd8, 0xff, 0xe0, 0, 0x10, 0x4a, 0x46],
    ...[0xfe, 0xff, 0xdd, 0xe0, 0, 0, 0, 0],
  ]);
  const endless = 0xffffffff;
  /** An icon: a picture in an item, of an explicit file. */
  const icon = (vr: string): Uint8Array =>
    Uint8Array.from([
      ...item,
      ...[0xe0, 0x7f, 0x10, 0, ...Array.from(vr, (c) => c.charCodeAt(0)), 0, 0, 0xff, 0xff, 0xff, 0xff, ...packed],
      ...ends,
    ]);
  for (const [what, form] of [
    ['without a preamble', { hasPreamble: false }],
    ['without a preamble, implicit', { hasPreamble: false, isImplicit: true }],
    ['whose syntax says explicit, and which are implicit', { isImplicit: true, syntax: '1.2.840.10008.1.2.1' }],
    ['with Rows as four bytes', { raw: [raw(0x00280010, 'UL', [3])] }],
    ['with Rows of an unknown representation', { raw: [raw(0x00280010, 'UN', Uint8Array.of(3, 0))] }],
    ['with Rows as a text', { raw: [raw(0x00280010, 'IS', '3 ')] }],
    ['with private sequences of no length', { raw: [raw(0x00111000, 'UN', unknown, 0xffffffff)] }],
    ['with a packed icon', { raw: [raw(0x00880200, 'SQ', icon('OB'), endless)] }],
    ['with a packed icon of words', { raw: [raw(0x00880200, 'SQ', icon('OW'), endless)] }],
    ['with a packed icon of an unknown representation', { raw: [raw(0x00880200, 'SQ', icon('UN'), endless)] }],
    ['with packed private bytes', { raw: [raw(0x00111010, 'OB', packed, endless)] }],
    ['with private sequences that say their length', { raw: [raw(0x00111000, 'SQ', [{ SliceThickness: '1' }])] }],
    ['with sequences that have marks', { hasMarks: true, raw: [raw(0x00111000, 'SQ', [{ SliceThickness: '1' }, {}])] }],
    ['with 64-bit numbers', { raw: [raw(0x00111001, 'SV', new Uint8Array(8)), raw(0x7fe00001, 'OV', [0])] }],
    ['with a value representation that is not known yet', { raw: [raw(0x00111001, 'QQ', new Uint8Array(8))] }],
    ['with more bytes after the pixels', { raw: [raw(0x7fe00010, 'OW', pixels(40))] }],
  ] as const satisfies readonly (readonly [string, DicomForm])[]) {
    it(what, async () => {
      expect(valuesOf(await decodeFields([ctSlice(0)], form))).to.deep.equal(expected);
    });
  }

  function pixels(bytes: number): Uint8Array {
    const all = new Uint8Array(bytes);
    all.set(ctSlice(0).PixelData as Uint8Array);
    return all;
  }
});

describe('damaged DICOM files are refused in words', () => {
  const nested = (depth: number): DicomFields[] => {
    let items: DicomFields[] = [{}];
    for (let i = 0; i < depth; i++) items = [{ MREchoSequence: items }];
    return items;
  };
  for (const [what, fields, form, words] of [
    ['cut pixels', {}, { raw: [raw(0x7fe00010, 'OW', new Uint8Array(20))] }, ['ends early', '20 bytes', 'need 24']],
    ['no rows', { Rows: undefined }, {}, ['no rows']],
    ['no columns', { Columns: [0] }, {}, ['0 columns']],
    ['huge rows and columns', { Rows: [65535], Columns: [65535] }, {}, ['ends early', 'need 8,589,672,450']],
    ['many frames', { NumberOfFrames: '60000' }, {}, ['ends early', '60000 frames']],
    ['too many frames', { NumberOfFrames: '999999999' }, {}, ['999999999 frames', '65,536']],
    ['bits that do not fit', { BitsStored: [17] }, {}, ['17 bits']],
    ['bits of another kind', { BitsAllocated: [12] }, {}, ['12 bits', 'gdcmconv']],
    [
      'a length beyond the end',
      {},
      { raw: [raw(0x00111000, 'OB', new Uint8Array(2), 0xfffffff0)] },
      ['(0011,1000)', '4,294,967,280'],
    ],
    [
      'a packed private element whose piece goes beyond the end',
      {},
      {
        raw: [
          raw(0x00111010, 'OB', Uint8Array.of(0xfe, 0xff, 0, 0xe0, 0xff, 0xff, 0xff, 0x7f, 0xff, 0xd8), 0xffffffff),
        ],
      },
      ['ends early', '(fffe,e000)', '2,147,483,647'],
    ],
    ['a deep sequence', { MREchoSequence: nested(40) }, {}, ['more than 32 deep']],
    ['a deep sequence with marks', { MREchoSequence: nested(40) }, { hasMarks: true }, ['more than 32 deep']],
    ['an unknown syntax', {}, { syntax: '1.2.3' }, ['transfer syntax', 'gdcmconv']],
    ['packed pixels that are not', {}, { syntax: '1.2.840.10008.1.2.5' }, ['packed with RLE']],
    [
      'JPEG that is none',
      {},
      { syntax: '1.2.840.10008.1.2.4.50', fragments: [new Uint8Array(8)] },
      ['JPEG', 'damaged'],
    ],
    ['JPEG XL', {}, { syntax: '1.2.840.10008.1.2.4.110', fragments: [new Uint8Array(8)] }, ['JPEG XL', 'gdcmconv']],
    ['a video', {}, { syntax: '1.2.840.10008.1.2.4.102', fragments: [new Uint8Array(8)] }, ['video']],
    [
      'runs that end early',
      {},
      {
        syntax: '1.2.840.10008.1.2.5',
        fragments: [Uint8Array.from([2, 0, 0, 0, 64, 0, 0, 0, 64, ...new Uint8Array(57)])],
      },
      ['end early'],
    ],
    ['no pieces', {}, { syntax: '1.2.840.10008.1.2.5', fragments: [] }, ['0 pieces']],
  ] as const satisfies readonly (readonly [string, DicomFields, DicomForm, readonly string[]])[]) {
    it(what, async () => {
      const error = await expectError(decodeFields([ctSlice(0, fields)], form));
      expect(error.code).to.match(/^format\/(corrupt|unsupported)$/);
      for (const part of ['the DICOM file', ...words]) expect(error.message).to.contain(part);
    });
  }

  it('cut anywhere', async () => {
    for (const form of [{}, { isImplicit: true }, { isBigEndian: true }, { isDeflated: true }, { hasMarks: true }]) {
      const whole = dicomBytes({ ...ctSlice(0), MREchoSequence: [{ EffectiveEchoTime: [3] }] }, form);
      for (let length = 132; length < whole.length; length++) {
        const error = await decodeSeries([whole.slice(0, length)]).then(
          () => null,
          (thrown: unknown) => thrown,
        );
        expect(error, `${length} of ${whole.length} bytes`).to.be.instanceOf(VolumeViewError);
        expect((error as VolumeViewError).code).to.match(/^format\/(corrupt|unsupported)$/);
      }
    }
  });
});

describe('a damaged file among others', () => {
  const places = [0, 5, 10, 15, 20];
  const whole = (): Uint8Array<ArrayBuffer>[] => places.map((z) => dicomBytes(ctSlice(z, {}, 100 + z)));
  const valueAt = (values: readonly number[], k: number): number[] => values.slice(12 * k, 12 * k + 12);
  const noData = Array.from({ length: 12 }, () => NaN);
  const slice = (k: number): number[] => Array.from({ length: 12 }, (_, i) => 100 + places[k] + i - 1024);
  /** Without its pixels, and the elements before them. */
  const cutHeader = (bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> => bytes.slice(0, bytes.length - 60);

  it('is no data where its slice is, and its number is said: the last one is cut', async () => {
    const files = whole();
    files[4] = files[4].slice(0, -6);
    const volume = await decodeSeries(files);
    expect(volume.grid.dimensions).to.deep.equal([4, 3, 5]);
    const values = valuesOf(volume);
    for (const k of [0, 1, 2, 3]) expect(valueAt(values, k)).to.deep.equal(slice(k));
    expect(valueAt(values, 4)).to.deep.equal(noData);
    expect(volume.left).to.deep.equal([
      'file 5 of 5: damaged, and its place shown as no data (ends early: got 18 bytes of pixels; 1 frame of 4 x 3 pixels of 16 bits need 24. Copy the file again)',
    ]);
  });

  it('is left out where its place is not known', async () => {
    const files = whole();
    files[2] = cutHeader(files[2]);
    const volume = await decodeSeries(files);
    const values = valuesOf(volume);
    expect(valueAt(values, 1)).to.deep.equal(slice(1));
    expect(valueAt(values, 2)).to.deep.equal(noData);
    expect(valueAt(values, 3)).to.deep.equal(slice(3));
    expect(volume.left![0]).to.match(
      /^file 3 of 5: damaged, and left out \(says how large its picture is, and ends before it/,
    );
    expect(volume.left![1]).to.contain('1 of 5 slices are missing');
  });

  it('of packed pixels is no data', async () => {
    const rle = '1.2.840.10008.1.2.5';
    const files = places.map((z, k) => {
      const numbers = Uint16Array.from({ length: 12 }, (_, i) => 100 + z + i);
      const packed = packRle(numbers);
      return dicomBytes(ctSlice(z), { syntax: rle, fragments: [k === 1 ? packed.subarray(0, 70) : packed] });
    });
    const volume = await decodeSeries(files);
    const values = valuesOf(volume);
    expect(valueAt(values, 1)).to.deep.equal(noData);
    expect(valueAt(values, 4)).to.deep.equal(slice(4));
    expect(volume.left![0]).to.match(/^file 2 of 5: damaged, and its place shown as no data/);
  });

  it('with several frames, which ends early, does not keep other series from being shown', async () => {
    const frames = dicomBytes({ ...ctSlice(0, { SeriesInstanceUID: '9.9' }), NumberOfFrames: '3' });
    const volume = await decodeSeries([...whole(), frames]);
    expect(volume.grid.dimensions).to.deep.equal([4, 3, 5]);
    expect(volume.left![0]).to.match(/^file 6 of 6: damaged, and left out \(ends early: got 24 bytes/);
  });

  it('is an error of all where most are', async () => {
    const files = whole().map((bytes, k) => (k < 3 ? bytes.slice(0, -6) : bytes));
    const error = await expectError(decodeSeries(files));
    expect(error.code).to.equal('format/corrupt');
    expect(error.message).to.contain('file 1 of 5 ends early: got 18 bytes of pixels');
  });

  it('of several is one of a number', async () => {
    const files = whole().map((bytes, k) => (k === 1 || k === 2 ? bytes.slice(0, -6) : bytes));
    expect((await decodeSeries(files)).left![0]).to.match(/^file 2 of 5, and 1 more file: damaged/);
  });
});

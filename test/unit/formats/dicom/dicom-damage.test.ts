import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { ctSlice, dicomBytes } from '../../../helpers/dicom-bytes.ts';
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
  for (const [what, form] of [
    ['without a preamble', { hasPreamble: false }],
    ['without a preamble, implicit', { hasPreamble: false, isImplicit: true }],
    ['whose syntax says explicit, and which are implicit', { isImplicit: true, syntax: '1.2.840.10008.1.2.1' }],
    ['with Rows as four bytes', { raw: [raw(0x00280010, 'UL', [3])] }],
    ['with Rows of an unknown representation', { raw: [raw(0x00280010, 'UN', Uint8Array.of(3, 0))] }],
    ['with Rows as a text', { raw: [raw(0x00280010, 'IS', '3 ')] }],
    ['with private sequences of no length', { raw: [raw(0x00111000, 'UN', unknown, 0xffffffff)] }],
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

  it('a cut file of a series, by its number', async () => {
    const files = [0, 5, 10].map((z) => dicomBytes(ctSlice(z)));
    files[2] = files[2].slice(0, -6);
    const error = await expectError(decodeSeries(files));
    expect(error.code).to.equal('format/corrupt');
    expect(error.message).to.contain('file 3 of 3 ends early: got 18 bytes of pixels');
  });

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

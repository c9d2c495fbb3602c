import { expect } from '@esm-bundle/chai';
import { gzipSync } from 'fflate';
import { ctSlice, dicomBytes, packRle, pixelFields, syntaxes } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { cases } from '../../../helpers/dicom-cases.ts';
import { decodeFields, decodeSeries } from '../../../helpers/dicom-series.ts';
import { decodeBytes, expectError, valuesOf } from '../../../helpers/decode.ts';

const u16 = [0, 5957, 11914, 17871, 23828, 29785, 35742, 41699, 47656, 53613, 59570, 65527];
const i16 = [-32768, -26811, -20854, -14897, -8940, -2983, 2974, 8931, 14888, 20845, 26802, 32759];
const u8 = [1, 24, 47, 70, 93, 116, 139, 162, 185, 208, 231, 254];
const i32 = [
  -2147483648, -1757032076, -1366580504, -976128932, -585677360, -195225788, 195225784, 585677356, 976128928,
  1366580500, 1757032072, 2147483644,
];

/** What pydicom 3.0.2 reads of the same bytes: pixel_array, then apply_rescale. */
const pydicom: Readonly<Record<string, readonly number[]>> = {
  'u16 explicit': u16,
  'u16 implicit': u16,
  'u16 deflated': u16,
  'u16 big endian': u16,
  'i16 explicit': i16,
  'i16 big endian': i16,
  'u8 explicit': u8,
  'u8 in words, big endian': u8,
  'i8 explicit': [-128, -105, -82, -59, -36, -13, 10, 33, 56, 79, 102, 125],
  'u32 explicit': [
    0, 390451572, 780903144, 1171354716, 1561806288, 1952257860, 2342709432, 2733161004, 3123612576, 3514064148,
    3904515720, 4294967292,
  ],
  'i32 explicit': i32,
  'i32 big endian': i32,
  'i16 with slope': [-253.5, -178.5, -103.5, -28.5, 46.5, 121.5, 196.5, 271.5, 346.5, 421.5, 496.5, 571.5],
  'u16 of CT': [-1024, -652, -280, 92, 464, 836, 1208, 1580, 1952, 2324, 2696, 3068],
  'u16 of 12 bits with an overlay': [500, 811, 1122, 1433, 1744, 2055, 2366, 2677, 2988, 3299, 3610, 3921],
  'i16 of 12 bits': [-1500, -1249, -998, -747, -496, -245, 6, 257, 508, 759, 1010, 1261],
  'float pixels': [-1.5, -1.125, -0.75, -0.375, 0, 0.375, 0.75, 1.125, 1.5, 1.875, 2.25, 2.625],
  'double pixels': [
    -1e100, -7e99, -4e99, -1.0000000000000002e99, 2.0000000000000004e99, 5.000000000000001e99, 8e99,
    1.1000000000000002e100, 1.4000000000000001e100, 1.7e100, 2.0000000000000004e100, 2.3000000000000003e100,
  ],
  'u16 by runs': [7, 7, 7, 7, 7, 9, 258, 258, 65535, 0, 0, 1],
  'u8 by runs': [7, 7, 7, 7, 7, 9, 8, 8, 255, 0, 0, 1],
};

/** Share of a value by which the 32 bits of a sample round it. */
const inFloat32 = 2 ** -23;

describe('numbers of DICOM files against pydicom', () => {
  it('has a value for each file', () => expect(Object.keys(pydicom)).to.have.members(Object.keys(cases)));

  for (const [name, expected] of Object.entries(pydicom)) {
    it(name, async () => {
      const volume = await decodeSeries([cases[name]]);
      expect(volume.grid.dimensions).to.deep.equal([4, 3, 1]);
      const values = volume.indexed
        ? Array.from(volume.indexed.samples, (index) => volume.indexed!.ids[index])
        : valuesOf(volume);
      const largest = Math.max(...expected.map(Math.abs));
      expected.forEach((value, i) =>
        expect(values[i], `number ${i}`).to.be.closeTo(value, name === 'double pixels' ? inFloat32 * largest : 0),
      );
    });
  }
});

describe('DICOM files that look like others', () => {
  const plain = dicomBytes(ctSlice(0));
  /** The first bytes may be anything: of NIfTI's header the length, as in 0.dcm of nibabel's own tests; of TIFF the mark, as in pydicom's MR_small. */
  const beginWith = (...bytes: number[]): Uint8Array<ArrayBuffer> => {
    const file = plain.slice();
    file.set(bytes);
    return file;
  };
  for (const [name, file] of Object.entries({
    'with the length of the header of NIfTI': beginWith(0x5c, 1, 0, 0),
    'with the mark of TIFF': beginWith(0x49, 0x49, 0x2a, 0, 0, 1, 0, 0),
    'packed with gzip': gzipSync(plain),
    'packed with gzip, with the length of the header of NIfTI': gzipSync(beginWith(0x5c, 1, 0, 0)),
    'packed with gzip, with the mark of TIFF': gzipSync(beginWith(0x49, 0x49, 0x2a, 0, 0, 1, 0, 0)),
  }))
    it(`${name} are read`, async () => {
      for (const end of ['.dcm', '', '.dcm.gz']) {
        const volume = await decodeBytes(file.slice(), `file${end}`);
        expect([volume.format, valuesOf(volume)], end).to.deep.equal([
          'DICOM, CT',
          valuesOf(await decodeSeries([plain])),
        ]);
      }
    });
});

describe('bytes in words of big endian, of which a frame has an odd number', () => {
  // pydicom 3.0.2 reads 158 as the last number of SC_rgb_small_odd_big_endian.dcm of its own tests, whose file ends with 158, 158, 0, 158.
  const numbers = [11, 12, 13, 14, 15, 16, 17, 18, 19];
  const inPairs = (bytes: readonly number[]): Uint8Array => Uint8Array.from(bytes, (_, i) => bytes[i ^ 1]);
  const mr = { Modality: 'MR', RescaleSlope: undefined, RescaleIntercept: undefined, Columns: [3], Rows: [3] };

  it('have the last one behind the byte that fills the word', async () => {
    const fields = ctSlice(0, { ...pixelFields(new Uint8Array(12)), ...mr, PixelData: inPairs([...numbers, 0]) });
    expect(valuesOf(await decodeFields([fields], { isBigEndian: true }))).to.deep.equal(numbers);
  });

  it('share a word with the next frame', async () => {
    const both = [...numbers, ...numbers.map((number) => 10 * number)];
    const frames = { ...mr, NumberOfFrames: [2], PixelData: inPairs(both) };
    const fields = ctSlice(0, { ...pixelFields(new Uint8Array(12)), ...frames });
    expect(valuesOf(await decodeFields([fields], { isBigEndian: true }))).to.deep.equal(both);
  });
});

const valuesOfSlices = async (files: readonly DicomFields[]): Promise<number[]> => valuesOf(await decodeFields(files));

describe('values of DICOM files', () => {
  it('are Hounsfield units of a CT, whose file says how they are scaled', async () => {
    const volume = await decodeFields([ctSlice(0), ctSlice(1)]);
    expect(volume).to.include({ unit: 'HU', format: 'DICOM, CT', transferFunction: 'ct-bone' });
    expect(volume.window?.every(Number.isFinite)).to.equal(true);
  });

  for (const [what, fields] of [
    ['a CT that says no intercept', { RescaleIntercept: undefined, RescaleSlope: undefined }],
    ['a localizer', { ImageType: 'ORIGINAL\\PRIMARY\\LOCALIZER' }],
    ['a CT of another scale', { RescaleType: 'Z_EFF' }],
    ['an MRI', { Modality: 'MR' }],
  ] as const) {
    it(`are not those of ${what}`, async () => expect((await decodeFields([ctSlice(0, fields)])).unit).to.equal(''));
  }

  it('have the first window of the file', async () => {
    const { window } = await decodeFields([ctSlice(0, { WindowCenter: '40\\-600', WindowWidth: '400\\1500' })]);
    expect(window).to.deep.equal([-160, 239]);
  });

  it('of slices with other scales are brought to one', async () => {
    const [a, b] = [
      ctSlice(0, { RescaleIntercept: [-1000] }),
      ctSlice(5, { RescaleIntercept: [-24], RescaleSlope: [2] }),
    ];
    const expected = [
      ...Array.from({ length: 12 }, (_, i) => -900 + i),
      ...Array.from({ length: 12 }, (_, i) => 176 + 2 * i),
    ];
    expect(await valuesOfSlices([a, b])).to.deep.equal(expected);
    const half = await valuesOfSlices([ctSlice(0), ctSlice(5, { RescaleSlope: [0.5] })]);
    expect(half.slice(12)).to.deep.equal(Array.from({ length: 12 }, (_, i) => 50 + i / 2 - 1024));
  });

  // Source: DICOM PS3.3, C.7.6.3.1.2: the smallest number is white. They are turned so that more is brighter.
  it('are turned where the smallest one is white', async () => {
    const mr = {
      Modality: 'MR',
      RescaleSlope: undefined,
      RescaleIntercept: undefined,
      PhotometricInterpretation: 'MONOCHROME1',
    };
    const window = { WindowCenter: [105], WindowWidth: [10] };
    const volume = await decodeFields([ctSlice(0, { ...mr, ...window, BitsStored: [12], HighBit: [11] })]);
    expect(valuesOf(volume)).to.deep.equal(Array.from({ length: 12 }, (_, i) => 4095 - 100 - i));
    expect(volume.window).to.deep.equal([4095 - 109, 4095 - 100]);
    expect(volume.windows).to.deep.equal([{ name: 'Window 1', from: 3986, to: 3995, width: 10, level: 4095 - 105 }]);
    const signed = pixelFields(Int16Array.from({ length: 12 }, (_, i) => i - 4));
    expect(await valuesOfSlices([ctSlice(0, { ...signed, ...mr })])).to.deep.equal(
      Array.from({ length: 12 }, (_, i) => -1 - (i - 4)),
    );
  });

  it('are not turned where they have a unit', async () => {
    const volume = await decodeFields([ctSlice(0, { PhotometricInterpretation: 'MONOCHROME1' })]);
    expect(valuesOf(volume)[0]).to.equal(100 - 1024);
  });

  // Source: DICOM PS3.3, C.7.5.1.1.2
  it('are no data where they are padding, a value or a range', async () => {
    const one = await decodeFields([ctSlice(0, { PixelPaddingValue: [103] })]);
    expect(valuesOf(one).slice(2, 5)).to.deep.equal([102 - 1024, NaN, 104 - 1024]);
    expect(one.hasNoData).to.equal(true);
    const range = { PixelPaddingValue: [103], PixelPaddingRangeLimit: [101] };
    expect((await valuesOfSlices([ctSlice(0, range)])).map(Number.isNaN).slice(0, 5)).to.deep.equal([
      false,
      true,
      true,
      true,
      false,
    ]);
    const signed = {
      ...pixelFields(Int16Array.from({ length: 12 }, (_, i) => i - 2000)),
      PixelPaddingValue: [0x10000 - 2000],
    };
    expect((await valuesOfSlices([ctSlice(0, signed)])).map(Number.isNaN).slice(0, 2)).to.deep.equal([true, false]);
  });

  it('without any padding among them stay whole numbers', async () => {
    const volume = await decodeFields([ctSlice(0, { PixelPaddingValue: [9] })]);
    expect(volume.samples).not.to.be.instanceOf(Float32Array);
    expect(volume.hasNoData).to.equal(false);
  });

  it('are those of all frames, in one piece or in several', async () => {
    const frames = [0, 1, 2].map((frame) => Uint16Array.from({ length: 12 }, (_, i) => (frame << 8) + (i >> 1)));
    const packed = frames.map(packRle);
    const all = frames.flatMap((frame) => [...frame]);
    const fields = ctSlice(0, {
      NumberOfFrames: '3',
      Modality: 'MR',
      RescaleSlope: undefined,
      RescaleIntercept: undefined,
    });
    const form = { syntax: syntaxes.rle, fragments: packed };
    expect(valuesOf(await decodeSeries([dicomBytes(fields, form)]))).to.deep.equal(all);
    const pieces = packed.flatMap((frame) => [frame.slice(0, 64), frame.slice(64)]);
    let at = 0;
    const offsets = packed.map((frame) => (at += frame.length + 16) - frame.length - 16);
    expect(valuesOf(await decodeSeries([dicomBytes(fields, { ...form, fragments: pieces, offsets })]))).to.deep.equal(
      all,
    );
    const error = await expectError(decodeSeries([dicomBytes(fields, { ...form, fragments: pieces })]));
    expect(error.code).to.equal('format/corrupt');
    expect(error.message).to.contain('6 pieces').and.to.contain('3 frames');
  });
});

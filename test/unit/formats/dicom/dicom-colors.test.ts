import { expect } from '@esm-bundle/chai';
import { lumaOf } from '../../../../src/formats/base/channels.ts';
import { rgbOf } from '../../../helpers/channels.ts';
import { ctSlice, dicomBytes, packRle, pixelFields, syntaxes } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields, DicomForm } from '../../../helpers/dicom-bytes.ts';
import { decodeFields, decodeSeries } from '../../../helpers/dicom-series.ts';
import { colorsInJ2k } from '../../../helpers/j2k-colors.ts';
import { expectError, valuesOf } from '../../../helpers/decode.ts';
import { jpegColorStreams } from '../../../helpers/jpeg-color-streams.ts';

/** 4 x 3 pixels of three colours. */
const rgb = Uint8Array.from([
  207, 21, 45, 60, 46, 205, 222, 149, 10, 24, 85, 110, 159, 122, 67, 40, 177, 188, 8, 29, 115, 100, 227, 132, 107, 110,
  170, 150, 44, 188, 193, 244, 201, 72, 81, 166,
]);
/** That of the same bytes as YBR_FULL: NumPy, of what convert_color_space of pydicom 3.0.2 makes of them. */
const ofYbr = [203, 59, 213, 37, 173, 36, 36, 86, 100, 147, 145, 70];
/** The same as RGB: what convert_color_space of pydicom 3.0.2 makes of them. */
const rgbOfYbr = [
  91, 255, 17, 168, 33, 0, 57, 255, 255, 0, 52, 0, 73, 205, 148, 124, 0, 127, 0, 51, 0, 106, 63, 255, 166, 83, 75, 234,
  136, 1, 255, 101, 255, 125, 61, 0,
];
const planesOf = (bytes: Uint8Array): Uint8Array<ArrayBuffer> =>
  Uint8Array.from([0, 1, 2].flatMap((plane) => [...bytes.filter((_byte, i) => i % 3 === plane)]));

/** Three segments, one for each colour. */
function packColors(bytes: Uint8Array): Uint8Array<ArrayBuffer> {
  const segments = [0, 1, 2].map((plane) => packRle(bytes.filter((_byte, i) => i % 3 === plane)).slice(64));
  const head = new DataView(new ArrayBuffer(64));
  head.setUint32(0, 3, true);
  let at = 64;
  segments.forEach((segment, i) => {
    head.setUint32(4 + 4 * i, at, true);
    at += segment.length;
  });
  return Uint8Array.from([...new Uint8Array(head.buffer), ...segments.flatMap((segment) => [...segment])]);
}

const inColors = (photometric: string, data: Uint8Array, fields: DicomFields = {}): DicomFields =>
  ctSlice(0, {
    ...pixelFields(new Uint8Array(12)),
    Modality: 'US',
    SamplesPerPixel: [3],
    PhotometricInterpretation: photometric,
    PlanarConfiguration: [0],
    PixelData: data,
    ...fields,
  });

/** Numbers and tables of colours: red rises, green falls, blue stays. */
const indices = Uint8Array.from([0, 1, 2, 3, 9, 10, 11, 12, 13, 14, 255, 11]);
const tableOf = (bits: number, color: (i: number) => number): Uint8Array =>
  bits === 8
    ? Uint8Array.from({ length: 4 }, (_, i) => color(i))
    : new Uint8Array(Uint16Array.from({ length: 4 }, (_, i) => 257 * color(i)).buffer);
const palette = (bits: number): DicomFields => ({
  SamplesPerPixel: [1],
  RedPaletteColorLookupTableDescriptor: [4, 10, bits],
  RedPaletteColorLookupTableData: tableOf(bits, (i) => 80 * i),
  GreenPaletteColorLookupTableData: tableOf(bits, (i) => 240 - 80 * i),
  BluePaletteColorLookupTableData: tableOf(bits, () => 100),
});
/** Of the entries 0 to 3: numbers below 10 have the first one, those above 13 the last one. */
const ofTable = [179, 139, 98, 58];
const entries = [0, 0, 0, 0, 0, 0, 1, 2, 3, 3, 3, 1];
const rgbOfPalette = entries.flatMap((i) => [80 * i, 240 - 80 * i, 100]);
const ofPalette = entries.map((entry) => ofTable[entry]);

/** Two pixels share their colours: Y, Y, Cb, Cr. */
const pairs = Uint8Array.from(
  [0, 2, 4, 6, 8, 10].flatMap((i) => [rgb[3 * i], rgb[3 * i + 3], rgb[3 * i + 1], rgb[3 * i + 2]]),
);

const ofRgb = colorsInJ2k.luma;

describe('DICOM in colours', () => {
  const cases: Readonly<
    Record<string, readonly [fields: DicomFields, form: DicomForm, values: readonly number[], rgb: readonly number[]]>
  > = {
    RGB: [inColors('RGB', rgb), {}, ofRgb, [...rgb]],
    'RGB in planes': [inColors('RGB', planesOf(rgb), { PlanarConfiguration: [1] }), {}, ofRgb, [...rgb]],
    'RGB in runs': [
      inColors('RGB', rgb, { PlanarConfiguration: [1] }),
      { syntax: syntaxes.rle, fragments: [packColors(rgb)] },
      ofRgb,
      [...rgb],
    ],
    'YBR_RCT in JPEG 2000': [
      inColors('YBR_RCT', rgb),
      { syntax: '1.2.840.10008.1.2.4.90', fragments: [colorsInJ2k.stream] },
      ofRgb,
      [...rgb],
    ],
    YBR_FULL: [inColors('YBR_FULL', rgb), {}, ofYbr, rgbOfYbr],
    'YBR_FULL in planes': [inColors('YBR_FULL', planesOf(rgb), { PlanarConfiguration: [1] }), {}, ofYbr, rgbOfYbr],
    'a palette of 8 bits': [inColors('PALETTE COLOR', indices, palette(8)), {}, ofPalette, rgbOfPalette],
    'a palette of 16 bits': [inColors('PALETTE COLOR', indices, palette(16)), {}, ofPalette, rgbOfPalette],
    'a palette in runs': [
      inColors('PALETTE COLOR', indices, palette(16)),
      { syntax: syntaxes.rle, fragments: [packRle(indices)] },
      ofPalette,
      rgbOfPalette,
    ],
  };
  for (const [name, [fields, form, values, colors]] of Object.entries(cases)) {
    it(`${name} are shown, with their brightness as values`, async () => {
      const volume = await decodeFields([fields], form);
      expect(valuesOf(volume)).to.deep.equal(values);
      expect(rgbOf(volume)).to.deep.equal(colors);
      expect(volume.unit).to.equal('');
      expect(volume.left).to.equal(undefined);
    });
  }

  const decodeJpeg = (
    { photometric, stream }: Pick<(typeof jpegColorStreams)[number], 'photometric' | 'stream'>,
    change: (bytes: Uint8Array<ArrayBuffer>) => Uint8Array<ArrayBuffer> = (bytes) => bytes,
  ): ReturnType<typeof decodeFields> => {
    const bytes = change(Uint8Array.from(atob(stream), (sign) => sign.charCodeAt(0)));
    const fields = inColors(photometric, new Uint8Array(), { Rows: [21], Columns: [26] });
    return decodeFields([fields], { syntax: '1.2.840.10008.1.2.4.50', fragments: [bytes] });
  };

  for (const one of jpegColorStreams)
    it(`packed with JPEG, ${one.name}, are shown, with the brightness that pydicom reads`, async () => {
      const volume = await decodeJpeg(one);
      const apart = valuesOf(volume).map((value, i) => Math.abs(value - one.values[i]));
      // Decoders may round the sum of cosines of each of three numbers up or down: pydicom's own two decoders are up to 2 apart.
      expect(Math.max(...apart)).to.be.at.most(2);
      expect(apart.reduce((sum, value) => sum + value, 0) / apart.length).to.be.below(0.25);
      const rgb = rgbOf(volume)!;
      valuesOf(volume).forEach((value, i) =>
        expect(lumaOf(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2])).to.equal(value),
      );
      expect(volume.left).to.equal(undefined);
    });

  it('packed with JPEG are shown as their streams say, and not as the file calls them', async () => {
    for (const one of jpegColorStreams.filter(({ name }) => name !== 'RGB')) {
      const colors = rgbOf(await decodeJpeg(one));
      expect(rgbOf(await decodeJpeg({ ...one, photometric: 'RGB' })), one.name).to.deep.equal(colors);
      // Without the mark of JFIF, three numbers of different sizes are no red, green and blue.
      const withoutMark = (bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> =>
        Uint8Array.from([...bytes.slice(0, 2), ...bytes.slice(20)]);
      const plain = rgbOf(await decodeJpeg({ ...one, photometric: 'RGB' }, withoutMark));
      if (one.name === '4:4:4') expect(plain, one.name).to.not.deep.equal(colors);
      else expect(plain, one.name).to.deep.equal(colors);
    }
  });

  it('packed with JPEG that are damaged give a volume or an error in words', async () => {
    let errors = 0;
    for (const one of jpegColorStreams) {
      for (let at = 2; at < 900; at += 23) {
        for (const change of [
          (bytes: Uint8Array<ArrayBuffer>) => bytes.slice(0, at),
          (bytes: Uint8Array<ArrayBuffer>) => bytes.map((byte, i) => (i === at ? byte ^ 0x55 : byte)),
        ]) {
          const error = await decodeJpeg(one, change).then(
            () => null,
            (thrown: unknown) => thrown,
          );
          if (error === null) continue;
          errors++;
          expect(error)
            .to.have.property('code')
            .that.matches(/^format\/(corrupt|unsupported|too-large)$/);
        }
      }
    }
    expect(errors).to.be.above(100);
  });

  it('YBR_FULL_422 has the colours of two pixels once', async () => {
    const volume = await decodeFields([inColors('YBR_FULL_422', pairs)]);
    // The first of two has the same three numbers as in YBR_FULL.
    expect(valuesOf(volume).filter((_value, i) => i % 2 === 0)).to.deep.equal(ofYbr.filter((_value, i) => i % 2 === 0));
  });

  it('leaves pictures in colours out where a scan is in gray', async () => {
    const files = [0, 5].map((z) => dicomBytes(ctSlice(z)));
    const report = dicomBytes(
      inColors('RGB', new Uint8Array(300), { Rows: [10], Columns: [10], SeriesInstanceUID: '1.2.9' }),
    );
    const volume = await decodeSeries([report, ...files]);
    expect(volume.grid.dimensions).to.deep.equal([4, 3, 2]);
    expect(volume.left).to.have.length(1);
    expect(volume.left![0]).to.contain('the one with the most voxels that is in gray is shown');
  });

  for (const [what, fields, form] of [
    ['packed with JPEG-LS', inColors('RGB', rgb), { syntax: '1.2.840.10008.1.2.4.80', fragments: [rgb] }],
    ['of pairs in runs', inColors('YBR_FULL_422', pairs), { syntax: syntaxes.rle, fragments: [packColors(rgb)] }],
    ['of 16 bits', inColors('RGB', new Uint8Array(72), { BitsAllocated: [16], BitsStored: [16], HighBit: [15] }), {}],
    ['in another form', inColors('CMYK', rgb), {}],
    ['with a palette that is not there', inColors('PALETTE COLOR', indices, { SamplesPerPixel: [1] }), {}],
  ] as const satisfies readonly (readonly [string, DicomFields, DicomForm])[]) {
    it(`${what} is refused in words`, async () => {
      const error = await expectError(decodeFields([fields], form));
      expect(error.code).to.equal('format/unsupported');
      expect(error.message).to.contain('is in colours').and.to.contain('dcmdjpeg');
    });
  }

  it('that end early are an error in words', async () => {
    const error = await expectError(decodeFields([inColors('RGB', rgb.slice(0, 30))]));
    expect(error.code).to.equal('format/corrupt');
    expect(error.message).to.contain('got 30 bytes').and.to.contain('need 36');
  });
});

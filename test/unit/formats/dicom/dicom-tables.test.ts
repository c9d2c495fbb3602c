// Tables from stored numbers to values (Modality LUT), against what pydicom reads of the same bytes.
import { expect } from '@esm-bundle/chai';
import { ctSlice, dicomBytes, pixelFields } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields, DicomForm } from '../../../helpers/dicom-bytes.ts';
import { decodeFields, decodeSeries } from '../../../helpers/dicom-series.ts';
import { expectError, valuesOf } from '../../../helpers/decode.ts';

/** Squares, from the stored number -3 on: six values. */
const squares = [9, 4, 1, 0, 1, 40000];
const bytesOf = (words: readonly number[], isBig = false): Uint8Array => {
  const view = new DataView(new ArrayBuffer(2 * words.length));
  for (const [i, word] of words.entries()) view.setUint16(2 * i, word, !isBig);
  return new Uint8Array(view.buffer);
};
const stored = Int16Array.from([-9, -4, -3, -2, -1, 0, 1, 2, 3, 9, 300, -300]);
/** pydicom 3.0.2, `apply_modality_lut` of `pixel_array`, where the descriptor has a sign. */
const pydicom = [9, 9, 9, 4, 1, 0, 1, 40000, 40000, 40000, 40000, 9];

const mr: DicomFields = { Modality: 'MR', RescaleSlope: undefined, RescaleIntercept: undefined };
const first = 2 ** 16 - 3;
const table = (data: Uint8Array, bits = 16, more: DicomFields = {}): DicomFields => ({
  ModalityLUTSequence: [{ LUTDescriptor: [6, first, bits], ModalityLUTType: 'US', LUTData: data, ...more }],
});
const file = (fields: DicomFields, form: DicomForm = {}): Uint8Array<ArrayBuffer> =>
  dicomBytes(
    ctSlice(0, { ...mr, ...pixelFields(stored, form.isBigEndian), PixelRepresentation: [1], ...fields }),
    form,
  );

describe('DICOM files with a table of values', () => {
  for (const [name, bytes] of Object.entries({
    'in words': file(table(bytesOf(squares))),
    'with implicit representations': file(table(bytesOf(squares)), { isImplicit: true }),
    'in words of big endian': file(table(bytesOf(squares, true)), { isBigEndian: true }),
    'next to a slope, which the table is in place of': file({
      ...table(bytesOf(squares)),
      RescaleSlope: [2],
      RescaleIntercept: [-1024],
    }),
  }))
    it(`have the values of pydicom, ${name}`, async () => {
      const { unit, format, ...volume } = await decodeSeries([bytes]);
      expect(valuesOf({ unit, format, ...volume })).to.deep.equal(pydicom);
      expect([unit, format]).to.deep.equal(['', 'DICOM, MR']);
    });

  it('may have values of 8 bits, in bytes or in words', async () => {
    const small = squares.map((value) => Math.min(200, value));
    const expected = pydicom.map((value) => Math.min(200, value));
    for (const data of [Uint8Array.from(small), bytesOf(small)])
      expect(valuesOf(await decodeSeries([file(table(data, 8))]))).to.deep.equal(expected);
  });

  it('in HU are in HU, and window and padding go with the values and with the stored numbers', async () => {
    const volume = await decodeSeries([
      file({
        ...table(bytesOf(squares), 16, { ModalityLUTType: 'HU' }),
        Modality: 'CT',
        WindowCenter: [100],
        WindowWidth: [50],
        PixelPaddingValue: [2 ** 16 - 300],
      }),
    ]);
    expect(volume.unit).to.equal('HU');
    expect(valuesOf(volume)).to.deep.equal([...pydicom.slice(0, -1), NaN]);
    expect(volume.windows).to.deep.equal([{ name: 'Window 1', from: 75, to: 124, width: 50, level: 100 }]);
  });

  it('are turned where the smallest value is white, up to the largest value of the table', async () => {
    const volume = await decodeSeries([file({ ...table(bytesOf(squares)), PhotometricInterpretation: 'MONOCHROME1' })]);
    expect(valuesOf(volume)).to.deep.equal(pydicom.map((value) => 40000 - value));
  });

  it('may each have another one in a series', async () => {
    const slices = [squares, squares.map((value) => value + 7)].map((words, k) =>
      ctSlice(5 * k, { ...mr, ...pixelFields(stored), PixelRepresentation: [1], ...table(bytesOf(words)) }),
    );
    expect(valuesOf(await decodeFields(slices))).to.deep.equal([...pydicom, ...pydicom.map((value) => value + 7)]);
  });

  it('keep their stored numbers where the table leads back to X-rays, which is not for display', async () => {
    const volume = await decodeSeries([file({ ...table(bytesOf(squares)), PixelIntensityRelationship: 'LOG' })]);
    expect(valuesOf(volume)).to.deep.equal([...stored]);
  });

  it('are refused in words where the table is cut short', async () => {
    const { code, message } = await expectError(decodeSeries([file(table(bytesOf(squares.slice(1))))]));
    expect(code).to.equal('format/corrupt');
    expect(message).to.contain('gives its values by a table, which is cut short: got 10 bytes for 6 values');
  });
});

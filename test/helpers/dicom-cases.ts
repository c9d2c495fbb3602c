// DICOM files of 4 x 3 pixels in every form of numbers that is read.
import { ctSlice, dicomBytes, packRle, pixelFields } from './dicom-bytes.ts';
import type { DicomFields, DicomForm } from './dicom-bytes.ts';
import { syntaxes } from './dicom-bytes.ts';

const ramp = (from: number, step: number): number[] => Array.from({ length: 12 }, (_, i) => from + step * i);
const mr: DicomFields = { Modality: 'MR', RescaleSlope: undefined, RescaleIntercept: undefined };

const of = (
  numbers: Parameters<typeof pixelFields>[0],
  fields: DicomFields = mr,
  form: DicomForm = {},
): Uint8Array<ArrayBuffer> => dicomBytes(ctSlice(0, { ...pixelFields(numbers, form.isBigEndian), ...fields }), form);

/** An overlay in the bits above those of the numbers, which are to be left out. */
const withOverlay = Uint16Array.from(ramp(500, 311), (value, i) => (value & 0xfff) | (i % 3 ? 0x1000 : 0x8000));
const signed12 = Int16Array.from(ramp(-1500, 251), (value) => value & 0xfff);

/** Files whose values, read by another program, are in dicom.test.ts. */
export const cases: Readonly<Record<string, Uint8Array<ArrayBuffer>>> = {
  'u16 explicit': of(Uint16Array.from(ramp(0, 5957))),
  'u16 implicit': of(Uint16Array.from(ramp(0, 5957)), mr, { isImplicit: true }),
  'u16 deflated': of(Uint16Array.from(ramp(0, 5957)), mr, { isDeflated: true }),
  'u16 big endian': of(Uint16Array.from(ramp(0, 5957)), mr, { isBigEndian: true }),
  'i16 explicit': of(Int16Array.from(ramp(-32768, 5957))),
  'i16 big endian': of(Int16Array.from(ramp(-32768, 5957)), mr, { isBigEndian: true }),
  'u8 explicit': of(Uint8Array.from(ramp(1, 23))),
  'u8 in words, big endian': of(
    Uint8Array.from(ramp(1, 23), (_, i) => 1 + 23 * (i ^ 1)),
    mr,
    { isBigEndian: true },
  ),
  'i8 explicit': of(Int8Array.from(ramp(-128, 23))),
  'u32 explicit': of(Uint32Array.from(ramp(0, 390_451_572))),
  'i32 explicit': of(Int32Array.from(ramp(-2_147_483_648, 390_451_572))),
  'i32 big endian': of(Int32Array.from(ramp(-2_147_483_648, 390_451_572)), mr, { isBigEndian: true }),
  'i16 with slope': of(Int16Array.from(ramp(-1000, 300)), {
    Modality: 'MR',
    RescaleSlope: '0.25',
    RescaleIntercept: '-3.5 ',
  }),
  'u16 of CT': of(Uint16Array.from(ramp(0, 372)), {}),
  'u16 of 12 bits with an overlay': of(withOverlay, { ...mr, BitsStored: [12], HighBit: [11] }),
  'i16 of 12 bits': of(signed12, { ...mr, BitsStored: [12], HighBit: [11] }),
  'float pixels': dicomBytes(
    ctSlice(0, {
      ...mr,
      PixelData: undefined,
      BitsAllocated: [32],
      BitsStored: undefined,
      HighBit: undefined,
      FloatPixelData: ramp(-1.5, 0.375),
    }),
  ),
  'double pixels': dicomBytes(
    ctSlice(0, {
      ...mr,
      PixelData: undefined,
      BitsAllocated: [64],
      BitsStored: undefined,
      HighBit: undefined,
      DoubleFloatPixelData: ramp(-1e100, 3e99),
    }),
  ),
  'u16 by runs': of(Uint16Array.from([7, 7, 7, 7, 7, 9, 258, 258, 65535, 0, 0, 1]), mr, {
    syntax: syntaxes.rle,
    fragments: [packRle(Uint16Array.from([7, 7, 7, 7, 7, 9, 258, 258, 65535, 0, 0, 1]))],
  }),
  'u8 by runs': of(Uint8Array.from([7, 7, 7, 7, 7, 9, 8, 8, 255, 0, 0, 1]), mr, {
    syntax: syntaxes.rle,
    fragments: [packRle(Uint8Array.from([7, 7, 7, 7, 7, 9, 8, 8, 255, 0, 0, 1]))],
  }),
};

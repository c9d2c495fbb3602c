import { ctSlice, dicomBytes, packRle, syntaxes } from '../../helpers/dicom-bytes.ts';
import type { DicomFields, DicomForm, RawElement } from '../../helpers/dicom-bytes.ts';
import { segment, segmentationFields } from '../../helpers/dicom-segmentation.ts';
import { jpegStreams } from '../../helpers/jpeg-streams.ts';
import { damage } from '../fuzz-case.ts';
import type { Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';

const text = (random: Random, ...numbers: readonly number[]): string =>
  numbers.map((number) => random.number(number)).join('\\');

/** DICOM: series of one to six files, with frames or without; sizes, places, scales and lengths that lie. Source: PS3.5 */
export const dicom: Grammar = (random) => {
  const files = random.or(random.int(1, 6), 1, 2);
  const step = random.or(5, 0, -3, 1e-9, 1e9);
  const form = chooseForm(random);
  const hasFrames = random.chance(0.3);
  return {
    ...(files > 1 && { stack: true as const }),
    files: Array.from({ length: files }, (_, k) => ({
      name: random.or(`${k}.dcm`, 'a', 'a.nii'),
      bytes: damage(
        random,
        writeFile(random, { place: random.isWild() ? random.int(0, 9) : k, step, form, hasFrames }),
      ),
    })),
  };
};

function chooseForm(random: Random): DicomForm {
  return {
    isImplicit: random.chance(0.2),
    isDeflated: random.chance(0.1),
    hasMarks: random.chance(0.3),
    hasPreamble: random.or(true, false),
  };
}

interface FileWish {
  readonly place: number;
  readonly step: number;
  readonly form: DicomForm;
  readonly hasFrames: boolean;
}

function writeFile(random: Random, { place, step, form, hasFrames }: FileWish): Uint8Array<ArrayBuffer> {
  const frames = hasFrames ? random.int(1, 4) : 1;
  const [rows, columns] = [random.or(3, 4), random.or(4, 5)];
  const isByte = random.or(false, true);
  const length = frames * rows * columns;
  const numbers = isByte ? random.bytes(length) : new Uint16Array(random.bytes(2 * length).buffer);
  const bits = isByte ? 8 : 16;
  const isPacked = random.chance(0.2) && !form.isDeflated && !form.isImplicit;
  const z = place * step;
  const fields: DicomFields = {
    ...ctSlice(z),
    ImageType: random.or('ORIGINAL\\PRIMARY\\AXIAL', 'ORIGINAL\\PRIMARY\\M\\MOSAIC', 'A\\B\\LOCALIZER', '\\\\\\'),
    Modality: random.or('CT', 'MR', 'PT', 'RTDOSE', ''),
    SeriesInstanceUID: random.or('1.2', '1.3', ''),
    ImagePositionPatient: random.isWild() ? text(random, 1, 2, z) : `-1\\-2\\${z}`,
    ImageOrientationPatient: text(random, 1, 0, 0, 0, 1, 0),
    PixelSpacing: text(random, 1, 1),
    SliceThickness: text(random, 5),
    SpacingBetweenSlices: text(random, 5),
    EchoTime: text(random, 20),
    AcquisitionNumber: random.or('1', '2', 'x'),
    InstanceNumber: String(random.size(place)),
    NumberOfImagesInMosaic: [random.size(4) & 0xffff],
    GridFrameOffsetVector: text(random, 0, 5, 10, 15),
    DoseGridScaling: text(random, 1),
    NumberOfFrames: String(random.size(frames)),
    Rows: [random.size(rows) & 0xffff],
    Columns: [random.size(columns) & 0xffff],
    SamplesPerPixel: [random.or(1, 3)],
    PhotometricInterpretation: random.or('MONOCHROME2', 'MONOCHROME1', 'RGB'),
    BitsAllocated: [random.size(bits) & 0xffff],
    BitsStored: [random.size(bits) & 0xffff],
    HighBit: [random.size(bits - 1) & 0xffff],
    PixelRepresentation: [random.or(0, 1, 7)],
    PixelPaddingValue: random.chance(0.3) ? [random.size(3) & 0xffff] : undefined,
    PixelPaddingRangeLimit: random.chance(0.1) ? [random.size(9) & 0xffff] : undefined,
    RescaleSlope: text(random, 1),
    RescaleIntercept: text(random, random.pick([0, -1024])),
    WindowCenter: text(random, 40),
    WindowWidth: text(random, 400),
    ...(hasFrames && random.chance(0.7) ? writeGroups(random, frames) : {}),
    PixelData: new Uint8Array(numbers.buffer),
  };
  const raw = listRaw(random);
  if (random.chance(0.15)) return dicomBytes({ ...fields, ...writeSegmentation(random) }, { ...form, raw });
  if (!isPacked) return dicomBytes(fields, { ...form, raw });
  if (random.chance(0.6)) return writeJpeg(random, fields, frames, { ...form, raw });
  const size = rows * columns;
  const packed = Array.from({ length: frames }, (_, i) =>
    damage(random, packRle(numbers.subarray(i * size, (i + 1) * size))),
  );
  const offsets = random.chance(0.5) ? packed.map(() => random.size(0)) : [];
  return dicomBytes(fields, {
    ...form,
    raw,
    syntax: random.or(syntaxes.rle, '1.2.840.10008.1.2.4.70', '1.2.840.10008.1.2.4.80'),
    fragments: packed,
    offsets,
  });
}

/** Frames of 10 x 9 pixels that other programs packed, some with a byte or two that are wrong. */
function writeJpeg(random: Random, fields: DicomFields, frames: number, form: DicomForm): Uint8Array<ArrayBuffer> {
  const { stream, bits } = random.pick(jpegStreams);
  const fragments = Array.from({ length: frames }, () => {
    const bytes = Uint8Array.from(atob(stream), (c) => c.charCodeAt(0));
    if (!random.isSound && random.chance(0.4)) bytes[random.int(0, bytes.length - 1)] = random.int(0, 255);
    return damage(random, bytes);
  });
  const size = {
    Rows: [random.size(9) & 0xffff],
    Columns: [random.size(10) & 0xffff],
    BitsAllocated: [random.or(bits > 8 ? 16 : 8, 8, 16, 32)],
    BitsStored: [random.or(bits, 8, 16)],
    HighBit: [bits - 1],
  };
  return dicomBytes({ ...fields, ...size }, { ...form, syntax: '1.2.840.10008.1.2.4.80', fragments });
}

/** Elements that readers pass over, with lengths that lie. */
function listRaw(random: Random): RawElement[] {
  if (!random.chance(0.2)) return [];
  const bytes = random.bytes(random.int(0, 40));
  return [
    {
      tag: random.pick([0x00091010, 0x00291010, 0x00280030, 0x00200032, 0x7fe00001, 0xfffee00d]),
      vr: random.pick(['OB', 'UN', 'SQ', 'DS', 'OV', 'QQ']),
      value: bytes,
      ...(random.isWild() ? { length: random.size(bytes.length) % 2 ** 32 } : {}),
    },
  ];
}

/** Segmentations of bits, bytes and words, with numbers, places and names that lie. */
function writeSegmentation(random: Random): DicomFields {
  const type = random.or('BINARY', 'FRACTIONAL', 'LABELMAP');
  const frames = random.int(1, 5);
  const step = random.or(1, 0, 1e-7, 1e7);
  const fields = segmentationFields({
    type,
    columns: 5,
    rows: 3,
    frames: Array.from({ length: frames }, () => ({
      slice: random.int(0, 4),
      segment: random.size(1) & 0xffff,
      pixels: [...random.bytes(15)],
    })),
    segments: [segment(random.size(1) & 0xffff, random.or('A', '\0\x1b$B', ''), [random.int(0, 65535), 1, 2])],
    ...(random.isWild() ? { positionOf: (slice) => [random.number(0), 0, step * slice] } : {}),
    bits: random.or(type === 'BINARY' ? 1 : 8, 16),
  });
  if (!random.isWild()) return fields;
  return {
    ...fields,
    Rows: [random.size(3) & 0xffff],
    Columns: [random.size(5) & 0xffff],
    NumberOfFrames: String(random.size(frames)),
    MaximumFractionalValue: [random.size(200) & 0xffff],
    SpecificCharacterSet: random.or('ISO_IR 192', 'ISO 2022 IR 87', 'X'),
    PixelPaddingValue: random.chance(0.2) ? [random.size(0) & 0xffff] : undefined,
  };
}

function writeGroups(random: Random, frames: number): DicomFields {
  return {
    SharedFunctionalGroupsSequence: [
      {
        PlaneOrientationSequence: [{ ImageOrientationPatient: text(random, 1, 0, 0, 0, 1, 0) }],
        PixelMeasuresSequence: [{ PixelSpacing: text(random, 1, 1), SliceThickness: text(random, 4) }],
      },
    ],
    PerFrameFunctionalGroupsSequence: Array.from({ length: random.or(frames, 0, 1, 9) }, (_, k) => ({
      FrameContentSequence: [{ TemporalPositionIndex: [random.or(1, 2)] }],
      PlanePositionSequence: [{ ImagePositionPatient: text(random, 1, 2, 5 * k) }],
      PixelValueTransformationSequence: [{ RescaleIntercept: text(random, 0), RescaleSlope: text(random, 1) }],
    })),
  };
}

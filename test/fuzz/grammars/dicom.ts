import { ctSlice, dicomBytes, packRle, syntaxes } from '../../helpers/dicom-bytes.ts';
import type { DicomFields, DicomForm, RawElement } from '../../helpers/dicom-bytes.ts';
import { segment, segmentationFields } from '../../helpers/dicom-segmentation.ts';
import { j2kStreams } from '../../helpers/j2k-streams.ts';
import { jpegColorStreams } from '../../helpers/jpeg-color-streams.ts';
import { jpegStreams } from '../../helpers/jpeg-streams.ts';
import { damage } from '../fuzz-case.ts';
import type { FuzzFile, Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';

const text = (random: Random, ...numbers: readonly number[]): string =>
  numbers.map((number) => random.number(number)).join('\\');

/** DICOM: series of one to six files, with frames or without; sizes, places, scales and lengths that lie. Source: PS3.5 */
export const dicom: Grammar = (random) => {
  const files = random.or(random.int(1, 6), 1, 2);
  const isFolder = random.chance(0.2);
  const chosen = writeFiles(random, files);
  if (isFolder) return { folder: true, files: chosen };
  return { ...(files > 1 && { stack: true as const }), files: chosen };
};

/** A folder: a series with enough files for a coarse picture, other series, files twice, and what has no pixels. */
export const dicomFolder: Grammar = (random) => {
  const files = writeFiles(random, random.chance(0.3) ? random.int(32, 40) : random.int(1, 6), { isAlike: true });
  if (random.chance(0.3)) files.push(...writeFiles(random, random.int(1, 3)));
  if (random.chance(0.2)) files.push(random.pick(files));
  if (random.chance(0.2)) files.push({ name: 'DICOMDIR', bytes: dicomBytes({ SOPClassUID: '1.2.840.10008.1.3.10' }) });
  if (random.chance(0.1)) files.push({ name: 'read me.txt', bytes: random.bytes(random.int(0, 50)) });
  return {
    folder: true,
    files: files.map(({ bytes }, i) => ({ name: `${i}`, bytes })),
    ...(random.chance(0.2) && { settings: { series: random.int(1, 3) } }),
  };
};

/** @param isAlike - whether the files are slices of one series, with numbers of their own */
function writeFiles(random: Random, count: number, { isAlike = false } = {}): FuzzFile[] {
  const step = random.or(5, 0, -3, 1e-9, 1e9);
  const form = chooseForm(random);
  const hasFrames = !isAlike && random.chance(0.3);
  return Array.from({ length: count }, (_, k) => ({
    name: random.or(`${k}.dcm`, 'a', 'a.nii'),
    bytes: damage(
      random,
      writeFile(random, { place: random.isWild() ? random.int(0, 9) : k, step, form, hasFrames, isAlike }),
    ),
  }));
}

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
  readonly isAlike: boolean;
}

function writeFile(random: Random, { place, step, form, hasFrames, isAlike }: FileWish): Uint8Array<ArrayBuffer> {
  const frames = hasFrames ? random.int(1, 4) : 1;
  const [rows, columns] = [random.or(3, 4), random.or(4, 5)];
  const isByte = random.or(false, true);
  const length = frames * rows * columns;
  const numbers = isByte ? random.bytes(length) : new Uint16Array(random.bytes(2 * length).buffer);
  const bits = isByte ? 8 : 16;
  const isPacked = random.chance(0.3) && !form.isDeflated && !form.isImplicit;
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
    WindowCenter: random.chance(0.2) ? text(random, 40, 50, -600) : text(random, 40),
    WindowWidth: random.chance(0.2) ? text(random, 400, 350, 1500) : text(random, 400),
    ...(hasFrames && random.chance(0.7) ? writeGroups(random, frames) : {}),
    ...(random.chance(0.2) ? writeFilm(random, frames) : {}),
    PixelData: new Uint8Array(numbers.buffer),
  };
  const raw = listRaw(random);
  if (!isAlike && random.chance(0.15)) return dicomBytes({ ...fields, ...writeSegmentation(random) }, { ...form, raw });
  if (!isPacked)
    return dicomBytes(random.chance(0.15) ? { ...fields, ...writeColors(random, length) } : fields, { ...form, raw });
  if (random.chance(0.7)) return writeStreams(random, fields, frames, { ...form, raw });
  const size = rows * columns;
  const packed = Array.from({ length: frames }, (_, i) =>
    damage(random, packRle(numbers.subarray(i * size, (i + 1) * size))),
  );
  return dicomBytes(fields, {
    ...form,
    syntax: random.or(syntaxes.rle, '1.2.840.10008.1.2.4.70', '1.2.840.10008.1.2.4.80'),
    ...cutFrames(random, packed, raw),
  });
}

/** What says that frames are no slices: a class, a kind of picture, what they are counted by, times, regions, tiles, all of which may lie. */
function writeFilm(random: Random, frames: number): DicomFields {
  const vector = (): number[] => Array.from({ length: random.or(frames, 0, 1, 7) }, () => random.or(1, 0, 2, 65_535));
  const hasTiles = random.chance(0.1);
  return {
    SOPClassUID: `1.2.840.10008.5.1.4.1.1.${random.pick(['20', '3.1', '12.1', '1', '6.2', '77.1.6'])}`,
    ImageType: `A\\B\\${random.pick(['DYNAMIC', 'GATED', 'TOMO', 'RECON TOMO', 'STATIC', ''])}`,
    FrameIncrementPointer: [random.pick([0x00181063, 0x00181065, 0x00540010, 0x00540080, 0x00182005])],
    FrameTime: text(random, 40),
    FrameTimeVector: text(random, ...Array.from({ length: frames }, () => 40)),
    EnergyWindowVector: vector(),
    DetectorVector: vector(),
    PhaseVector: vector(),
    RRIntervalVector: vector(),
    TimeSlotVector: vector(),
    TimeSliceVector: vector(),
    SliceVector: random.chance(0.5) ? vector() : undefined,
    PhaseInformationSequence: [
      {
        PhaseDelay: text(random, 0),
        ActualFrameDuration: text(random, 1000),
        PauseBetweenFrames: text(random, 0),
        NumberOfFramesInPhase: [random.size(2) & 0xffff],
      },
    ],
    GatedInformationSequence: [{ DataInformationSequence: [{ FrameTime: text(random, 50) }] }],
    SequenceOfUltrasoundRegions: [
      {
        RegionSpatialFormat: [1],
        PhysicalUnitsXDirection: [3],
        PhysicalUnitsYDirection: [3],
        PhysicalDeltaX: [random.number(0.05)],
        PhysicalDeltaY: [random.number(0.05)],
      },
    ],
    PixelAspectRatio: text(random, 1, 1),
    ...(hasTiles && { TotalPixelMatrixColumns: [random.size(8) >>> 0], TotalPixelMatrixRows: [random.size(8) >>> 0] }),
  };
}

/** Frames in one piece or in several, with a table of where each begins, one of 64 bits, or none. Source: PS3.5, A.4 */
function cutFrames(
  random: Random,
  frames: readonly Uint8Array<ArrayBuffer>[],
  raw: readonly RawElement[],
): Pick<DicomForm, 'fragments' | 'offsets' | 'raw'> {
  const offsets: number[] = [];
  const fragments: Uint8Array<ArrayBuffer>[] = [];
  let at = 0;
  for (const frame of frames) {
    offsets.push(at);
    const cut = random.chance(0.2) ? 2 * random.int(0, frame.length >> 1) : 0;
    const pieces = cut > 0 && cut < frame.length ? [frame.slice(0, cut), frame.slice(cut)] : [frame];
    for (const piece of pieces) at += 8 + piece.length + (piece.length % 2);
    fragments.push(...pieces);
  }
  const stated = offsets.map((offset) => random.size(offset));
  const table = random.pick(['basic', 'extended', 'none'] as const);
  const long = new Uint8Array(8 * stated.length);
  stated.forEach((offset, i) => new DataView(long.buffer).setBigUint64(8 * i, BigInt(offset), true));
  return {
    fragments,
    offsets: table === 'basic' ? stated.map((offset) => offset % 2 ** 32) : [],
    raw: table === 'extended' ? [...raw, { tag: 0x7fe00001, vr: 'OV', value: long }] : raw,
  };
}

/** Colours that are not packed: three numbers of a pixel, or one into a palette. */
function writeColors(random: Random, pixels: number): DicomFields {
  if (random.chance(0.4)) {
    const palette = random.bytes(2 * 256);
    const describe = (): number[] => [random.size(256) & 0xffff, random.or(0, 5), random.or(16, 8)];
    return {
      PhotometricInterpretation: 'PALETTE COLOR',
      ...uncompressed(8),
      RedPaletteColorLookupTableDescriptor: describe(),
      GreenPaletteColorLookupTableDescriptor: describe(),
      BluePaletteColorLookupTableDescriptor: describe(),
      RedPaletteColorLookupTableData: palette,
      GreenPaletteColorLookupTableData: random.or(palette, new Uint8Array()),
      BluePaletteColorLookupTableData: palette,
      PixelData: random.bytes(pixels),
    };
  }
  const photometric = random.pick(['RGB', 'YBR_FULL', 'YBR_FULL_422']);
  return {
    PhotometricInterpretation: photometric,
    SamplesPerPixel: [random.or(3, 1, 4)],
    PlanarConfiguration: [photometric === 'YBR_FULL_422' ? 0 : random.int(0, 1)],
    ...uncompressed(8),
    PixelData: random.bytes((random.or(photometric === 'YBR_FULL_422' ? 2 : 3, 1) as number) * pixels),
  };
}

const uncompressed = (bits: number): DicomFields => ({
  BitsAllocated: [bits],
  BitsStored: [bits],
  HighBit: [bits - 1],
  PixelRepresentation: [0],
});

/** What a stream that another program packed is, as a file says it. */
interface Packed {
  readonly stream: string;
  readonly bits: number;
  readonly isSigned?: boolean;
  readonly syntax: string;
  readonly photometric?: string;
}

const jpegSyntax = '1.2.840.10008.1.2.4';
const packedStreams: readonly (readonly Packed[])[] = [
  jpegStreams.map((one) => ({ ...one, syntax: `${jpegSyntax}.80` })),
  j2kStreams.map((one) => ({ ...one, syntax: `${jpegSyntax}.${one.isHt ? 203 : 91}` })),
  jpegColorStreams.map((one) => ({ ...one, bits: 8, syntax: `${jpegSyntax}.50` })),
];

/** Frames of 10 x 9 pixels that other programs packed, some with a byte or two that are wrong. */
function writeStreams(random: Random, fields: DicomFields, frames: number, form: DicomForm): Uint8Array<ArrayBuffer> {
  const { stream, bits, isSigned = false, syntax, photometric } = random.pick(random.pick(packedStreams));
  const packed = Array.from({ length: frames }, () => {
    const bytes = Uint8Array.from(atob(stream), (c) => c.charCodeAt(0));
    if (!random.isSound && random.chance(0.4)) bytes[random.int(0, bytes.length - 1)] = random.int(0, 255);
    return damage(random, bytes);
  });
  const [columns, rows] = photometric ? [26, 21] : [10, 9];
  const size: DicomFields = {
    Rows: [random.size(rows) & 0xffff],
    Columns: [random.size(columns) & 0xffff],
    BitsAllocated: [random.or(bits > 8 ? 16 : 8, 8, 16, 32)],
    BitsStored: [random.or(bits, 8, 16)],
    HighBit: [bits - 1],
    PixelRepresentation: [random.or(isSigned ? 1 : 0, 1)],
    ...(photometric && { PhotometricInterpretation: photometric, SamplesPerPixel: [random.or(3, 1)] }),
  };
  return dicomBytes(
    { ...fields, ...size },
    { ...form, syntax: random.or(syntax, `${jpegSyntax}.50`), ...cutFrames(random, packed, form.raw ?? []) },
  );
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

// Writes DICOM files, element by element, that may say what is not true. Source: DICOM PS3.5, chapter 7, and PS3.10, 7.1
import { deflateSync } from 'fflate';

/** Elements by their keywords in PS3.6: their tag and value representation. */
const dictionary = {
  OffsetOfTheFirstDirectoryRecordOfTheRootDirectoryEntity: [0x00041200, 'UL'],
  SpecificCharacterSet: [0x00080005, 'CS'],
  ImageType: [0x00080008, 'CS'],
  SOPClassUID: [0x00080016, 'UI'],
  SOPInstanceUID: [0x00080018, 'UI'],
  StudyDate: [0x00080020, 'DA'],
  SeriesDate: [0x00080021, 'DA'],
  AcquisitionDate: [0x00080022, 'DA'],
  AcquisitionDateTime: [0x0008002a, 'DT'],
  SeriesTime: [0x00080031, 'TM'],
  AcquisitionTime: [0x00080032, 'TM'],
  ContentTime: [0x00080033, 'TM'],
  AccessionNumber: [0x00080050, 'SH'],
  Modality: [0x00080060, 'CS'],
  InstitutionName: [0x00080080, 'LO'],
  ReferringPhysicianName: [0x00080090, 'PN'],
  CodeValue: [0x00080100, 'SH'],
  SeriesDescription: [0x0008103e, 'LO'],
  FrameType: [0x00089007, 'CS'],
  ComplexImageComponent: [0x00089208, 'CS'],
  PatientName: [0x00100010, 'PN'],
  PatientID: [0x00100020, 'LO'],
  PatientBirthDate: [0x00100030, 'DA'],
  PatientWeight: [0x00101030, 'DS'],
  PatientComments: [0x00104000, 'LT'],
  SliceThickness: [0x00180050, 'DS'],
  EchoTime: [0x00180081, 'DS'],
  SpacingBetweenSlices: [0x00180088, 'DS'],
  TriggerTime: [0x00181060, 'DS'],
  FrameTime: [0x00181063, 'DS'],
  FrameTimeVector: [0x00181065, 'DS'],
  RadiopharmaceuticalStartTime: [0x00181072, 'TM'],
  RadionuclideTotalDose: [0x00181074, 'DS'],
  RadionuclideHalfLife: [0x00181075, 'DS'],
  RadiopharmaceuticalStartDateTime: [0x00181078, 'DT'],
  ActualFrameDuration: [0x00181242, 'IS'],
  SequenceOfUltrasoundRegions: [0x00186011, 'SQ'],
  RegionSpatialFormat: [0x00186012, 'US'],
  RegionLocationMaxX1: [0x0018601c, 'UL'],
  RegionLocationMaxY1: [0x0018601e, 'UL'],
  PhysicalUnitsXDirection: [0x00186024, 'US'],
  PhysicalUnitsYDirection: [0x00186026, 'US'],
  PhysicalDeltaX: [0x0018602c, 'FD'],
  PhysicalDeltaY: [0x0018602e, 'FD'],
  FrameAcquisitionDateTime: [0x00189074, 'DT'],
  EffectiveEchoTime: [0x00189082, 'FD'],
  MREchoSequence: [0x00189114, 'SQ'],
  CardiacSynchronizationSequence: [0x00189118, 'SQ'],
  MRImageFrameTypeSequence: [0x00189226, 'SQ'],
  ImageDataTypeSequence: [0x00189807, 'SQ'],
  DataType: [0x00189808, 'CS'],
  NominalScannedPixelSpacing: [0x00182010, 'DS'],
  NumberOfImagesInMosaic: [0x0019100a, 'US'],
  StudyInstanceUID: [0x0020000d, 'UI'],
  SeriesInstanceUID: [0x0020000e, 'UI'],
  SeriesNumber: [0x00200011, 'IS'],
  AcquisitionNumber: [0x00200012, 'IS'],
  InstanceNumber: [0x00200013, 'IS'],
  ImagePositionPatient: [0x00200032, 'DS'],
  ImageOrientationPatient: [0x00200037, 'DS'],
  TemporalPositionIdentifier: [0x00200100, 'IS'],
  SliceLocation: [0x00201041, 'DS'],
  ImageComments: [0x00204000, 'LT'],
  StackID: [0x00209056, 'SH'],
  FrameContentSequence: [0x00209111, 'SQ'],
  PlanePositionSequence: [0x00209113, 'SQ'],
  PlaneOrientationSequence: [0x00209116, 'SQ'],
  TemporalPositionIndex: [0x00209128, 'UL'],
  NominalCardiacTriggerDelayTime: [0x00209153, 'FD'],
  FrameAcquisitionNumber: [0x00209156, 'US'],
  NominalPercentageOfCardiacPhase: [0x00209241, 'FL'],
  DimensionOrganizationType: [0x00209311, 'CS'],
  ImagePositionVolume: [0x00209301, 'FD'],
  ImageOrientationVolume: [0x00209302, 'FD'],
  PlanePositionVolumeSequence: [0x0020930e, 'SQ'],
  PlaneOrientationVolumeSequence: [0x0020930f, 'SQ'],
  TemporalPositionTimeOffset: [0x0020930d, 'FD'],
  TemporalPositionSequence: [0x00209310, 'SQ'],
  SamplesPerPixel: [0x00280002, 'US'],
  PhotometricInterpretation: [0x00280004, 'CS'],
  PlanarConfiguration: [0x00280006, 'US'],
  NumberOfFrames: [0x00280008, 'IS'],
  FrameIncrementPointer: [0x00280009, 'AT'],
  Rows: [0x00280010, 'US'],
  Columns: [0x00280011, 'US'],
  PixelSpacing: [0x00280030, 'DS'],
  PixelAspectRatio: [0x00280034, 'IS'],
  CorrectedImage: [0x00280051, 'CS'],
  BitsAllocated: [0x00280100, 'US'],
  BitsStored: [0x00280101, 'US'],
  HighBit: [0x00280102, 'US'],
  PixelRepresentation: [0x00280103, 'US'],
  PixelPaddingValue: [0x00280120, 'US'],
  PixelPaddingRangeLimit: [0x00280121, 'US'],
  BurnedInAnnotation: [0x00280301, 'CS'],
  PixelIntensityRelationship: [0x00281040, 'CS'],
  WindowCenter: [0x00281050, 'DS'],
  WindowWidth: [0x00281051, 'DS'],
  RescaleIntercept: [0x00281052, 'DS'],
  RescaleSlope: [0x00281053, 'DS'],
  RescaleType: [0x00281054, 'LO'],
  WindowCenterWidthExplanation: [0x00281055, 'LO'],
  VOILUTFunction: [0x00281056, 'CS'],
  RedPaletteColorLookupTableDescriptor: [0x00281101, 'US'],
  GreenPaletteColorLookupTableDescriptor: [0x00281102, 'US'],
  BluePaletteColorLookupTableDescriptor: [0x00281103, 'US'],
  RedPaletteColorLookupTableData: [0x00281201, 'OW'],
  GreenPaletteColorLookupTableData: [0x00281202, 'OW'],
  BluePaletteColorLookupTableData: [0x00281203, 'OW'],
  ModalityLUTSequence: [0x00283000, 'SQ'],
  LUTDescriptor: [0x00283002, 'US'],
  LUTExplanation: [0x00283003, 'LO'],
  ModalityLUTType: [0x00283004, 'LO'],
  LUTData: [0x00283006, 'OW'],
  VOILUTSequence: [0x00283010, 'SQ'],
  PixelMeasuresSequence: [0x00289110, 'SQ'],
  FrameVOILUTSequence: [0x00289132, 'SQ'],
  PixelValueTransformationSequence: [0x00289145, 'SQ'],
  SiemensImageHeader: [0x00291010, 'OB'],
  MeasurementUnitsCodeSequence: [0x004008ea, 'SQ'],
  RealWorldValueMappingSequence: [0x00409096, 'SQ'],
  RealWorldValueIntercept: [0x00409224, 'FD'],
  RealWorldValueSlope: [0x00409225, 'FD'],
  TotalPixelMatrixColumns: [0x00480006, 'UL'],
  TotalPixelMatrixRows: [0x00480007, 'UL'],
  RadiopharmaceuticalInformationSequence: [0x00540016, 'SQ'],
  DetectorInformationSequence: [0x00540022, 'SQ'],
  EnergyWindowVector: [0x00540010, 'US'],
  DetectorVector: [0x00540020, 'US'],
  PhaseVector: [0x00540030, 'US'],
  PhaseInformationSequence: [0x00540032, 'SQ'],
  NumberOfFramesInPhase: [0x00540033, 'US'],
  PhaseDelay: [0x00540036, 'IS'],
  PauseBetweenFrames: [0x00540038, 'IS'],
  RotationVector: [0x00540050, 'US'],
  RRIntervalVector: [0x00540060, 'US'],
  GatedInformationSequence: [0x00540062, 'SQ'],
  DataInformationSequence: [0x00540063, 'SQ'],
  TimeSlotVector: [0x00540070, 'US'],
  SliceVector: [0x00540080, 'US'],
  AngularViewVector: [0x00540090, 'US'],
  TimeSliceVector: [0x00540100, 'US'],
  Units: [0x00541001, 'CS'],
  SUVType: [0x00541006, 'CS'],
  DecayCorrection: [0x00541102, 'CS'],
  FrameReferenceTime: [0x00541300, 'DS'],
  SegmentationType: [0x00620001, 'CS'],
  SegmentSequence: [0x00620002, 'SQ'],
  SegmentNumber: [0x00620004, 'US'],
  SegmentLabel: [0x00620005, 'LO'],
  SegmentAlgorithmType: [0x00620008, 'CS'],
  SegmentIdentificationSequence: [0x0062000a, 'SQ'],
  ReferencedSegmentNumber: [0x0062000b, 'US'],
  RecommendedDisplayCIELabValue: [0x0062000d, 'US'],
  MaximumFractionalValue: [0x0062000e, 'US'],
  SegmentationFractionalType: [0x00620010, 'CS'],
  ImagePlanePixelSpacing: [0x30020011, 'DS'],
  DoseUnits: [0x30040002, 'CS'],
  GridFrameOffsetVector: [0x3004000c, 'DS'],
  DoseGridScaling: [0x3004000e, 'DS'],
  StructureSetROISequence: [0x30060020, 'SQ'],
  ROINumber: [0x30060022, 'IS'],
  ROIName: [0x30060026, 'LO'],
  ROIDisplayColor: [0x3006002a, 'IS'],
  ROIContourSequence: [0x30060039, 'SQ'],
  ContourSequence: [0x30060040, 'SQ'],
  ContourGeometricType: [0x30060042, 'CS'],
  ContourSlabThickness: [0x30060044, 'DS'],
  NumberOfContourPoints: [0x30060046, 'IS'],
  ContourData: [0x30060050, 'DS'],
  ReferencedROINumber: [0x30060084, 'IS'],
  SharedFunctionalGroupsSequence: [0x52009229, 'SQ'],
  PerFrameFunctionalGroupsSequence: [0x52009230, 'SQ'],
  ExtendedOffsetTable: [0x7fe00001, 'OV'],
  FloatPixelData: [0x7fe00008, 'OF'],
  DoubleFloatPixelData: [0x7fe00009, 'OD'],
  PixelData: [0x7fe00010, 'OW'],
} as const satisfies Record<string, readonly [tag: number, vr: string]>;

export type Keyword = keyof typeof dictionary;

/** A value: a text, numbers, bytes, or the items of a sequence. */
export type DicomValue = string | readonly number[] | Uint8Array | readonly DicomFields[];
export type DicomFields = { readonly [keyword in Keyword]?: DicomValue | undefined };

/** An element that is written as it is said here. */
export interface RawElement {
  readonly tag: number;
  readonly vr: string;
  readonly value: DicomValue;
  /** Instead of that of the value. */
  readonly length?: number;
}

export interface DicomForm {
  readonly syntax?: string;
  readonly isImplicit?: boolean;
  readonly isBigEndian?: boolean;
  readonly isDeflated?: boolean;
  /** Whether sequences and their items end with a mark, and say no length. */
  readonly hasMarks?: boolean;
  readonly hasPreamble?: boolean;
  /** Further elements, and those that replace the fields of the same tag. */
  readonly raw?: readonly RawElement[];
  /** Packed frames, each in pieces, instead of the bytes of PixelData. */
  readonly fragments?: readonly Uint8Array[];
  /** Where frames begin among the pieces. */
  readonly offsets?: readonly number[];
}

export const syntaxes = {
  implicit: '1.2.840.10008.1.2',
  explicit: '1.2.840.10008.1.2.1',
  deflated: '1.2.840.10008.1.2.1.99',
  bigEndian: '1.2.840.10008.1.2.2',
  rle: '1.2.840.10008.1.2.5',
} as const;

/** Value representations with a length of two bytes. */
const short = /^(AE|AS|AT|CS|DA|DS|DT|FD|FL|IS|LO|LT|PN|SH|SL|SS|ST|TM|UI|UL|US)$/;
const widths: Readonly<Record<string, 2 | 4 | 8>> = {
  US: 2,
  SS: 2,
  OW: 2,
  UL: 4,
  SL: 4,
  FL: 4,
  OF: 4,
  FD: 8,
  OD: 8,
  OV: 8,
};

/** A file of the given elements, in the order of their tags. */
export function dicomBytes(fields: DicomFields, form: DicomForm = {}): Uint8Array<ArrayBuffer> {
  const { isBigEndian = false, isImplicit = false, isDeflated = false, hasPreamble = true } = form;
  const { bigEndian, implicit, deflated, explicit } = syntaxes;
  const syntax = form.syntax ?? (isBigEndian ? bigEndian : isImplicit ? implicit : isDeflated ? deflated : explicit);
  const body = Uint8Array.from(writeSet(fields, form));
  const meta = writeElement({ tag: 0x00020010, vr: 'UI', value: syntax }, {});
  return Uint8Array.from([
    ...(hasPreamble
      ? [
          ...new Uint8Array(128),
          ...latin('DICM'),
          ...writeElement({ tag: 0x00020000, vr: 'UL', value: [meta.length] }, {}),
          ...meta,
        ]
      : []),
    ...(isDeflated ? deflateSync(body) : body),
  ]);
}

function writeSet(fields: DicomFields, form: DicomForm): number[] {
  const elements: RawElement[] = Object.entries(fields).flatMap(([keyword, value]) => {
    const [tag, vr] = dictionary[keyword as Keyword];
    return value === undefined || form.raw?.some((one) => one.tag === tag) ? [] : [{ tag, vr, value }];
  });
  elements.push(...(form.raw ?? []));
  elements.sort((a, b) => a.tag - b.tag);
  return elements.flatMap((element) => writeElement(element, form));
}

function writeElement(element: RawElement, form: DicomForm): number[] {
  const { tag, vr, value } = element;
  const { isImplicit = false, fragments, raw: _raw, ...rest } = form;
  const word = (number: number, bytes: number): number[] => numberBytes(number, bytes, form.isBigEndian);
  const name = [...word(Math.floor(tag / 0x10000), 2), ...word(tag % 0x10000, 2)];
  const isPacked = tag === 0x7fe00010 && fragments !== undefined;
  const isSequence = vr === 'SQ' && Array.isArray(value);
  const bytes = isPacked
    ? writeFragments(fragments, form.offsets ?? [])
    : isSequence
      ? writeItems(value as readonly DicomFields[], { ...rest, isImplicit })
      : valueBytes(value, vr, form.isBigEndian);
  const length = element.length ?? (isPacked || (isSequence && form.hasMarks) ? 0xffffffff : bytes.length);
  if (isImplicit) return [...name, ...word(length, 4), ...bytes];
  const representation = latin(isPacked ? 'OB' : vr);
  if (short.test(vr)) return [...name, ...representation, ...word(length, 2), ...bytes];
  return [...name, ...representation, 0, 0, ...word(length, 4), ...bytes];
}

function writeItems(items: readonly DicomFields[], form: DicomForm): number[] {
  const mark = (number: number, length: number): number[] => [
    ...numberBytes(0xfffe, 2, form.isBigEndian),
    ...numberBytes(number, 2, form.isBigEndian),
    ...numberBytes(length, 4, form.isBigEndian),
  ];
  const written = items.flatMap((item) => {
    const bytes = writeSet(item, form);
    return form.hasMarks
      ? [...mark(0xe000, 0xffffffff), ...bytes, ...mark(0xe00d, 0)]
      : [...mark(0xe000, bytes.length), ...bytes];
  });
  return form.hasMarks ? [...written, ...mark(0xe0dd, 0)] : written;
}

function writeFragments(fragments: readonly Uint8Array[], offsets: readonly number[]): number[] {
  const item = (bytes: readonly number[]): number[] => [0xfe, 0xff, 0, 0xe0, ...numberBytes(bytes.length, 4), ...bytes];
  return [
    ...item(offsets.flatMap((offset) => numberBytes(offset, 4))),
    ...fragments.flatMap((piece) => item([...piece, ...(piece.length % 2 ? [0] : [])])),
    ...[0xfe, 0xff, 0xdd, 0xe0, 0, 0, 0, 0],
  ];
}

function valueBytes(value: DicomValue, vr: string, isBigEndian = false): number[] {
  if (typeof value === 'string') {
    const bytes = latin(value);
    return bytes.length % 2 ? [...bytes, vr === 'UI' ? 0 : 0x20] : bytes;
  }
  if (value instanceof Uint8Array) return [...value, ...(value.length % 2 ? [0] : [])];
  const numbers = value as readonly number[];
  // A tag: its group and its number.
  if (vr === 'AT')
    return numbers.flatMap((id) => [id >>> 16, id & 0xffff].flatMap((word) => numberBytes(word, 2, isBigEndian)));
  // Texts of numbers.
  if (!(vr in widths)) return valueBytes(numbers.join('\\'), vr);
  return numbers.flatMap((number) => {
    if (!/^[FO][LFD]$/.test(vr)) return numberBytes(number, widths[vr], isBigEndian);
    const view = new DataView(new ArrayBuffer(widths[vr]));
    if (widths[vr] === 4) view.setFloat32(0, number, !isBigEndian);
    else view.setFloat64(0, number, !isBigEndian);
    return [...new Uint8Array(view.buffer)];
  });
}

function numberBytes(number: number, count: number, isBigEndian = false): number[] {
  const bytes = Array.from({ length: count }, (_, i) => Math.floor(number / 2 ** (8 * i)) & 0xff);
  if (isBigEndian) bytes.reverse();
  return bytes;
}

const latin = (text: string): number[] => Array.from(text, (c) => c.charCodeAt(0));

/** The fields of a CT slice of 4 x 3 pixels of 16 bits, 0.5 x 0.75 mm, whose numbers are `base` and those after it. */
export function ctSlice(z: number, fields: DicomFields = {}, base = 100): DicomFields {
  return {
    SOPClassUID: '1.2.840.10008.5.1.4.1.1.2',
    SOPInstanceUID: `1.2.3.${Math.round(1000 * z) + 1e6}`,
    ImageType: 'ORIGINAL\\PRIMARY\\AXIAL',
    Modality: 'CT',
    SeriesInstanceUID: '1.2.3',
    ImagePositionPatient: [-10, -20, z],
    ImageOrientationPatient: [1, 0, 0, 0, 1, 0],
    PixelSpacing: [0.75, 0.5],
    SliceThickness: [5],
    RescaleSlope: [1],
    RescaleIntercept: [-1024],
    ...pixelFields(Uint16Array.from({ length: 12 }, (_, i) => base + i)),
    ...fields,
  };
}

/** The fields of pixels, 4 in a row, as numbers of their own type, little endian. */
export function pixelFields(
  numbers: Uint8Array | Int8Array | Uint16Array | Int16Array | Uint32Array | Int32Array,
  isBigEndian = false,
): DicomFields {
  const bytes = new Uint8Array(numbers.buffer.slice(0));
  const width = numbers.BYTES_PER_ELEMENT;
  if (isBigEndian) for (let at = 0; at < bytes.length; at += width) bytes.subarray(at, at + width).reverse();
  return {
    SamplesPerPixel: [1],
    PhotometricInterpretation: 'MONOCHROME2',
    Rows: [numbers.length / 4],
    Columns: [4],
    BitsAllocated: [8 * width],
    BitsStored: [8 * width],
    HighBit: [8 * width - 1],
    PixelRepresentation: [numbers.constructor.name.startsWith('Int') ? 1 : 0],
    PixelData: bytes,
  };
}

/** A frame of numbers packed by runs: two equal bytes or more are a run, other bytes are single. Source: PS3.5, annex G */
export function packRle(numbers: Uint8Array | Uint16Array | Int16Array): Uint8Array<ArrayBuffer> {
  const width = numbers.BYTES_PER_ELEMENT;
  const bytes = new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
  const segments = Array.from({ length: width }, (_, segment) => {
    const plane = bytes.filter((_byte, i) => i % width === width - 1 - segment);
    const packed: number[] = [];
    for (let at = 0; at < plane.length;) {
      let run = 1;
      while (run < 128 && plane[at + run] === plane[at]) run++;
      packed.push(run > 1 ? 257 - run : 0, plane[at]);
      at += run;
    }
    return packed.length % 2 ? [...packed, 0] : packed;
  });
  let at = 64;
  const starts = segments.map(({ length }) => (at += length) - length);
  const head = [width, ...starts, ...Array.from({ length: 15 - width }, () => 0)];
  return Uint8Array.from([...head.flatMap((number) => numberBytes(number, 4)), ...segments.flat()]);
}

/** An element as DICOMweb servers say it. Source: PS3.18, annex F */
interface JsonElement {
  readonly vr: string;
  readonly Value?: readonly unknown[];
  readonly BulkDataURI?: string;
}

/**
 * The elements as a DICOMweb server lists them: bytes are elsewhere.
 * @param addressOf - where the bytes of an element are, by its digits
 */
export function dicomJson(fields: DicomFields, addressOf: (tag: string) => string): Record<string, JsonElement> {
  const json: Record<string, JsonElement> = {};
  for (const [keyword, value] of Object.entries(fields)) {
    const [id, vr] = dictionary[keyword as Keyword];
    const tag = id.toString(16).padStart(8, '0').toUpperCase();
    if (value === undefined) continue;
    if (value instanceof Uint8Array) json[tag] = { vr, BulkDataURI: addressOf(tag) };
    else json[tag] = { vr, Value: valuesOf(value, vr, addressOf) };
  }
  return json;
}

function valuesOf(
  value: Exclude<DicomValue, Uint8Array>,
  vr: string,
  addressOf: (tag: string) => string,
): readonly unknown[] {
  if (vr === 'SQ') return (value as readonly DicomFields[]).map((item) => dicomJson(item, addressOf));
  if (typeof value !== 'string') return value;
  return value.split('\\').map((one) => (/^(DS|IS)$/.test(vr) ? Number(one) : one));
}

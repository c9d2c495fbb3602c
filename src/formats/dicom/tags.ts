/** An element that is read. Files with implicit value representations do not say what an element holds; then `vr` counts. */
export interface Tag {
  /** 65,536 times its group, plus its number. */
  readonly id: number;
  /** Value representation. */
  readonly vr: string;
}

const tag = (id: number, vr: string): Tag => ({ id, vr });

/**
 * Every element that is read. All others are skipped, and nothing of them is kept.
 * Source: DICOM PS3.6, chapter 6; those of odd groups: the conformance statements of their makers
 */
export const tags = {
  transferSyntax: tag(0x00020010, 'UI'),
  firstRecord: tag(0x00041200, 'UL'),
  characterSet: tag(0x00080005, 'CS'),
  imageType: tag(0x00080008, 'CS'),
  sopClass: tag(0x00080016, 'UI'),
  sopInstance: tag(0x00080018, 'UI'),
  seriesDate: tag(0x00080021, 'DA'),
  acquisitionDate: tag(0x00080022, 'DA'),
  contentDate: tag(0x00080023, 'DA'),
  acquisitionDateTime: tag(0x0008002a, 'DT'),
  seriesTime: tag(0x00080031, 'TM'),
  codeValue: tag(0x00080100, 'SH'),
  acquisitionTime: tag(0x00080032, 'TM'),
  contentTime: tag(0x00080033, 'TM'),
  modality: tag(0x00080060, 'CS'),
  frameType: tag(0x00089007, 'CS'),
  complexPart: tag(0x00089208, 'CS'),
  patientWeight: tag(0x00101030, 'DS'),
  sliceThickness: tag(0x00180050, 'DS'),
  echoTime: tag(0x00180081, 'DS'),
  inversionTime: tag(0x00180082, 'DS'),
  echoNumber: tag(0x00180086, 'IS'),
  spacingBetweenSlices: tag(0x00180088, 'DS'),
  triggerTime: tag(0x00181060, 'DS'),
  frameTime: tag(0x00181063, 'DS'),
  injectionTime: tag(0x00181072, 'TM'),
  totalDose: tag(0x00181074, 'DS'),
  halfLife: tag(0x00181075, 'DS'),
  injectionDateTime: tag(0x00181078, 'DT'),
  imagerPixelSpacing: tag(0x00181164, 'DS'),
  effectiveEchoTime: tag(0x00189082, 'FD'),
  frameDateTime: tag(0x00189074, 'DT'),
  bValue: tag(0x00189087, 'FD'),
  referenceDateTime: tag(0x00189151, 'DT'),
  siemensImages: tag(0x0019100a, 'US'),
  siemensBValue: tag(0x0019100c, 'IS'),
  series: tag(0x0020000e, 'UI'),
  acquisition: tag(0x00200012, 'IS'),
  seriesNumber: tag(0x00200011, 'IS'),
  instance: tag(0x00200013, 'IS'),
  position: tag(0x00200032, 'DS'),
  orientation: tag(0x00200037, 'DS'),
  temporalPosition: tag(0x00200100, 'IS'),
  sliceLocation: tag(0x00201041, 'DS'),
  stack: tag(0x00209056, 'SH'),
  temporalIndex: tag(0x00209128, 'UL'),
  triggerDelay: tag(0x00209153, 'FD'),
  frameAcquisition: tag(0x00209156, 'US'),
  heartPhase: tag(0x00209241, 'FL'),
  breathPhase: tag(0x00209245, 'FL'),
  timeOffset: tag(0x0020930d, 'FD'),
  samplesPerPixel: tag(0x00280002, 'US'),
  photometric: tag(0x00280004, 'CS'),
  planar: tag(0x00280006, 'US'),
  frames: tag(0x00280008, 'IS'),
  frameIncrement: tag(0x00280009, 'AT'),
  rows: tag(0x00280010, 'US'),
  columns: tag(0x00280011, 'US'),
  pixelSpacing: tag(0x00280030, 'DS'),
  correctedImage: tag(0x00280051, 'CS'),
  bitsAllocated: tag(0x00280100, 'US'),
  bitsStored: tag(0x00280101, 'US'),
  highBit: tag(0x00280102, 'US'),
  pixelRepresentation: tag(0x00280103, 'US'),
  paddingValue: tag(0x00280120, 'US'),
  paddingLimit: tag(0x00280121, 'US'),
  burnedIn: tag(0x00280301, 'CS'),
  pixelIntensity: tag(0x00281040, 'CS'),
  windowCenter: tag(0x00281050, 'DS'),
  windowWidth: tag(0x00281051, 'DS'),
  intercept: tag(0x00281052, 'DS'),
  slope: tag(0x00281053, 'DS'),
  rescaleType: tag(0x00281054, 'LO'),
  windowExplanation: tag(0x00281055, 'LO'),
  windowFunction: tag(0x00281056, 'CS'),
  redDescriptor: tag(0x00281101, 'US'),
  redTable: tag(0x00281201, 'OW'),
  greenTable: tag(0x00281202, 'OW'),
  blueTable: tag(0x00281203, 'OW'),
  tableDescriptor: tag(0x00283002, 'US'),
  tableExplanation: tag(0x00283003, 'LO'),
  modalityTableType: tag(0x00283004, 'LO'),
  tableData: tag(0x00283006, 'US'),
  siemensHeader: tag(0x00291010, 'OB'),
  energyWindowVector: tag(0x00540010, 'US'),
  detectorVector: tag(0x00540020, 'US'),
  phaseVector: tag(0x00540030, 'US'),
  intervalVector: tag(0x00540060, 'US'),
  timeSlotVector: tag(0x00540070, 'US'),
  sliceVector: tag(0x00540080, 'US'),
  timeSliceVector: tag(0x00540100, 'US'),
  realWorldIntercept: tag(0x00409224, 'FD'),
  realWorldSlope: tag(0x00409225, 'FD'),
  units: tag(0x00541001, 'CS'),
  frameReferenceTime: tag(0x00541300, 'DS'),
  segmentationType: tag(0x00620001, 'CS'),
  segmentNumber: tag(0x00620004, 'US'),
  segmentLabel: tag(0x00620005, 'LO'),
  referencedSegment: tag(0x0062000b, 'US'),
  segmentColor: tag(0x0062000d, 'US'),
  maxFraction: tag(0x0062000e, 'US'),
  suvType: tag(0x00541006, 'CS'),
  decayCorrection: tag(0x00541102, 'CS'),
  roiNumber: tag(0x30060022, 'IS'),
  roiName: tag(0x30060026, 'LO'),
  roiColor: tag(0x3006002a, 'IS'),
  contourType: tag(0x30060042, 'CS'),
  slabThickness: tag(0x30060044, 'DS'),
  contourData: tag(0x30060050, 'DS'),
  referencedRoi: tag(0x30060084, 'IS'),
  doseOffsets: tag(0x3004000c, 'DS'),
  doseUnits: tag(0x30040002, 'CS'),
  doseScaling: tag(0x3004000e, 'DS'),
} as const;

/** Sequences whose items are read. */
export const sequences = {
  modalityTable: tag(0x00283000, 'SQ'),
  windowTables: tag(0x00283010, 'SQ'),
  rois: tag(0x30060020, 'SQ'),
  roiContours: tag(0x30060039, 'SQ'),
  contours: tag(0x30060040, 'SQ'),
  sharedGroups: tag(0x52009229, 'SQ'),
  frameGroups: tag(0x52009230, 'SQ'),
  echo: tag(0x00189114, 'SQ'),
  heart: tag(0x00189118, 'SQ'),
  diffusion: tag(0x00189117, 'SQ'),
  mrFrameType: tag(0x00189226, 'SQ'),
  ctFrameType: tag(0x00189329, 'SQ'),
  petFrameType: tag(0x00189751, 'SQ'),
  radiopharmaceutical: tag(0x00540016, 'SQ'),
  detector: tag(0x00540022, 'SQ'),
  segments: tag(0x00620002, 'SQ'),
  segmentOfFrame: tag(0x0062000a, 'SQ'),
  frameContent: tag(0x00209111, 'SQ'),
  realWorldUnits: tag(0x004008ea, 'SQ'),
  realWorld: tag(0x00409096, 'SQ'),
  planePosition: tag(0x00209113, 'SQ'),
  planeOrientation: tag(0x00209116, 'SQ'),
  breath: tag(0x00209253, 'SQ'),
  temporalPosition: tag(0x00209310, 'SQ'),
  pixelMeasures: tag(0x00289110, 'SQ'),
  frameWindow: tag(0x00289132, 'SQ'),
  pixelTransformation: tag(0x00289145, 'SQ'),
} as const;

/** The pixels, and what their numbers are. */
export const pixelTags: ReadonlyMap<number, 'integers' | 'float32' | 'float64'> = new Map([
  [0x7fe00008, 'float32'],
  [0x7fe00009, 'float64'],
  [0x7fe00010, 'integers'],
]);

export const itemTags = { item: 0xfffee000, itemEnd: 0xfffee00d, sequenceEnd: 0xfffee0dd } as const;

const byId: ReadonlyMap<number, Tag> = new Map(
  [...Object.values(tags), ...Object.values(sequences)].map((one) => [one.id, one]),
);

/** The element of an id, if it is read. */
export const findTag = (id: number): Tag | undefined => byId.get(id);

/** SOP classes of segmentations, and of those that are label maps. Source: PS3.6, annex A */
export const segmentations: ReadonlySet<string> = new Set([
  '1.2.840.10008.5.1.4.1.1.66.4',
  '1.2.840.10008.5.1.4.1.1.66.7',
]);

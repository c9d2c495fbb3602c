// Frames: the pictures of a file with their places, and what the numbers stand for.
import { cross, dot, length, normalize, scale, add } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { DataSet } from './data-set.ts';
import { findFlat } from './flat-pictures.ts';
import type { FlatPicture } from './flat-pictures.ts';
import type { Frame, Plane } from './frame.ts';
import type { Picture } from './picture.ts';
import { findRealWorld } from './real-world.ts';
import { findMosaic } from './siemens-mosaic.ts';
import { findSuvFactor } from './suv.ts';
import { sequences, tags } from './tags.ts';
import { readFrameVector, readTraits, readVectors } from './traits.ts';
import type { Find, FrameVectors } from './traits.ts';
import { readRegionSpacing } from './ultrasound.ts';
import { readValueTable } from './value-table.ts';
import { readWindows } from './windows.ts';

/** The frames of a picture. */
export function listFrames(picture: Picture): Frame[] {
  const { set, frames, columns, rows } = picture;
  const offsets = set.numbers(tags.doseOffsets);
  const vectors = readVectors(picture);
  const isPlaced = hasOwnPlaces(set);
  const flatOf = isPlaced ? null : findFlat(picture);
  const known = { vectors, detectorOf: findDetectors(picture, flatOf !== null) };
  const mosaic = findMosaic(picture);
  if (mosaic) {
    const frame = describeFrame(picture, 0, known);
    return mosaic.place(frame).map(({ corner, position }, i) => ({
      ...frame,
      ...mosaic.size,
      corner,
      position,
      order: [...frame.order.slice(0, -1), i],
    }));
  }
  return Array.from({ length: frames }, (_, index) => {
    const frame = describeFrame(picture, index, known);
    const size = { ...frame, columns, rows };
    if (flatOf) return asFlat(size, flatOf(index));
    if (frames === 1 || isPlaced || !frame.position || !frame.plane) return size;
    // All frames have the place of the first one, and the file says how far the others are from it.
    const slice = vectors.slices.length > 0 ? vectors.slices[index] - 1 : index;
    const along =
      offsets.length >= frames
        ? doseSign(offsets[0], frame.position, frame.plane) * (offsets[index] - offsets[0])
        : slice * (signedStep(set) ?? frame.step ?? NaN);
    const position = Number.isFinite(along) ? add(frame.position, scale(frame.plane.normal, along)) : null;
    return { ...size, position };
  });
}

/**
 * Offsets of a dose run along the normal where the first one is 0. Where it is the z of the first frame, and slices are axial, they are the
 * z of each. Source: PS3.3, C.8.8.3.2
 */
function doseSign(first: number, position: Vector3, { normal }: Plane): number {
  const areHeights = first !== 0 && Math.abs(first - position[2]) < sameHeight && Math.abs(normal[2]) > axial;
  return areHeights ? Math.sign(normal[2]) : 1;
}

/** In mm: files round both. Cosine of a quarter of a degree. */
const [sameHeight, axial] = [0.01, 1 - 1e-5];

/** Nuclear medicine counts against the normal where the spacing is negative. Source: PS3.3, C.8.4.15 */
const signedStep = (set: DataSet): number | undefined => set.number(tags.spacingBetweenSlices);

/** Nobody knows where a camera stood that was turned. */
const asFlat = (frame: Frame, flat: FlatPicture): Frame =>
  flat.isTurned ? { ...frame, flat, position: null, plane: null } : { ...frame, flat };

/** Whether the file says of each frame where it lies. One place for all of them is that of each. */
function hasOwnPlaces(set: DataSet): boolean {
  return [...set.items(sequences.sharedGroups), ...set.items(sequences.frameGroups)].some(
    (item) => item.items(sequences.planePosition).length > 0 || item.items(sequences.volumePosition).length > 0,
  );
}

/** Finds an element: among those of the frame, among those that all frames share, among those of the file. */
function finder({ set }: Picture, index: number, detector: DataSet | undefined): Find {
  const own = set.items(sequences.frameGroups)[index] as DataSet | undefined;
  const shared = set.items(sequences.sharedGroups)[0] as DataSet | undefined;
  return (group, tag) => {
    for (const one of [own, shared]) {
      const found = group && one?.items(group)[0];
      if (found?.has(tag)) return found;
    }
    return detector?.has(tag) && !set.has(tag) ? detector : set;
  };
}

/** By the number of a frame, the detector that says where it is. What was reconstructed of several has the place of the first one. */
function findDetectors(picture: Picture, isFlat: boolean): (index: number) => DataSet | undefined {
  const detectors = picture.set.items(sequences.detector);
  const numbers = isFlat && detectors.length > 1 ? readFrameVector(picture, tags.detectorVector) : [];
  return (index) => detectors[(numbers[index] ?? 1) - 1];
}

function describeFrame(
  picture: Picture,
  index: number,
  { vectors, detectorOf }: { vectors: FrameVectors; detectorOf: (index: number) => DataSet | undefined },
): Frame {
  const { set, columns, rows } = picture;
  const find = finder(picture, index, detectorOf(index));
  const imageType = set.texts(tags.imageType);
  const values = readValues(picture, index, find);
  return {
    picture,
    index,
    columns,
    rows,
    corner: [0, 0],
    series: set.text(tags.series),
    seriesNumber: readSeriesNumber(set),
    isLocalizer: imageType.includes('LOCALIZER'),
    ...readPlace(find),
    spacing: readSpacing(find) ?? readRegionSpacing(picture),
    aspect: readAspect(set),
    step: readStep(find),
    thickness: Math.abs(find(sequences.pixelMeasures, tags.sliceThickness).number(tags.sliceThickness) ?? 0) || null,
    stack: find(sequences.frameContent, tags.stack).text(tags.stack),
    order: [set.number(tags.sliceLocation) ?? 0, set.number(tags.instance) ?? 0, index],
    ...values,
    flat: null,
    traits: readTraits(picture, index, find, vectors),
  };
}

/** Scanners count from 1. A larger number may be anything, such as a date of birth. */
function readSeriesNumber(set: DataSet): number | undefined {
  const number = set.number(tags.seriesNumber);
  return number !== undefined && Number.isInteger(number) && number >= 0 && number < 1e5 ? number : undefined;
}

function readVector([x, y, z]: readonly number[]): Vector3 | null {
  return Number.isFinite(x + y + z) ? [x, y, z] : null;
}

/** Ultrasound in three dimensions may say its places only within its volume. Source: PS3.3, C.7.6.16.2.21 and C.7.6.16.2.22 */
function readPlace(find: Find): Pick<Frame, 'position' | 'plane' | 'ofPatient'> {
  const position = readVector(find(sequences.planePosition, tags.position).numbers(tags.position));
  const plane = readPlane(find(sequences.planeOrientation, tags.orientation).numbers(tags.orientation));
  const { volumePosition, volumeOrientation } = tags;
  const place = readVector(find(sequences.volumePosition, volumePosition).numbers(volumePosition));
  if (position || !place) return { position, plane, ofPatient: true };
  const found = find(sequences.volumeOrientation, volumeOrientation).numbers(volumeOrientation);
  return { position: place, plane: readPlane(found), ofPatient: false };
}

function readPlane(numbers: readonly number[]): Plane | null {
  const [row, column] = [readVector(numbers), readVector(numbers.slice(3))];
  if (!row || !column) return null;
  const normal = cross(row, column);
  // Vectors of length 0, or along one line, give no plane.
  if (!(length(normal) > 0.5 && Math.abs(dot(row, column)) < 0.1)) return null;
  return { row: normalize(row), column: normalize(column), normal: normalize(normal) };
}

/** The file has the distance of rows first. */
function readSpacing(find: Find): readonly [number, number] | null {
  for (const tag of [tags.pixelSpacing, tags.imagerPixelSpacing, tags.scannedSpacing, tags.planeSpacing]) {
    const [y, x = y] = find(sequences.pixelMeasures, tag).numbers(tag);
    if (x > 0 && y > 0 && Number.isFinite(x + y)) return [x, y];
  }
  return null;
}

/** Height and width of a pixel as a ratio. Source: PS3.3, C.7.6.3.1.7 */
function readAspect(set: DataSet): number {
  const [height, width] = set.numbers(tags.pixelAspect);
  return height > 0 && width > 0 ? height / width : 1;
}

function readStep(find: Find): number | null {
  for (const tag of [tags.spacingBetweenSlices, tags.sliceThickness]) {
    const step = Math.abs(find(sequences.pixelMeasures, tag).number(tag) ?? 0);
    if (step > 0) return step;
  }
  return null;
}

function readValues(
  picture: Picture,
  index: number,
  find: Find,
): Pick<Frame, 'table' | 'slope' | 'intercept' | 'unit' | 'windows'> {
  const { set, isInverted, isSigned, bitsStored, colors } = picture;
  if (colors) return { table: null, slope: 1, intercept: 0, unit: '', windows: () => ({ windows: [], left: [] }) };
  const modality = set.text(tags.modality).toUpperCase();
  const rescale = find(sequences.pixelTransformation, tags.slope);
  const table = readValueTable(picture);
  const isRescaled = table !== null || rescale.has(tags.slope) || set.has(tags.doseScaling);
  const real = isRescaled ? null : findRealWorld(picture, index);
  // The table is in place of slope and intercept, also where a file has both.
  const stated = table
    ? table.type === 'HU'
      ? 'HU'
      : ''
    : readUnit(set, rescale, modality, set.texts(tags.imageType)) || (real?.unit ?? '');
  const suv = modality === 'PT' && stated === 'Bq/ml' ? findSuvFactor(set) : null;
  const [unit, factor] = suv ? ['SUV', suv] : [stated, 1];
  const slope = table
    ? 1
    : factor *
      ((modality === 'RTDOSE' ? set.number(tags.doseScaling) : (real?.slope ?? rescale.number(tags.slope))) || 1);
  const intercept = table ? 0 : factor * (real?.intercept ?? rescale.number(tags.intercept) ?? 0);
  const windowsOf = (mirror: number | null): Frame['windows'] => {
    const isNegative = table === null && (isSigned || (intercept < 0 && !real));
    return () => readWindows(find(sequences.frameWindow, tags.windowCenter), set, { factor, mirror, isNegative, real });
  };
  // Where values have a unit, white for the smallest one is only a way to show them.
  if (!isInverted || unit !== '') return { table, slope, intercept, unit, windows: windowsOf(null) };
  const turned = table ? table.largest : isSigned ? -1 : 2 ** bitsStored - 1;
  return {
    table,
    slope: -slope,
    intercept: slope * turned + intercept,
    unit,
    windows: windowsOf(slope * turned + 2 * intercept),
  };
}

/** Units that are known by their code. Source: PS3.3, C.8.9.1.1.3 */
const petUnits: Readonly<Record<string, string>> = {
  BQML: 'Bq/ml',
  GML: 'g/ml',
  CNTS: 'counts',
  CPS: 'counts/s',
  PROPCPS: 'counts/s',
};

function readUnit(set: DataSet, rescale: DataSet, modality: string, imageType: readonly string[]): string {
  const type = rescale.text(tags.rescaleType).toUpperCase();
  if (modality === 'CT') {
    const isScaled = rescale.has(tags.intercept) && !imageType.includes('LOCALIZER');
    return isScaled && (type === '' || type === 'HU') ? 'HU' : '';
  }
  if (modality === 'PT') {
    const units = set.text(tags.units).toUpperCase();
    return units === 'GML' && /^(BW)?$/i.test(set.text(tags.suvType)) ? 'SUV' : (petUnits[units] ?? '');
  }
  if (modality === 'RTDOSE') return set.text(tags.doseUnits).toUpperCase() === 'GY' ? 'Gy' : '';
  return '';
}

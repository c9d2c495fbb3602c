// Structure sets (RTSTRUCT): contours around regions, which become labels. Loaded with the first of them. Source: PS3.3, C.8.8.6
import { add, cross, dot, normalize, scale, subtract } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { unsupportedFile } from '../base/file-problem.ts';
import type { ReadContext } from '../base/format.ts';
import { listContours } from './contours.ts';
import type { Contour } from './contours.ts';
import { fillPolygons } from './fill-polygons.ts';
import type { Polygon } from './fill-polygons.ts';
import type { Plane } from './frame.ts';
import { count } from './group-frames.ts';
import { labelVolume, startLabels } from './label-volume.ts';
import { placeSegments } from './place-segments.ts';
import type { LabelSlice } from './place-segments.ts';
import type { DicomFile } from './read-file.ts';

const what = 'the DICOM structure set';

/** Points may be so far from the plane of their contour, and contours of one plane from each other, mm. */
const [flat, samePlace] = [0.1, 0.05];

/** A normal that is nearer to an axis than this is the axis: files round places to hundredths of a millimetre. */
const nearAxis = 1e-3;

/**
 * Pixels are as fine as this many voxels allow, and no finer than this share of the distance of two planes, in which nothing is known
 * either. A file does not say the pixels that its contours were drawn on.
 */
const [maxVoxels, finest] = [2 ** 24, 1 / 8];

/** Of a single plane: this share of the size of all contours. */
const finestAlone = 1 / 512;

/** So many regions with gaps are said one by one. */
const maxListed = 8;

/**
 * Reads contours as labels, on a grid of their own: a voxel has the label of a region where its middle is inside its contours. Nothing of
 * the file becomes text but the names of its regions, which are those of labels.
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 */
export function readContours({ set }: DicomFile, { budget, onProgress }: ReadContext): DecodedCartesianVolume {
  const { contours, named, left: unread } = listContours(set, budget, what);
  if (contours.length === 0)
    throw unsupportedFile(what, 'has no closed contours; expected CLOSED_PLANAR ones, which are around a region');
  const plane = findPlane(contours);
  const { planes, askew } = sortIntoPlanes(contours, plane);
  if (planes.length === 0) throw unsupportedFile(what, 'has no flat contours; expected some in parallel planes');
  const { slices, origin, pixel } = layGrid(planes, plane);
  const placed = placeSegments(slices, what);
  const { dimensions } = placed;
  const [columns, rows] = dimensions;
  const painter = startLabels(dimensions, Math.max(...named.map(({ id }) => id)), budget, what);
  const covered = new Map<number, Set<number>>();
  const areas = sumAreas(contours);
  const jobs = planes.flatMap(({ ofLabels }, i) =>
    Array.from(ofLabels, ([id, own]) => ({ id, own, at: placed.slicesOf(slices[i]) })),
  );
  // The largest region first, as one lies in the other: a tumour in its organ, this in the body. What comes later is seen.
  jobs.sort((a, b) => areas.get(b.id)! - areas.get(a.id)! || a.id - b.id);
  for (const [done, { id, own, at }] of jobs.entries()) {
    onProgress(done, jobs.length);
    const bytes = own.reduce((sum, { points }) => sum + (points.byteLength * 2) / 3, 0);
    budget.take(bytes, what);
    const polygons = own.map(({ points }) => toGrid(points, plane, { origin, pixel }));
    const seen = covered.get(id) ?? new Set<number>();
    covered.set(id, seen);
    const paint = (row: number, begin: number, end: number): void => {
      budget.step((at.length * (end - begin)) / 2, what);
      for (const k of at) {
        const start = (k * rows + row) * columns;
        for (let i = begin; i < end; i++) painter.paint(start + i, id);
        seen.add(k);
      }
    };
    fillPolygons(polygons, { columns, rows }, { budget, what }, paint);
    budget.giveBack(bytes);
  }
  const left = [
    ...unread,
    ...(askew > 0 ? [`${count(askew, 'contour')} not flat, or of another orientation than the largest one`] : []),
    ...placed.left,
    ...describeGaps(covered),
    ...painter.describeHidden((id) => `region ${id}`),
  ];
  return labelVolume(placed, painter, { format: 'DICOM, RTSTRUCT', named, left });
}

/** The orientation of the contour around the largest area. */
function findPlane(contours: readonly Contour[]): Plane {
  let [normal, largest]: [Vector3, number] = [[0, 0, 1], 0];
  for (const { points } of contours) {
    const area = areaOf(points);
    const size = dot(area, area);
    if (size > largest) [normal, largest] = [area, size];
  }
  let axis = normalize(normal);
  const main = [0, 1, 2].reduce((best, i) => (Math.abs(axis[i]) > Math.abs(axis[best]) ? i : best));
  if (axis[main] < 0) axis = scale(axis, -1);
  const unit: Vector3 = [Number(main === 0), Number(main === 1), Number(main === 2)];
  if (axis.every((one, i) => Math.abs(one - unit[i]) < nearAxis)) axis = unit;
  const along: Vector3 = main === 0 ? [0, 1, 0] : [1, 0, 0];
  const row = normalize(subtract(along, scale(axis, dot(along, axis))));
  return { row, column: cross(axis, row), normal: axis };
}

/** Of each label the area inside all its contours, those of holes too: twice, in mm^2. */
function sumAreas(contours: readonly Contour[]): ReadonlyMap<number, number> {
  const areas = new Map<number, number>();
  for (const { id, points } of contours) {
    const area = areaOf(points);
    areas.set(id, (areas.get(id) ?? 0) + Math.sqrt(dot(area, area)));
  }
  return areas;
}

/** A vector along the normal of a closed line, as long as twice the area. Source: Newell's method */
function areaOf(points: Float64Array): Vector3 {
  const sum: [number, number, number] = [0, 0, 0];
  const n = points.length;
  for (let at = 0; at < n; at += 3) {
    const after = (at + 3) % n;
    for (let axis = 0; axis < 3; axis++) {
      const [b, c] = [(axis + 1) % 3, (axis + 2) % 3];
      sum[axis] += (points[at + b] - points[after + b]) * (points[at + c] + points[after + c]);
    }
  }
  return sum;
}

interface ContourPlane {
  /** Along the normal, mm. */
  readonly place: number;
  readonly ofLabels: ReadonlyMap<number, readonly Contour[]>;
}

/** The planes in ascending order, and how many contours lie in none. */
function sortIntoPlanes(
  contours: readonly Contour[],
  { normal }: Plane,
): { readonly planes: readonly ContourPlane[]; readonly askew: number } {
  const flatOnes: { contour: Contour; place: number }[] = [];
  for (const contour of contours) {
    let [low, high] = [Infinity, -Infinity];
    for (let at = 0; at < contour.points.length; at += 3) {
      const place = dot(pointAt(contour.points, at), normal);
      [low, high] = [Math.min(low, place), Math.max(high, place)];
    }
    if (high - low <= flat) flatOnes.push({ contour, place: (low + high) / 2 });
  }
  flatOnes.sort((a, b) => a.place - b.place);
  const planes: { place: number; ofLabels: Map<number, Contour[]> }[] = [];
  for (const { contour, place } of flatOnes) {
    if (planes.length === 0 || place - planes[planes.length - 1].place > samePlace)
      planes.push({ place, ofLabels: new Map() });
    const { ofLabels } = planes[planes.length - 1];
    const own = ofLabels.get(contour.id);
    if (own) own.push(contour);
    else ofLabels.set(contour.id, [contour]);
  }
  return { planes, askew: contours.length - flatOnes.length };
}

const pointAt = (points: Float64Array, at: number): Vector3 => [points[at], points[at + 1], points[at + 2]];

/** Pixels over all contours, with one slice for each plane. */
function layGrid(
  planes: readonly ContourPlane[],
  plane: Plane,
): { readonly slices: readonly LabelSlice[]; readonly origin: readonly [number, number]; readonly pixel: number } {
  const all = planes.flatMap(({ ofLabels }) => [...ofLabels.values()].flat());
  const [low, high] = [
    [Infinity, Infinity],
    [-Infinity, -Infinity],
  ];
  for (const { points } of all)
    for (let at = 0; at < points.length; at += 3) {
      const point = pointAt(points, at);
      for (const [axis, direction] of [plane.row, plane.column].entries()) {
        const along = dot(point, direction);
        low[axis] = Math.min(low[axis], along);
        high[axis] = Math.max(high[axis], along);
      }
    }
  const size = [high[0] - low[0], high[1] - low[1]];
  const steps = planes.slice(1).map(({ place }, i) => place - planes[i].place);
  const thickness = all.find((one) => one.thickness !== null && one.thickness > 0)?.thickness ?? null;
  const step = steps.length > 0 ? Math.min(...steps) : thickness;
  const slabs = steps.length > 0 ? Math.round((planes[planes.length - 1].place - planes[0].place) / step!) + 1 : 1;
  const pixel =
    Math.max(
      Math.sqrt((size[0] * size[1] * slabs) / maxVoxels),
      steps.length > 0 ? step! * finest : 0,
      Math.max(...size) * (steps.length > 0 ? 2 ** -11 : finestAlone),
    ) || 1;
  const [columns, rows] = size.map((length) => Math.max(1, Math.ceil(length / pixel)));
  const origin = [(low[0] + high[0] - (columns - 1) * pixel) / 2, (low[1] + high[1] - (rows - 1) * pixel) / 2] as const;
  const corner = add(scale(plane.row, origin[0]), scale(plane.column, origin[1]));
  const slices = planes.map(({ place }): LabelSlice => ({
    plane,
    columns,
    rows,
    spacing: [pixel, pixel],
    step: thickness,
    position: add(corner, scale(plane.normal, place)),
  }));
  return { slices, origin, pixel };
}

function toGrid(
  points: Float64Array,
  { row, column }: Plane,
  { origin, pixel }: { readonly origin: readonly [number, number]; readonly pixel: number },
): Polygon {
  const polygon = new Float64Array((points.length / 3) * 2);
  for (let at = 0, to = 0; at < points.length; at += 3) {
    const point = pointAt(points, at);
    polygon[to++] = (dot(point, row) - origin[0]) / pixel;
    polygon[to++] = (dot(point, column) - origin[1]) / pixel;
  }
  return polygon;
}

/** Regions that have no contour in some planes between others: nothing is put there. */
function describeGaps(covered: ReadonlyMap<number, ReadonlySet<number>>): string[] {
  const gaps = Array.from(covered, ([id, slices]) => {
    if (slices.size === 0) return { id, all: 0, missing: 0 };
    let [first, last] = [Infinity, -Infinity];
    for (const k of slices) [first, last] = [Math.min(first, k), Math.max(last, k)];
    const all = last - first + 1;
    return { id, all, missing: all - slices.size };
  }).filter(({ missing }) => missing > 0);
  const tiny = Array.from(covered).filter(([, slices]) => slices.size === 0).length;
  return [
    ...(tiny > 0 ? [`${tiny} region${tiny === 1 ? '' : 's'} so small that the middle of no voxel lies inside`] : []),
    ...gaps
      .slice(0, maxListed)
      .map(
        ({ id, all, missing }) =>
          `region ${id} has no contour in ${missing} of the ${all} planes from its first to its last one, and no label there`,
      ),
    ...(gaps.length > maxListed ? [`the same for ${gaps.length - maxListed} other regions`] : []),
  ];
}

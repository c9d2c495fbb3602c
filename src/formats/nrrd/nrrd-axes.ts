import type { Vector3 } from '../../volume/matrix.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { needField, readCount, what } from './nrrd-header.ts';
import type { NrrdFields } from './nrrd-header.ts';

/** One axis of the array, the fastest first. */
export interface NrrdAxis {
  readonly size: number;
  /** '' if the header does not say it. */
  readonly kind: string;
  /** One step along it in the header's space; null if it is not given, 'none' if the axis does not lie in space. */
  readonly direction: Vector3 | 'none' | null;
  /** Length of a step, if there is no direction. */
  readonly spacing: number;
  /** Whether the header says it; else it is 1. */
  readonly isSpaced: boolean;
  /** Position of its first sample, from the axis' own range; 0 if it is not given. */
  readonly first: number;
  readonly unit: string;
}

/** @throws {VolumeViewError} `format/corrupt`, `format/unsupported` */
export function readAxes(fields: NrrdFields): NrrdAxis[] {
  needField(fields, 'dimension');
  const dimension = readCount(fields, 'dimension', 1);
  if (dimension > 16) throw corruptFile(what, `got ${dimension} axes; expected 1 to 16`);
  const each = (name: string, split: (text: string) => string[]): string[] => {
    const text = fields.get(name);
    const list = text === undefined ? [] : split(text);
    if (text !== undefined && list.length !== dimension)
      throw corruptFile(what, `got ${list.length} ${name} "${text.slice(0, 60)}"; expected ${dimension}, one an axis`);
    return list;
  };
  needField(fields, 'sizes');
  const sizes = each('sizes', words);
  const kinds = each('kinds', words);
  const directions = each('spacedirections', splitVectors);
  const spacings = each('spacings', words);
  const units = each('units', quoted);
  const [mins, maxs, centers] = ['axismins', 'axismaxs', 'centers'].map((name) => each(name, words));
  return sizes.map((size, axis) => ({
    size: readSize(size),
    kind: (kinds[axis] ?? '').toLowerCase().replace(/^(none|\?\?\?)$/, ''),
    direction: directions[axis] === undefined ? null : readDirection(directions[axis]),
    ...readRange(readSize(size), spacings[axis], {
      min: mins[axis],
      max: maxs[axis],
      isNode: /^node$/i.test(centers[axis] ?? ''),
    }),
    unit: units[axis] ?? '',
  }));
}

const words = (text: string): string[] => text.split(/\s+/);
export const splitVectors = (text: string): string[] => text.match(/none|\([^)]*\)/gi) ?? [];
export const quoted = (text: string): string[] =>
  Array.from(text.matchAll(/"((?:[^"\\]|\\.)*)"/g), ([, inner]) => inner);

function readSize(text: string): number {
  const size = Number(text);
  if (/^\d+$/.test(text) && size >= 1 && Number.isSafeInteger(size)) return size;
  throw corruptFile(what, `got the size "${text.slice(0, 40)}"; expected a whole number from 1`);
}

/** A spacing that is not given, or 'nan', is 1. */
function readSpacing(text: string | undefined): number {
  if (text === undefined || /^nan$/i.test(text)) return 1;
  const spacing = Number(text);
  if (Number.isFinite(spacing) && spacing !== 0) return spacing;
  throw corruptFile(what, `got the spacing "${text.slice(0, 40)}"; expected a number other than 0`);
}

/**
 * An axis' own range goes from the first sample to the last one if the samples are nodes, else around their cells. It
 * gives the spacing if nothing else does.
 * Source: *Definition of NRRD File Format*, "axis mins", "centers"; Teem's nrrdOriginCalculate treats samples of
 * unknown centering as cells
 */
function readRange(
  size: number,
  spacingText: string | undefined,
  { min, max, isNode }: { readonly min?: string; readonly max?: string; readonly isNode: boolean },
): Pick<NrrdAxis, 'spacing' | 'isSpaced' | 'first'> {
  const [low, high] = [min, max].map((text) => Number(text ?? NaN));
  const isSaid = spacingText !== undefined && !/^nan$/i.test(spacingText);
  const computed = (high - low) / (isNode ? size - 1 : size);
  const isComputed = !isSaid && Number.isFinite(computed) && computed !== 0;
  const spacing = isComputed ? computed : readSpacing(spacingText);
  return {
    spacing,
    isSpaced: isSaid || isComputed,
    first: Number.isFinite(low) ? low + (isNode ? 0 : spacing / 2) : 0,
  };
}

/** A fourth number belongs to time and is ignored. An axis without a direction in space is one of time. */
function readDirection(text: string): Vector3 | 'none' {
  if (/^none$/i.test(text)) return 'none';
  const vector = readVector(text);
  return vector.every((n) => n === 0) ? 'none' : vector;
}

/** '(1, 0, 0)'; numbers that a space of fewer dimensions lacks are 0. */
export function readVector(text: string): Vector3 {
  const numbers = text
    .replace(/[()]/g, '')
    .split(',')
    .map((part) => (part.trim() === '' ? NaN : Number(part)));
  if (numbers.every(Number.isFinite) && numbers.length >= 1 && numbers.length <= 4)
    return [numbers[0], numbers[1] ?? 0, numbers[2] ?? 0];
  throw corruptFile(what, `got the vector "${text.slice(0, 60)}"; expected numbers such as (1,0,0)`);
}

/** The error for voxels of more than one number, or null. */
function refuseKind(kind: string): string | null {
  if (/color/.test(kind)) return 'colours: a transfer function needs one number per voxel';
  if (/complex|vector|normal|gradient|quaternion|matrix/.test(kind))
    return `several numbers per voxel (${kind}): a transfer function needs one`;
  return null;
}

/** How a volume lies in the array. */
export interface NrrdLayout {
  readonly dimensions: Vector3;
  /** Samples from one voxel to the next along each of the three axes. */
  readonly strides: Vector3;
  /** The axes that lie in space, at most three. */
  readonly axes: readonly NrrdAxis[];
  /** Number of volumes in the array; the first is shown. */
  readonly volumes: number;
}

/**
 * Chooses the axes that lie in space. Of the others (lists, time, more than three) the first entry is used.
 * @throws {VolumeViewError} `format/unsupported`, `format/corrupt`
 */
export function chooseAxes(all: readonly NrrdAxis[]): NrrdLayout {
  const isSpatial = ({ direction, kind }: NrrdAxis): boolean =>
    direction === null ? /^(|domain|space)$/.test(kind) : direction !== 'none';
  const strides: number[] = [];
  all.reduce((stride, { size }) => (strides.push(stride), stride * size), 1);
  const spatial = all.flatMap((axis, i) => (isSpatial(axis) ? [i] : [])).slice(0, 3);
  if (spatial.length === 0)
    throw corruptFile(what, 'got no axis that lies in space; expected kinds "domain" or "space" for one to three');
  const others = all.filter((_, i) => !spatial.includes(i));
  for (const { size, kind } of others) {
    const refused = size > 1 ? refuseKind(kind) : null;
    if (refused) throw unsupportedFile('the NRRD file', `holds ${refused}; convert it to one number per voxel first`);
  }
  const pick = (values: readonly number[]): Vector3 => [
    values[spatial[0]],
    values[spatial[1]] ?? 1,
    values[spatial[2]] ?? 1,
  ];
  return {
    dimensions: pick(all.map(({ size }) => size)),
    strides: pick(strides),
    axes: spatial.map((i) => all[i]),
    volumes: others.reduce((product, { size }) => product * size, 1),
  };
}

/** Where each of the array's volumes begins, samples. */
export function listVolumes(all: readonly NrrdAxis[], { axes }: NrrdLayout): number[] {
  let [starts, stride] = [[0], 1];
  for (const axis of all) {
    const step = stride;
    if (!axes.includes(axis))
      starts = Array.from({ length: axis.size }, (_, i) => starts.map((start) => start + i * step)).flat();
    stride *= axis.size;
  }
  return starts;
}

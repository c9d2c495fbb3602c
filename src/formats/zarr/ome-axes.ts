import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { millimetresOf } from '../base/length-units.ts';
import { isObject, listOf, objectOf } from './read-json.ts';

/** What the axes of an image stand for. */
export interface OmeAxes {
  readonly count: number;
  /** Which of them is i (x), j (y) and k (z); null for an image without z. */
  readonly space: readonly [number, number, number | null];
  /** Which of them is time, and which the channel; null where there is none. */
  readonly time: number | null;
  readonly channel: number | null;
  /** Millimetres of the unit of x, y and z; undefined where one of them is not known. */
  readonly millimetres: readonly [number, number, number] | undefined;
  readonly timeUnit: unknown;
  /** 1 or -1 for x, y and z: the direction of the world (to the right, the front, the head) in which each counts up. */
  readonly signs: readonly [number, number, number];
  /** Whether the file says that the axes are a patient's. */
  readonly anatomical: boolean;
}

const what = 'the metadata of the OME-Zarr';

/** Names and types of the axes of files that do not say them: OME-Zarr 0.1 and 0.2. */
const usual = ['t', 'c', 'z', 'y', 'x'];

/** The directions of the world, x to the right, y to the front, z to the head. Source: RFC-4 of OME-NGFF */
const directions: Readonly<Record<string, readonly [axis: number, sign: number]>> = {
  'left-to-right': [0, 1],
  'right-to-left': [0, -1],
  'posterior-to-anterior': [1, 1],
  'anterior-to-posterior': [1, -1],
  'inferior-to-superior': [2, 1],
  'superior-to-inferior': [2, -1],
};

/**
 * Reads the axes of an image. Where no direction is said, x and y count as the columns and rows of an image, as for all images without a
 * place: to the left and to the back of the world.
 * @param list - `axes` of a multiscale; undefined for old files and plain arrays @param count - axes of the arrays
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`
 */
export function readAxes(list: unknown, count: number): OmeAxes {
  const axes = listOf(list).length > 0 ? listOf(list).map(describe) : usual.slice(-count).map((name) => describe(name));
  if (axes.length !== count)
    throw corruptFile(what, `has ${axes.length} axes, and its arrays have ${count}; expected as many`);
  const find = (type: string, name: string): number[] =>
    axes.flatMap((axis, i) => (axis.type === type || (axis.type === '' && axis.name === name) ? [i] : []));
  const inSpace = axes.flatMap((axis, i) => (isSpace(axis) ? [i] : []));
  const [times, channels] = [find('time', 't'), find('channel', 'c')];
  const others = count - inSpace.length - times.length - channels.length;
  if (inSpace.length < 2 || inSpace.length > 3 || times.length > 1 || channels.length > 1 || others > 0)
    throw unsupportedFile(
      what,
      `has ${inSpace.length} axes of space, ${times.length} of time, ${channels.length} of channels and ${others} others; expected x and y, or x, y and z, with time and channel at most once`,
    );
  const space = orderSpace(axes, inSpace);
  const spaceAxes = space.map((axis) => (axis === null ? null : axes[axis]));
  const lengths = spaceAxes.map((axis) => (axis ? millimetresOf(axis.unit) : 1));
  const found = spaceAxes.map((axis) =>
    axis && Object.hasOwn(directions, axis.direction) ? directions[axis.direction] : null,
  );
  const isPatient = found.every((one, i) => one?.[0] === i);
  return {
    count,
    space,
    time: times[0] ?? null,
    channel: channels[0] ?? null,
    millimetres: lengths.every((one) => one !== undefined) ? (lengths as [number, number, number]) : undefined,
    timeUnit: times.length > 0 ? axes[times[0]].unit : undefined,
    signs: isPatient ? (found.map((one) => one![1]) as [number, number, number]) : [-1, -1, 1],
    anatomical: isPatient,
  };
}

interface Axis {
  readonly name: string;
  readonly type: string;
  readonly unit: unknown;
  readonly direction: string;
}

function describe(axis: unknown): Axis {
  // Version 0.3 has only names.
  if (typeof axis === 'string') return { name: axis.toLowerCase(), type: '', unit: undefined, direction: '' };
  const { name, type, unit, orientation } = isObject(axis) ? axis : {};
  const word = (value: unknown): string => (typeof value === 'string' ? value.toLowerCase() : '');
  return { name: word(name), type: word(type), unit, direction: word(objectOf(orientation).value) };
}

const isSpace = ({ name, type }: Axis): boolean => type === 'space' || (type === '' && ['x', 'y', 'z'].includes(name));

/** By their names; else the last one is x, and the first one z. */
function orderSpace(axes: readonly Axis[], inSpace: readonly number[]): [number, number, number | null] {
  const byName = ['x', 'y', 'z'].map((name) => inSpace.find((i) => axes[i].name === name));
  const isNamed =
    inSpace.length === byName.filter((one) => one !== undefined).length &&
    byName[0] !== undefined &&
    byName[1] !== undefined;
  if (isNamed) return [byName[0]!, byName[1]!, byName[2] ?? null];
  const last = inSpace.length - 1;
  return [inSpace[last], inSpace[last - 1], inSpace[last - 2] ?? null];
}

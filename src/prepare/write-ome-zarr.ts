import { VolumeViewError } from '../core/errors.ts';
import { buildPyramid, copyBrick } from '../bricks/pyramid.ts';
import type { Pyramid } from '../bricks/pyramid.ts';
import { blockOfResiduals, measureResiduals } from '../bricks/residuals.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Samples } from '../volume/samples.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import { ErrorSum } from './measure-error.ts';
import type { ValueError } from './measure-error.ts';
import { orderAxes } from './order-axes.ts';
import { jsonOf, writeArray } from './zarr-arrays.ts';
import type { ArrayData, ArrayLayout, StoreFile } from './zarr-arrays.ts';

/** Voxels of a chunk along each axis. */
const side = 32;

/** Binary digits that numbers of what the levels hide have after their first one: with all of them, packed files are twice as long. */
const digits = 4;

/** Chunks of a shard along each axis: 256 voxels. */
const chunksPerShard = 8;

/** The group with what the levels hide: see docs/guide/prepare.md. */
export const residualsGroup = 'volume-view';

/** Numbers as they are written, and the value of 0 of them. */
interface Written {
  readonly samples: Samples;
  readonly offset: number;
  readonly type: 'uint8' | 'int8' | 'uint16' | 'int16' | 'int32' | 'float32';
  /** What rounding to this type changes, in data values. */
  readonly error: ValueError;
}

/** A volume that is ready to be written. */
export interface OmeZarr {
  /** Of a number. */
  readonly bits: number;
  /** Of the finest level. */
  readonly error: ValueError;
  /** One after the other, so that only one shard is held in addition to the volume and its levels. */
  readonly files: Iterable<StoreFile>;
}

/**
 * A volume as OME-Zarr 0.5: a pyramid of means whose voxels are where they are at each level, in shards, and next to it what each
 * level hides.
 * @param pack - gzip
 * @throws {VolumeViewError} `format/unsupported` for what OME-Zarr can't say: places that are turned, labels, channels and radars
 */
export function makeOmeZarr(volume: Volume, pack: ArrayLayout['pack']): OmeZarr {
  refuseOthers(volume);
  const { grid, samples } = orderAxes(volume);
  const axes = describeAxes(grid, volume.anatomical === true);
  const written = chooseNumbers({ ...volume, samples });
  return {
    bits: 8 * arrays[written.type].BYTES_PER_ELEMENT,
    error: written.error,
    files: writeFiles(volume, { grid, axes, written }, pack),
  };
}

function* writeFiles(
  volume: Volume,
  { grid, axes, written }: { readonly grid: GridFrame; readonly axes: Axes; readonly written: Written },
  pack: ArrayLayout['pack'],
): Generator<StoreFile> {
  const { samples, offset, type } = written;
  const pyramid = buildPyramid({ samples, dimensions: grid.dimensions }, side);
  const layout = { side, chunksPerShard, pack };
  yield [
    'zarr.json',
    jsonOf({
      zarr_format: 3,
      node_type: 'group',
      attributes: {
        ome: {
          version: '0.5',
          multiscales: [
            {
              name: 'image',
              type: 'mean',
              axes: axes.list,
              datasets: pyramid.levels.map((_, level) => ({
                path: String(level),
                coordinateTransformations: placesOf(axes, level),
              })),
            },
          ],
          ...(volume.window && { omero: { channels: [describeWindow(volume)] } }),
        },
      },
    }),
  ];
  for (const level of pyramid.levels.keys())
    yield* writeArray(String(level), levelArray(pyramid, level, { offset, type }), layout);
  yield* writeResiduals(pyramid, offset, layout);
}

function refuseOthers({ isDiscrete, channels, ...volume }: Volume): void {
  const what = isPolar({ ...volume, grid: volume.grid })
    ? 'a radar scan, which has no voxels: a mosaic keeps its gates'
    : isDiscrete
      ? 'labels'
      : channels
        ? 'several channels'
        : null;
  if (what)
    throw new VolumeViewError('format/unsupported', `it holds ${what}; expected one volume of voxels for an OME-Zarr`);
}

/** The axes of the file, z, y and x, and the places of their voxels. */
interface Axes {
  readonly list: readonly object[];
  readonly scale: readonly number[];
  readonly translation: readonly number[];
}

/** Directions in which an axis counts up, and down: to the right, the front and the head. Source: RFC-4 of OME-NGFF */
const directions = [
  ['left-to-right', 'right-to-left'],
  ['posterior-to-anterior', 'anterior-to-posterior'],
  ['inferior-to-superior', 'superior-to-inferior'],
] as const;

/** The directions that a reader takes where a file says none. */
const usualSigns = [-1, -1, 1];

/** Shares of a voxel that count as rounding. */
const rounding = 1e-4;

function describeAxes({ indexToWorld: m, dimensions }: GridFrame, anatomical: boolean): Axes {
  const own = [m[0], m[5], m[10]];
  const isTurned = [1, 2, 4, 6, 8, 9].some((at) => {
    // How far the last voxel of the volume is off the axis.
    const axis = at % 4;
    return Math.abs(m[at]) * dimensions[axis] > rounding * Math.abs(own[axis]);
  });
  const signs = own.map(Math.sign);
  if (isTurned || (!anatomical && signs.some((sign, axis) => sign !== usualSigns[axis])))
    throw new VolumeViewError(
      'format/unsupported',
      'its axes are turned or mirrored, which OME-Zarr 0.5 can not say; expected axes along those of the world, such as those of a volume that was resampled',
    );
  return {
    list: [2, 1, 0].map((axis) => ({
      name: 'xyz'[axis],
      type: 'space',
      unit: 'millimeter',
      ...(anatomical && { orientation: { type: 'anatomical', value: directions[axis][signs[axis] > 0 ? 0 : 1] } }),
    })),
    scale: [2, 1, 0].map((axis) => Math.abs(own[axis])),
    translation: [2, 1, 0].map((axis) => m[4 * axis + 3] * signs[axis]),
  };
}

/** A voxel of level L has its centre half of its own length, less half a voxel of level 0, from the first voxel's. */
function placesOf({ scale, translation }: Axes, level: number): readonly object[] {
  const factor = 2 ** level;
  return [
    { type: 'scale', scale: scale.map((length) => length * factor) },
    { type: 'translation', translation: translation.map((start, axis) => start + (scale[axis] * (factor - 1)) / 2) },
  ];
}

/** Whole numbers keep a type of whole numbers. Numbers with a factor of their own become floats, as OME-Zarr has no factors. */
function chooseNumbers({ samples, slope, intercept, range }: Volume): Written {
  const exact = { max: 0, rms: 0 };
  if (samples instanceof Float32Array && slope === 1 && intercept === 0)
    return { samples, offset: 0, type: 'float32', error: exact };
  const [low, high] = range;
  const isWhole = !(samples instanceof Float32Array) && slope === 1 && Number.isInteger(intercept);
  const type = isWhole && wholeTypes.find((one) => low >= ranges[one][0] && high <= ranges[one][1]);
  if (type) return { samples, offset: intercept, type, error: exact };
  const numbers = new Float32Array(samples.length);
  const sum = new ErrorSum();
  for (let at = 0; at < samples.length; at++) {
    const value = slope * samples[at] + intercept;
    numbers[at] = value;
    if (value === value) sum.add(numbers[at] - value);
  }
  return { samples: numbers, offset: 0, type: 'float32', error: sum.error };
}

const wholeTypes = ['uint8', 'int8', 'uint16', 'int16', 'int32'] as const;

const ranges = {
  uint8: [0, 255],
  int8: [-128, 127],
  uint16: [0, 65535],
  int16: [-32768, 32767],
  int32: [-(2 ** 31), 2 ** 31 - 1],
} as const;

const arrays = {
  uint8: Uint8Array,
  int8: Int8Array,
  uint16: Uint16Array,
  int16: Int16Array,
  int32: Int32Array,
  float32: Float32Array,
} as const;

function levelArray(pyramid: Pyramid, level: number, { offset, type }: Pick<Written, 'offset' | 'type'>): ArrayData {
  const { dimensions, samples } = pyramid.levels[level];
  const fill = samples instanceof Float32Array ? NaN : 0;
  return {
    type,
    dimensions,
    fill,
    chunkAt: (at) => {
      const brick = copyBrick(pyramid, { level, at });
      const numbers = new arrays[type](brick.length).fill(fill);
      const [width, height, depth] = dimensions.map((n, axis) => Math.min(side, n - at[axis] * side));
      let isEmpty = true;
      for (let k = 0; k < depth; k++)
        for (let j = 0; j < height; j++)
          for (let i = 0, n = side * (j + side * k); i < width; i++, n++) {
            numbers[n] = brick[n] + offset;
            isEmpty &&= Object.is(numbers[n], fill);
          }
      return isEmpty ? null : littleEndian(numbers);
    },
  };
}

/** What each level hides, as arrays of one number a block. */
function* writeResiduals(pyramid: Pyramid, offset: number, layout: ArrayLayout): Generator<StoreFile> {
  const block = blockOfResiduals(pyramid.levels[0].dimensions);
  const { blocks, low, high, levels, along } = measureResiduals(pyramid, block);
  const array = (numbers: Float32Array<ArrayBuffer>): ArrayData => ({
    type: 'float32',
    dimensions: blocks,
    fill: NaN,
    chunkAt: (at) =>
      littleEndian(copyBrick({ levels: [{ dimensions: blocks, samples: numbers }], side }, { level: 0, at })),
  });
  yield [
    `${residualsGroup}/zarr.json`,
    jsonOf({
      zarr_format: 3,
      node_type: 'group',
      attributes: { 'volume-view': { version: 1, block: [block, block, block], levels: levels.length, along } },
    }),
  ];
  yield* writeArray(
    `${residualsGroup}/min`,
    array(low.map((value) => (value < Infinity ? value + offset : NaN))),
    layout,
  );
  yield* writeArray(
    `${residualsGroup}/max`,
    array(high.map((value) => (value > -Infinity ? value + offset : NaN))),
    layout,
  );
  for (const [level, { rms, max }] of levels.entries()) {
    if (level === 0) continue;
    yield* writeArray(`${residualsGroup}/residual-rms-${level}`, array(shorten(rms, 'nearest')), layout);
    yield* writeArray(`${residualsGroup}/residual-max-${level}`, array(shorten(max, 'up')), layout);
  }
}

/** Numbers from 0 on with few binary digits. */
function shorten(numbers: Float32Array, way: 'nearest' | 'up'): Float32Array<ArrayBuffer> {
  const short = Float32Array.from(numbers);
  const bits = new Uint32Array(short.buffer);
  const rest = 2 ** (23 - digits) - 1;
  const more = way === 'up' ? rest : (rest + 1) / 2;
  for (const [n, all] of bits.entries()) bits[n] = (all + more) & ~rest;
  return short;
}

/** The bytes of numbers. */
function littleEndian(numbers: InstanceType<(typeof arrays)[keyof typeof arrays]>): Uint8Array {
  const bytes = new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
  if (new Uint8Array(Uint16Array.of(1).buffer)[0] === 1) return bytes;
  const size = numbers.BYTES_PER_ELEMENT;
  return bytes.map((_, at) => bytes[at - (at % size) + size - 1 - (at % size)]);
}

function describeWindow({ window, range }: Volume): object {
  const [start, end] = window!;
  return { color: 'FFFFFF', active: true, window: { min: range[0], max: range[1], start, end } };
}

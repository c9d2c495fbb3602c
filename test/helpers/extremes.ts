import { orbitCamera } from '../../src/optics/rays/camera.ts';
import type { Camera } from '../../src/optics/rays/camera.ts';
import { buildDefaultPreset } from '../../src/optics/transfer/default-preset.ts';
import { spanAround } from '../../src/optics/transfer/span-around.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { hostIsLittleEndian, numberTypes } from '../../src/formats/base/number-types.ts';
import { storeSamples } from '../../src/formats/base/store-samples.ts';
import { boundingSphere, longestDiagonal } from '../../src/volume/grid.ts';
import { summarize } from '../../src/volume/histogram.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import type { Matrix4, Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import type { Optics } from '../../src/renderer/ray/ray-module.ts';
import { plainOptics, shells } from './picture.ts';
import type { View } from './picture.ts';
import { smoothField, syntheticVolume } from './synthetic.ts';
import type { SyntheticOptions } from './synthetic.ts';

/** A picture with an extreme setting, and the result that it has to have. */
export interface Extreme {
  readonly name: string;
  readonly view: View;
  /** The correct limit, if it has a closed form: the opacity as a function of a ray's length inside the volume, in world units. */
  readonly alpha?: (length: number) => number;
  /** The correct limit, if it is the picture of a moderate view; `near`: the error of the reference to it, in 1/255. */
  readonly same?: View;
  readonly near?: number;
}

interface Options {
  readonly data?: Partial<SyntheticOptions>;
  readonly volume?: Volume;
  readonly camera?: Partial<Camera>;
  /** The camera's distance from the volume's centre, in diagonals of the volume. */
  readonly radius?: number;
  readonly theta?: number;
  readonly phi?: number;
  readonly steps?: number;
  readonly optics?: Partial<Optics>;
  readonly size?: View['size'];
}

const [fieldOfView, diagonalsAway] = [0.6, 1.6];

function viewOf({
  data,
  volume: given,
  camera,
  radius = diagonalsAway,
  theta = 0.6,
  phi = 1.2,
  steps = 60,
  optics,
  size,
}: Options): View {
  const volume = given ?? syntheticVolume({ dimensions: [14, 12, 10], ...data });
  const diagonal = longestDiagonal(volume.grid);
  const around = orbitCamera(
    { theta, phi, radius: radius * diagonal },
    boundingSphere(volume.grid).center,
    fieldOfView,
  );
  return {
    volume,
    camera: { ...around, ...camera },
    stepLength: diagonal / steps,
    // The same density in any unit and at any size of voxels.
    optics: { ...plainOptics, referenceLength: diagonal / 20, ...optics },
    ...(size ? { size } : {}),
  };
}

const flat = (opacity: number, color: readonly [number, number, number] = [1, 1, 1]): TransferFunction => [
  { value: 0.5, color, opacity },
];
const half = (): number => 0.5;
const constant: Partial<SyntheticOptions> = { field: half, kind: 'float32' };

/** A constant volume with an optical depth for each diagonal. */
function depthOf(depth: number, options: Options = {}): Pick<Extreme, 'view' | 'alpha'> {
  const view = viewOf({
    data: constant,
    ...options,
    optics: { transferFunction: flat(1 - Math.exp(-1)), ...options.optics },
  });
  const diagonal = longestDiagonal(view.volume.grid);
  // A reference length is a twentieth of the diagonal and has a depth of 1.
  const optics: Optics = { ...view.optics!, opacityFactor: depth / 20 };
  return { view: { ...view, optics }, alpha: (length) => -Math.expm1((-depth * length) / diagonal) };
}

/** A small picture: tests of very many steps only need single rays, and more pixels would only take longer. */
const few = [16, 12] as const;

const steps: Extreme[] = [
  { name: '1 step, a uniform volume', ...depthOf(3, { steps: 1 }) },
  { name: '10,000 steps, a uniform volume', ...depthOf(3, { steps: 10_000, size: few }) },
  { name: 'a step of 1.5 diagonals', ...depthOf(3, { steps: 1 / 1.5 }) },
  { name: 'a step of 1e9 diagonals', ...depthOf(3, { steps: 1e-9 }) },
  { name: '1 step through a smooth field', view: viewOf({ steps: 1 }) },
  {
    name: '10,000 steps through a smooth field',
    view: viewOf({ steps: 10_000, size: few }),
    same: viewOf({ steps: 2500, size: few }),
    near: 0.01,
  },
];

const jump = (at: number): TransferFunction => [
  { value: 0, color: [0.2, 0.4, 1], opacity: 0.02 },
  { value: at, color: [0.2, 0.4, 1], opacity: 0.02 },
  { value: at, color: [1, 0.8, 0.2], opacity: 0.9 },
];

const opacities: Extreme[] = [
  { name: 'opacity 0', view: viewOf({ optics: { transferFunction: flat(0) } }), alpha: () => 0 },
  { name: 'opacity factor 0', view: viewOf({ optics: { opacityFactor: 0 } }), alpha: () => 0 },
  {
    name: 'opacity 1, one stop that covers everything',
    view: viewOf({ optics: { transferFunction: flat(1) } }),
    alpha: (l) => Math.min(1, l * 1e12),
  },
  {
    name: 'one stop of opacity 0.2 that covers everything',
    view: viewOf({ optics: { transferFunction: flat(0.2), referenceLength: 1 } }),
    alpha: (l) => 1 - 0.8 ** l,
  },
  {
    name: 'a jump from 0 to 1',
    view: viewOf({
      optics: {
        transferFunction: [
          { value: 0.4, color: [1, 1, 1], opacity: 0 },
          { value: 0.4, color: [1, 0.5, 0], opacity: 1 },
        ],
      },
    }),
  },
  {
    name: 'a ramp from 0 to 1',
    view: viewOf({
      optics: {
        transferFunction: [
          { value: 0.2, color: [1, 1, 1], opacity: 0 },
          { value: 0.9, color: [1, 0.5, 0], opacity: 1 },
        ],
      },
    }),
  },
  {
    name: 'a jump from 0.02 to 0.9 at the last stop, 500 steps',
    view: viewOf({ steps: 500, optics: { transferFunction: jump(0.55) } }),
  },
  {
    name: 'a jump from 0.02 to 0.9 at the last stop, 30 steps',
    view: viewOf({ steps: 30, optics: { transferFunction: jump(0.55) } }),
  },
  ...[1e-6, 1e-3, 1, 10, 1e3, 1e6].map((depth): Extreme => ({
    name: `an optical depth of ${depth}`,
    ...depthOf(depth),
  })),
  { name: 'an optical depth of 1e6 in 500 steps', ...depthOf(1e6, { steps: 500 }) },
  { name: 'an optical depth of 1e30', ...depthOf(1e30) },
  {
    name: 'a reference length of 1e-42',
    view: viewOf({ data: constant, optics: { transferFunction: flat(0.3), referenceLength: 1e-42 } }),
    alpha: (l) => Math.min(1, l * 1e12),
  },
  { name: 'a reference length of 1e-42 where some is clear', view: viewOf({ optics: { referenceLength: 1e-42 } }) },
  { name: 'a reference length of 1e30', view: viewOf({ optics: { referenceLength: 1e30 } }), alpha: () => 0 },
  { name: 'light factor 0', view: viewOf({ optics: { lightFactor: 0 } }) },
  { name: 'light factor 100', view: viewOf({ optics: { lightFactor: 100 } }) },
];

const shapes: Extreme[] = [
  { name: 'one voxel', ...depthOf(3, { data: { ...constant, dimensions: [1, 1, 1] } }) },
  {
    name: 'one voxel, 8 bit, 1 step',
    view: viewOf({ data: { dimensions: [1, 1, 1], field: half }, steps: 1 }),
    same: viewOf({ data: { dimensions: [3, 3, 3], field: half } }),
    near: 1e-6,
  },
  { name: 'one slice', view: viewOf({ data: { dimensions: [20, 18, 1], spacing: [1, 1, 5] } }) },
  {
    name: 'one slice, thin',
    view: viewOf({ data: { dimensions: [20, 18, 1], spacing: [1, 1, 1e-3] }, optics: { referenceLength: 1e-3 } }),
  },
  { name: '1 x 1 x 40: tiles of one pixel', view: viewOf({ data: { dimensions: [1, 1, 40], spacing: [9, 9, 1] } }) },
  {
    name: '1 x 1 x 41, 16 bit',
    view: viewOf({ data: { dimensions: [1, 1, 41], kind: 'uint16', spacing: [9, 9, 1] } }),
  },
  { name: '40 x 1 x 1', view: viewOf({ data: { dimensions: [40, 1, 1], spacing: [1, 9, 9] } }) },
  { name: '1 x 40 x 1', view: viewOf({ data: { dimensions: [1, 40, 1], kind: 'float32', spacing: [9, 1, 9] } }) },
  {
    name: 'sizes that are not powers of two, a last row that is half empty',
    view: viewOf({ data: { dimensions: [13, 17, 11] } }),
  },
  { name: 'the same, 16 bit', view: viewOf({ data: { dimensions: [13, 17, 11], kind: 'uint16' } }) },
];

const float = (field: SyntheticOptions['field'], rest: Partial<SyntheticOptions> = {}): Volume =>
  syntheticVolume({ dimensions: [14, 12, 10], kind: 'float32', field, ...rest });
/** A volume of doubles, stored as those of a file. */
function doubles(field: (x: number, y: number, z: number) => number): Volume {
  const [nx, ny, nz] = [14, 12, 10];
  const values = Float64Array.from({ length: nx * ny * nz }, (_, at) =>
    field(((at % nx) + 0.5) / nx, ((Math.floor(at / nx) % ny) + 0.5) / ny, (Math.floor(at / nx / ny) + 0.5) / nz),
  );
  const { samples, scale, offset } = storeSamples(
    new Uint8Array(values.buffer),
    numberTypes.float64,
    hostIsLittleEndian,
    { slope: 1, intercept: 0 },
  );
  return {
    ...float(() => 0),
    samples,
    slope: scale,
    intercept: offset,
    macrocells: buildMacrocells(samples, [nx, ny, nz]),
    ...summarize(samples, scale, offset),
  };
}
/** The stops, moved to other data values. */
const shellsAt = (slope: number, intercept = 0): TransferFunction =>
  shells.map((stop) => ({ ...stop, value: stop.value * slope + intercept }));
/** From clear to half opaque. */
const jumpAt = (value: number): TransferFunction => [0, 0.2].map((opacity) => ({ value, color: [1, 0.5, 0], opacity }));
const inHalf =
  (beyond: number) =>
  (x: number, y: number, z: number): number =>
    x < 0.5 ? beyond : smoothField(x, y, z);
const ends = (x: number, _y: number, z: number): number => (x + z < 1 ? 0 : 1);
const smoothFloats = viewOf({ volume: float(smoothField) });
const noData = viewOf({ volume: float(inHalf(NaN)) });
const nothing = { alpha: () => 0 };

const values: Extreme[] = [
  ...(['uint8', 'uint16', 'float32'] as const).flatMap((kind) =>
    [0, 1].map((value): Extreme => ({
      name: `a constant volume of ${kind}, all ${value}`,
      view: viewOf({
        data: { kind, field: () => value },
        optics: {
          transferFunction: [
            { value: 0, color: [1, 1, 1], opacity: 0.1 },
            { value: 1, color: [1, 1, 1], opacity: 0.2 },
          ],
          referenceLength: 1,
        },
      }),
      alpha: (l) => 1 - (value === 0 ? 0.9 : 0.8) ** l,
    })),
  ),
  ...[1e30, -1e30, 3e38, -3.3e38, 1e-40].map((value): Extreme => {
    const volume = float(() => value);
    const stored = volume.samples[0];
    return {
      name: `a constant volume of ${value}, and stops there`,
      view: viewOf({
        volume,
        optics: {
          transferFunction: [
            { value: stored, color: [1, 1, 1], opacity: 0 },
            { value: stored, color: [1, 1, 1], opacity: 0.1 },
          ],
          referenceLength: 1,
        },
      }),
      alpha: (l) => 1 - 0.9 ** l,
    };
  }),
  ...[1e17, -1e300].map((value): Extreme => ({
    name: `a constant volume of ${value}, and the window around it`,
    view: viewOf({
      volume: { ...float(() => 0), intercept: value },
      optics: {
        transferFunction: spanAround(value).map((at) => ({ value: at, color: [1, 1, 1], opacity: 0.1 })),
        referenceLength: 1,
      },
    }),
    alpha: (l) => 1 - 0.9 ** l,
  })),
  { name: 'no data at all', view: viewOf({ volume: float(() => NaN) }), ...nothing },
  { name: 'no data in one half', view: noData },
  { name: 'no data in one half, 7 steps', view: { ...noData, stepLength: noData.stepLength * 8.5 } },
  { name: 'infinities, which are no data', view: viewOf({ volume: float(inHalf(Infinity)) }), same: noData, near: 0 },
  {
    name: 'infinities below 0, which are no data',
    view: viewOf({ volume: float(inHalf(-Infinity)) }),
    same: noData,
    near: 0,
  },
  ...[1e-38, 1e-40, 1e30, 1e38, 3e38].map((unit): Extreme => ({
    name: `floats of ${unit}`,
    view: viewOf({
      volume: float((x, y, z) => unit * smoothField(x, y, z)),
      optics: { transferFunction: shellsAt(unit) },
    }),
    same: smoothFloats,
    // Denormals have 17 bits left at 1e-40.
    near: unit < 1e-38 ? 0.1 : 1e-3,
  })),
  // Doubles beyond the range of float32, stored as those of a file. Denormal doubles have 36 bits left at 5e-310, and 11 at 1e-320.
  ...[5e-310, 1e-320, 1e-300, 1e299].map((unit): Extreme => ({
    name: `doubles of ${unit}`,
    view: viewOf({
      volume: doubles((x, y, z) => unit * smoothField(x, y, z)),
      optics: { transferFunction: shellsAt(unit) },
    }),
    same: smoothFloats,
    near: unit < 1e-318 ? 1 : 1e-2,
  })),
  {
    name: 'doubles of 5e-310 on both sides of 0',
    view: viewOf({
      volume: doubles((x, y, z) => 5e-310 * (smoothField(x, y, z) - 0.4)),
      optics: { transferFunction: shellsAt(5e-310, -0.4 * 5e-310) },
    }),
    same: smoothFloats,
    near: 1e-2,
  },
  {
    name: 'a constant volume of 5e-310, and the window around it',
    view: viewOf({
      volume: doubles(() => 5e-310),
      optics: {
        transferFunction: spanAround(5e-310).map((at) => ({ value: at, color: [1, 1, 1], opacity: 0.1 })),
        referenceLength: 1,
      },
    }),
    alpha: (l) => 1 - 0.9 ** l,
  },
  {
    name: 'floats from -3.3e38 to 3.3e38',
    view: viewOf({
      volume: float((x, y, z) => 6.6e38 * smoothField(x, y, z) - 3.3e38),
      optics: { transferFunction: shellsAt(6.6e38, -3.3e38) },
    }),
    same: smoothFloats,
    near: 1e-2,
  },
  {
    name: 'floats of 1e30 with a window around 0',
    view: viewOf({
      volume: float((x, y, z) => 1e30 * (smoothField(x, y, z) - 0.4)),
      optics: { transferFunction: shells },
    }),
    // So far outside of the data that only a jump is left.
    same: viewOf({
      volume: float((x, y, z) => smoothField(x, y, z) - 0.4),
      optics: { transferFunction: shellsAt(1e-12) },
    }),
    near: 0.01,
  },
  {
    name: 'floats of 1e30 with one jump at 0',
    view: viewOf({
      volume: float((x, y, z) => 1e30 * (smoothField(x, y, z) - 0.4)),
      optics: { transferFunction: jumpAt(0) },
    }),
    same: viewOf({ volume: float((x, y, z) => smoothField(x, y, z) - 0.4), optics: { transferFunction: jumpAt(0) } }),
    near: 0.01,
  },
  ...[1e-20, 1e-45, 5e-324].map((width): Extreme => ({
    name: `stops that are ${width} apart`,
    view: viewOf({
      volume: float((x, y, z) => smoothField(x, y, z) - 0.4),
      optics: { transferFunction: [jumpAt(0)[0], { ...jumpAt(0)[1], value: width }] },
    }),
    same: viewOf({ volume: float((x, y, z) => smoothField(x, y, z) - 0.4), optics: { transferFunction: jumpAt(0) } }),
    // A ramp instead of a jump: the same picture, but a step that crosses it may be cut into one part more or one part fewer.
    near: 0.05,
  })),
  ...[1e38, 3.4e38, 1e300].map((width): Extreme => ({
    name: `the default colours from -${width} to ${width}: all data are in the middle`,
    view: viewOf({
      data: { kind: 'float32' },
      optics: { transferFunction: buildDefaultPreset([-width, width]), referenceLength: 1 },
    }),
    alpha: (l) => 1 - 0.93 ** l,
  })),
  {
    name: 'floats with values of 1e30 among them',
    view: viewOf({ volume: float((x, y, z) => (Math.hypot(x - 0.5, y - 0.5) < 0.15 ? 1e30 : smoothField(x, y, z))) }),
  },
  {
    name: 'denormals among floats',
    view: viewOf({ volume: float((x, y, z) => (x < 0.3 ? 1e-42 : smoothField(x, y, z))) }),
    same: viewOf({ volume: float((x, y, z) => (x < 0.3 ? 0 : smoothField(x, y, z))) }),
    near: 1e-6,
  },
  {
    name: 'int16 at both ends',
    view: viewOf({
      data: { kind: 'uint16', field: ends, slope: 65535, intercept: -32768 },
      optics: { transferFunction: shellsAt(65535, -32768) },
    }),
    same: viewOf({ data: { kind: 'float32', field: ends } }),
    near: 1e-6,
  },
  {
    name: 'int16 constant at its lower end, stops from there',
    view: viewOf({
      data: { kind: 'uint16', field: () => 0, slope: 65535, intercept: -32768 },
      optics: {
        transferFunction: [
          { value: -32768, color: [1, 1, 1], opacity: 0.1 },
          { value: 32767, color: [1, 1, 1], opacity: 0.5 },
        ],
        referenceLength: 1,
      },
    }),
    alpha: (l) => 1 - 0.9 ** l,
  },
  {
    name: 'int16 constant at its upper end, stops up to there',
    view: viewOf({
      data: { kind: 'uint16', field: () => 1, slope: 65535, intercept: -32768 },
      optics: {
        transferFunction: [
          { value: -32768, color: [1, 1, 1], opacity: 0.5 },
          { value: 32767, color: [1, 1, 1], opacity: 0.1 },
        ],
        referenceLength: 1,
      },
    }),
    alpha: (l) => 1 - 0.9 ** l,
  },
  {
    name: 'int16 constant at its upper end, and a jump there',
    view: viewOf({
      data: { kind: 'uint16', field: () => 1, slope: 65535, intercept: -32768 },
      optics: {
        transferFunction: [
          { value: -32768, color: [1, 1, 1], opacity: 0 },
          { value: 32767, color: [1, 1, 1], opacity: 0 },
          { value: 32767, color: [1, 1, 1], opacity: 0.1 },
        ],
        referenceLength: 1,
      },
    }),
    alpha: (l) => 1 - 0.9 ** l,
  },
  {
    name: 'all values above the window',
    view: viewOf({ data: { kind: 'uint16' }, optics: { transferFunction: shellsAt(1, -5), referenceLength: 1 } }),
    alpha: (l) => 1 - 0.65 ** l,
  },
  {
    name: 'all values below the window',
    view: viewOf({ data: { kind: 'uint16' }, optics: { transferFunction: shellsAt(1, 5) } }),
    ...nothing,
  },
  {
    name: 'most values outside the window',
    view: viewOf({ data: { kind: 'uint16' }, optics: { transferFunction: shellsAt(0.1, 0.3) } }),
  },
  {
    name: 'a window of a millionth of the values',
    view: viewOf({ data: { kind: 'float32' }, optics: { transferFunction: shellsAt(1e-6, 0.4) } }),
  },
  {
    name: 'a window of a million times the values',
    view: viewOf({ data: { kind: 'float32' }, optics: { transferFunction: shellsAt(1e6, -0.4e6) } }),
  },
];

const cubic = (unit: number, offset: Vector3 = [0, 0, 0]): Matrix4 => [
  unit,
  0,
  0,
  offset[0],
  0,
  -unit,
  0,
  offset[1],
  0,
  0,
  unit,
  offset[2],
  0,
  0,
  0,
  1,
];
const moved = (unit: number, offset?: Vector3): View => viewOf({ data: { indexToWorld: cubic(unit, offset) } });

/** A thin tower, seen from near: from far away it would be only a line. */
const tower = (unit: number): View =>
  viewOf({
    data: { spacing: [unit, unit, 1e4 * unit] },
    radius: 4e-4,
    steps: 1e5,
    optics: { referenceLength: 3 * unit },
  });

const places: Extreme[] = [
  { name: 'spacings of 1e-9', view: moved(1e-9), same: moved(1), near: 1e-6 },
  { name: 'spacings of 1e9', view: moved(1e9), same: moved(1), near: 1e-6 },
  { name: 'slices 1e4 times as far apart as pixels of 1e-9', view: tower(1e-9), same: tower(1), near: 1e-6 },
  { name: 'slices 1e4 times as far apart as pixels of 1e9', view: tower(1e9), same: tower(1), near: 1e-6 },
  {
    name: 'slices 1e4 times as near as pixels',
    view: viewOf({ data: { spacing: [1, 1, 1e-4] }, optics: { referenceLength: 1e-3 } }),
  },
  // Rounding of 1e7 in float64: 1e-9 of a voxel.
  { name: 'world offsets of 1e7', view: moved(1, [1e7, -1e7, 1e7]), same: moved(1), near: 1e-4 },
  { name: 'a world offset of 1e7 voxels of 1e-9', view: moved(1e-9, [1e-2, -1e-2, 1e-2]), same: moved(1), near: 1e-4 },
];

/** The volume is 14 x 12 x 10 around the origin. */
const eyeAt = (eye: Vector3, target: Vector3 = [0, 0, 0], rest: Partial<Camera> = {}): View =>
  viewOf({ camera: { eye, target, up: [0, 0, 1], fieldOfView: 1.2, ...rest } });
/** Degrees. */
const withField = (degrees: number): Options => {
  const angle = (degrees * Math.PI) / 180;
  return { radius: 0.5 / Math.sin(angle / 2), camera: { fieldOfView: angle } };
};

const eyes: Extreme[] = [
  { name: 'the eye on a face', view: eyeAt([7, 0, 0]) },
  { name: 'the eye on a face, looking along it', view: eyeAt([7, 0, 0], [7, 5, 0]) },
  { name: 'the eye on an edge', view: eyeAt([7, 6, 0]) },
  { name: 'the eye on an edge, looking along it', view: eyeAt([7, 6, 0], [7, 6, 5], { up: [0, 1, 0] }) },
  { name: 'the eye on a corner', view: eyeAt([7, 6, 5]) },
  { name: 'the eye at the centre', view: eyeAt([0, 0, 0], [1, 0.3, 0.2]) },
  {
    name: 'the eye 1e6 diagonals away',
    view: viewOf({ radius: 1e6, camera: { fieldOfView: 1e-6 } }),
    same: viewOf({ radius: 1e4, camera: { fieldOfView: 1e-4 } }),
    near: 1,
  },
  { name: 'the eye 1e6 diagonals away with an ordinary field of view', view: viewOf({ radius: 1e6 }), alpha: () => 0 },
  { name: 'a field of view of 1e-3 degrees', view: viewOf(withField(1e-3)), same: viewOf(withField(1e-2)), near: 1 },
  {
    name: 'a field of view of 1e-3 degrees from inside',
    view: viewOf({ radius: 0.1, camera: { fieldOfView: 1e-3 * (Math.PI / 180) } }),
  },
  {
    name: 'a field of view of 179 degrees',
    view: eyeAt([7.03, 0, 0], [0, 0, 0], { fieldOfView: 179 * (Math.PI / 180) }),
  },
  {
    name: 'a field of view of 179 degrees from inside',
    view: viewOf({ radius: 0.1, camera: { fieldOfView: 179 * (Math.PI / 180) } }),
  },
  ...[0, 1e-7, -1e-7].flatMap((tilt): Extreme[] => {
    const far = { radius: 1e6, camera: { fieldOfView: 1e-6 } };
    const attached = tilt === 0 ? '' : `, ${tilt} off`;
    return [
      {
        name: `rays along z${attached}`,
        view: viewOf({ ...far, theta: 0, phi: tilt }),
        same: viewOf({ ...far, theta: 0, phi: 0 }),
        near: 1,
      },
      {
        name: `rays along y${attached}`,
        view: viewOf({ ...far, theta: tilt, phi: Math.PI / 2 }),
        same: viewOf({ ...far, theta: 0, phi: Math.PI / 2 }),
        near: 1,
      },
      {
        name: `rays along x${attached}`,
        view: viewOf({ ...far, theta: Math.PI / 2 + tilt, phi: Math.PI / 2 }),
        same: viewOf({ ...far, theta: Math.PI / 2, phi: Math.PI / 2 }),
        near: 1,
      },
    ];
  }),
];

/** Issue 3, "stability at the extremes". Separate tests cover its other items. */
export const extremes: readonly Extreme[] = [...steps, ...opacities, ...shapes, ...values, ...places, ...eyes];

/** The names of those that textures and tables of numbers decide: sizes of volumes, and every third kind of numbers. */
export const storedExtremes: ReadonlySet<string> = new Set(
  [...shapes, ...values.filter((_, i) => i % 3 === 0)].map(({ name }) => name),
);

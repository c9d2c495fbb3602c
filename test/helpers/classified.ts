import { orbitCamera } from '../../src/optics/rays/camera.ts';
import { parseTransferFunction } from '../../src/optics/transfer/parse-transfer-function.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { storeSamples } from '../../src/formats/base/store-samples.ts';
import { numberTypes } from '../../src/formats/base/number-types.ts';
import { axialIndexToWorld, cartesianGrid, longestDiagonal } from '../../src/volume/grid.ts';
import { summarize } from '../../src/volume/histogram.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Samples, Volume } from '../../src/volume/volume.ts';
import { plainOptics } from './picture.ts';
import type { View } from './picture.ts';
import { randomNumbers } from './synthetic.ts';

/** A volume, its appearance, and the same volume with the file's own numbers, which the reference uses. */
export interface Classified {
  readonly name: string;
  readonly view: View;
  readonly exact: Volume;
}

/** More than one macrocell along each axis. */
const dimensions: Vector3 = [22, 20, 18];
const count = dimensions[0] * dimensions[1] * dimensions[2];

type Numbers = Samples | Float64Array;

function volumeOf(samples: Numbers, slope = 1, intercept = 0): Volume {
  const stored = samples as Samples;
  return {
    grid: cartesianGrid(dimensions, axialIndexToWorld(dimensions, [1, 1, 1])),
    samples: stored,
    slope,
    intercept,
    unit: '',
    format: 'synthetic',
    macrocells: buildMacrocells(stored, dimensions),
    ...summarize(stored, slope, intercept),
  };
}

/** Convert a file's own numbers to a volume, as the readers do. */
function readBack(type: 'float32' | 'float64' | 'int32', numbers: Float64Array): { volume: Volume; exact: Volume } {
  const array = { float32: Float32Array, float64: Float64Array, int32: Int32Array }[type].from(numbers);
  const exact = Float64Array.from(array);
  const { samples, scale, offset } = storeSamples(new Uint8Array(array.buffer), numberTypes[type], true, {
    slope: 1,
    intercept: 0,
  });
  return { volume: volumeOf(samples, scale, offset), exact: volumeOf(exact) };
}

/** Fill an array with the numbers of voxels, computed from their places in the unit cube. */
function fill<T extends Numbers>(numbers: T, field: (x: number, y: number, z: number) => number): T {
  const [nx, ny, nz] = dimensions;
  for (let at = 0; at < count; at++)
    numbers[at] = field(
      ((at % nx) + 0.5) / nx,
      ((Math.floor(at / nx) % ny) + 0.5) / ny,
      (Math.floor(at / (nx * ny)) + 0.5) / nz,
    );
  return numbers;
}

interface Look {
  readonly theta?: number;
  readonly phi?: number;
  readonly steps?: number;
  /** Reference lengths per diagonal. */
  readonly lengths?: number;
}

function look(
  volume: Volume,
  transferFunction: TransferFunction | string,
  { theta = 0.6, phi = 1.2, steps = 50, lengths = 40 }: Look = {},
): View {
  const diagonal = longestDiagonal(volume.grid);
  const stops =
    typeof transferFunction === 'string' ? parseTransferFunction(transferFunction, [0, 1]) : transferFunction;
  return {
    volume,
    camera: orbitCamera({ theta, phi, radius: 1.5 * diagonal }, [0, 0, 0], 0.6),
    stepLength: diagonal / steps,
    optics: { ...plainOptics, transferFunction: stops, referenceLength: diagonal / lengths },
    size: [32, 24],
  };
}

const scene = (
  name: string,
  volume: Volume,
  stops: TransferFunction | string,
  { exact = volume, ...more }: Look & { readonly exact?: Volume } = {},
): Classified => ({ name, view: look(volume, stops, more), exact });

const ball = (x: number, y: number, z: number): number => Math.hypot(x - 0.5, y - 0.45, z - 0.55);
/** Shells of labels around a place; outside of them is air. */
const shellsOf =
  (labels: readonly number[], air = 0) =>
  (x: number, y: number, z: number): number => {
    const shell = Math.floor(ball(x, y, z) / 0.13);
    return shell < labels.length ? labels[shell] : air;
  };
const wave = (x: number, y: number, z: number): number => 0.5 + 0.5 * Math.sin(7 * x + 2 * y) * Math.cos(5 * y - 3 * z);

const manyStops = (): TransferFunction => {
  const random = randomNumbers(12);
  return Array.from({ length: 500 }, (_, i) => ({
    value: i / 499,
    color: [random(), random(), random()] as const,
    opacity: 0.3 * random(),
  }));
};

/** Ordinary transfer functions that a table of columns of equal width shows wrongly, and numbers that float32 stores with large errors. */
export function listClassified(): Classified[] {
  const labels = volumeOf(fill(new Uint16Array(count), shellsOf([2000, 1, 3])));
  const bytes = volumeOf(fill(new Uint8Array(count), shellsOf([200, 41, 10])));
  const tissues = volumeOf(fill(new Uint16Array(count), shellsOf([1030, 1020, 1010], 1000)));
  const air = volumeOf(fill(new Uint16Array(count), shellsOf([24, 1500, 10, 5])), 1, -1000);
  const smooth = volumeOf(fill(new Float32Array(count), wave));
  const edge = volumeOf(fill(new Uint8Array(count), shellsOf([90, 60, 30])));
  const tenths = volumeOf(fill(new Uint8Array(count), shellsOf([7, 6, 3])), 0.1, 0);
  const far = readBack(
    'float32',
    fill(new Float64Array(count), (x, y, z) => 1e7 + Math.round(1000 * wave(x, y, z))),
  );
  const deep = readBack(
    'int32',
    fill(new Float64Array(count), (x, y, z) =>
      x + y + z < 0.2 ? -2e9 : x + y + z > 2.8 ? 2e9 : 1.5e9 + Math.round(1000 * wave(x, y, z)),
    ),
  );
  const lone = readBack(
    'float64',
    fill(new Float64Array(count), (x, y, z) => (x < 0.03 && y < 0.03 && z < 0.03 ? 0 : 1e9 + 1000 * wave(x, y, z))),
  );
  const tiny = readBack(
    'float64',
    fill(new Float64Array(count), (x, y, z) => 4e-310 * wave(x, y, z)),
  );
  return [
    scene('labels over 0', labels, '0 #000 0, 1 #f00 60%, 2000 #00f 60%'),
    scene(
      'tissues 10 apart in a domain of 65,535',
      tissues,
      '0 #000 0, 1005 #000 0, 1005 #f00 30%, 1015 #f00 30%, 1015 #0f0 30%, 1025 #0f0 30%, 1025 #00f 30%, 1035 #00f 30%, 1035 #000 0, 65535 #000 0',
    ),
    scene(
      'ramps among tissues 10 apart in a domain of 65,535',
      tissues,
      '0 #000 0, 1000 #000 0, 1010 #f00 30%, 1020 #0f0 40%, 1030 #00f 10%, 65535 #fff 10%',
    ),
    scene(
      'values on edges of bands',
      edge,
      '0 #000 0, 30 #000 0, 30 #f00 20%, 60 #f00 20%, 60 #0f0 50%, 90 #0f0 50%, 90 #00f 90%, 255 #00f 90%',
      { theta: 0.9 },
    ),
    scene(
      'values on edges of bands, the last of which are clear',
      edge,
      '0 #ff0 20%, 30 #ff0 20%, 30 #f00 0, 60 #f00 0, 60 #0f0 50%, 90 #0f0 50%, 90 #00f 0',
    ),
    scene(
      'values of a slope of 0.1 on edges of bands',
      tenths,
      '0 #000 0, 0.3 #000 0, 0.3 #f00 20%, 0.6 #f00 20%, 0.6 #0f0 50%, 0.7 #0f0 50%, 0.7 #00f 90%, 25 #00f 90%',
      { theta: 0.9 },
    ),
    scene('values at a threshold', edge, '0 #000 0, 30 #f00 0, 60 #f00 60%, 255 #fff 80%', { lengths: 300 }),
    scene('values at a threshold that no column is at', edge, '0 #000 0, 30.01 #f00 0, 59.99 #f00 60%, 255 #fff 80%', {
      lengths: 300,
    }),
    scene('values of opacity 1 alone', edge, '0 #000 0, 30 #f00 10%, 60 #0f0 100%, 90 #00f 10%, 255 #fff 10%'),
    scene('a ramp to opacity 1', smooth, '0 #000 0, 0.7 #08f 20%, 1 #fff 100%'),
    scene('air at -1000, a ramp up to -990', air, '-1000 #000 0, -990 #f80 50%, 3000 #fff 60%'),
    scene('air at the low end', bytes, '0 #000 0, 41 #08f 80%', { lengths: 300 }),
    scene('500 stops', smooth, manyStops()),
    scene(
      'float32 around 1e7',
      far.volume,
      '10000000 #000 0, 10000400 #08f 10%, 10000600 #f80 50%, 10001000 #fff 20%',
      { exact: far.exact },
    ),
    scene(
      'int32 of +-2e9 with detail of 1,000',
      deep.volume,
      '1500000000 #000 0, 1500000400 #08f 10%, 1500000600 #f80 50%, 1500001000 #fff 20%',
      { exact: deep.exact },
    ),
    scene(
      'float64 around 1e9 with one voxel of 0',
      lone.volume,
      '1000000000 #000 0, 1000000400 #08f 10%, 1000000600 #f80 50%, 1000001000 #fff 20%',
      { exact: lone.exact },
    ),
    scene(
      'float64 subnormals',
      tiny.volume,
      [
        { value: 0, color: [0, 0, 0], opacity: 0 },
        { value: 2e-310, color: [0, 0.5, 1], opacity: 0.1 },
        { value: 4e-310, color: [1, 1, 1], opacity: 0.5 },
      ],
      { exact: tiny.exact },
    ),
  ];
}

/** A random transfer function over random data; stops are often at data values: labels, air, wide domains, floats. */
export function drawLots(seed: number): Classified {
  const random = randomNumbers(seed);
  const below = (n: number): number => Math.floor(random() * n);
  const pick = <T>(list: readonly T[]): T => list[below(list.length)];
  const kind = pick(['uint8', 'uint16', 'float32'] as const);
  const max = kind === 'uint8' ? 255 : pick([100, 2000, 65535]);
  const scaling = pick([
    [1, 0],
    [1, -1024],
    [0.1, 0],
    [-1, 500],
    [0.0037, 12.5],
  ] as const);
  const labels = Array.from({ length: 3 + below(3) }, () => below(max + 1));
  const air = pick([0, 0, below(max)]);
  const smooth = pick([0, 0, 0.3, 1]);
  const waves = (x: number, y: number, z: number): number => max * wave(x, y, z);
  const field = (x: number, y: number, z: number): number =>
    (1 - smooth) * shellsOf(labels, air)(x, y, z) + smooth * waves(x, y, z);
  const samples = fill(new { uint8: Uint8Array, uint16: Uint16Array, float32: Float32Array }[kind](count), (x, y, z) =>
    kind === 'float32' ? field(x, y, z) : Math.round(field(x, y, z)),
  );
  const volume = volumeOf(samples, scaling[0], scaling[1]);
  const value = (stored: number): number => scaling[0] * stored + scaling[1];
  const places = Array.from({ length: 1 + below(6) }, () => (random() < 0.6 ? pick([air, ...labels]) : random() * max));
  const values = [...places, ...(random() < 0.7 ? [0, max] : []), ...(random() < 0.2 ? [1e6] : [])].map(value);
  const bands = random() < 0.4;
  const sorted = Float64Array.from(values);
  sorted.sort();
  const transferFunction = [...sorted].flatMap((at) => {
    const stop = (): TransferFunction[number] => ({
      value: at,
      color: [random(), random(), random()],
      opacity: random() < 0.4 ? 0 : random() < 0.05 ? 1 : random() * pick([0.05, 0.5, 0.9]),
    });
    return bands && random() < 0.7 ? [stop(), stop()] : [stop()];
  });
  const more = {
    theta: random() * 6,
    phi: 0.3 + random() * 2.5,
    steps: pick([20, 40, 80]),
    lengths: pick([10, 40, 300]),
  };
  const text = transferFunction
    .map(({ value: at, color, opacity }) => `${at} ${color.map((x) => x.toFixed(2)).join('/')} ${opacity.toFixed(3)}`)
    .join(', ');
  return scene(
    `seed ${seed}: ${kind} * ${scaling.join(' + ')} of ${labels.join(' ')}, air ${air}, smooth ${smooth}: ${text}; ${JSON.stringify(more)}`,
    volume,
    transferFunction,
    more,
  );
}

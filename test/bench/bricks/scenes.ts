// Data, looks and views of `npm run bench -- bricks`.
import { orbitCamera, framingDistance } from '../../../src/optics/rays/camera.ts';
import type { Camera, Orbit } from '../../../src/optics/rays/camera.ts';
import { parseTransferFunction } from '../../../src/optics/transfer/parse-transfer-function.ts';
import { resolveTransferFunction } from '../../../src/optics/transfer/resolve-transfer-function.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { windowFromHistogram } from '../../../src/optics/transfer/window.ts';
import { polarField } from '../../../src/radar/twins.ts';
import { boundingSphere, cartesianGrid, unitToWorld } from '../../../src/volume/grid.ts';
import { axialIndexToWorld } from '../../../src/volume/grid.ts';
import { summarize } from '../../../src/volume/histogram.ts';
import { transformPoint } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { longestEdgeShare } from '../../../src/volume/reference-length.ts';
import type { Samples } from '../../../src/volume/samples.ts';
import { isPolar } from '../../../src/volume/volume.ts';
import type { CartesianGrid } from '../../../src/volume/grid.ts';
import { decodeBytes } from '../../helpers/decode.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';
import { veilValue } from '../../accuracy/small-volumes.ts';

/** A volume of the bench with the transfer functions that it is drawn with. */
export interface BrickScene {
  readonly name: string;
  readonly grid: CartesianGrid;
  readonly samples: Samples;
  readonly slope: number;
  readonly intercept: number;
  readonly looks: readonly { readonly name: string; readonly transferFunction: TransferFunction }[];
  readonly referenceLength: number;
}

/** A view, and where a crosshair would be. */
export interface BrickView {
  readonly name: string;
  readonly camera: Camera;
  readonly crosshair: Vector3;
}

/** How a file of the shared data is read; null where it is not here. */
type ReadShared = (path: string) => Promise<Uint8Array<ArrayBuffer> | null>;

const opaqueRamp = '0% #2a4a7a 0, 40% #2a4a7a 4%, 50% #ffe8c0 100%, 100% white 100%';
const peaks =
  '19.5% #48c 0, 20% #48c 60%, 20.5% #48c 0, 44.5% #f93 0, 45% #f93 60%, 45.5% #f93 0, 69.5% #fff 0, 70% #fff 60%, 70.5% #fff 0';

async function withLooks(
  name: string,
  data: Pick<BrickScene, 'grid' | 'samples' | 'slope' | 'intercept'>,
  looks: Readonly<Record<string, string>>,
  window?: readonly [number, number],
): Promise<BrickScene> {
  const span = window ?? windowFromHistogram(summarize(data.samples, data.slope, data.intercept).histogram);
  return {
    name,
    ...data,
    referenceLength: longestEdgeShare(data.grid),
    looks: await Promise.all(
      Object.entries(looks).map(async ([look, text]) => ({
        name: look,
        transferFunction: /^[a-z-]+$/.test(text)
          ? await resolveTransferFunction(text, span)
          : parseTransferFunction(text, span),
      })),
    ),
  };
}

/** A volume by its id; null where its file is not here. */
export const brickScenes: Readonly<Record<string, (read: ReadShared) => Promise<BrickScene | null>>> = {
  head: (read) =>
    fromFile(read, 'medical/ch2_mricron/ch2.nii.gz', 'MRI of a head, 8 bit', {
      smooth: 'mri',
      surface: opaqueRamp,
      peaks,
    }),
  cranium: (read) =>
    fromFile(read, 'medical/cranium_ct/cranium_ct.nii.gz', 'CT of a skull, 16 bit', {
      bone: 'ct-bone',
      'soft tissue': 'ct-soft-tissue',
      surface: '-250 #2a4a7a 0, 150 #2a4a7a 2%, 300 #ffe8c0 100%, 2000 white 100%',
    }),
  storm: readStorm,
  specks: () => Promise.resolve(makeSpecks()),
  shells: () => Promise.resolve(makeShells()),
};

async function fromFile(
  read: ReadShared,
  path: string,
  name: string,
  looks: Readonly<Record<string, string>>,
): Promise<BrickScene | null> {
  const bytes = await read(path);
  if (!bytes) return null;
  const volume = await decodeBytes(bytes, path);
  if (isPolar(volume)) throw new Error(`${path}: expected voxels`);
  return withLooks(name, { ...volume, grid: volume.grid as CartesianGrid }, looks);
}

/** A thunderstorm, from a radar's own geometry to voxels of 1 km, and of 250 m upwards: as weather services grid them. */
async function readStorm(read: ReadShared): Promise<BrickScene | null> {
  const path = 'radar/odim_au40_captainsflat/40_20181220_060630.pvol.h5';
  const bytes = await read(path);
  if (!bytes) return null;
  const volume = await decodeBytes(bytes, path, { moment: 'DBZH' });
  if (!isPolar(volume)) throw new Error(`${path}: expected a radar`);
  const field = polarField(volume);
  const dimensions: Vector3 = [448, 448, 64];
  const samples = new Uint8Array(dimensions[0] * dimensions[1] * dimensions[2]);
  // 0 is "no echo", as in files of weather services; 1 to 255 are -32 dBZ and above, half a dBZ each.
  let at = 0;
  for (let k = 0; k < dimensions[2]; k++)
    for (let j = 0; j < dimensions[1]; j++)
      for (let i = 0; i < dimensions[0]; i++, at++) {
        const place = [i, j, k].map((n, axis) => (n + 0.5) / dimensions[axis]) as unknown as Vector3;
        const { value, valid } = field.sampleAt(place);
        samples[at] = valid ? Math.min(255, Math.max(0, Math.round(2 * (value + 32.5)))) : 0;
      }
  const box = transformPoint(unitToWorld(volume.grid), [1, 1, 1]).map(
    (high, axis) => high - transformPoint(unitToWorld(volume.grid), [0, 0, 0])[axis],
  );
  // Heights four times as large, as radar volumes are usually shown.
  const spacing = box.map(
    (edge, axis) => ((axis === 2 ? 4 : 1) * Math.abs(edge)) / dimensions[axis],
  ) as unknown as Vector3;
  const grid = cartesianGrid(dimensions, axialIndexToWorld(dimensions, spacing));
  return withLooks(
    'Storm of a radar as voxels, 8 bit',
    { grid, samples, slope: 0.5, intercept: -32.5 },
    {
      dbz: 'radar-dbz',
      cores: '35 #fdf802 0, 45 #fd9500 60%, 55 #d40000 100%, 70 #9854c6 100%',
      peaks: '9.5 #48c 0, 10 #48c 60%, 10.5 #48c 0, 29.5 #f93 0, 30 #f93 60%, 30.5 #f93 0',
    },
    [-10, 70],
  );
}

/** Specks of one voxel, spheres of two to twelve voxels and threads of one voxel, in a veil. */
function makeSpecks(): Promise<BrickScene> {
  const edge = 256;
  const random = randomNumbers(40);
  const samples = new Uint8Array(edge ** 3).map(() => veilValue + 6 * random());
  const ball = (radius: number, value: number): void => {
    const center = [0, 1, 2].map(() => Math.floor(random() * edge));
    const reach = Math.ceil(radius);
    for (let c = -reach; c <= reach; c++)
      for (let b = -reach; b <= reach; b++)
        for (let a = -reach; a <= reach; a++) {
          const [i, j, k] = [center[0] + a, center[1] + b, center[2] + c];
          if (a * a + b * b + c * c <= radius * radius && [i, j, k].every((n) => n >= 0 && n < edge))
            samples[i + edge * (j + edge * k)] = value;
        }
  };
  for (let n = 0; n < 300; n++) ball(0, 220);
  for (let n = 0; n < 60; n++) ball(1.5, 200);
  for (let n = 0; n < 20; n++) ball(4, 180);
  for (let n = 0; n < 5; n++) ball(12, 150);
  const grid = cubeGrid(edge);
  return withLooks(
    'Specks and balls in a veil, by formula, 8 bit',
    { grid, samples, slope: 1, intercept: 0 },
    {
      veil: '0 #247 0, 20 #247 0, 40 #247 0.6%, 120 #247 0.6%, 180 #fd8 60%, 255 #fd8 60%',
      solid: '0 #fd8 0, 100 #fd8 0, 180 #fd8 60%, 255 #fd8 60%',
      fog: '0 #247 0, 255 #fd8 12%',
    },
    [0, 255],
  );
}

/** Fractal noise, half as strong at each octave, that bends a shell and roughens it: detail at every scale. */
function makeShells(): Promise<BrickScene> {
  const edge = 256;
  const samples = new Uint16Array(edge ** 3);
  const octaves = [4, 8, 16, 32, 64, 128].map((nodes, n) => ({
    ...latticeNoise(nodes, 7 + n),
    strength: 0.5 ** (n + 1),
  }));
  let at = 0;
  for (let k = 0; k < edge; k++)
    for (let j = 0; j < edge; j++)
      for (let i = 0; i < edge; i++, at++) {
        const [x, y, z] = [(i + 0.5) / edge, (j + 0.5) / edge, (k + 0.5) / edge];
        let noise = 0;
        for (const { at: valueAt, strength } of octaves) noise += strength * valueAt(x, y, z);
        const distance = Math.hypot(x - 0.5, y - 0.5, z - 0.5) - 0.36 + 0.24 * (noise - 0.5);
        samples[at] = Math.round(60000 * Math.exp(-((distance * 16) ** 2)) * (0.5 + noise));
      }
  return withLooks(
    'Shell of fractal noise, by formula, 16 bit',
    { grid: cubeGrid(edge), samples, slope: 1 / 65535, intercept: 0 },
    { smooth: 'mri', surface: opaqueRamp, peaks },
    [0, 1],
  );
}

function latticeNoise(nodes: number, seed: number): { readonly at: (x: number, y: number, z: number) => number } {
  const random = randomNumbers(seed);
  const width = nodes + 2;
  const values = Float32Array.from({ length: width ** 3 }, random);
  return {
    at: (x, y, z) => {
      const [u, v, w] = [x * nodes, y * nodes, z * nodes];
      const [i, j, k] = [Math.floor(u), Math.floor(v), Math.floor(w)];
      const [a, b, c] = [u - i, v - j, w - k];
      const first = i + width * (j + width * k);
      const line = (n: number): number => values[n] + a * (values[n + 1] - values[n]);
      const plane = (n: number): number => line(n) + b * (line(n + width) - line(n));
      return plane(first) + c * (plane(first + width * width) - plane(first));
    },
  };
}

const cubeGrid = (edge: number): CartesianGrid =>
  cartesianGrid([edge, edge, edge], axialIndexToWorld([edge, edge, edge], [1, 1, 1]));

const fieldOfView = 0.6;

/** The views of a volume: all of it from two sides, and from near a place away from its middle. */
export function listViews(grid: CartesianGrid): BrickView[] {
  const { center, radius } = boundingSphere(grid);
  const aside = transformPoint(unitToWorld(grid), [0.62, 0.6, 0.55]);
  const far = 0.8 * framingDistance(radius, fieldOfView, 1);
  const view = (name: string, orbit: Orbit, target: Vector3): BrickView => ({
    name,
    camera: orbitCamera(orbit, target, fieldOfView),
    crosshair: target,
  });
  return [
    view('front', { theta: 0.1, phi: 1.5, radius: far }, center),
    view('slanted', { theta: 0.9, phi: 1, radius: far }, center),
    view('near', { theta: 0.5, phi: 1.2, radius: 0.3 * far }, aside),
  ];
}

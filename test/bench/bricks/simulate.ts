// The simulator of `npm run bench -- bricks`: bytes and seconds to a picture of a given error, by policy. It needs no GPU.
import { brighten } from '../../../src/optics/transfer/brighten.ts';
import { projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import { setUpRays } from '../../../src/optics/rays/rays.ts';
import { describeBrick } from '../../../src/bricks/choose-bricks.ts';
import type { BrickCells } from '../../../src/bricks/choose-bricks.ts';
import { hiddenByTable } from '../../../src/bricks/hidden-values.ts';
import { buildPyramid, copyBrick, countBricks, listBricks } from '../../../src/bricks/pyramid.ts';
import type { Pyramid } from '../../../src/bricks/pyramid.ts';
import { learnDetail, measureOctaves } from '../../../src/bricks/learn-detail.ts';
import type { Octave } from '../../../src/bricks/learn-detail.ts';
import { measureResiduals } from '../../../src/bricks/residuals.ts';
import type { ResidualTable } from '../../../src/bricks/residuals.ts';
import { sumSpans } from '../../../src/bricks/span-sums.ts';
import { finestSpacing } from '../../../src/volume/grid.ts';
import type { CoveredError } from '../../helpers/covered-error.ts';
import { arrivalTimes } from './network.ts';
import type { Network } from './network.ts';
import { atOnce, crosshairOrder, errorOrder, nearestLevelOrder, resolveLevels } from './policies.ts';
import type { LoadOrder, PolicyInput } from './policies.ts';
import { brickScenes, listViews } from './scenes.ts';
import type { BrickScene } from './scenes.ts';
import { judgeView, macrocellsOf } from './truth.ts';
import type { Judge } from './truth.ts';

export interface Settings {
  readonly scenes: readonly string[];
  readonly looks?: readonly string[];
  readonly views?: readonly string[];
  /** Voxels of a brick along each axis. */
  readonly side: number;
  /** Voxels of a block of the table along each axis. */
  readonly tableSide: number;
  /** Rays of a measured picture, across and down. */
  readonly size: number;
  /** Pixels of the picture that policies aim at. */
  readonly pixels: number;
  /** Rays of an estimate, across and down. */
  readonly probes: number;
  readonly errors: readonly number[];
  readonly networks: readonly Network[];
  readonly read: (path: string) => Promise<Uint8Array<ArrayBuffer> | null>;
  readonly pack: (bytes: Uint8Array) => Uint8Array;
  readonly log: (text: string) => void;
}

/** When a policy has reached an error. */
export interface Reached {
  readonly error: number;
  readonly bricks: number;
  readonly bytes: number;
  /** Seconds, by network. */
  readonly seconds: readonly number[];
}

export interface PolicyResult {
  readonly policy: string;
  /** By error; null where it is not reached even with all bricks. */
  readonly reached: readonly (Reached | null)[];
  /** What was said and what was true, wherever both are known. */
  readonly stated: readonly { readonly stated: number; readonly true: CoveredError; readonly bytes: number }[];
}

export interface SceneResult {
  readonly scene: string;
  readonly look: string;
  readonly view: string;
  /** Bytes of all bricks that are in the picture. */
  readonly totalBytes: number;
  readonly tableBytes: number;
  /** With the coarsest level alone. */
  readonly coarsest: CoveredError;
  readonly policies: readonly PolicyResult[];
}

/** A pyramid with all that does not depend on a view. */
interface PackedScene {
  readonly pyramid: Pyramid;
  readonly bricks: readonly BrickCells[];
  readonly table: ResidualTable;
  readonly tableBytes: number;
  readonly octaves: readonly Octave[];
}

export async function* simulate(settings: Settings): AsyncGenerator<SceneResult> {
  for (const id of settings.scenes) {
    const scene = await brickScenes[id](settings.read);
    if (!scene) {
      settings.log(`${id}: left out, as there is no ../shared/data`);
      continue;
    }
    const packed = packScene(scene, settings);
    const macrocells = macrocellsOf(packed.pyramid);
    for (const look of scene.looks) {
      if (settings.looks && !settings.looks.includes(look.name)) continue;
      for (const view of listViews(scene.grid)) {
        if (settings.views && !settings.views.includes(view.name)) continue;
        const { camera, crosshair } = view;
        const rays = setUpRays(scene.grid, viewMatrix(camera), projectionMatrix(camera.fieldOfView, 1, 1, 2))!;
        const { pyramid, bricks, table, tableBytes } = packed;
        const cells = countBricks(pyramid, 0).reduce((a, b) => a * b);
        const judge = judgeView(scene, pyramid, macrocells, {
          transferFunction: look.transferFunction,
          rays,
          size: settings.size,
        });
        const input: PolicyInput = { pyramid, grid: scene.grid, camera, crosshair, pixels: settings.pixels, bricks };
        const range = [minOf(table.low), maxOf(table.high)] as const;
        const detail = {
          rays,
          sums: sumSpans(brighten(look.transferFunction, 1), range, {
            ...scene,
            stepRatio: finestSpacing(scene.grid) / scene.referenceLength,
          }),
          step: finestSpacing(scene.grid) / rays.diameter,
          hidden: hiddenByTable(table, scene.grid.dimensions),
          across: settings.probes,
        };
        const learnt = learnDetail(pyramid, packed.octaves, scene.grid.dimensions, range);
        const policies: Record<string, LoadOrder> = {
          'by error': errorOrder(input, detail, { tableBytes }),
          'by error, learnt': errorOrder(
            input,
            { ...detail, hidden: learnt },
            { tableBytes: 0, learn: (levelOf) => learnt.update(levelOf) },
          ),
          'nearest level': nearestLevelOrder(input),
          crosshair: crosshairOrder(input),
        };
        yield {
          scene: scene.name,
          look: look.name,
          view: view.name,
          totalBytes: sum(policies['nearest level'].bricks.map(({ bytes }) => bytes)),
          tableBytes,
          coarsest: judge.errorOf(new Uint8Array(cells).fill(pyramid.levels.length - 1)),
          policies: Object.entries(policies).map(([policy, order]) => ({
            policy,
            ...findReached({ order, judge, pyramid, cells }, settings),
          })),
        };
      }
    }
  }
}

function packScene({ samples, grid }: BrickScene, { side, tableSide, pack }: Settings): PackedScene {
  const pyramid = buildPyramid({ samples, dimensions: grid.dimensions }, side);
  const bricks = pyramid.levels.flatMap((_, level) =>
    listBricks(pyramid, level).map((brick) => {
      const { buffer } = copyBrick(pyramid, brick);
      return describeBrick(pyramid, brick, pack(new Uint8Array(buffer)).length);
    }),
  );
  const table = measureResiduals(pyramid, tableSide);
  return { pyramid, bricks, table, tableBytes: pack(packTable(table)).length, octaves: measureOctaves(pyramid) };
}

/** A table as a file would have it: a byte for each number, on a scale by factors of 2^(1/8), rounded up. */
function packTable({ low, high, levels }: ResidualTable): Uint8Array {
  const range = maxOf(high) - minOf(low);
  const code = (value: number): number => Math.max(0, Math.min(255, 255 + Math.ceil(8 * Math.log2(value / range))));
  return Uint8Array.from([
    ...[low, high].flatMap((values) => [...values].map((value) => Math.round((255 * (value - minOf(low))) / range))),
    ...levels.slice(1).flatMap(({ rms, max }) => [rms, max].flatMap((values) => [...values].map(code))),
  ]);
}

/** One policy's order in one view. */
interface Course {
  readonly order: LoadOrder;
  readonly judge: Judge;
  readonly pyramid: Pyramid;
  /** Number of cells. */
  readonly cells: number;
}

/** Each count of bricks whose error is measured first has at least so many times the bytes of the one before. */
const stride = 1.4;

/** How exactly the bytes are found between two of them. */
const exactly = 1.05;

function findReached(
  { order: { bricks, tableBytes, stated }, judge, pyramid, cells }: Course,
  { errors, networks }: Settings,
): Omit<PolicyResult, 'policy'> {
  const top = pyramid.levels.length - 1;
  const first = bricks.filter(({ brick }) => brick.level === top).length;
  // After so many bricks.
  const bytes = new Float64Array(bricks.length + 1);
  bytes[0] = tableBytes;
  bricks.forEach((one, n) => (bytes[n + 1] = bytes[n] + one.bytes));
  const known = new Map<number, CoveredError>();
  const errorAt = (count: number): CoveredError => {
    let error = known.get(count);
    if (!error) {
      const levelOf = new Uint8Array(cells).fill(top);
      resolveLevels(levelOf, bricks.slice(0, count));
      known.set(count, (error = judge.errorOf(levelOf)));
    }
    return error;
  };
  // From the coarsest level to all bricks, or until nothing more is asked for.
  const counts = [first];
  const enough = Math.min(...errors) / 2;
  for (let count = first, below = 0; count < bricks.length && below < 2; counts.push(count)) {
    const next = bytes.findIndex((sum, n) => n > count && sum >= stride * bytes[count]);
    count = next < 0 ? bricks.length : next;
    below = errorAt(count).e < enough ? below + 1 : 0;
  }
  /** The fewest bricks between two counts, of which the second one is enough, that keep an error. */
  const narrow = (low: number, high: number, error: number): number => {
    if (high - low <= 1 || bytes[high] <= exactly * bytes[low]) return high;
    const middle = (low + high) >> 1;
    return errorAt(middle).e <= error ? narrow(low, middle, error) : narrow(middle, high, error);
  };
  const times = networks.map((network) =>
    arrivalTimes([tableBytes, ...bricks.map((one) => one.bytes)], network, { atOnce, first: first + 1 }),
  );
  const reached = errors.map((error) => {
    // From this count on, the error is kept.
    let good = counts.length;
    while (good > 0 && errorAt(counts[good - 1]).e <= error) good--;
    if (good === counts.length) return null;
    const count = good > 0 ? narrow(counts[good - 1], counts[good], error) : first;
    return { error, bricks: count, bytes: bytes[count], seconds: times.map((time) => time[count]) };
  });
  return {
    reached,
    stated: [...stated]
      .filter(([count]) => known.has(count))
      .map(([count, said]) => ({ stated: said, true: known.get(count)!, bytes: bytes[count] })),
  };
}

const sum = (values: readonly number[]): number => values.reduce((a, b) => a + b, 0);
const minOf = (values: Float32Array): number => values.reduce((a, b) => Math.min(a, b), Infinity);
const maxOf = (values: Float32Array): number => values.reduce((a, b) => Math.max(a, b), -Infinity);

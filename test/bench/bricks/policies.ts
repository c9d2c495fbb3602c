// Which brick is loaded next. Each policy gives the whole order, so that every prefix of it is a state of the picture.
import { projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import type { Camera } from '../../../src/optics/rays/camera.ts';
import { estimateDetail } from '../../../src/bricks/estimate-detail.ts';
import type { DetailScene } from '../../../src/bricks/detail-scene.ts';
import { chooseBricks } from '../../../src/bricks/choose-bricks.ts';
import type { BrickCells } from '../../../src/bricks/choose-bricks.ts';
import type { Pyramid } from '../../../src/bricks/pyramid.ts';
import { detailField } from '../../../src/bricks/resident-field.ts';
import { multiply, transformPoint } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { unitToWorld } from '../../../src/volume/grid.ts';
import type { CartesianGrid } from '../../../src/volume/grid.ts';

/** Bricks in the order in which they are asked for, the coarsest level first. */
export interface LoadOrder {
  readonly bricks: readonly BrickCells[];
  /** Bytes that are loaded with the coarsest level. */
  readonly tableBytes: number;
  /** What was said about the picture after so many bricks: the error that is left, in 1/255. */
  readonly stated: ReadonlyMap<number, number>;
}

export interface PolicyInput {
  readonly pyramid: Pyramid;
  readonly grid: CartesianGrid;
  readonly camera: Camera;
  readonly crosshair: Vector3;
  /** Pixels of the picture, across and down. */
  readonly pixels: number;
  /** All bricks of all levels. */
  readonly bricks: readonly BrickCells[];
}

/** A brick with its box in the world, and what the view sees of it. */
interface Placed {
  readonly cells: BrickCells;
  /** World length from the eye, and from the crosshair, to the nearest point of its bounding sphere. */
  readonly fromEye: number;
  readonly fromCrosshair: number;
  /** World length of its longest edge. */
  readonly edge: number;
  /** World length of its voxels. */
  readonly voxel: number;
}

function placeBricks({ pyramid, grid, camera, crosshair, bricks }: PolicyInput): Placed[] {
  const toWorld = unitToWorld(grid);
  const clip = multiply(projectionMatrix(camera.fieldOfView, 1, 1, 2), viewMatrix(camera));
  const top = pyramid.levels.length - 1;
  return bricks.flatMap((cells) => {
    const { level, at } = cells.brick;
    const scale = 2 ** level;
    const ends = [0, 1].map((end) =>
      at.map((n, axis) => Math.min(1, ((n + end) * pyramid.side * scale) / grid.dimensions[axis])),
    );
    const corners = Array.from({ length: 8 }, (_, c) =>
      transformPoint(toWorld, [ends[c & 1][0], ends[(c >> 1) & 1][1], ends[c >> 2][2]]),
    );
    // What is outside of the picture is never asked for.
    const seen = corners.map((p) =>
      [0, 4, 12].map((r) => clip[r] * p[0] + clip[r + 1] * p[1] + clip[r + 2] * p[2] + clip[r + 3]),
    );
    const isOutside =
      seen.every(([x, , w]) => x > w) ||
      seen.every(([x, , w]) => x < -w) ||
      seen.every(([, y, w]) => y > w) ||
      seen.every(([, y, w]) => y < -w) ||
      seen.every(([, , w]) => w <= 0);
    if (isOutside && level < top) return [];
    const [low, high] = [Math.min, Math.max].map((choose) =>
      [0, 1, 2].map((axis) => choose(...corners.map((p) => p[axis]))),
    );
    const distance = (p: Vector3): number =>
      Math.hypot(...p.map((x, axis) => Math.max(0, low[axis] - x, x - high[axis])));
    return [
      {
        cells,
        fromEye: distance(camera.eye),
        fromCrosshair: distance(crosshair),
        edge: Math.max(...low.map((x, axis) => high[axis] - x)),
        voxel: Math.max(...grid.spacing) * scale,
      },
    ];
  });
}

const inOrder = (placed: readonly Placed[], key: (one: Placed) => readonly number[]): LoadOrder => {
  const keyed = placed.map((one) => ({ one, key: key(one) }));
  keyed.sort((a, b) => {
    const first = a.key.findIndex((x, i) => x !== b.key[i]);
    return first < 0 ? 0 : a.key[first] - b.key[first];
  });
  return { bricks: keyed.map(({ one }) => one.cells), tableBytes: 0, stated: new Map() };
};

/**
 * A brick is wanted as soon as the voxels of the next coarser level appear larger than some pixels. The limit is 8 pixels at first, as in
 * Kiln, and then half as large again and again, so that the policy goes on where the others do; at each limit coarse bricks come first,
 * and the nearest first.
 */
export function nearestLevelOrder(input: PolicyInput): LoadOrder {
  const { camera, pixels, pyramid } = input;
  const top = pyramid.levels.length - 1;
  return inOrder(placeBricks(input), ({ cells, fromEye, voxel }) => {
    const { level } = cells.brick;
    if (level === top) return [-1, 0, 0];
    const size = (2 * voxel * pixels) / (2 * Math.tan(camera.fieldOfView / 2) * Math.max(fromEye, voxel));
    return [Math.max(0, Math.ceil(Math.log2(8 / size))), -level, fromEye];
  });
}

/** The finer, the nearer to the crosshair: a brick is wanted once its distance is below so many of its edges. */
export function crosshairOrder(input: PolicyInput): LoadOrder {
  const top = input.pyramid.levels.length - 1;
  return inOrder(placeBricks(input), ({ cells, fromCrosshair, edge }) =>
    cells.brick.level === top ? [-1, 0] : [fromCrosshair / edge, -cells.brick.level],
  );
}

/** Requests at once. */
export const atOnce = 8;

/**
 * The brick that brings most a byte. What is on its way is not known yet: each choice knows the bricks of all choices but the last one.
 * @param tableBytes - of what is known beside the voxels, 0 if nothing is
 */
export function errorOrder(
  input: PolicyInput,
  detail: Omit<DetailScene, 'field'>,
  { tableBytes, learn }: { readonly tableBytes: number; readonly learn?: (levelOf: Uint8Array) => void },
): LoadOrder {
  const { pyramid } = input;
  const top = pyramid.levels.length - 1;
  const placed = placeBricks(input);
  const bricks = placed.filter(({ cells }) => cells.brick.level === top).map(({ cells }) => cells);
  let rest = placed.filter(({ cells }) => cells.brick.level < top);
  const count = Math.max(...bricks.flatMap(({ cells }) => cells)) + 1;
  const known = new Uint8Array(count).fill(top);
  const asked = known.slice();
  const stated = new Map<number, number>();
  for (let turn = 0, last: readonly BrickCells[] = []; rest.length > 0; turn++) {
    learn?.(known);
    const { gains, rms } = estimateDetail(
      {
        ...detail,
        field: detailField(pyramid, known),
        shift: [(turn * 0.618) % 1, (turn * 0.7549) % 1],
      },
      count,
    );
    stated.set(bricks.length - last.length, rms);
    const chosen = new Set(
      chooseBricks(
        pyramid,
        rest.map(({ cells }) => cells),
        { gains, levelOf: asked, count: Math.max(atOnce, Math.ceil(bricks.length / 24)) },
      ).map(({ brick }) => brick),
    );
    resolveLevels(known, last);
    if (chosen.size === 0 && last.length === 0) break;
    // In the order of the choice.
    const byBrick = new Map(rest.map(({ cells }) => [cells.brick, cells]));
    last = [...chosen].map((brick) => byBrick.get(brick)!);
    resolveLevels(asked, last);
    bricks.push(...last);
    rest = rest.filter(
      ({ cells }) => !chosen.has(cells.brick) && cells.cells.some((cell) => asked[cell] > cells.brick.level),
    );
  }
  // What seems to bring nothing comes at the end, coarse levels and near bricks first.
  rest.sort((a, b) => b.cells.brick.level - a.cells.brick.level || a.fromEye - b.fromEye);
  bricks.push(...rest.map(({ cells }) => cells));
  return { bricks, tableBytes, stated };
}

/** Gives cells the levels of bricks that have come. */
export function resolveLevels(levelOf: Uint8Array, bricks: readonly BrickCells[]): void {
  for (const { brick, cells } of bricks) for (const cell of cells) levelOf[cell] = Math.min(levelOf[cell], brick.level);
}

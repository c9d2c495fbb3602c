import { spacingOf, unitToWorld } from '../volume/grid.ts';
import type { GridFrame } from '../volume/grid.ts';
import { invertAffine, multiply, scaleAndTranslate } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { brickHalo, brickSide, slotSide } from './brick-data.ts';
import type { BrickLevel } from './brick-data.ts';
import { chooseGroupSide } from './cell-numbers.ts';
import { mostLayersOfTable, shapeTable, tableBytes, tableDepth } from './page-table.ts';
import type { Brick } from './pyramid.ts';

export const slotDimensions: Vector3 = [slotSide, slotSide, slotSide];

/** Levels of bricks at most: programs know the scales of so many, and that of the volume. Twin: shaders/chunks/field/bricks-3d.glsl */
export const mostLevels = 15;

/** A level of a pyramid over the unit cube of a volume. */
export interface LevelFrame extends Pick<BrickLevel, 'dimensions' | 'bricks' | 'factors'> {
  /** Voxels of the level = scale * place + shift; whole numbers are at the faces between voxels. */
  readonly scale: Vector3;
  readonly shift: Vector3;
}

/** Levels that lie as bricks over a volume, finest first, and cells (bricks of the finest level) that say which brick is where. */
export interface BrickLayout {
  readonly levels: readonly LevelFrame[];
  /** Cells along each axis; and of a group of them, see `CellNumbers`. */
  readonly cells: Vector3;
  readonly groupSide: number;
  /** The finest level over the volume's own unit cube. */
  readonly finest: GridFrame;
}

/** Bricks, and the volume over which they lie, in one 3D texture: the volume with its halo first, then layers of slots along z. */
export interface AtlasShape {
  /** Slots along x and y. */
  readonly columns: number;
  readonly rows: number;
  /** Texels along x and y. */
  readonly width: number;
  readonly height: number;
  /** Texels of the volume along z. */
  readonly depth: number;
  /** Slots of a layer: the atlas grows by whole layers. */
  readonly slotsOfLayer: number;
}

/** Slots of an atlas along x and y, where the volume itself is not wider: at most so many. */
const mostColumns = 16;

/** Texels along z for which an atlas is made: most devices have so many. Source: WebGL Report, MAX_3D_TEXTURE_SIZE */
const usualDepth = 2048;

/**
 * The smallest atlas that has room for so many slots, or as many as there may be: what is wider than the volume is lost next to it, and next to slots what is
 * wider than these.
 * @param dimensions - of the volume
 */
export function shapeAtlas([nx, ny, nz]: Vector3, slots = Infinity): AtlasShape {
  const [volumeWidth, volumeHeight, depth] = [nx, ny, nz].map((n) => n + 2 * brickHalo);
  const mostLayers = Math.max(1, Math.floor((usualDepth - depth) / slotSide));
  let best: AtlasShape | null = null;
  let least = Infinity;
  const [widest, highest] = [volumeWidth, volumeHeight].map((n) => Math.max(mostColumns, Math.floor(n / slotSide)));
  const wanted = Math.min(slots, widest * highest * mostLayers);
  for (let columns = Math.max(1, Math.floor(volumeWidth / slotSide)); columns <= widest; columns++)
    for (let rows = Math.max(1, Math.floor(volumeHeight / slotSide)); rows <= highest; rows++) {
      const slotsOfLayer = columns * rows;
      const layers = Math.ceil(wanted / slotsOfLayer);
      if (layers > mostLayers) continue;
      const [width, height] = [Math.max(volumeWidth, columns * slotSide), Math.max(volumeHeight, rows * slotSide)];
      const texels = width * height * (depth + layers * slotSide);
      if (texels >= least) continue;
      least = texels;
      best = { columns, rows, width, height, depth, slotsOfLayer };
    }
  return best!;
}

/** Texels along the longest edge of the smallest atlas: with one layer of slots. */
export function atlasEdge(dimensions: Vector3): number {
  const { width, height, depth } = shapeAtlas(dimensions); // With as many slots as there may be.
  return Math.max(width, height, depth + slotSide);
}

/** Slots for which an atlas has room where a texture has at most so many texels along z. */
export function slotsBelow({ depth, slotsOfLayer }: AtlasShape, texels: number): number {
  return slotsOfLayer * Math.floor((texels - depth) / slotSide);
}

/**
 * Slots that so many bytes of the GPU have room for, next to the volume and the table of pages: whole layers of the atlas.
 * @param bytesPerSample - of a texel
 */
export function slotsWithin(bytes: number, shape: AtlasShape, layout: BrickLayout, bytesPerSample: number): number {
  const { width, height, depth, slotsOfLayer } = shape;
  const slice = width * height * bytesPerSample;
  const table = shapeTable(layout);
  const hasRoom = (layers: number): boolean => {
    const ofTable = mostLayersOfTable(layout, layers * slotsOfLayer);
    const needed = slice * (depth + layers * slotSide) + tableBytes(table, ofTable);
    return needed <= bytes && tableDepth(table, ofTable) <= usualDepth;
  };
  let layers = Math.max(0, Math.floor((bytes / slice - depth) / slotSide));
  while (layers > 0 && !hasRoom(layers)) layers--;
  return slotsOfLayer * layers;
}

/** The first texel of a slot. */
export function placeOfSlot({ columns, rows, depth, slotsOfLayer }: AtlasShape, slot: number): Vector3 {
  return [
    slotSide * (slot % columns),
    slotSide * (Math.floor(slot / columns) % rows),
    depth + slotSide * Math.floor(slot / slotsOfLayer),
  ];
}

/** How far a level's axes may turn away from the volume's, in voxels over its whole length. */
const maxTurn = 0.25;

/**
 * Lay bricks over a volume, which is another level of the same pyramid.
 * @param grid - of the volume
 * @param levels - finest first
 * @returns null where that can't be done: a level lies askew over the volume, or there are more than `mostLevels`
 */
export function layBricks(grid: GridFrame, levels: readonly BrickLevel[]): BrickLayout | null {
  if (levels.length > mostLevels) return null;
  const frames: LevelFrame[] = [];
  for (const { dimensions, bricks, factors, indexToWorld } of levels) {
    const back = invertAffine(indexToWorld);
    if (!back) return null;
    const m = multiply(back, unitToWorld(grid));
    const scale: Vector3 = [m[0], m[5], m[10]];
    const turned = [m[1], m[2], m[4], m[6], m[8], m[9]];
    if (turned.some((x) => Math.abs(x) > maxTurn) || scale.some((x) => !(x > 0))) return null;
    frames.push({ dimensions, bricks, factors, scale, shift: [m[3] + 0.5, m[7] + 0.5, m[11] + 0.5] });
  }
  if (frames.length === 0) return null;
  const cells = frames[0].bricks;
  return { levels: frames, cells, groupSide: chooseGroupSide(cells), finest: gridOfLevel(grid, frames[0]) };
}

/** How far, in its voxels, a level may end from where one of exactly twice, four times ... as long voxels would: filters of devices see less. */
const endsAlike = 2 ** -10;

/**
 * How often voxels of each level of bricks, then those of the volume over which they lie, are twice as long as the finest ones, along each axis; null where a level's
 * voxels are longer by another factor. Finest level first.
 */
export function halvingsOf({ levels }: Pick<BrickLayout, 'levels'>, volume: Vector3): readonly Vector3[] | null {
  const scales = [...levels.map(({ scale }) => scale), volume];
  const halvings = scales.map((scale) => scale.map((n, axis) => Math.round(Math.log2(levels[0].scale[axis] / n))));
  const isHalved = halvings.every((times, level) =>
    times.every(
      (n, axis) =>
        n >= 0 && n <= mostLevels && Math.abs(levels[0].scale[axis] / 2 ** n - scales[level][axis]) < endsAlike,
    ),
  );
  return isHalved ? (halvings as unknown as readonly Vector3[]) : null;
}

/** A level as a grid over the unit cube of a volume; its voxels need not be whole there. */
export function gridOfLevel(grid: GridFrame, { scale }: LevelFrame): GridFrame {
  const each = scale.map((n) => 1 / n) as unknown as Vector3;
  const middle = each.map((x) => x / 2) as unknown as Vector3;
  const indexToWorld = multiply(unitToWorld(grid), scaleAndTranslate(each, middle));
  return { dimensions: scale, indexToWorld, spacing: spacingOf(indexToWorld) };
}

/** The cell at a place of the volume's unit cube; outside of the finest level, the nearest one. */
export function cellOfPlace({ cells, levels: [{ scale, shift }] }: BrickLayout, place: Vector3): Vector3 {
  // Without `map`: each sample of a ray in float64 asks for it.
  const along = (axis: number): number =>
    Math.min(cells[axis] - 1, Math.max(0, Math.floor((place[axis] * scale[axis] + shift[axis]) / brickSide)));
  return [along(0), along(1), along(2)];
}

/** A cell's number along each axis. @param cell - i fastest */
export function placeOfCell({ cells: [cx, cy] }: BrickLayout, cell: number): Vector3 {
  return [cell % cx, Math.floor(cell / cx) % cy, Math.floor(cell / (cx * cy))];
}

/** The brick of a level that has a cell. @param cell - its number along each axis */
export function brickOfCell({ factors, bricks }: LevelFrame, cell: Vector3): Vector3 {
  return cell.map((n, axis) => Math.min(bricks[axis] - 1, Math.floor(n / factors[axis]))) as unknown as Vector3;
}

/** The brick of a coarser level, or of the same one, that covers a brick. */
export function brickAround({ levels }: BrickLayout, { level, at }: Brick, coarser: number): Brick {
  const cell = at.map((n, axis) => n * levels[level].factors[axis]) as unknown as Vector3;
  return { level: coarser, at: brickOfCell(levels[coarser], cell) };
}

/** The number of a brick in its level, i fastest. */
export function numberOfBrick({ levels }: BrickLayout, level: number, [i, j, k]: Vector3): number {
  const [nx, ny] = levels[level].bricks;
  return i + nx * (j + ny * k);
}

/** Cells along each axis: from the first one up to, not including, the last. */
export type CellBox = readonly [Vector3, Vector3];

/** Whether two boxes have a face, an edge or a corner in common, or more. */
export function touches([low, high]: CellBox, [otherLow, otherHigh]: CellBox): boolean {
  for (let axis = 0; axis < 3; axis++) if (low[axis] > otherHigh[axis] || otherLow[axis] > high[axis]) return false;
  return true;
}

/** The cells that a brick has. */
export function cellsOfBrick({ cells, levels }: BrickLayout, level: number, at: Vector3): CellBox {
  const { factors, bricks } = levels[level];
  const low = at.map((n, axis) => Math.min(cells[axis], n * factors[axis]));
  const high = at.map((n, axis) =>
    n === bricks[axis] - 1 ? cells[axis] : Math.min(cells[axis], (n + 1) * factors[axis]),
  );
  return [low as unknown as Vector3, high as unknown as Vector3];
}

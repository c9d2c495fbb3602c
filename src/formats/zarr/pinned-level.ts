import type { BrickLevel } from '../../bricks/brick-data.ts';
import { atlasEdge } from '../../bricks/brick-layout.ts';
import { bytesOfCell } from '../../bricks/page-table.ts';
import type { DeviceLimits } from '../../volume/reduce.ts';
import { chooseGroupSide, groupsOf } from '../../bricks/cell-numbers.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { chooseKeptBytes, shareOfBrick, usualGpuBytes } from '../base/brick-limits.ts';
import type { DecodeSettings } from '../base/decoded-volume.ts';
import { chooseBrickLevels } from './brick-levels.ts';
import { chooseBrickNumbers } from './brick-numbers.ts';
import type { BrickNumbers } from './brick-numbers.ts';
import { countVoxels, isReadable, storedBytes } from './choose-level.ts';
import type { LevelBox } from './choose-level.ts';
import type { ArrayBox } from './list-chunks.ts';
import type { OmeImage } from './open-image.ts';

/** Bytes of the level that is always there: it is read as a whole before the first brick, and panes show it. */
const pinnedBytes = 2 ** 25;

/**
 * The share of the GPU's bytes that it may take, so that all views that have a context at once have room for it; and where no level is so small, the coarsest
 * one.
 */
const [shareOfPinned, shareOfCoarsest] = [1 / 7, 1 / 2];

/** Cells of the finest level that is read, and groups of them: the GPU has a 3D table with a texel for each group. */
const [maxCells, maxGroups] = [2 ** 30, 2 ** 20];

/** The share of the GPU's bytes that this table may take. */
const shareOfTable = 1 / 2;

/** A pyramid that is read in bricks: the level that is always there, as a whole, and those that come in bricks. */
export interface PinnedLevel {
  readonly box: LevelBox;
  readonly numbers: BrickNumbers;
  /** The finest first. */
  readonly levels: readonly BrickLevel[];
}

/**
 * What is read of a pyramid in bricks: one whose finest level the device can't hold, or takes more than its author allows on the GPU.
 * @param boxes - all levels as wholes, the finest first @param arrayBox - what is read of a level's array
 * @returns null for what is read as a whole, or can't be read in bricks
 */
export function choosePinned(
  image: OmeImage,
  boxes: readonly LevelBox[],
  arrayBox: (box: LevelBox) => ArrayBox,
  { limits, settings }: { readonly limits: DeviceLimits; readonly settings: DecodeSettings },
): PinnedLevel | null {
  const { maxGpuBytes, finer, region, maxBytes, spacing, indexToWorld, clean, labelDetail } = settings;
  const isPlain = [region, maxBytes, spacing, indexToWorld, clean, labelDetail].every((one) => one === undefined);
  if (!finer || !isPlain || limits.maxAtlasSize !== null || image.labels) return null;
  const { array } = boxes[0].level;
  const numbers = chooseBrickNumbers(array.type, array.littleEndian, { slope: 1, intercept: 0 });
  const bytesOf = (box: LevelBox): number => countVoxels(box) * storedBytes(array.type);
  const isSmall = (box: LevelBox, most: number): boolean =>
    bytesOf(box) <= most && Math.max(...box.dimensions) <= limits.maxVoxelsPerAxis && isReadable(box, arrayBox(box));
  if (isSmall(boxes[0], Math.min(maxGpuBytes ?? Infinity, limits.maxBytes))) return null;
  const bytes = maxGpuBytes ?? usualGpuBytes();
  const most = Math.min(pinnedBytes, bytes * shareOfPinned, limits.maxBytes);
  const coarsest = boxes[boxes.length - 1];
  // It lies in one texture with the bricks.
  const hasRoom = ({ dimensions }: LevelBox): boolean => atlasEdge(dimensions) <= limits.maxVoxelsPerAxis;
  const box =
    boxes.find((one) => isSmall(one, most) && hasRoom(one)) ??
    (hasRoom(coarsest) && isSmall(coarsest, Math.min(bytes * shareOfCoarsest, limits.maxBytes)) ? coarsest : null);
  const mostGroups = Math.min(maxGroups, (bytes * shareOfTable) / bytesOfCell);
  const hasTable = (cells: Vector3): boolean => {
    const groups = groupsOf(cells, chooseGroupSide(cells));
    const count = ([x, y, z]: Vector3): number => x * y * z;
    return count(cells) <= maxCells && count(groups) <= mostGroups && Math.max(...groups) <= limits.maxVoxelsPerAxis;
  };
  const inBricks = chooseBrickLevels(image, chooseKeptBytes() * shareOfBrick).filter(
    ({ number }) => box && number < boxes.indexOf(box),
  );
  const levels = relativeToFirst(inBricks.map(({ brick }) => brick).filter(({ bricks }) => hasTable(bricks)));
  return box && levels.length > 0 ? { box, numbers, levels } : null;
}

/** Levels whose factors count voxels of the first of them; those without whole ones are left out. */
function relativeToFirst(levels: readonly BrickLevel[]): BrickLevel[] {
  return levels
    .map(
      (level) =>
        ({ ...level, factors: level.factors.map((n, axis) => n / levels[0].factors[axis]) }) as unknown as BrickLevel,
    )
    .filter(({ factors }) => factors.every(Number.isInteger));
}

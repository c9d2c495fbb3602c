import { brickSide } from '../../bricks/brick-data.ts';
import type { BrickSamples } from '../../bricks/brick-data.ts';
import type { Brick } from '../../bricks/pyramid.ts';
import { bricksAtOnce, chooseKeptBytes, shareOfBrick } from '../base/brick-limits.ts';
import { Budget } from '../base/budget.ts';
import type { BrickStore } from '../base/brick-store.ts';
import type { DecodeSettings } from '../base/decoded-volume.ts';
import { Queue } from '../base/queue.ts';
import { untilAborted } from '../base/shared-work.ts';
import { chooseBrickLevels } from './brick-levels.ts';
import type { ZarrBrickLevel } from './brick-levels.ts';
import { chooseBrickNumbers } from './brick-numbers.ts';
import type { Scaling } from './brick-numbers.ts';
import type { BrickTree } from './brick-trees.ts';
import { chooseTime } from './choose-time.ts';
import { chooseChannels } from './ome-channels.ts';
import { openImage } from './open-image.ts';
import { readBrick } from './read-brick.ts';
import { readResiduals } from './read-residuals.ts';

/** What a pyramid is opened with. */
export interface BrickOpening {
  /** Gives up opening it, and closes it. */
  readonly signal: AbortSignal;
  /** Bytes of unpacked chunks that are kept; what this device can afford if undefined. */
  readonly keptBytes?: number;
  /** Bytes that may be held on this device; undefined where it does not say it. */
  readonly deviceBytes?: number;
  /** Of numbers that become floats: those of the ordinary volume; 1 and 0 if undefined. */
  readonly scaling?: Scaling;
}

/** Of all that are open: a page may show many. */
const queue = new Queue(bricksAtOnce);

/**
 * Opens an OME-Zarr to read one channel of one time of it in bricks.
 * @param settings - as the ordinary volume is read with
 * @returns null for what is not read in bricks: several channels, labels, a place that the page sets, and levels or chunks that do not fit bricks
 * @throws {VolumeViewError} `format/…`, `source/…`, `attribute/invalid`; the signal's reason
 */
export async function openZarrBricks(
  { tree, before, chunks: source }: BrickTree,
  settings: DecodeSettings,
  { signal, keptBytes: most = chooseKeptBytes(), deviceBytes, scaling }: BrickOpening,
): Promise<BrickStore | null> {
  const opening = { budget: new Budget(deviceBytes), signal };
  const image = await openImage(tree, settings.series && settings.series - before, opening);
  const { axes, labels } = image;
  const shown = chooseChannels(image, tree);
  if (shown.kind === 'colors' || labels || settings.spacing || settings.indexToWorld) return null;
  const levels = chooseBrickLevels(image, most * shareOfBrick);
  if (levels.length === 0) return null;
  const { time } = chooseTime(image, settings, {});
  const { array } = levels[0].level;
  const at = array.shape.map((_, axis) => (axis === axes.time ? time : axis === axes.channel ? shown.index : 0));
  const numbers = chooseBrickNumbers(array.type, array.littleEndian, scaling ?? { slope: 1, intercept: 0 });
  /** What is under way; null once the store is closed. */
  let running: Set<AbortController> | null = new Set();
  const close = (): void => {
    for (const one of running ?? []) one.abort(closedError());
    running = null;
  };
  if (signal.aborted) close();
  signal.addEventListener('abort', close, { once: true });
  /** Runs something until its own signal, or until the store is closed. */
  const untilClosed = async <T>(own: AbortSignal, run: (signal: AbortSignal) => Promise<T>): Promise<T> => {
    own.throwIfAborted();
    if (!running) throw closedError();
    const either = new AbortController();
    const stop = (): void => either.abort(own.reason);
    running.add(either);
    own.addEventListener('abort', stop, { once: true });
    try {
      return await untilAborted(run(either.signal), either.signal);
    } finally {
      own.removeEventListener('abort', stop);
      running?.delete(either);
    }
  };
  return {
    side: brickSide,
    type: numbers.type,
    slope: numbers.slope,
    intercept: numbers.intercept,
    levels: levels.map(({ brick }) => brick),
    read: (brick, own, isAlone = false) => {
      checkBrick(levels, brick);
      const read = async (either: AbortSignal): Promise<BrickSamples> => {
        either.throwIfAborted();
        const reading = { brick, isAlone, at, space: axes.space, numbers, signal: either };
        return readBrick(source, levels[brick.level], reading);
      };
      // What is given up makes room for others at once: a page that has gone never answers.
      return untilClosed(own, (either) => queue.run(() => untilAborted(read(either), either)));
    },
    residuals: (own) =>
      untilClosed(own, (either) => readResiduals(tree, { image, levels, numbers, deviceBytes, signal: either })),
    close() {
      signal.removeEventListener('abort', close);
      close();
    },
  };
}

const closedError = (): Error => new DOMException('the bricks are closed', 'AbortError');

function checkBrick(levels: readonly ZarrBrickLevel[], { level, at }: Brick): void {
  const bricks = levels[level]?.brick.bricks;
  if (!bricks || !at.every((n, axis) => Number.isInteger(n) && n >= 0 && n < bricks[axis]))
    throw new RangeError(`there is no brick ${at.join(', ')} of level ${level}`);
}

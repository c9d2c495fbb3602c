import type { BrickSamples } from '../../bricks/brick-data.ts';
import type { Brick } from '../../bricks/pyramid.ts';
import type { ResidualTable } from '../../bricks/residuals.ts';
import type { BrickStore } from '../../formats/base/brick-store.ts';
import type { LoadRequest } from '../../formats/base/load-request.ts';
import { untilAborted } from '../../formats/base/shared-work.ts';
import type { FinerLevel } from '../../volume/finer-voxels.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { openBricks } from '../../worker/open-bricks.ts';

interface BrickSourceParts {
  readonly request: LoadRequest;
  readonly fetch?: typeof globalThis.fetch | null;
  /** The level that is always there. */
  readonly pinned: GridFrame;
  /** Finest first. */
  readonly levels: readonly FinerLevel[];
}

interface OpenedStore {
  readonly store: BrickStore;
  /** The store's level that is the finest of the bricks. */
  readonly first: number;
  readonly life: AbortSignal;
}

/** Where the bricks of a view come from: a store that is open while the view shows the volume, and is opened again when it shows it again. */
export class BrickSource {
  #opened = waitForStore();

  constructor(readonly parts: BrickSourceParts) {}

  /** @param life - ends what is read @throws {VolumeViewError} see `openBricks`; {Error} where the pyramid is another one than before */
  async open(life: AbortSignal): Promise<void> {
    const { request, fetch, levels } = this.parts;
    const store = await openBricks(request, { signal: life, fetch });
    const first = store?.levels.findIndex(({ dimensions }) => String(dimensions) === String(levels[0].dimensions));
    const isSame = levels.every(
      ({ dimensions }, n) => String(dimensions) === String(store?.levels[first! + n]?.dimensions),
    );
    if (!store || !isSame) {
      store?.close();
      throw new Error('the levels of the pyramid have changed, or no worker reads them');
    }
    const opened = this.#opened;
    life.addEventListener('abort', () => {
      if (this.#opened === opened) this.#opened = waitForStore();
      store.close();
    });
    if (life.aborted) store.close();
    else opened.resolve({ store, first: first!, life });
  }

  /** A brick, as soon as the store is open. @param isAlone, @throws - as `BrickStore.read` */
  async read({ level, at }: Brick, signal: AbortSignal, isAlone: boolean): Promise<BrickSamples> {
    for (;;) {
      const { store, first, life } = await untilAborted(this.#opened.promise, signal);
      try {
        return await store.read({ level: level + first, at }, signal, isAlone);
      } catch (error) {
        if (signal.aborted || !life.aborted) throw error;
      }
    }
  }

  /**
   * What the pyramid's writer has said of its levels, and which of them are those of the bricks and, last, the one that is always there.
   * @returns null where nothing is said of these @throws as `BrickStore.residuals`
   */
  async readTable(
    signal: AbortSignal,
  ): Promise<{ readonly table: ResidualTable; readonly levels: readonly number[] } | null> {
    const { store, first } = await untilAborted(this.#opened.promise, signal);
    const pinned = String(this.parts.pinned.dimensions);
    const levels = this.parts.levels.map((_, n) => n);
    levels.push(store.levels.findIndex(({ dimensions }) => String(dimensions) === pinned));
    // A table counts from the finest level of the file.
    if (first !== 0 || levels.includes(-1)) return null;
    const table = await store.residuals(signal);
    return table && { table, levels };
  }
}

function waitForStore(): { readonly promise: Promise<OpenedStore>; resolve(store: OpenedStore): void } {
  let resolve!: (store: OpenedStore) => void;
  return { promise: new Promise<OpenedStore>((give) => (resolve = give)), resolve };
}

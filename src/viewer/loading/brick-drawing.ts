import type { SocketView, SocketViewer } from '../model/view-socket.ts';

/** Pictures with bricks that have just come pause for so many times as long as one of them takes. */
const pause = 3;

/** A view that had to give its context to another one has it at most so long when it comes back, so that all its bricks come, ms. */
const turnMs = 10_000;

/** What a reader does with another view ends the turn. */
const interactions = ['pointerdown', 'keydown', 'wheel'];

/** Resolves when all is drawn that has changed; never where the view leaves the page before. */
async function whenDrawn({ loop }: SocketViewer): Promise<void> {
  while (loop.drawing !== null || loop.dirty) await loop.change();
}

/** Draws pictures while bricks come: not one for each of them. */
export class BrickDrawing {
  #isDue = false;
  /** How long the last picture took that showed new bricks. */
  #drawnMs = 0;

  /** A picture with the bricks that have come, once the one in progress is there. @param isWanted - asked just before it; the last picture comes without a pause */
  async drawSoon(viewer: SocketViewer, isWanted: () => boolean): Promise<void> {
    if (this.#isDue) return;
    this.#isDue = true;
    await whenDrawn(viewer);
    await new Promise((resolve) => setTimeout(resolve, pause * this.#drawnMs));
    this.#isDue = false;
    const { loop } = viewer;
    if (!isWanted() || loop.drawing !== null || loop.dirty) return;
    const began = performance.now();
    loop.request();
    await whenDrawn(viewer);
    this.#drawnMs = performance.now() - began;
  }

  /** The view is drawn in another scene: what was due in the last one may never be drawn. */
  restart(): void {
    this.#isDue = false;
  }
}

/**
 * A turn of a view that shares the page's contexts with others: it keeps its context until its bricks are there and drawn, for some seconds at most, or until a
 * reader takes another view in hand.
 * @param life - ends the turn, too
 * @param settled - resolves when the bricks are there
 */
export function takeTurn({ host, viewer }: SocketView, life: AbortSignal, settled: Promise<void>): void {
  const over = new AbortController();
  const turn = new Promise<void>((resolve) => over.signal.addEventListener('abort', () => resolve()));
  const end = (): void => over.abort();
  const timer = setTimeout(end, turnMs);
  over.signal.addEventListener('abort', () => clearTimeout(timer));
  life.addEventListener('abort', end, { signal: over.signal });
  void settled.then(() => whenDrawn(viewer!)).then(end);
  const isElsewhere = (event: Event): boolean => !event.composedPath().includes(host);
  for (const type of interactions)
    addEventListener(type, (event) => isElsewhere(event) && end(), {
      capture: true,
      passive: true,
      signal: over.signal,
    });
  // It rejects where the view leaves the page.
  void viewer!.controller.withScene(() => turn).catch(() => {});
}

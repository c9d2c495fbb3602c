import type { Scene } from './scene.ts';

/** The pieces of a picture. */
export interface Pieces {
  /** Rows of the first. */
  readonly rows: number;
  /** What each may take: those that follow get more or fewer rows. */
  readonly pieceMs: number;
}

/** A picture to be gathered. */
export interface Gathering extends Pieces {
  /** World length. */
  readonly stepLength: number;
  /** Device pixels. */
  readonly width: number;
  readonly height: number;
}

/** A piece has at least so many rows. */
const minRows = 8;

/** A piece has at most so many times the rows of the one before, and at least this part of them. */
const mostChange = 2;

/**
 * Draw the volume's next picture piece by piece, between frames of the page, where nobody sees it: however long it takes,
 * the page goes on and a change is answered within the time of a piece.
 * @param goesOn - whether the picture is still wanted
 * @returns ms that all pieces took; null where it was given up
 */
export async function gatherPicture(
  scene: Scene,
  { stepLength, width, height, rows, pieceMs }: Gathering,
  goesOn: () => boolean,
): Promise<number | null> {
  let total = 0;
  let next = rows;
  for (const pass of scene.passes({ width, height })) {
    for (let firstRow = 0; firstRow < pass.height; ) {
      const began = performance.now();
      // As many pixels of a coarser lattice lie in more of its rows.
      const count = Math.min(Math.max(minRows, Math.round(next)) * pass.stride, pass.height - firstRow);
      scene.gather(stepLength, { pass, firstRow, rows: count }, { width, height });
      await scene.finished();
      const took = performance.now() - began;
      total += took;
      firstRow += count;
      next *= Math.min(mostChange, Math.max(1 / mostChange, pieceMs / Math.max(0.1, took)));
      await new Promise(requestAnimationFrame);
      if (!goesOn()) return null;
    }
  }
  return total;
}

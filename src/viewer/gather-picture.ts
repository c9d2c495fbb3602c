import type { Scene } from './scene.ts';

/** A picture to be gathered. */
export interface Gathering {
  /** World length. */
  readonly stepLength: number;
  /** Device pixels. */
  readonly width: number;
  readonly height: number;
  /** Rows of a piece. */
  readonly rows: number;
}

/**
 * Draw the volume's next picture piece by piece, between frames of the page, where nobody sees it: however long it takes,
 * the page goes on and a change is answered within the time of a piece.
 * @param goesOn - whether the picture is still wanted
 * @returns ms that all pieces took; null where it was given up
 */
export async function gatherPicture(
  scene: Scene,
  { stepLength, width, height, rows }: Gathering,
  goesOn: () => boolean,
): Promise<number | null> {
  let total = 0;
  for (const pass of scene.passes({ width, height })) {
    // As many pixels of a coarser lattice lie in more of its rows.
    for (let firstRow = 0; firstRow < pass.height; firstRow += rows * pass.stride) {
      const began = performance.now();
      scene.gather(stepLength, { pass, firstRow, rows: Math.min(rows * pass.stride, pass.height - firstRow) }, { width, height });
      await scene.finished();
      total += performance.now() - began;
      await new Promise(requestAnimationFrame);
      if (!goesOn()) return null;
    }
  }
  return total;
}

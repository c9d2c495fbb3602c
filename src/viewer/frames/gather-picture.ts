import type { RayPlan } from '../../renderer/ray/ray-plan.ts';
import type { PictureSize } from '../model/picture-size.ts';
import type { Pass, Scene } from '../model/scene.ts';

/** The pieces of a picture. */
export interface Pieces {
  /** Rows of the first piece. */
  readonly rows: number;
  /** Time that each piece may take: the pieces after the first get more or fewer rows. */
  readonly pieceMs: number;
}

/** A picture to be gathered. */
export interface Gathering extends Pieces {
  readonly plan: RayPlan & { readonly picture: PictureSize };
}

/**
 * Minimum number of rows in a piece. The number is always a multiple of `wholeRows`: GPUs draw quads of 2 x 2 pixels, and draw a quad twice
 * where two pieces share it.
 */
const minRows = 8;
const wholeRows = 4;

/** A piece has at most this many times the rows of the one before, and at least the inverse of it. */
const maxChange = 2;

/**
 * No piece has more than this many times the rows that the times of whole pictures suggest, even if the pieces at the picture's
 * empty edge took almost no time: the next one may take long.
 */
const maxRows = 2;

/**
 * Number of pieces that are sent to the GPU: while it draws one, the next is already there, so that it never waits. The time for a
 * piece is shared by both.
 */
const atOnce = 2;

/** WebGL 1 waits for each piece and blocks the page meanwhile: give the page time after each piece. */
function rest(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}

/** The number of pixels in some rows of a pass. */
function countPixels({ over, width }: Pass, rows: number): number {
  return over ? 0 : width * rows;
}

/**
 * Draw the volume's next picture piece by piece, off screen. However long it takes, the page can work, and a change is handled
 * within the time of one piece.
 * @param goesOn - whether the picture is still needed
 * @param reported - called after each piece with the share of the picture that is drawn, 0..1
 * @returns ms that all pieces took; null where the picture was given up
 */
export async function gatherPicture(
  scene: Scene,
  picture: Gathering,
  goesOn: () => boolean,
  reported: (share: number) => void = () => {},
): Promise<number | null> {
  const {
    plan,
    plan: { picture: size },
    rows,
    pieceMs,
  } = picture;
  const began = performance.now();
  let freeSince = began;
  /** Time that the GPU took for the last piece, ms. */
  const timeLast = async (): Promise<number> => {
    const reported = performance.now();
    await scene.finished();
    const took = performance.now() - Math.max(reported, freeSince);
    freeSince = performance.now();
    return took;
  };
  let next = rows / atOnce;
  const max = maxRows * Math.max(minRows, rows);
  let before: Promise<number> | null = null;
  const passes = scene.startGathering(plan, size);
  // A pass that is drawn over another one has few rays.
  const pixels = passes.reduce((sum, pass) => sum + countPixels(pass, pass.height), 0);
  let done = 0;
  for (const pass of passes) {
    // Such a pass first reads the earlier ones, and the page would wait for them. Its few rays may be anywhere.
    if (pass.over) await before;
    const limit = pass.over ? pass.height : max;
    for (let firstRow = 0; firstRow < pass.height;) {
      // A row of a coarser lattice has fewer pixels, so that a piece has more of its rows.
      const count = Math.min(
        Math.max(minRows, wholeRows * Math.round(next / wholeRows)) * pass.stride,
        pass.height - firstRow,
      );
      scene.gather(plan, { pass, firstRow, rows: count }, size);
      firstRow += count;
      done += countPixels(pass, count);
      const last = timeLast();
      if (!scene.device.webgl2) await rest();
      const took = await before;
      if (!goesOn()) return null;
      reported(done / pixels);
      if (took !== null)
        next = Math.min(
          limit,
          next * Math.min(maxChange, Math.max(1 / maxChange, pieceMs / atOnce / Math.max(0.1, took))),
        );
      before = last;
    }
  }
  await before;
  return goesOn() ? freeSince - began : null;
}

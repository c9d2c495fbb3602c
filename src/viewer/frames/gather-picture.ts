import type { Pass, Scene } from '../model/scene.ts';

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

/** A piece has at least so many rows, and a multiple of `wholeRows`: graphics processors draw quads of 2 x 2 pixels, and those that a piece cuts are drawn twice. */
const minRows = 8;
const wholeRows = 4;

/** A piece has at most so many times the rows of the one before, and at least this part of them. */
const mostChange = 2;

/** However little pieces take at a picture's empty edge, none has more than so many times the rows that a piece should have by what is known of all: the next may be dear. */
const mostRows = 2;

/** While the GPU draws one piece the next one is there already, so that it never waits: what a piece may take is for both. */
const atOnce = 2;

/** WebGL 1 waits for each piece, and leaves no time to the page: it gets some after each. */
function rest(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}

/** Pixels of some rows of a pass. */
function countPixels({ over, width }: Pass, rows: number): number {
  return over ? 0 : width * rows;
}

/**
 * Draw the volume's next picture piece by piece, where nobody sees it: however long it takes, the page goes on and a change is
 * answered within the time of a piece.
 * @param goesOn - whether the picture is still wanted
 * @param told - is given how much of the picture is there after each piece, 0..1
 * @returns ms that all pieces took; null where it was given up
 */
export async function gatherPicture(scene: Scene, picture: Gathering, goesOn: () => boolean, told: (share: number) => void = () => {}): Promise<number | null> {
  const { stepLength, width, height, rows, pieceMs } = picture;
  const began = performance.now();
  let freeSince = began;
  /** ms that the GPU took for what it was told last. */
  const timeLast = async (): Promise<number> => {
    const told = performance.now();
    await scene.finished();
    const took = performance.now() - Math.max(told, freeSince);
    freeSince = performance.now();
    return took;
  };
  let next = rows / atOnce;
  const most = mostRows * Math.max(minRows, rows);
  let before: Promise<number> | null = null;
  scene.startGathering(stepLength, { width, height });
  const passes = scene.passes({ width, height });
  // A pass over another one has few rays.
  const pixels = passes.reduce((sum, pass) => sum + countPixels(pass, pass.height), 0);
  let done = 0;
  for (const pass of passes) {
    // It begins by reading what has been drawn, for which the page would wait. Its few rays may be anywhere.
    if (pass.over) await before;
    const limit = pass.over ? pass.height : most;
    for (let firstRow = 0; firstRow < pass.height; ) {
      // As many pixels of a coarser lattice lie in more of its rows.
      const count = Math.min(Math.max(minRows, wholeRows * Math.round(next / wholeRows)) * pass.stride, pass.height - firstRow);
      scene.gather(stepLength, { pass, firstRow, rows: count }, { width, height });
      firstRow += count;
      done += countPixels(pass, count);
      const last = timeLast();
      if (!scene.device.webgl2) await rest();
      const took = await before;
      if (!goesOn()) return null;
      told(done / pixels);
      if (took !== null) next = Math.min(limit, next * Math.min(mostChange, Math.max(1 / mostChange, pieceMs / atOnce / Math.max(0.1, took))));
      before = last;
    }
  }
  await before;
  return goesOn() ? freeSince - began : null;
}

/** A piece of a ray: where it begins, how long it is, and how much opacity it adds to the ray. A surface has length 0. */
export interface Rise {
  readonly begin: number;
  readonly span: number;
  readonly height: number;
}

/** Pieces of a ray that follow one another, from the first to the last, and the opacity that they add together. */
export interface Jump {
  readonly first: number;
  readonly last: number;
  readonly height: number;
}

/** Two things count as separate if, between them, the opacity added per length falls below this share of both peaks. */
const valleyShare = 0.5;

/**
 * Where the opacity of a ray jumps most: the highest of its rises. A rise runs from one valley of the steepness to the next. If two rises
 * are equally high, the front one counts. A surface is always a rise of its own.
 * @returns null if nothing is visible
 * Source: Wiebel, Vos, Foerster and Hege, *WYSIWYP: What You See Is What You Pick*, 2012. Noise and the kinks of interpolation make
 * shallow valleys; these do not count here
 */
export function findJump(rises: readonly Rise[]): Jump | null {
  let highest: Jump | null = null;
  let first = 0;
  let [peak, valley, bottom] = [0, 0, 0];
  const close = (last: number): void => {
    let height = 0;
    for (let i = first; i <= last; i++) height += rises[i].height;
    if (height > (highest?.height ?? 0)) highest = { first, last, height };
  };
  for (let i = 0; i < rises.length; i++) {
    if (rises[i].span === 0 && rises[i].height > 0) {
      close(i - 1);
      first = i;
      close(i);
      first = i + 1;
      [peak, valley, bottom] = [0, 0, i];
      continue;
    }
    const steepness = rises[i].span > 0 ? rises[i].height / rises[i].span : 0;
    if (valley < valleyShare * Math.min(peak, steepness)) {
      close(bottom);
      first = bottom + 1;
      peak = 0;
    }
    if (steepness >= peak) [peak, valley, bottom] = [steepness, steepness, i];
    else if (steepness <= valley) [valley, bottom] = [steepness, i];
  }
  close(rises.length - 1);
  return highest;
}

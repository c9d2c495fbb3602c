/** A piece of a ray: where it begins and how long it is, and by how much it makes the ray more opaque. A surface is 0 long. */
export interface Rise {
  readonly begin: number;
  readonly span: number;
  readonly height: number;
}

/** Pieces of a ray that follow one another, from the first to the last, and by how much they make it more opaque together. */
export interface Jump {
  readonly first: number;
  readonly last: number;
  readonly height: number;
}

/** Two things are told apart where between them less than this share of either is added to a length. */
const valleyShare = 0.5;

/**
 * Where the opacity of a ray jumps most: the largest of its rises, each from one valley of its steepness to the next. Of two
 * that are equally high it is the one in front. A surface is a thing of its own.
 * @returns null where nothing is to be seen
 * Source: Wiebel, Vos, Foerster and Hege, *WYSIWYP: What You See Is What You Pick*, 2012; shallow valleys, which noise
 * and the kinks of interpolation make, are no valleys here
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

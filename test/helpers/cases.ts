// Which cases of a list a run takes. `npm run accuracy -- claims` runs the tests that ask here with all of their cases.

declare global {
  /** Set by the runners of tests where VOLUME_VIEW_ALL_CASES is set. */
  var __allCases: boolean | undefined;
}

/** Whether this run takes all cases. */
export const takesAll = Boolean(globalThis.__allCases);

/**
 * The cases that this run takes. In the tests these are the ones that `isTested` names: one for each way through the code. The others repeat
 * the same claim with other numbers; `npm run accuracy -- claims` takes them too.
 */
export function casesOf<T>(all: readonly T[], isTested: (one: T, index: number) => boolean): readonly T[] {
  const tested = all.filter(isTested);
  if (tested.length === 0) throw new Error('no case is tested');
  return takesAll ? all : tested;
}

/**
 * The cases for a version of WebGL. WebGL 2 takes all of them. WebGL 1 draws with the same formulas, but from other textures: in the tests it
 * takes those that `isOther` names, one for each kind of texture or module.
 */
export function casesIn<T>(
  version: 1 | 2,
  all: readonly T[],
  isOther: (one: T, index: number) => boolean,
): readonly T[] {
  return version === 2 ? all : casesOf(all, isOther);
}

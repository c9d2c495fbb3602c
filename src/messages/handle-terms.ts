/** The words of handles over a picture. */
export interface HandleTerms {
  /** What the keys do to a handle that moves freely. */
  readonly handleKeys: string;
  /** What they do to one that moves along one direction. */
  readonly handleKeysAlong: string;
}

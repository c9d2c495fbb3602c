/** The messages of handles over a picture. */
export interface HandleMessages {
  /** Help: how keys move a handle that moves freely. */
  readonly handleKeys: string;
  /** Help: how keys move a handle that moves along one direction. */
  readonly handleKeysAlong: string;
}

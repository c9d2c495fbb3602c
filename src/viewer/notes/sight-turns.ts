/** Rays to places of notes while the camera moves, for each picture: a ray costs the same in every browser, a time would not. */
export const raysPerPicture = 2;

/** Whose turn it is to be looked at while the camera moves: those that were looked at longest ago. */
export class SightTurns<Note extends object> {
  #turn = 0;
  readonly #last = new WeakMap<Note, number>();

  /** @returns at most `count` of the notes, in the order in which it is their turn; those that were never looked at come first */
  next(notes: readonly Note[], count = raysPerPicture): Note[] {
    const turnOf = (note: Note): number => this.#last.get(note) ?? 0;
    const sorted = [...notes];
    sorted.sort((a, b) => turnOf(a) - turnOf(b));
    return sorted.slice(0, count);
  }

  /** These have been looked at now, for the same camera. */
  seen(notes: readonly Note[]): void {
    this.#turn++;
    for (const note of notes) this.#last.set(note, this.#turn);
  }
}

// Answers that a page keeps in its own storage, so that they survive a reload. Nothing is sent anywhere.

/** What is kept of a question. */
export interface KeptAnswer {
  /** What was asked: an answer to another question does not count. */
  readonly asked: string;
  readonly response: string;
  /** Numbers of the chosen answers; empty for other types. */
  readonly chosen: readonly number[];
  readonly correct: boolean;
  readonly tries: number;
}

type Store = Pick<Storage, 'getItem' | 'setItem' | 'removeItem'>;

const keyOf = (path: string, id: string): string => `volume-question ${path}#${id}`;

/** Keeps answers by the ids of questions. A store that throws, as in private windows and where a page has none, keeps nothing. */
export class KeptAnswers {
  /** @param open - returns the store; it may throw */
  constructor(
    readonly open: () => Store,
    readonly path: string,
  ) {}

  keep(id: string, answer: KeptAnswer): void {
    try {
      this.open().setItem(keyOf(this.path, id), JSON.stringify(answer));
    } catch {
      // The answer is there until the page is left.
    }
  }

  /** @returns null where nothing is kept, or nothing that can be read */
  recall(id: string, asked: string): KeptAnswer | null {
    try {
      const found = JSON.parse(this.open().getItem(keyOf(this.path, id)) ?? 'null') as Partial<KeptAnswer> | null;
      const isWhole =
        found !== null &&
        typeof found === 'object' &&
        found.asked === asked &&
        typeof found.response === 'string' &&
        typeof found.correct === 'boolean' &&
        Number.isInteger(found.tries) &&
        Number(found.tries) > 0 &&
        Array.isArray(found.chosen) &&
        found.chosen.every((one) => Number.isInteger(one));
      return isWhole ? (found as KeptAnswer) : null;
    } catch {
      return null;
    }
  }

  forget(id: string): void {
    try {
      this.open().removeItem(keyOf(this.path, id));
    } catch {
      // There is nothing to forget.
    }
  }
}

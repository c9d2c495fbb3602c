/** What a viewer would do with a context: nothing, be ready for a hand, draw what is not yet right, or follow a hand. */
export type Need = 'none' | 'ready' | 'picture' | 'hand';

/** Who draws with a WebGL context, of which a page may have only so many at once. */
export interface ContextHolder {
  /** Whether it is in the visible part of the page. */
  readonly inSight: boolean;
  /** Whether a script waits for its picture. */
  readonly asked: boolean;
  /** Whether it may hold a context at all: what is far from the visible part, and asked for by nobody, may not. */
  readonly mayHold: boolean;
  readonly need: Need;
  /** Whether it can't leave at this moment. */
  readonly busy: boolean;
  /** It may have a context from now on. */
  enter(): void;
  /** It has to give its context back: another one needs it. */
  leave(): void;
}

/** Browsers allow 16 contexts in a page, 8 on phones; beyond that they take the oldest one away. Others may want some too. */
export const maxContexts = 6;

/** As long as something moves, and others wait, it gets turns of this length, ms. */
const turnMs = 2000;

const urgency: Readonly<Record<Need, number>> = { none: 0, ready: 1, picture: 2, hand: 3 };

/**
 * Which of a page's viewers have a WebGL context. Those in sight come first, and never leave for one that is not; among them
 * those under a hand, then those whose picture is not right yet, in the order in which they came. A context is given
 * back by whoever has drawn its picture, the one that drew longest ago first. Of those out of sight that a script waits for,
 * one may have a context beyond the others', so that it need not wait for what is in sight.
 */
export class ContextPool {
  /** In the order in which they are served. */
  readonly #candidates = new Set<ContextHolder>();
  /** Since when each holds its context; the one that drew longest ago first. */
  readonly #holders = new Map<ContextHolder, number>();
  #planned = false;

  constructor(readonly most: number) {}

  add(candidate: ContextHolder): void {
    this.#candidates.add(candidate);
    this.review();
  }

  /** Whoever leaves the page has given back its context already. */
  remove(candidate: ContextHolder): void {
    this.#candidates.delete(candidate);
    this.release(candidate);
  }

  /** A holder has no context after all. */
  release(holder: ContextHolder): void {
    this.#holders.delete(holder);
    this.review();
  }

  /** A holder has drawn. */
  drew(candidate: ContextHolder): void {
    const since = this.#holders.get(candidate);
    if (since === undefined) return;
    this.#holders.delete(candidate);
    this.#holders.set(candidate, since);
    this.review();
  }

  /** Something is otherwise with somebody: see soon who gets a context. */
  review(): void {
    if (this.#planned) return;
    this.#planned = true;
    queueMicrotask(() => {
      this.#planned = false;
      this.#clear();
      this.#admit();
    });
  }

  #clear(): void {
    for (const holder of this.#holders.keys()) {
      const isBeyond = this.#holders.size > this.most && !holder.inSight && isIdle(holder);
      if (!holder.busy && (!holder.mayHold || isBeyond)) this.#dismiss(holder);
    }
  }

  #admit(): void {
    for (let rank = rankOf({ need: 'hand', inSight: true }); rank >= rankOf({ need: 'ready', inSight: true }); rank--) {
      for (const candidate of [...this.#candidates]) {
        if (this.#holders.has(candidate) || !candidate.mayHold || rankOf(candidate) !== rank || !this.#makeRoom(candidate)) continue;
        this.#holders.set(candidate, performance.now());
        this.#candidates.delete(candidate);
        this.#candidates.add(candidate); // Next time it comes last.
        candidate.enter();
      }
    }
  }

  #makeRoom(candidate: ContextHolder): boolean {
    if (this.#holders.size < this.most) return true;
    const holders = [...this.#holders.keys()];
    const leaving = holders.filter((holder) => this.#mayTake(candidate, holder));
    const last = leaving.find((holder) => !holder.inSight) ?? leaving.find(isIdle) ?? leaving[0];
    if (last) this.#dismiss(last);
    return last !== undefined || (candidate.asked && !candidate.inSight && holders.every((holder) => holder.inSight));
  }

  #mayTake(candidate: ContextHolder, holder: ContextHolder): boolean {
    if (holder.busy) return false;
    if (holder.inSight && (!candidate.inSight || candidate.need === 'ready')) return false;
    if (isIdle(holder)) return true;
    if (candidate.need === 'ready') return false;
    if (candidate.inSight && !holder.inSight) return true;
    return holder.need !== 'hand' && performance.now() - this.#holders.get(holder)! >= turnMs;
  }

  #dismiss(holder: ContextHolder): void {
    this.#holders.delete(holder);
    holder.leave();
  }
}

/** The contexts of this page. */
export const contextPool = new ContextPool(maxContexts);

/** Whether its picture is right, and no hand is on it. */
function isIdle({ need }: ContextHolder): boolean {
  return urgency[need] < urgency.picture;
}

function rankOf({ need, inSight }: Pick<ContextHolder, 'need' | 'inSight'>): number {
  return 2 * urgency[need] + (inSight ? 1 : 0);
}

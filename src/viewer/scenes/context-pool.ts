/** How a viewer would use a context: not at all, be ready for interaction, draw a picture that is not final, or follow an interaction. */
export type Need = 'none' | 'ready' | 'picture' | 'hand';

/** A user of a WebGL context. A page may have only a limited number of contexts at once. */
export interface ContextHolder {
  /** Whether it is in the visible part of the page. */
  readonly inSight: boolean;
  /** Whether a script waits for its picture. */
  readonly asked: boolean;
  /** Whether it may hold a context at all: false if it is far from the visible part and no script waits for it. */
  readonly mayHold: boolean;
  readonly need: Need;
  /** Whether it can't give its context back at this moment. */
  readonly busy: boolean;
  /** It may have a context from now on. */
  enter(): void;
  /** It must give its context back: another user needs it. */
  leave(): void;
}

/** Browsers allow 16 contexts in a page, 8 on phones; above that they remove the oldest one. Other scripts may need some too. */
export const maxContexts = 6;

/** While several users move and others wait, each gets turns of this length, ms. */
const turnMs = 2000;

const urgency: Readonly<Record<Need, number>> = { none: 0, ready: 1, picture: 2, hand: 3 };

/**
 * Decides which of a page's viewers have a WebGL context. Visible ones come first, and never lose it to one that is not visible;
 * among them come first those in interaction, then those whose picture is not final, in the order in which they came. Viewers
 * whose picture is drawn give their context back, the one that drew longest ago first. One viewer that is not visible, but that a
 * script waits for, may have an extra context, so that it does not have to wait for the visible ones.
 */
export class ContextPool {
  /** In the order in which they get a context. */
  readonly #candidates = new Set<ContextHolder>();
  /** Since when each holder has its context; the one that drew longest ago comes first. */
  readonly #holders = new Map<ContextHolder, number>();
  #planned = false;

  constructor(readonly max: number) {}

  add(candidate: ContextHolder): void {
    this.#candidates.add(candidate);
    this.review();
  }

  /** Called when a viewer leaves the page: it has already given its context back. */
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

  /** The state of a viewer has changed: decide soon which viewers get a context. */
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
      const isBeyond = this.#holders.size > this.max && !holder.inSight && isIdle(holder);
      if (!holder.busy && (!holder.mayHold || isBeyond)) this.#dismiss(holder);
    }
  }

  #admit(): void {
    for (let rank = rankOf({ need: 'hand', inSight: true }); rank >= rankOf({ need: 'ready', inSight: true }); rank--) {
      for (const candidate of [...this.#candidates]) {
        if (
          this.#holders.has(candidate) ||
          !candidate.mayHold ||
          rankOf(candidate) !== rank ||
          !this.#makeRoom(candidate)
        )
          continue;
        this.#holders.set(candidate, performance.now());
        this.#candidates.delete(candidate);
        this.#candidates.add(candidate); // Next time it comes last.
        candidate.enter();
      }
    }
  }

  #makeRoom(candidate: ContextHolder): boolean {
    if (this.#holders.size < this.max) return true;
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

/** Whether its picture is final, and nobody interacts with it. */
function isIdle({ need }: ContextHolder): boolean {
  return urgency[need] < urgency.picture;
}

function rankOf({ need, inSight }: Pick<ContextHolder, 'need' | 'inSight'>): number {
  return 2 * urgency[need] + (inSight ? 1 : 0);
}

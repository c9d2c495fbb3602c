// Undo and redo: a list of values, and a place in it.

export interface History<T> {
  readonly past: readonly T[];
  readonly present: T;
  /** The next one first. */
  readonly future: readonly T[];
  /** What the last change was of: further changes of the same thing are one step of undo. null after undo and redo. */
  readonly mark: string | null;
}

/** Steps that can be undone. */
const maxPast = 200;

export const startHistory = <T>(present: T): History<T> => ({ past: [], present, future: [], mark: null });

/** @param mark - a name for typing in one field, or for dragging one slider; null for a change that is a step of its own */
export function change<T>(history: History<T>, present: T, mark: string | null): History<T> {
  if (present === history.present) return history;
  if (mark !== null && mark === history.mark) return { ...history, present, future: [] };
  return { past: [...history.past, history.present].slice(-maxPast), present, future: [], mark };
}

/** Another present that is no change to undo. */
export const replace = <T>(history: History<T>, present: T): History<T> => ({ ...history, present });

export function undo<T>({ past, present, future }: History<T>): History<T> | null {
  if (past.length === 0) return null;
  return { past: past.slice(0, -1), present: past[past.length - 1], future: [present, ...future], mark: null };
}

export function redo<T>({ past, present, future }: History<T>): History<T> | null {
  if (future.length === 0) return null;
  return { past: [...past, present], present: future[0], future: future.slice(1), mark: null };
}

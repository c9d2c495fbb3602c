import type { Budget } from './budget.ts';

/**
 * Takes bytes from the budget while something is read. The result is not counted any longer: callers that keep it take
 * its bytes themselves.
 * @param bytes - and what needs them, as in `Budget.take`
 */
export function takeDuring<Result>(
  budget: Budget,
  { bytes, what }: { bytes: number; what: string },
  read: () => Result,
): Result {
  budget.take(bytes, what);
  try {
    return read();
  } finally {
    budget.giveBack(bytes);
  }
}

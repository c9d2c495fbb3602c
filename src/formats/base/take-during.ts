import type { Budget } from './budget.ts';

/**
 * Take bytes while something is read. What is returned is not counted any more: who keeps it takes for it.
 * @param bytes - and for whom, as `Budget.take` has it
 */
export function takeDuring<Result>(budget: Budget, { bytes, what }: { bytes: number; what: string }, read: () => Result): Result {
  budget.take(bytes, what);
  try {
    return read();
  } finally {
    budget.giveBack(bytes);
  }
}

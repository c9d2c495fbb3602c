import type { FuzzCase } from './fuzz-case.ts';
import type { Verdict } from './verdict.ts';

/** What a worker is asked to run: a case by its number, one with nothing wrong, one that is given, or one of those with names. */
export type Order =
  | { readonly type: 'draw'; readonly format: string; readonly seed: number; readonly index: number }
  | { readonly type: 'sound'; readonly format: string; readonly index: number }
  | { readonly type: 'given'; readonly made: FuzzCase }
  | { readonly type: 'named'; readonly name: string };

/** What a worker says: the case before it is run, so that it is known if the worker does not come back; then what came of it. */
export type Answer =
  | { readonly type: 'ready'; readonly formats: readonly string[]; readonly named: readonly string[] }
  | { readonly type: 'made'; readonly made: FuzzCase }
  | { readonly type: 'judged'; readonly verdict: Verdict; readonly kept: number };

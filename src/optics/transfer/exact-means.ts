import { domainOf, meanOverSpan } from './emission.ts';
import type { SpanMeans } from './emission.ts';
import type { TransferFunction } from './transfer-function.ts';

/** The exact means of a transfer function, without a table. */
export function exactMeans(transferFunction: TransferFunction): SpanMeans {
  const [low, high] = domainOf(transferFunction);
  return { low, high, mean: (from, to) => meanOverSpan(transferFunction, from, to) };
}

import { domainOf } from './emission.ts';
import type { TransferFunction } from './transfer-function.ts';

/** Columns of the table that holds usual transfer functions: each per cent of the domain is on one. */
export const usualColumns = 2001;

/** Above this the logarithm's pole is near, and no table is fine enough. */
export const mostOpacity = 0.95;

/** Whether a transfer function is no trouble to the table: all stops are at whole per cents of its domain, none at another's. */
export function isUsual(stops: TransferFunction): boolean {
  const [low, high] = domainOf(stops);
  return stops.every(({ value, opacity }, i) => {
    const percents = ((value - low) / (high - low)) * 100;
    return opacity <= mostOpacity && !(value === stops[i - 1]?.value) && Math.abs(percents - Math.round(percents)) < 1e-6;
  });
}

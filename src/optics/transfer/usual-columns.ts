import { domainOf } from './emission.ts';
import type { TransferFunction } from './transfer-function.ts';

/** Number of columns of the table for usual transfer functions: each percent of the domain lies on one. */
export const usualColumns = 2001;

/** Above this opacity, the logarithm's pole is so near that no table is fine enough. */
export const maxOpacity = 0.95;

/** Whether the usual table can hold a transfer function: all stops lie at whole percents of its domain, and no two at the same value. */
export function isUsual(stops: TransferFunction): boolean {
  const [low, high] = domainOf(stops);
  return stops.every(({ value, opacity }, i) => {
    const percents = ((value - low) / (high - low)) * 100;
    return (
      opacity <= maxOpacity && !(value === stops[i - 1]?.value) && Math.abs(percents - Math.round(percents)) < 1e-6
    );
  });
}

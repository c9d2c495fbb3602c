// Sentences about numbers of a file that the picture can't show as they are: loaded with the first file that has some.
import { largestWindow } from '../../optics/transfer/transfer-function.ts';
import type { Rounded } from '../../volume/index-numbers.ts';
import type { DecodedCartesianVolume } from './decoded-volume.ts';

/** @param range - the smallest and the largest value */
export function reportNumbers(
  { rounded, unkept, intercept }: Pick<DecodedCartesianVolume, 'rounded' | 'unkept' | 'intercept'>,
  [low, high]: readonly [number, number],
): string[] {
  const { infinite = 0, small = 0 } = unkept ?? {};
  const largest = Math.max(-low, high);
  return [
    ...(rounded ? [reportRounded(rounded)] : []),
    ...(infinite > 0 ? [`${count(infinite, 'value is', 'values are')} infinite, and shown as no data`] : []),
    ...(small > 0
      ? [
          `${count(small, 'value differs', 'values differ')} too little from ${intercept} to be kept with values as large as ${largest.toPrecision(3)}`,
        ]
      : []),
    ...(largest > largestWindow
      ? [`the values go from ${low.toPrecision(3)} to ${high.toPrecision(3)}, and colours end at ${largestWindow}`]
      : []),
  ];
}

function reportRounded({ count: numbers, by }: Rounded): string {
  return `${numbers.toLocaleString('en')} whole numbers are rounded, by up to ${by.toLocaleString('en')}: beyond 16,777,216 at most 65,536 different ones are kept exactly, and none beyond 9,007,199,254,740,991`;
}

function count(values: number, one: string, many: string): string {
  return `${values.toLocaleString('en')} ${values === 1 ? one : many}`;
}

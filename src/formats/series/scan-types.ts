import { floats, numberTypes, viewAs } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';

/** The types of numbers that scans of one file can have, by their names. */
export const scanTypes: ReadonlyMap<string, NumberType> = new Map(
  [
    ...Object.values(numberTypes),
    floats('complex64', 4, viewAs(Float32Array), true),
    floats('complex128', 8, viewAs(Float64Array), true),
  ].map((type) => [type.name, type]),
);

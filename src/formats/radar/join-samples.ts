import type { Samples } from '../../volume/volume.ts';
import type { Budget } from '../base/budget.ts';
import type { SweepData } from './radar-file.ts';

/** Samples of all sweeps in one type and on one scale. */
export interface JoinedSamples {
  /** Filled with "no data": 0 for integers, NaN for floats. */
  readonly samples: Samples;
  readonly slope: number;
  readonly intercept: number;
  /** Copies a radial of one of the sweeps. @param to - index of its first gate in `samples` */
  copyRadial(data: SweepData, radial: number, to: number): void;
}

/**
 * Chooses one type and scale for sweeps that may differ in both: their own scale if it is the same for all, in the
 * widest of their types; else data values as floats.
 * @param length - samples to allocate, taken from the budget
 */
export function joinSamples(sweeps: readonly SweepData[], length: number, budget: Budget): JoinedSamples {
  const [{ slope, intercept }] = sweeps;
  const take = (bytes: number): void => budget.take(bytes * length, 'the gates of all sweeps');
  if (sweeps.some((data) => data.slope !== slope || data.intercept !== intercept)) {
    take(4);
    return { ...joinFloats(length, (value, data) => data.slope * value + data.intercept), slope: 1, intercept: 0 };
  }
  if (sweeps.some((data) => data.samples instanceof Float32Array)) {
    take(4);
    return { ...joinFloats(length, (value) => value), slope, intercept };
  }
  const isWide = sweeps.some((data) => data.samples instanceof Uint16Array);
  take(isWide ? 2 : 1);
  const samples = isWide ? new Uint16Array(length) : new Uint8Array(length);
  const copyRadial: JoinedSamples['copyRadial'] = (data, radial, to) => samples.set(radialOf(data, radial), to);
  return { samples, slope, intercept, copyRadial };
}

function joinFloats(
  length: number,
  convert: (value: number, data: SweepData) => number,
): Pick<JoinedSamples, 'samples' | 'copyRadial'> {
  const samples = new Float32Array(length).fill(NaN);
  const copyRadial: JoinedSamples['copyRadial'] = (data, radial, to) => {
    const from = radialOf(data, radial);
    const isFloat = from instanceof Float32Array;
    for (let gate = 0; gate < from.length; gate++) {
      const value = from[gate];
      if (isFloat ? Number.isFinite(value) : value !== 0) samples[to + gate] = convert(value, data);
    }
  };
  return { samples, copyRadial };
}

function radialOf({ samples, gates }: SweepData, radial: number): SweepData['samples'] {
  return samples.subarray(radial * gates, (radial + 1) * gates);
}

import type { Lossy, LossyError } from '../../volume/volume.ts';
import { Expected, isFinite } from './manifest-checks.ts';
import type { Check } from './manifest-checks.ts';
import { readFields } from './manifest-radar.ts';

const size: Check<number> = (value) => {
  if (!isFinite(value) || value < 0) throw new Expected('a number from 0');
  return value;
};

const error: Check<LossyError> = (value) => {
  const { rms, p99, max } = readFields<Partial<LossyError>>(value, { rms: size, p99: size, max: size });
  if (rms === undefined || p99 === undefined || max === undefined)
    throw new Expected('{ "rms": …, "p99": …, "max": … }');
  return { rms, p99, max };
};

/** What a lossy form changed. */
export const lossy: Check<Lossy> = (value) => {
  const values = error(value);
  const { picture } = readFields<{ picture?: LossyError }>(value, { picture: error });
  return { ...values, ...(picture ? { picture } : {}) };
};

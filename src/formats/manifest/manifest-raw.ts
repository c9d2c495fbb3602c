import { rawTypes } from '../raw/raw-layout.ts';
import type { RawLayout, RawType } from '../raw/raw-layout.ts';
import { count, Expected } from './manifest-checks.ts';
import type { Check } from './manifest-checks.ts';
import { readFields } from './manifest-radar.ts';

const type: Check<RawType> = (value) => {
  if (!rawTypes.includes(value as RawType)) throw new Expected(`one of ${rawTypes.join(', ')}`);
  return value as RawType;
};

const endian: Check<'little' | 'big'> = (value) => {
  if (value !== 'little' && value !== 'big') throw new Expected('"little" or "big"');
  return value;
};

const dimensions: Check<RawLayout['dimensions']> = (value) => {
  if (!Array.isArray(value) || value.length !== 3) throw new Expected('three whole numbers from 1');
  return value.map((one: unknown) => count(one)) as unknown as RawLayout['dimensions'];
};

const offset: Check<number> = (value) => {
  if (!Number.isSafeInteger(value) || (value as number) < 0) throw new Expected('a whole number from 0');
  return value as number;
};

/** The layout of a file without a header. */
export const raw: Check<RawLayout> = (value) => {
  const layout = readFields<RawLayout>(value, { type, endian, dimensions, offset });
  for (const name of ['type', 'dimensions'] as const) {
    if (layout[name] === undefined) throw new Expected(`an object with "${name}"`);
  }
  return layout;
};

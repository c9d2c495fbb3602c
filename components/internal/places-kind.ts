import type { Vector3 } from '../../src/volume/matrix.ts';
import { numbers, text } from './property-kinds.ts';
import type { Kind } from './property-kinds.ts';

/** A list of places, three numbers each. */
export const places: Kind<readonly Vector3[] | null> = {
  read: (text) => {
    const found = numbers.read(text);
    return found && found.length % 3 === 0
      ? Array.from({ length: found.length / 3 }, (_, i) => found.slice(3 * i, 3 * i + 3) as unknown as Vector3)
      : null;
  },
  write: (value) =>
    text.write(
      typeof value === 'object' ? (value?.map((place) => place.join(' ')).join(', ') ?? null) : (value ?? null),
    ),
};

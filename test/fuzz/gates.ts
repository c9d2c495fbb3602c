import type { Random } from './random.ts';

/**
 * The numbers of a sweep, of one draw: a draw for each gate would take longer than to read the file, and changes of a case would seldom be
 * those of its structure.
 * @returns [radials][gates], whole numbers from 0 to `max`
 */
export function makeGates(random: Random, [radials, gates]: readonly [number, number], max: number): number[][] {
  let state = random.u32();
  const next = (): number => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0);
  return Array.from({ length: radials }, () =>
    Array.from({ length: gates }, () => Math.floor((next() / 2 ** 32) * (max + 1))),
  );
}

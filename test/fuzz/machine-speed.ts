/** Milliseconds that the work below takes on a quiet machine of the kind on which the limit of time was set. */
const usualMs = 30;

const numbers = new Float32Array(2 ** 22);

/**
 * How many times slower this machine is right now than a quiet one. Other programs share its caches and cores with us, so that
 * the same work takes up to four times as much of the processor's time.
 */
export function measureSlowness(): number {
  const start = process.cpuUsage();
  let sum = 0;
  for (let round = 0; round < 8; round++) for (let i = 0; i < numbers.length; i++) sum += numbers[i] * 1.5;
  const { user, system } = process.cpuUsage(start);
  return Math.max(1, (user + system + sum) / 1000 / usualMs);
}

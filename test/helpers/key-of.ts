/** Numbers of objects, in the order in which they were met. */
const numbers = new WeakMap<object, number>();
let met = 0;

function numberOf(object: object): number {
  if (!numbers.has(object)) numbers.set(object, ++met);
  return numbers.get(object)!;
}

const isPlain = (object: object): boolean => Array.isArray(object) || Object.getPrototypeOf(object) === Object.prototype;

/**
 * The same text for what is the same all the way down. A volume (what has `samples`), a function and whatever else is not plain, such as an
 * array of bytes, is only the same as itself: who changes one in place asks in vain.
 */
export function keyOf(value: unknown): string {
  if (typeof value === 'function') return `#${numberOf(value)}`;
  if (typeof value !== 'object' || value === null) return typeof value === 'string' ? JSON.stringify(value) : String(value);
  if (!isPlain(value) || 'samples' in value) return `#${numberOf(value)}`;
  const [open, close] = Array.isArray(value) ? '[]' : '{}';
  return `${open}${Object.entries(value).map(([name, one]) => `${JSON.stringify(name)}:${keyOf(one)}`).join()}${close}`;
}

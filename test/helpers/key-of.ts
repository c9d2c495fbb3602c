/** Objects are numbered in the order in which `keyOf` gets them. */
const numbers = new WeakMap<object, number>();
let met = 0;

function numberOf(object: object): number {
  if (!numbers.has(object)) numbers.set(object, ++met);
  return numbers.get(object)!;
}

const isPlain = (object: object): boolean =>
  Array.isArray(object) || Object.getPrototypeOf(object) === Object.prototype;

/**
 * A text that is the same for deeply equal values. A volume (an object with `samples`), a function, and any other object that is not
 * plain, such as an array of bytes, is only equal to itself: if you change one in place, its key does not change.
 */
export function keyOf(value: unknown): string {
  if (typeof value === 'function') return `#${numberOf(value)}`;
  if (typeof value !== 'object' || value === null)
    return typeof value === 'string' ? JSON.stringify(value) : String(value);
  if (!isPlain(value) || 'samples' in value) return `#${numberOf(value)}`;
  const [open, close] = Array.isArray(value) ? '[]' : '{}';
  return `${open}${Object.entries(value)
    .map(([name, one]) => `${JSON.stringify(name)}:${keyOf(one)}`)
    .join()}${close}`;
}

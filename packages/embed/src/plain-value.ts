// Details of events for another page: numbers, texts, lists and plain objects, and little of them.

const maxDepth = 4;
const maxEntries = 64;
const maxText = 2000;

/** A value that can be sent. What is no plain value, or too deep, is left out (undefined). */
export function toPlain(value: unknown, depth = 0): unknown {
  if (typeof value === 'string') return value.slice(0, maxText);
  if (typeof value === 'number' || typeof value === 'boolean' || value === null) return value;
  if (typeof value !== 'object' || depth >= maxDepth) return undefined;
  if (Array.isArray(value)) return value.slice(0, maxEntries).map((one) => toPlain(one, depth + 1) ?? null);
  if (value instanceof Error) return { message: value.message.slice(0, maxText) };
  const prototype: unknown = Object.getPrototypeOf(value);
  if (prototype !== Object.prototype && prototype !== null) return undefined;
  return Object.fromEntries(
    Object.entries(value)
      .slice(0, maxEntries)
      .map(([name, one]) => [name, toPlain(one, depth + 1)] as const)
      .filter(([, one]) => one !== undefined),
  );
}

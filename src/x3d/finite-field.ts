import type { X3dNode } from './x3dom-types.ts';

/** Squares of larger numbers have no place in a GPU's floats. */
const largest = 1e18;

/** Whether a node's field, which may be none of its own, holds numbers that can be drawn, or no numbers. */
export function isFiniteField(node: X3dNode, lowerName: string): boolean {
  const name = Object.keys(node._vf).find((one) => one.toLowerCase() === lowerName);
  return name === undefined || isFinite(node._vf[name]);
}

function isFinite(value: unknown): boolean {
  if (typeof value === 'number') return Math.abs(value) <= largest;
  if (typeof value !== 'object' || value === null) return true;
  if (ArrayBuffer.isView(value) || Array.isArray(value)) return (value as unknown as unknown[]).every(isFinite);
  return Object.values(value).every((part) => typeof part !== 'number' || Math.abs(part) <= largest);
}

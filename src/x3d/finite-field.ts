import { length } from '../volume/matrix.ts';
import type { X3dLight, X3dNode } from './x3dom-types.ts';

/** Squares of larger numbers have no place in a GPU's floats. */
const largest = 1e18;

/** Whether a node's field, which may be none of its own, holds numbers that can be drawn, or no numbers. */
export function isFiniteField(node: X3dNode, lowerName: string): boolean {
  const name = Object.keys(node._vf).find((one) => one.toLowerCase() === lowerName);
  return name === undefined || isFinite(node._vf[name]);
}

/** Whether a node is a light that shines nowhere. x3dom makes 0 0 0 of a direction in words, too. */
export function hasNoDirection(node: X3dNode): boolean {
  const { direction } = (node as X3dLight)._vf;
  return direction !== undefined && !(length([direction.x, direction.y, direction.z]) > 0);
}

function isFinite(value: unknown): boolean {
  if (typeof value === 'number') return Math.abs(value) <= largest;
  if (typeof value !== 'object' || value === null) return true;
  if (ArrayBuffer.isView(value) || Array.isArray(value)) return (value as unknown as unknown[]).every(isFinite);
  return Object.values(value).every((part) => typeof part !== 'number' || Math.abs(part) <= largest);
}

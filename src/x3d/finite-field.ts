import { length } from '../volume/matrix.ts';
import type { X3dLight, X3dNode } from './x3dom-types.ts';

/** Squares of larger numbers have no place in a GPU's floats. */
const largest = 1e18;

/** Whether a node's field, which may be none of its own, holds numbers that can be drawn, or no numbers. */
export function isFiniteField(node: X3dNode, lowerName: string): boolean {
  const name = Object.keys(node._vf).find((one) => one.toLowerCase() === lowerName);
  return name === undefined || isFinite(node._vf[name]);
}

/** What is told of an attribute that holds another number. */
export function explainInfinite(element: Element, name: string): string {
  const value = element.getAttribute(name) ?? '';
  const wrong = value.split(/[\s,]+/).find((word) => !isFinite(Number(word))) ?? value;
  return `${name} of <${element.localName}> got "${wrong.slice(0, 40)}"; expected numbers up to 1e18`;
}

/** Whether a node is a light that shines nowhere. x3dom makes 0 0 0 of a direction in words, too. */
export function hasNoDirection(node: X3dNode): boolean {
  const { direction } = (node as X3dLight)._vf;
  return direction !== undefined && !(length([direction.x, direction.y, direction.z]) > 0);
}

/** Numbers, those of a place or a matrix, lists of numbers, and lists of places; x3dom's lists are no arrays. */
function isFinite(value: unknown, depth = 0): boolean {
  if (typeof value === 'number') return Math.abs(value) <= largest;
  if (typeof value !== 'object' || value === null || depth > 1) return true;
  const parts: readonly unknown[] = ArrayBuffer.isView(value) ? (value as unknown as number[]) : Object.values(value);
  return parts.every((part) => isFinite(part, depth + 1));
}

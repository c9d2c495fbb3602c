import { length } from '../volume/matrix.ts';
import type { X3dLight, X3dNode } from './x3dom-types.ts';

/** The square of a larger number does not fit into a GPU's float. */
const largest = 1e18;

/**
 * Whether a node's field holds numbers that can be drawn; true if it holds no numbers, or if the node has no such
 * field.
 */
export function isFiniteField(node: X3dNode, lowerName: string): boolean {
  const name = Object.keys(node._vf).find((one) => one.toLowerCase() === lowerName);
  return name === undefined || isFinite(node._vf[name]);
}

/** The message about an attribute that holds another number. */
export function explainInfinite(element: Element, name: string): string {
  const value = element.getAttribute(name) ?? '';
  const wrong = value.split(/[\s,]+/).find((word) => !isFinite(Number(word))) ?? value;
  return `${name} of <${element.localName}> got "${wrong.slice(0, 40)}"; expected numbers up to 1e18`;
}

/** Whether a node is a light without a direction. x3dom also reads a direction of words as 0 0 0. */
export function hasNoDirection(node: X3dNode): boolean {
  const { direction } = (node as X3dLight)._vf;
  return direction !== undefined && !(length([direction.x, direction.y, direction.z]) > 0);
}

/** Checks numbers, those of a vector or a matrix, lists of numbers, and lists of vectors; x3dom's lists are not arrays. */
function isFinite(value: unknown, depth = 0): boolean {
  if (typeof value === 'number') return Math.abs(value) <= largest;
  if (typeof value !== 'object' || value === null || depth > 1) return true;
  const parts: readonly unknown[] = ArrayBuffer.isView(value) ? (value as unknown as number[]) : Object.values(value);
  return parts.every((part) => isFinite(part, depth + 1));
}

import { fileAttributes } from '../../lesson-writers/src/allowed-html.ts';
import { listAddresses } from '../../lesson-writers/src/check-lesson-html.ts';
import type { LessonNode } from '../../lesson-writers/src/check-lesson-html.ts';
import { readAddress } from '../../lesson-writers/src/lesson-paths.ts';

/** Attributes that a view in a frame does not have: they are for pages of their author, or would send cookies to a server that strangers choose. */
const leftOut: readonly string[] = ['authoring', 'crossorigin', 'link-state'];

/**
 * A node of a lesson that was checked, as the browser has it.
 * @param addressOf - of a file of the lesson, by its path
 * @param leftToo - attributes that are left out besides
 */
export function buildNode(
  node: LessonNode,
  addressOf: (path: string) => string,
  leftToo: readonly string[] = [],
): Node {
  if (typeof node === 'string') return document.createTextNode(node);
  const element = document.createElement(node.name);
  for (const [name, value] of node.attributes) {
    if (leftToo.includes(name) || (node.name === 'volume-view' && leftOut.includes(name))) continue;
    element.setAttribute(name, fileAttributes.includes(name) ? resolve(value, addressOf) : value);
    if (name === 'href' && !value.trim().startsWith('#')) {
      element.setAttribute('target', '_blank');
      element.setAttribute('rel', 'noopener noreferrer');
    }
  }
  element.append(...node.children.map((child) => buildNode(child, addressOf, leftToo)));
  return element;
}

const resolve = (value: string, addressOf: (path: string) => string): string =>
  listAddresses(value)
    .flatMap((address) => {
      const file = readAddress(address);
      return file ? [addressOf(file.path) + file.fragment] : [];
    })
    .join(' ');

// A lesson, read by the browser's own parser. Nothing of it runs or is loaded, as the document that it becomes is never shown; what is shown is
// built from the names and texts that the rules of a lesson allow.
import { checkLessonHtml } from '../../lesson-writers/src/check-lesson-html.ts';
import type { LessonContent, ParsedElement, ParsedNode } from '../../lesson-writers/src/check-lesson-html.ts';
import { trust } from './page-parts.ts';

export const parseLesson = (html: string): LessonContent =>
  checkLessonHtml(html, (text) => {
    const parsed = new DOMParser().parseFromString(trust(text, 'createHTML'), 'text/html');
    return listNodes(parsed).filter((node) => typeof node !== 'string');
  });

/**
 * A property as the browser has it: an `<input name="childNodes">` would stand in its place on the element of a form.
 * @param holder - the prototype that has it
 */
function reader<T extends object, K extends keyof T>(holder: T, name: K): (object: T) => T[K] {
  const { get } = Object.getOwnPropertyDescriptor(holder, name)!;
  return (object) => (get as (this: T) => T[K]).call(object);
}

const childrenOf = reader(Node.prototype, 'childNodes');
const typeOf = reader(Node.prototype, 'nodeType');
const textOf = reader(CharacterData.prototype, 'data');
const nameOf = reader(Element.prototype, 'localName');
const spaceOf = reader(Element.prototype, 'namespaceURI');
const attributesOf = reader(Element.prototype, 'attributes');

/** An element of the browser. Its children are made when they are asked for: a hostile tree may be very deep. */
class BrowserElement implements ParsedElement {
  readonly line = null;

  constructor(readonly element: Element) {}

  get name(): string {
    return nameOf(this.element);
  }

  get isHtml(): boolean {
    return spaceOf(this.element) === 'http://www.w3.org/1999/xhtml';
  }

  get attributes(): ParsedElement['attributes'] {
    return [...attributesOf(this.element)].map(({ name, value }) => ({ name, value }));
  }

  get children(): readonly ParsedNode[] {
    return listNodes(this.element);
  }
}

const listNodes = (parent: Node): ParsedNode[] =>
  [...childrenOf(parent)].flatMap((node): ParsedNode[] => {
    const type = typeOf(node);
    if (type === Node.ELEMENT_NODE) return [new BrowserElement(node as Element)];
    return type === Node.TEXT_NODE ? [textOf(node as Text)] : [];
  });

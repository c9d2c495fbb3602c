import { fieldOf, isAllowedField, isAllowedNode, isHandler, isUrlField, sortUrls } from './author-allowed.ts';
import { meantChildren, meantParent, meantWithin } from '../page/unclosed.ts';
import type { X3dOwned } from './x3dom-types.ts';

/** Receives what is left out of an author's element, and why. */
export type ReportLeftOut = (element: Element, what: string, why: string) => void;

/** Maximum depth of nested elements. */
const maxDepth = 200;

/** Maximum number of nodes of one scene that `use` repeats: a few names that use each other would make millions. */
const maxRepeated = 4000;

/**
 * Maximum number of lights of one scene, and of ClipPlanes: each makes x3dom's shaders longer, and then they may take a
 * minute to compile.
 */
const maxLights = 16;
const costly = /(light|clipplane)$/i;

/** Maximum values of fields that say how much x3dom makes: parts of a surface, pixels of a shadow, pixels of a text. */
const limits: Readonly<Record<string, number>> = {
  subdivision: 256,
  shadowmapsize: 4096,
  shadowcascades: 6,
  shadowfiltersize: 16,
  image: 4096,
  quality: 10,
  anisotropicdegree: 16,
};

/** Maximum number of letters of a text that is drawn. */
const maxTextLength = 2000;

/** Renames the author's nodes, so that they differ from every name in x3dom's own tables. */
const asName = (name: string): string => `author-${name}`;

const nameFields = new Set(['fromnode', 'tonode']);

/**
 * Copies the parts of an author's elements that may join a scene. x3dom sees only the copies: it writes into them, and
 * the author's elements stay as they are.
 */
export class AuthorCopies {
  readonly #copies = new WeakMap<Element, X3dOwned>();
  /** For `use`: the number of nodes under each name. */
  readonly #sizes = new Map<string, number>();
  /** The names that are used inside the element of each name. */
  readonly #uses = new Map<string, Set<string>>();
  #repeated = 0;
  readonly #costly = new Set<Element>();

  constructor(readonly report: ReportLeftOut) {}

  copyOf(element: Node): X3dOwned | undefined {
    return this.#copies.get(element as Element);
  }

  /** @returns the copy of an element and its content; null if it may not join the scene */
  copy(element: Element): X3dOwned | null {
    return this.#copy(element, namesAround(element), 0)?.copy ?? null;
  }

  /** Call this when elements have left the scene. */
  forget(element: Element): void {
    for (const one of [element, ...meantWithin(element)]) {
      this.#copies.delete(one);
      this.#costly.delete(one);
      const name = useOf(one);
      if (name !== null) this.#repeated = Math.max(0, this.#repeated - (this.#sizes.get(name) ?? 0));
    }
  }

  /** The value of an attribute in the copy; null if the copy does not have it. */
  valueOf(element: Element, name: string): string | null {
    const value = element.getAttribute(name);
    if (value === null) return null;
    if (isHandler(name)) this.report(element, name, 'it would be run as a script. Use addEventListener');
    else if (name.toLowerCase() === 'buffer') this.report(element, name, 'data of other files are not loaded');
    if (!isAllowedField(name)) return null;
    const field = fieldOf(name);
    if (isUrlField(name)) return this.#pictures(element, name, value);
    if (nameFields.has(field)) return asName(value);
    if (/^(from|to)field$/.test(field) && (!isAllowedField(value) || isUrlField(value))) {
      this.report(element, name, `"${value.slice(0, 40)}" is no field that can be joined`);
      return null;
    }
    const max = limits[field] ?? Infinity;
    if (
      field in limits &&
      value
        .split(/[\s,]+/)
        .slice(0, 2)
        .some((word) => Number(word) > max)
    ) {
      this.report(element, name, `it asks for more than ${max}`);
      return null;
    }
    if (field === 'plane') return unitPlane(value);
    if (field === 'string' && value.length > maxTextLength) {
      this.report(element, name, `the text is longer than ${maxTextLength} letters`);
      return null;
    }
    return value;
  }

  #pictures(element: Element, name: string, value: string): string | null {
    const { allowed, refused } = sortUrls(value, element.ownerDocument.baseURI);
    for (const url of refused)
      this.report(
        element,
        name,
        `"${url.slice(0, 60)}" is not loaded: a picture's URL begins with https:, http: or data:image/, or is relative`,
      );
    return allowed === '' ? null : allowed;
  }

  /** Whether one of some names is used inside the element of a name, directly or indirectly. */
  #reaches(name: string, wanted: readonly string[]): boolean {
    const seen = new Set([name]);
    for (const one of seen) for (const used of this.#uses.get(one) ?? []) seen.add(used);
    return wanted.some((one) => seen.has(one));
  }

  /** @param around - names of the elements around it */
  #copy(element: Element, around: readonly string[], depth: number): { copy: X3dOwned; size: number } | null {
    const leaveOut = (why: string): null => {
      this.report(element, `<${element.localName}>`, why);
      return null;
    };
    if (/volume(style|data)$/i.test(element.localName)) return null; // The volume's own nodes are read elsewhere.
    if (!isAllowedNode(element))
      return leaveOut('no X3D node of this name takes part in the scene, see docs/guide/shapes.md');
    if (depth > maxDepth) return leaveOut(`it is more than ${maxDepth} elements deep`);
    const kind = costly.exec(element.localName)?.[1].toLowerCase();
    if (
      kind &&
      [...this.#costly.add(element)].filter(({ localName }) => localName.toLowerCase().endsWith(kind)).length >
        maxLights
    ) {
      this.#costly.delete(element);
      return leaveOut(`there are more than ${maxLights} ${kind}s`);
    }
    const use = useOf(element);
    const def = nameOf(element);
    if (use !== null && this.#reaches(use, around))
      return leaveOut(`its use of "${use.slice(0, 40)}" is within that element itself, without end`);
    if (use !== null) for (const name of around) this.#uses.set(name, (this.#uses.get(name) ?? new Set()).add(use));
    // Created in this document, whatever document the author's element is from: x3dom knows no elements of other
    // windows.
    const repeated = use === null ? 0 : (this.#sizes.get(use) ?? 0);
    if (this.#repeated + repeated > maxRepeated)
      return leaveOut(`more than ${maxRepeated} nodes would be repeated by use`);
    this.#repeated += repeated;
    const copy = document.createElement(element.localName.toLowerCase());
    let size = repeated + 1;
    for (const name of element.getAttributeNames()) {
      const value = this.valueOf(element, name);
      if (value !== null) copy.setAttribute(name, value);
    }
    if (use !== null) copy.setAttribute('USE', asName(use));
    else if (def !== '') copy.setAttribute('DEF', asName(def));
    for (const child of use === null ? meantChildren(element) : []) {
      const made = this.#copy(child, def === '' ? around : [...around, def], depth + 1);
      if (!made) continue;
      copy.append(made.copy);
      size += made.size;
    }
    if (use === null && def !== '') this.#sizes.set(def, size);
    this.#copies.set(element, copy);
    return { copy, size };
  }
}

/**
 * The plane of a ClipPlane with a normal of length 1: x3dom cuts at the wrong place for other lengths. A normal of
 * length 0 cuts nothing.
 */
function unitPlane(value: string): string {
  const numbers = value
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  const max = Math.max(...numbers.slice(0, 3).map(Math.abs));
  const length = max * Math.hypot(...numbers.slice(0, 3).map((x) => x / max));
  return max === 0 ? '0 0 0 0' : numbers.map((x) => x / length).join(' ');
}

/** The name under which an element can be used again; empty if it has none. */
function nameOf(element: Element): string {
  return element.getAttribute('DEF') ?? element.getAttribute('def') ?? element.id;
}

function useOf(element: Element): string | null {
  return element.getAttribute('USE') ?? element.getAttribute('use');
}

function namesAround(element: Element): string[] {
  const names: string[] = [];
  for (let one = meantParent(element); one && isAllowedNode(one); one = meantParent(one)) names.push(nameOf(one));
  return names.filter((name) => name !== '');
}

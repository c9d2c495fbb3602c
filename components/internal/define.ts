import { version } from './version.ts';

/** Where an element's class says what version it is of. */
const versionKey = Symbol.for('volume-view.version');

type Versioned = CustomElementConstructor & { [versionKey]?: string };

/** Whether an element of this name is defined, and by this package. */
export function isOurs(localName: string): boolean {
  const element = customElements.get(localName);
  return element !== undefined && versionKey in element;
}

let hasTold = false;

/**
 * Define an element, unless the page has one of this name: of several copies of a script the first one holds. Where it is
 * of another version, the console says so, once.
 */
export function define(name: string, element: CustomElementConstructor): void {
  // Modules are imported in Node too, which has no elements unless somebody brings them.
  if (typeof customElements === 'undefined') return;
  const first: Versioned | undefined = customElements.get(name);
  if (!first) {
    Object.defineProperty(element, versionKey, { value: version });
    customElements.define(name, element);
  } else if (first !== element && first[versionKey] !== version && !hasTold) {
    hasTold = true;
    console.warn(`<${name}> of volume-view ${version} was not defined: the page has ${first[versionKey] ?? 'another one'} already. Load one copy of the script.`);
  }
}

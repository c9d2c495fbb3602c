import { handOver } from '#hand-over';
import { version } from './version.ts';

/** The key under which the class of an element stores its version, and the page's registry that a second version has been reported. */
const versionKey = Symbol.for('volume-view.version');

type Versioned<T> = T & { [versionKey]?: string };

/** Whether an element of this name is defined, and this package has defined it. */
export function isOurs(localName: string): boolean {
  const element = customElements.get(localName);
  return element !== undefined && versionKey in element;
}

/**
 * Define an element, unless the page already has one of this name: where a script is loaded several times, the first copy counts. If the
 * first copy has another version, a warning in the console says so, once for all copies.
 * @returns whether a copy of the script at another address defines it
 */
export function define(name: string, element: CustomElementConstructor): boolean {
  // Modules are also imported in Node, which has no custom elements unless a script adds them.
  if (typeof customElements === 'undefined') return false;
  if (handOver(name)) return true;
  const registry: Versioned<CustomElementRegistry> = customElements;
  const first: Versioned<CustomElementConstructor> | undefined = customElements.get(name);
  if (!first) {
    Object.defineProperty(element, versionKey, { value: version });
    customElements.define(name, element);
  } else if (first !== element && first[versionKey] !== version && !registry[versionKey]) {
    registry[versionKey] = version;
    console.warn(
      `<${name}> of volume-view ${version} is left out: the page has ${first[versionKey] ?? 'another'} already. Load one script.`,
    );
  }
  return false;
}

import { LitElement } from 'lit';
import { text } from './property-kinds.ts';
import type { Kind } from './property-kinds.ts';

/**
 * An element whose attributes are what it holds, as with the elements of HTML: to set a property writes its attribute at
 * once, to read one reads it. So there is one truth, and the property of an attribute that can't be read is null.
 */
export class ReflectingElement extends LitElement {
  protected override createRenderRoot(): HTMLElement | ShadowRoot {
    try {
      return super.createRenderRoot() as ShadowRoot;
    } catch {
      this.adoptedCallback();
      return this.shadowRoot!;
    }
  }

  /** The element has come into another document, where it has to be given its styles anew. */
  adoptedCallback(): void {
    void import('./wear-styles.ts').then(({ wearStyles }) => wearStyles(this), () => {});
  }

  /** The text of an attribute; null where it is absent. */
  protected readText(attribute: string): string | null {
    return this.getAttribute(attribute);
  }

  protected writeText(attribute: string, text: string | null): void {
    if (text === null) this.removeAttribute(attribute);
    else this.setAttribute(attribute, text);
  }

  /** To write the same text again is a change too, as with the elements of HTML. */
  override attributeChangedCallback(name: string, old: string | null, _value: string | null): void {
    const { elementProperties } = this.constructor as typeof LitElement;
    for (const [property, { attribute }] of elementProperties) {
      if (attribute === name) this.requestUpdate(property, old);
    }
  }
}

/** What accessors need of an element: its protected part. */
interface TextHolder {
  readText(attribute: string): string | null;
  writeText(attribute: string, text: string | null): void;
}

export interface PropertyOptions<T> {
  /** By default the property's own name. */
  attribute?: string;
  /** By default text. */
  kind?: Kind<T>;
}

/** The text of a value, whatever a script gives. Of one that has none it is one that no attribute takes, and the element says so. */
export function writeSafely<T>(write: (value: T) => string | null, value: T): string | null {
  try {
    return write(value);
  } catch {
    return '?';
  }
}

/** Decorates a property that an attribute holds. A class that has accessors of its own for it keeps them. */
export function property<T>({ attribute, kind }: PropertyOptions<T> = {}) {
  return (prototype: ReflectingElement, name: string, own?: PropertyDescriptor): void => {
    const { read, write } = (kind ?? text) as Kind<unknown>;
    const { constructor } = prototype as { constructor: unknown };
    const attributeName = attribute ?? name;
    // One text that can't be read is not the other: the old value says nothing of whether there is a change.
    (constructor as typeof LitElement).createProperty(name, { attribute: attributeName, noAccessor: true, hasChanged: () => true });
    if (own) return;
    Object.defineProperty(prototype, name, {
      configurable: true,
      enumerable: true,
      get(this: TextHolder): unknown {
        return read(this.readText(attributeName));
      },
      set(this: TextHolder, value: unknown): void {
        this.writeText(attributeName, writeSafely(write, value));
      },
    });
  };
}

import { LitElement } from 'lit';
import { text } from './property-kinds.ts';
import type { Kind } from './property-kinds.ts';

/**
 * An element that keeps its values in its attributes, as the elements of HTML do: setting a property writes its attribute at once, reading
 * a property reads the attribute. So each value is stored in one place only. If an attribute can't be read, its property is null.
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

  /** The element was moved into another document, where its styles have to be applied again. */
  adoptedCallback(): void {
    void import('./apply-styles.ts').then(
      ({ applyStyles }) => applyStyles(this),
      () => {},
    );
  }

  /** The text of an attribute; null where it is absent. */
  protected readText(attribute: string): string | null {
    return this.getAttribute(attribute);
  }

  protected writeText(attribute: string, text: string | null): void {
    if (text === null) this.removeAttribute(attribute);
    else this.setAttribute(attribute, text);
  }

  /** Writing the same text again counts as a change too, as for the elements of HTML. */
  override attributeChangedCallback(name: string, old: string | null, _value: string | null): void {
    const { elementProperties } = this.constructor as typeof LitElement;
    for (const [property, { attribute }] of elementProperties) {
      if (attribute === name) this.requestUpdate(property, old);
    }
  }
}

/** The protected members of an element that accessors need. */
interface TextHolder {
  readText(attribute: string): string | null;
  writeText(attribute: string, text: string | null): void;
}

export interface PropertyOptions<T> {
  /** Default: the name of the property. */
  attribute?: string;
  /** Default: text. */
  kind?: Kind<T>;
}

/**
 * The text of any value that a script sets. If the value has no text, the result is a text that no attribute accepts, so that the element
 * reports an error.
 */
export function writeSafely<T>(write: (value: T) => string | null, value: T): string | null {
  try {
    return write(value);
  } catch {
    return '?';
  }
}

/** Decorator for a property that is stored in an attribute. Accessors that the class itself has for the property are kept. */
export function property<T>({ attribute, kind }: PropertyOptions<T> = {}) {
  return (prototype: ReflectingElement, name: string, own?: PropertyDescriptor): void => {
    const { read, write } = (kind ?? text) as Kind<unknown>;
    const { constructor } = prototype as { constructor: unknown };
    const attributeName = attribute ?? name;
    // Two different texts that can't be read both give null, so the old value does not show whether there is a change.
    (constructor as typeof LitElement).createProperty(name, {
      attribute: attributeName,
      noAccessor: true,
      hasChanged: () => true,
    });
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

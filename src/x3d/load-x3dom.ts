import { VolumeViewError } from '../core/errors.ts';
import { trust } from '../core/trust.ts';
import type { X3dom } from './x3dom-types.ts';
import { injectOwnText } from './x3dom-source.ts';
import { findX3domUrl } from './x3dom-url.ts';

let loading: Promise<X3dom> | null = null;

/**
 * x3dom, loaded once a page when the first element needs it; a page's own x3dom is used where there is one.
 * It is a classic script that sets a global, hence the script element.
 * @throws {VolumeViewError} `x3dom/unavailable`; a later call tries again
 */
export function loadX3dom(): Promise<X3dom> {
  const own = globalX3dom();
  if (own) return Promise.resolve(own);
  return (loading ??= findAndInject());
}

function globalX3dom(): X3dom | undefined {
  // An element with this id or name is a property of the window, too, but not its own.
  return Object.hasOwn(globalThis, 'x3dom') ? (globalThis as { x3dom?: X3dom }).x3dom : undefined;
}

async function findAndInject(): Promise<X3dom> {
  const url = findX3domUrl();
  try {
    // A bundler that knows `new URL(…)` gives the file a name of its own. Where it has the old one, that may mean a file beside the
    // bundle, which nobody put there: the text comes first then.
    return await (injectOwnText && url.endsWith('/x3dom.js') ? injectOwnText(url, injectScript) : injectScript(url));
  } catch (cause) {
    loading = null;
    throw new VolumeViewError(
      'x3dom/unavailable',
      `x3dom could not be loaded from ${url}. Put volume-view's x3dom.js there; the page's Content-Security-Policy has to allow it.`,
      { cause },
    );
  }
}

function injectScript(url: string): Promise<X3dom> {
  return new Promise((resolve, reject) => {
    const script = document.createElement('script');
    const end = adaptWhileRunning(script);
    const fail = (cause?: unknown) => {
      end();
      script.remove();
      reject(cause);
    };
    script.src = trust(url, 'createScriptURL');
    script.onerror = fail;
    script.onload = () => {
      const x3dom = globalX3dom();
      if (!x3dom) return fail(); // It was another script.
      end();
      // Its log goes to hidden elements as HTML text; nobody reads it and nothing of it may reach the page.
      x3dom.debug.maxLinesToLog = -1;
      resolve(x3dom);
    };
    readDocument<HTMLElement>('head').append(script);
  });
}

/**
 * What x3dom may not do, or not so, while its script runs. It listens to `unload`, which would cost the page its place in the
 * back-forward cache: what it does there, to free its contexts, a page that goes does by itself. And it makes elements of a
 * text of its own, which Trusted Types want to be told.
 * @returns puts all back
 */
function adaptWhileRunning(script: HTMLScriptElement): () => void {
  const ends = [
    adapt(script, EventTarget.prototype, 'addEventListener', (args) => (args[0] === 'unload' ? null : args)),
    adapt(script, DOMParser.prototype, 'parseFromString', ([text, type]) => [trust(text as string, 'createHTML'), type]),
  ];
  return () => ends.forEach((end) => end());
}

/** @param change - of the arguments that the script gives; null where it is not to be called */
function adapt<T>(script: HTMLScriptElement, target: T, name: keyof T, change: (args: unknown[]) => unknown[] | null): () => void {
  const native = target[name] as (...args: unknown[]) => unknown;
  const adapted = function (this: unknown, ...args: unknown[]): unknown {
    const changed = readDocument('currentScript') === script ? change(args) : args;
    return changed && Reflect.apply(native, this, changed);
  };
  target[name] = adapted as T[keyof T];
  return () => {
    if (target[name] === adapted) target[name] = native as T[keyof T]; // Else somebody came after us, and calls us.
  };
}

/** A property of the document, and not an image or a form that has its name. */
function readDocument<T>(name: 'currentScript' | 'head'): T {
  return Reflect.get(Document.prototype, name, document) as T;
}

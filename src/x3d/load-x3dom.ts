import { VolumeViewError } from '../core/errors.ts';
import { trust } from '../core/trust.ts';
import type { X3dom } from './x3dom-types.ts';
import { injectOwnText } from '#x3dom-text';
import { findX3domUrl } from '#x3dom-url';

let loading: Promise<X3dom> | null = null;

/**
 * Loads x3dom once per page when the first element needs it; uses the page's own x3dom if there is one. It is a classic
 * script that sets a global, hence the script element.
 * @throws {VolumeViewError} `x3dom/unavailable`; a later call tries again
 */
export function loadX3dom(): Promise<X3dom> {
  const own = globalX3dom();
  if (own) return Promise.resolve(own);
  return (loading ??= findAndInject());
}

function globalX3dom(): X3dom | undefined {
  // An element with this id or name is a property of the window too, but not an own property.
  return Object.hasOwn(globalThis, 'x3dom') ? (globalThis as { x3dom?: X3dom }).x3dom : undefined;
}

async function findAndInject(): Promise<X3dom> {
  const url = findX3domUrl();
  try {
    // A bundler that knows `new URL(…)` gives the file a new name. If the file still has its old name, the bundler may
    // not have copied it at all, so the text is tried first.
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
      if (!x3dom) return fail(); // The script was not x3dom.
      end();
      // It logs HTML text into hidden elements; nobody reads that, and none of it may reach the page.
      x3dom.debug.maxLinesToLog = -1;
      resolve(x3dom);
    };
    readDocument<HTMLElement>('head').append(script);
  });
}

/**
 * Changes what x3dom does while its script runs. It listens to `unload`, which would exclude the page from the
 * back-forward cache; it frees its contexts there, which happens anyway when a page goes. And it makes elements from a
 * text of its own, which Trusted Types have to allow.
 * @returns a function that restores everything
 */
function adaptWhileRunning(script: HTMLScriptElement): () => void {
  const ends = [
    adapt(script, EventTarget.prototype, 'addEventListener', (args) => (args[0] === 'unload' ? null : args)),
    adapt(script, DOMParser.prototype, 'parseFromString', ([text, type]) => [
      trust(text as string, 'createHTML'),
      type,
    ]),
  ];
  return () => ends.forEach((end) => end());
}

/** @param change - receives the script's arguments; null means that the call is skipped */
function adapt<T>(
  script: HTMLScriptElement,
  target: T,
  name: keyof T,
  change: (args: unknown[]) => unknown[] | null,
): () => void {
  const native = target[name] as (...args: unknown[]) => unknown;
  const adapted = function (this: unknown, ...args: unknown[]): unknown {
    const changed = readDocument('currentScript') === script ? change(args) : args;
    return changed && Reflect.apply(native, this, changed);
  };
  target[name] = adapted as T[keyof T];
  return () => {
    if (target[name] === adapted) target[name] = native as T[keyof T]; // Else another script wrapped it later, and calls ours.
  };
}

/** Reads a property of the document, even if an image or a form has its name. */
function readDocument<T>(name: 'currentScript' | 'head'): T {
  return Reflect.get(Document.prototype, name, document) as T;
}

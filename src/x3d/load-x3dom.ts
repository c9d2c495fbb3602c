import { VolumeViewError } from '../errors.ts';
import { trustUrl } from '../trust-url.ts';
import type { X3dom } from './x3dom-types.ts';
import { x3domUrl } from './x3dom-url.ts';

let loading: Promise<X3dom> | null = null;

/**
 * x3dom, loaded once a page when the first element needs it; a page's own x3dom is used where there is one.
 * It is a classic script that sets a global, hence the script element.
 * @throws {VolumeViewError} `x3dom/unavailable`; a later call tries again
 */
export function loadX3dom(): Promise<X3dom> {
  const own = globalX3dom();
  if (own) return Promise.resolve(own);
  loading ??= injectScript().catch((error: unknown) => {
    loading = null;
    throw error;
  });
  return loading;
}

function globalX3dom(): X3dom | undefined {
  // An element with this id or name is a property of the window, too, but not its own.
  return Object.hasOwn(globalThis, 'x3dom') ? (globalThis as { x3dom?: X3dom }).x3dom : undefined;
}

function injectScript(): Promise<X3dom> {
  return new Promise((resolve, reject) => {
    const script = document.createElement('script');
    const end = keepOutUnload(script);
    const fail = (cause: unknown) => {
      end();
      script.remove();
      reject(new VolumeViewError(
        'x3dom/unavailable',
        `The 3D library x3dom could not be loaded from ${x3domUrl}. Put x3dom.js beside the script of volume-view, and check that the page's Content-Security-Policy allows it.`,
        { cause },
      ));
    };
    script.src = trustUrl(x3domUrl);
    script.async = true;
    script.addEventListener('error', fail, { once: true });
    script.addEventListener('load', () => {
      const x3dom = globalX3dom();
      if (!x3dom) return fail(new Error('the script ran but left no global x3dom'));
      end();
      // Its log goes to hidden elements as HTML text; nobody reads it and nothing of it may reach the page.
      x3dom.debug.maxLinesToLog = -1;
      resolve(x3dom);
    }, { once: true });
    readDocument<HTMLElement>('head').append(script);
  });
}

/**
 * Let a script that is loaded not listen to `unload`: a page with such a listener has no place in the back-forward cache.
 * What x3dom would do there, to free its contexts, a page that goes does by itself.
 * @returns puts all back
 */
function keepOutUnload(script: HTMLScriptElement): () => void {
  const before = Object.getOwnPropertyDescriptor(window, 'addEventListener');
  const native = window.addEventListener;
  const filter: typeof native = function (this: unknown, ...args: unknown[]) {
    if (args[0] !== 'unload' || readDocument('currentScript') !== script) Reflect.apply(native, this ?? window, args);
  };
  window.addEventListener = filter;
  return () => {
    if (window.addEventListener !== filter) return; // Another one has put its own in its place.
    if (before) Object.defineProperty(window, 'addEventListener', before);
    else delete (window as Partial<Window>).addEventListener;
  };
}

/** A property of the document, and not an image or a form that has its name. */
function readDocument<T>(name: 'currentScript' | 'head'): T {
  return Reflect.get(Document.prototype, name, document) as T;
}

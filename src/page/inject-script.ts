import { trust } from '../core/trust.ts';

/** Run a classic script of this package. @param url - absolute @returns resolves when it has run; rejects where it could not be loaded */
export function injectScript(url: string): Promise<void> {
  return new Promise((resolve, reject) => {
    const script = document.createElement('script');
    script.src = trust(url, 'createScriptURL');
    script.onload = () => {
      script.remove();
      resolve();
    };
    script.onerror = () => {
      script.remove();
      reject(new Error(`${url} could not be loaded`));
    };
    // An image or a form with the name "head" can hide `document.head`.
    Reflect.get(Document.prototype, 'head', document).append(script);
  });
}

// Large files that the studio loads when it needs them. They are scripts, as a page on a disk may load scripts and nothing else.

declare global {
  interface Window {
    /** Their bytes as base64, by their names. */
    studioParts?: Record<string, string>;
  }
}

const loading = new Map<string, Promise<Uint8Array<ArrayBuffer>>>();

/** The bytes of `parts/NAME.js`. @throws {Error} where the file is not there */
export function loadPart(name: string): Promise<Uint8Array<ArrayBuffer>> {
  const known = loading.get(name);
  if (known) return known;
  const part = new Promise<Uint8Array<ArrayBuffer>>((resolve, reject) => {
    const script = document.createElement('script');
    script.src = `parts/${name}.js`;
    script.onload = () => {
      const text = window.studioParts?.[name];
      if (text === undefined) reject(new Error(`parts/${name}.js`));
      else resolve(Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0)));
      delete window.studioParts?.[name];
      script.remove();
    };
    script.onerror = () => {
      loading.delete(name);
      reject(new Error(`parts/${name}.js`));
    };
    document.head.append(script);
  });
  loading.set(name, part);
  return part;
}

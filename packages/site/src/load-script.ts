const loaded = new Map<string, Promise<void>>();

/** Loads a classic script once: it works from a disk too, where a page may read no other files. @throws {Error} where it does not come */
export function loadScript(url: string): Promise<void> {
  const known =
    loaded.get(url) ??
    new Promise<void>((resolve, reject) => {
      const script = document.createElement('script');
      script.src = url;
      script.addEventListener('load', () => resolve());
      script.addEventListener('error', () => reject(new Error(`${url} could not be loaded`)));
      document.head.append(script);
    });
  loaded.set(url, known);
  return known;
}

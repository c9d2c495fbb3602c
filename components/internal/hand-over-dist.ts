import type { handOver as usual } from './hand-over.ts';

// The build writes `import.meta.url` in its place, as in create-worker-dist.ts.
declare const OWN_URL: string;

/**
 * In place of hand-over.ts, in the modules for a page. A CMS adds a version to the addresses of scripts: `volume-view.js?ver=1.2`. The
 * other parts import the script without it, and for a browser that is another module, with classes and state of its own. So the copy
 * with a version defines nothing: it loads the one without.
 * @param name - of the element that the script defines, and of its file
 * @returns whether the other copy defines the element
 */
export const handOver: typeof usual = (name) => {
  const [address] = OWN_URL.split(/[?#]/);
  if (address === OWN_URL || !address.endsWith(`/${name}.js`)) return false;
  void import(/* @vite-ignore */ address);
  return true;
};

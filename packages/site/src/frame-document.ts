/** The text of the page in which an example is shown. */

/** Names of files in an example, in the attributes that name files. */
const attributes = /\b(src|table|poster)="([^"]*)"/g;

/** The same with `data:` URLs in the place of the files that are known, for a page from a disk. @param files - URLs by name */
export function withDataUrls(code: string, files: Readonly<Record<string, string>>): string {
  return code.replaceAll(attributes, (whole, name: string, value: string) => {
    const words = value.split(/\s+/);
    return words.some((word) => Object.hasOwn(files, word))
      ? `${name}="${words.map((word) => (Object.hasOwn(files, word) ? files[word] : word)).join(' ')}"`
      : whole;
  });
}

export interface FramePlace {
  /** What addresses in the example count from. */
  readonly base: string;
  /** A page from a disk may load classic scripts only. */
  readonly isFromDisk: boolean;
}

/** A whole page for an example, with the scripts of the element where it has none. */
export function frameDocument(code: string, { base, isFromDisk }: FramePlace): string {
  const own = isFromDisk
    ? code.replaceAll(
        /<script type="module" src="dist\/volume-view\.js"><\/script>/g,
        '<script src="dist/volume-view.iife.js"></script>',
      )
    : code;
  const start = `<base href="${base.replaceAll('"', '%22')}">`;
  if (/^\s*<!doctype/i.test(own)) return own.replace(/<head>|<!doctype[^>]*>/i, (found) => found + start);
  const element = /<script[^>]+volume-view\./.test(own)
    ? ''
    : '<link rel="stylesheet" href="dist/volume-view.css"><script src="dist/volume-view.iife.js"></script>';
  const style =
    '<style>:root { color-scheme: light dark } body { margin: 0.5rem; font: 1rem/1.4 system-ui, sans-serif } iframe { border: 0; max-inline-size: 100% }</style>';
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>Example</title>${start}${style}${element}</head><body>\n${own}</body></html>`;
}

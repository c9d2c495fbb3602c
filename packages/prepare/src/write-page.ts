import { escapeMarkup } from '../../lesson-writers/src/index.ts';

/** Maximum number of bytes of a file in a page: some browsers open no larger pages. */
export const maxPageBytes = 64 * 2 ** 20;

/**
 * Write a page that contains a volume and works from disk, in the same folder as `volume-view.iife.js`.
 * @param bytes - of a file that <volume-view> reads, at most `maxPageBytes`
 * @param alt - a description of the volume
 * @throws {RangeError} where the file is larger
 */
export function writePage(bytes: Uint8Array, alt: string): string {
  if (bytes.length > maxPageBytes) {
    throw new RangeError(
      `the file has ${Math.round(bytes.length / 2 ** 20)} MiB; expected at most ${maxPageBytes / 2 ** 20}: put it on a web server`,
    );
  }
  const url = `data:application/octet-stream;base64,${Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength).toString('base64')}`;
  return `<!doctype html>
<html lang="en">
  <meta charset="utf-8">
  <meta name="viewport" content="width=device-width">
  <title>${escapeMarkup(alt)}</title>
  <script src="volume-view.iife.js"></script>
  <volume-view controls alt="${escapeMarkup(alt)}" src="${url}"></volume-view>
</html>
`;
}

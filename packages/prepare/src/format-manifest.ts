/** Write a manifest as JSON; lists and objects without nested ones are on one line. */
export function formatManifest(manifest: object): string {
  const oneLine = (inner: string): string => inner.replace(/\s+/g, ' ');
  const text = JSON.stringify(manifest, null, 2)
    .replace(/\[\s+([^[\]{}]+?)\s+\]/g, (_, list: string) => `[${oneLine(list)}]`)
    .replace(/\{\n {4,}([^{}]+?)\s+\}/g, (_, fields: string) => `{ ${oneLine(fields)} }`);
  return `${text}\n`;
}

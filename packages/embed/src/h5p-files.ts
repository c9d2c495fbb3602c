// The files of a lesson in H5P. Some hosts rename each file when a package is uploaded, and write its new path into the content.
import { fillManifest } from '../../lesson-writers/src/manifest-files.ts';

/**
 * The addresses of files by the names that the lesson has for them. A manifest, which names others, is written again with their addresses.
 * @param listed - of content.json, perhaps by a stranger: `{ name, file: { path } }` for each file
 * @param locate - the address of a path in the content
 * @throws where a manifest can't be fetched
 */
export async function locateFiles(
  listed: unknown,
  locate: (path: string) => string,
): Promise<ReadonlyMap<string, string>> {
  const addresses = new Map<string, string>();
  for (const { name, file } of (Array.isArray(listed) ? listed : []) as Record<
    string,
    { path?: unknown } | undefined
  >[]) {
    const path = file?.path;
    if (typeof name === 'string' && typeof path === 'string' && isInside(path)) addresses.set(name, locate(path));
  }
  const filled = await Promise.all(
    [...addresses]
      .filter(([name]) => /\.(?:json|gltf)$/i.test(name))
      .map(async ([name, address]) => {
        const response = await fetch(address);
        if (!response.ok) throw new Error(`the server answered with HTTP status ${response.status} for ${name}`);
        const bytes = fillManifest(
          { path: name, bytes: new Uint8Array(await response.arrayBuffer()) },
          (path) => addresses.get(path) ?? '',
        );
        return [name, bytes] as const;
      }),
  );
  for (const [name, bytes] of filled)
    if (bytes) addresses.set(name, URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>])));
  return addresses;
}

/** Whether a path stays in the content: H5P takes whole addresses too. */
const isInside = (path: string): boolean => !/^(?:[a-z][a-z\d+.-]*:|\/|\\)|(?:^|\/)\.\.(?:\/|$)/i.test(path);

// A manifest (JSON) of the element names further files. They belong to the lesson, and may not be elsewhere.
import { cleanPath, readAddress } from './lesson-paths.ts';
import type { LessonFile } from './lesson.ts';

/** The largest manifest that is read, bytes: one that holds its image may be larger than others. */
const maxManifest = 2 ** 28;

/**
 * The paths of the files that a manifest names, from the folder of the lesson. Empty for all other files.
 * @returns null in a list stands for an address elsewhere
 */
export function listManifestFiles({ path, bytes }: LessonFile): (string | null)[] {
  if (!/\.(?:json|gltf)$/i.test(path) || bytes.length > maxManifest) return [];
  let found;
  try {
    found = JSON.parse(new TextDecoder().decode(bytes)) as unknown;
  } catch {
    return []; // The page says that it can't be read.
  }
  const folder = (cleanPath(path) ?? '').split('/').slice(0, -1).join('/');
  return listNames(found, 0)
    .filter((name) => !/^data:/i.test(name.trim()))
    .map((name) => {
      const file = readAddress(name.trim());
      return file && (folder ? `${folder}/${file.path}` : file.path);
    });
}

/** Values of the fields that name files, at any depth. */
function listNames(value: unknown, depth: number): string[] {
  if (typeof value !== 'object' || value === null || depth > 8) return [];
  if (Array.isArray(value)) return value.flatMap((one) => listNames(one, depth + 1));
  return Object.entries(value).flatMap(([field, inner]) => {
    if (field === 'image' || field === 'uri') return typeof inner === 'string' ? [inner] : [];
    if (field === 'files' && Array.isArray(inner)) return inner.filter((one): one is string => typeof one === 'string');
    return listNames(inner, depth + 1);
  });
}

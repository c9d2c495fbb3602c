// A manifest (JSON) of the element names further files. They belong to the lesson, and may not be elsewhere.
import { cleanPath, readAddress } from './lesson-paths.ts';
import type { LessonFile } from './lesson.ts';

/** The largest manifest that is read, bytes: one that holds its image may be larger than others. */
const maxManifest = 2 ** 28;

/**
 * The paths of the files that a manifest names, from the folder of the lesson. Empty for all other files.
 * @returns null in a list stands for an address elsewhere
 */
export function listManifestFiles(file: LessonFile): (string | null)[] {
  const names: (string | null)[] = [];
  mapNames(readManifest(file), 0, (name) => {
    if (!isInside(name)) names.push(resolve(file, name));
    return name;
  });
  return names;
}

/**
 * A manifest with other addresses in the place of the paths that it names.
 * @param addressOf - of a path from the folder of the lesson
 * @returns its bytes; null for a file that names none
 */
export function fillManifest(file: LessonFile, addressOf: (path: string) => string): Uint8Array | null {
  if (!listManifestFiles(file).some((path) => path !== null)) return null;
  const filled = mapNames(readManifest(file), 0, (name) => {
    const path = isInside(name) ? null : resolve(file, name);
    return path === null ? name : addressOf(path);
  });
  return new TextEncoder().encode(JSON.stringify(filled));
}

function readManifest({ path, bytes }: LessonFile): unknown {
  if (!/\.(?:json|gltf)$/i.test(path) || bytes.length > maxManifest) return null;
  try {
    return JSON.parse(new TextDecoder().decode(bytes)) as unknown;
  } catch {
    return null; // The page says that it can't be read.
  }
}

/** Whether a name is an address that has its bytes inside. */
const isInside = (name: string): boolean => /^data:/i.test(name.trim());

function resolve({ path }: LessonFile, name: string): string | null {
  const folder = (cleanPath(path) ?? '').split('/').slice(0, -1).join('/');
  const file = readAddress(name.trim());
  return file && (folder ? `${folder}/${file.path}` : file.path);
}

/** A value of JSON with other values in the fields that name files, at any depth. */
function mapNames(value: unknown, depth: number, change: (name: string) => string): unknown {
  if (typeof value !== 'object' || value === null || depth > 8) return value;
  if (Array.isArray(value)) return value.map((one) => mapNames(one, depth + 1, change));
  return Object.fromEntries(
    Object.entries(value).map(([field, inner]: [string, unknown]) => {
      if (field === 'image' || field === 'uri') return [field, typeof inner === 'string' ? change(inner) : inner];
      if (field === 'files' && Array.isArray(inner))
        return [field, inner.map((one: unknown) => (typeof one === 'string' ? change(one) : one))];
      return [field, mapNames(inner, depth + 1, change)];
    }),
  );
}

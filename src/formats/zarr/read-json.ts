import type { Budget } from '../base/budget.ts';
import { corruptFile } from '../base/file-problem.ts';
import { parseJson } from '../base/parse-json.ts';
import type { FileTree } from './file-tree.ts';

/** An object of a JSON file from a stranger. */
export type Json = Readonly<Record<string, unknown>>;

/** Bytes of a metadata file: those of many thousand arrays. */
const maxJsonBytes = 2 ** 24;

/** Bytes of memory for each byte of JSON. */
const memoryPerByte = 8;

/** Reads a metadata file; null where there is none. @throws {VolumeViewError} `format/corrupt`, `format/too-large`, `source/…` */
export async function readJson(
  tree: Pick<FileTree, 'read'>,
  path: string,
  { budget, signal }: { readonly budget: Budget; readonly signal?: AbortSignal },
): Promise<Json | null> {
  const bytes = await tree.read(path, { maxBytes: maxJsonBytes, signal });
  if (!bytes) return null;
  const what = `the metadata of the Zarr (${nameOfFile(path)})`;
  budget.addFile(bytes.length);
  budget.take(memoryPerByte * bytes.length, what);
  budget.giveBack(memoryPerByte * bytes.length);
  let value: unknown;
  try {
    value = parseJson(new TextDecoder().decode(bytes));
  } catch {
    throw corruptFile(what, 'are no JSON');
  }
  if (!isObject(value)) throw corruptFile(what, 'are no JSON object');
  return value;
}

/** Only the part of a path that the format itself gives. */
const nameOfFile = (path: string): string => path.slice(path.lastIndexOf('/') + 1);

export function isObject(value: unknown): value is Json {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

export const objectOf = (value: unknown): Json => (isObject(value) ? value : {});

export const listOf = (value: unknown): readonly unknown[] => (Array.isArray(value) ? value : []);

/** Its numbers; null where it is no list of numbers. */
export function numbersOf(value: unknown): readonly number[] | null {
  return Array.isArray(value) && value.every((n) => typeof n === 'number' && Number.isFinite(n)) ? value : null;
}

/** A word of a file for messages: short, and of usual characters only. */
export function shownWord(value: unknown): string {
  return typeof value === 'string' && /^[\w.|<>-]{1,40}$/.test(value) ? `"${value}"` : 'something else';
}

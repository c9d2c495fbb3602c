import type { DecodeInput } from '../formats/base/decoded-volume.ts';
import type { LocalFiles } from '../formats/base/load-request.ts';
import type { ByteRange } from './byte-store.ts';
import type { FetchOptions } from './download.ts';
import { HttpStore } from './http-store.ts';
import { LocalStore } from './local-store.ts';

/** Fetches a part of a file. @param local - the chosen files, where it is one of them */
export async function fetchRange(
  url: string,
  options: FetchOptions & { readonly range: ByteRange },
  local?: LocalFiles,
): Promise<DecodeInput> {
  const store = local && url.startsWith(local.base) ? new LocalStore(local.files, local.base) : new HttpStore(options);
  return store.read(url, { ...options, maxBytes: undefined });
}

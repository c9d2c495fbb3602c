import type { AttributeValue, DataArray, DataGroup } from '../data-tree.ts';
import { readAttributes } from './attributes.ts';
import { Hdf5Dataset } from './dataset.ts';
import type { Hdf5Bytes } from './hdf5-bytes.ts';
import { readLinks } from './links.ts';
import { findMessage, messageTypes, readMessages } from './object-header.ts';
import type { Message } from './object-header.ts';
import { openBytes } from './superblock.ts';

// A reader of its own, because the bytes come from strangers: libraries that were tried follow a damaged file's circles
// for ever, allocate what it asks for, or are a megabyte of WebAssembly. It reads what radar files and NetCDF-4 use:
// superblocks 0 to 3, both forms of groups and attributes, compact, whole and chunked arrays (B-trees of version 1, single
// chunks, fixed arrays), deflate, shuffle and checksums. All else is `format/unsupported`, in words.

/**
 * Open an HDF5 file, such as ODIM_H5 or NetCDF-4.
 * @returns its root; the rest is read on demand, and may then turn out to be damaged
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt`, `format/unsupported`
 * Source: HDF5 File Format Specification 3.0
 */
export function openHdf5(bytes: Uint8Array<ArrayBuffer>): DataGroup {
  const { file, root } = openBytes(bytes);
  return new Hdf5Group(file, '', readMessages(file, root));
}

class Hdf5Group implements DataGroup {
  readonly #file: Hdf5Bytes;
  readonly #path: string;
  readonly #messages: readonly Message[];
  readonly #links: ReadonlyMap<string, number>;
  readonly #children = new Map<string, Hdf5Group | Hdf5Dataset>();
  #attributes: Map<string, AttributeValue> | null = null;

  constructor(file: Hdf5Bytes, path: string, messages: readonly Message[]) {
    this.#file = file;
    this.#path = path;
    this.#messages = messages;
    this.#links = readLinks(file, messages);
  }

  get path(): string {
    return this.#path || '/';
  }

  get attributes(): ReadonlyMap<string, AttributeValue> {
    this.#attributes ??= readAttributes(this.#file, this.#messages);
    return this.#attributes;
  }

  get names(): readonly string[] {
    return [...this.#links.keys()];
  }

  group(name: string): DataGroup | null {
    const child = this.#open(name);
    return child instanceof Hdf5Group ? child : null;
  }

  /** NetCDF-4 hides a variable under another name where a dimension that it does not run along has its name. */
  array(name: string): DataArray | null {
    const child = this.#open(name);
    if (child instanceof Hdf5Dataset) return child;
    const hidden = this.#open(`_nc4_non_coord_${name}`);
    return hidden instanceof Hdf5Dataset ? hidden : null;
  }

  #open(name: string): Hdf5Group | Hdf5Dataset | null {
    const known = this.#children.get(name);
    if (known) return known;
    const address = this.#links.get(name);
    if (address === undefined) return null;
    const messages = readMessages(this.#file, address);
    const path = `${this.#path}/${name}`;
    const isArray = findMessage(messages, messageTypes.layout) !== undefined;
    const child = isArray ? new Hdf5Dataset(this.#file, path, messages) : new Hdf5Group(this.#file, path, messages);
    this.#children.set(name, child);
    return child;
  }
}

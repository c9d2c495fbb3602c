import type { Budget } from '../base/budget.ts';
import type { AttributeValue, DataArray, DataGroup } from '../base/data-tree.ts';
import { readAttributes } from './attributes.ts';
import { Hdf5Dataset } from './dataset.ts';
import { corruptHdf5, unsupportedHdf5 } from './hdf5-bytes.ts';
import type { Hdf5Bytes } from './hdf5-bytes.ts';
import { readLinks } from './links.ts';
import type { Link } from './links.ts';
import { findMessage, messageTypes, readMessages } from './object-header.ts';
import type { Message } from './object-header.ts';
import { openBytes } from './superblock.ts';

// Our own reader, because the bytes come from strangers. The libraries that we tried follow a damaged file's loops
// forever, allocate whatever it asks for, or are a megabyte of WebAssembly. It reads what radar files and NetCDF-4 use:
// superblocks 0 to 3, both forms of groups and attributes, soft links, compact, contiguous and chunked arrays (B-trees
// of version 1, single chunks, fixed arrays), deflate, shuffle, scale-offset and checksums. Everything else is `format/unsupported`,
// with a message.

/** Maximum number of soft links in a row, as in HDF5's own library. */
const maxSoftLinks = 16;

/** NetCDF-4 writes this before the name of a variable where a dimension that it does not use as its own has its name. Source: netcdf-c 4.9, nc4internal.h */
const hiddenStart = '_nc4_non_coord_';

/** Steps for each name in the path of a soft link. */
const stepsPerName = 16;

/**
 * Opens an HDF5 file, such as ODIM_H5 or NetCDF-4.
 * @param budget - of the load; if undefined, one for this file alone
 * @returns its root. The rest is read on demand, and may then turn out to be damaged
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt`, `format/unsupported`, `format/too-large`
 * Source: HDF5 File Format Specification 3.0
 */
export function openHdf5(bytes: Uint8Array<ArrayBuffer>, budget?: Budget): DataGroup {
  const { file, root } = openBytes(bytes, budget);
  return openObject({ file, root, objects: new Map() }, root, '') as Hdf5Group;
}

/** A file, and the objects that were opened in it. */
interface Hdf5File {
  readonly file: Hdf5Bytes;
  /** Address of the root group's header. */
  readonly root: number;
  /** By the address of its header: many names may lead to one object. */
  readonly objects: Map<number, Hdf5Object>;
}

type Hdf5Object = Hdf5Group | Hdf5Dataset;

/** @param path - the object's path if it was not opened before */
function openObject(open: Hdf5File, address: number, path: string): Hdf5Object {
  const known = open.objects.get(address);
  if (known) return known;
  const messages = readMessages(open.file, address);
  const isArray = address !== open.root && findMessage(messages, messageTypes.layout) !== undefined;
  const object = isArray ? new Hdf5Dataset(open.file, path, messages) : new Hdf5Group(open, path, messages);
  open.objects.set(address, object);
  return object;
}

class Hdf5Group implements DataGroup {
  readonly #open: Hdf5File;
  readonly #path: string;
  readonly #messages: readonly Message[];
  readonly #links: ReadonlyMap<string, Link>;
  readonly names: readonly string[];
  #attributes: Map<string, AttributeValue> | null = null;

  constructor(open: Hdf5File, path: string, messages: readonly Message[]) {
    this.#open = open;
    this.#path = path;
    this.#messages = messages;
    this.#links = readLinks(open.file, messages);
    this.names = [
      ...new Set(
        [...this.#links.keys()].map((name) => (name.startsWith(hiddenStart) ? name.slice(hiddenStart.length) : name)),
      ),
    ];
  }

  get path(): string {
    return this.#path || '/';
  }

  get attributes(): ReadonlyMap<string, AttributeValue> {
    this.#attributes ??= readAttributes(this.#open.file, this.#messages);
    return this.#attributes;
  }

  group(name: string): DataGroup | null {
    const child = this.#find(name);
    return child instanceof Hdf5Group ? child : null;
  }

  array(name: string): DataArray | null {
    // What has the variable's own name is then the dimension alone, without numbers.
    const hidden = this.#find(`${hiddenStart}${name}`);
    const child = hidden instanceof Hdf5Dataset ? hidden : this.#find(name);
    return child instanceof Hdf5Dataset ? child : null;
  }

  /** @param softLinks - number of soft links followed so far */
  #find(name: string, softLinks = 0): Hdf5Object | null {
    const link = this.#links.get(name);
    if (link === undefined) return null;
    switch (link.kind) {
      case 'hard':
        return openObject(this.#open, link.address, `${this.#path}/${name}`);
      case 'soft':
        return this.#follow(link.path, softLinks + 1);
      case 'elsewhere':
        throw unsupportedHdf5(`a link to another file at ${this.#path}/${name.slice(0, 80)}`, 'one-file');
    }
  }

  /** The object at a path, from the root or from this group; null if there is none: links may dangle. */
  #follow(path: string, softLinks: number): Hdf5Object | null {
    if (softLinks > maxSoftLinks) throw corruptHdf5(`has more than ${maxSoftLinks} soft links one after another`);
    const names = path.split('/').filter((name) => name !== '' && name !== '.');
    let object: Hdf5Object | null = path.startsWith('/') ? openObject(this.#open, this.#open.root, '') : this;
    for (const name of names) {
      this.#open.file.budget.step(stepsPerName, 'a soft link');
      object = object instanceof Hdf5Group ? object.#find(name, softLinks) : null;
    }
    return object;
  }
}

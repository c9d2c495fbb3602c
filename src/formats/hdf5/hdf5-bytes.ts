import { VolumeViewError } from '../../core/errors.ts';
import { Budget } from '../base/budget.ts';
import { adviceOf } from './advice.ts';
import type { Remedy } from './advice.ts';

/** The address that means that nothing is stored. */
export const noAddress = -1;

/**
 * The bytes of an HDF5 file, with what its superblock says about addresses. Every read is checked against the file's
 * end, and counted: a damaged file can hold loops, which then end in an error. Code that makes something of the bytes
 * takes the memory from the load's budget: a small file may refer to the same bytes a thousand times.
 */
export class Hdf5Bytes {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly view: DataView;
  readonly budget: Budget;
  /** Bytes of an address and of a length. */
  addressBytes = 8;
  lengthBytes = 8;
  /** Position of address 0 in the file: after the user block. */
  base = 0;
  /** Objects of the heaps that were read, by address and index: many attributes share one heap. */
  readonly heaps = new Map<number, ReadonlyMap<number, Uint8Array>>();
  /**
   * Remaining reads of the file's own structure: a valid file takes a hundredth of them. They are counted here because
   * asking the budget for each field would be slow.
   */
  #steps: number;

  constructor(bytes: Uint8Array<ArrayBuffer>, budget = Budget.ofFile(bytes.length)) {
    this.bytes = bytes;
    this.budget = budget;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.#steps = 4_000_000 + 4 * bytes.length;
  }

  /** Checks that bytes [at, at + length) are in the file. */
  check(at: number, length: number): void {
    const isThere = at >= 0 && length >= 0 && at + length <= this.bytes.length;
    if (!isThere) throw corruptHdf5(`refers to bytes ${at} to ${at + length}, and has ${this.bytes.length}`);
    this.#steps -= 1 + length / 256;
    if (this.#steps < 0) throw corruptHdf5('refers to its own parts in circles');
  }

  slice(at: number, length: number): Uint8Array<ArrayBuffer> {
    this.check(at, length);
    return this.bytes.subarray(at, at + length);
  }

  /** A cursor at an address of the file. */
  at(address: number): Cursor {
    if (address === noAddress) throw corruptHdf5('refers to a part that it does not hold');
    return new Cursor(this, this.base + address);
  }
}

/** Reads little-endian fields one after another, as HDF5's own tables list them. */
export class Cursor {
  readonly file: Hdf5Bytes;
  /** Position in the file, bytes. */
  position: number;

  constructor(file: Hdf5Bytes, position: number) {
    this.file = file;
    this.position = position;
  }

  /** A whole number of 1 to 8 bytes. A number beyond 2^53 is not a valid size or address. */
  unsigned(bytes: number): number {
    const at = this.#take(bytes);
    let value = 0;
    for (let i = bytes - 1; i >= 0; i--) value = value * 256 + this.file.bytes[at + i];
    return value;
  }

  u8(): number {
    return this.file.bytes[this.#take(1)];
  }

  u16(): number {
    return this.file.view.getUint16(this.#take(2), true);
  }

  u32(): number {
    return this.file.view.getUint32(this.#take(4), true);
  }

  length(): number {
    return this.unsigned(this.file.lengthBytes);
  }

  /** An address; `noAddress` if all bits are set. */
  address(): number {
    const { bytes, addressBytes } = this.file;
    const at = this.position;
    const value = this.unsigned(addressBytes);
    return bytes.subarray(at, at + addressBytes).every((byte) => byte === 0xff) ? noAddress : value;
  }

  skip(bytes: number): void {
    this.#take(bytes);
  }

  slice(bytes: number): Uint8Array<ArrayBuffer> {
    return this.file.slice(this.#take(bytes), bytes);
  }

  /** Checks the four characters at the start of a structure. */
  expect(signature: string): void {
    const got = String.fromCharCode(...this.slice(signature.length));
    if (got !== signature)
      throw corruptHdf5(`has no ${signature} where one belongs (byte ${this.position - signature.length})`);
  }

  /** Checks a version. */
  expectVersion(what: string, ...known: number[]): number {
    const version = this.u8();
    if (!known.includes(version)) throw unsupportedHdf5(`${what} of version ${version}; expected ${known.join(', ')}`);
    return version;
  }

  #take(bytes: number): number {
    const at = this.position;
    this.file.check(at, bytes);
    this.position += bytes;
    return at;
  }
}

/** How many bytes can hold numbers up to a limit. */
export function bytesToHold(limit: number): number {
  return limit < 1 ? 1 : Math.floor(Math.floor(Math.log2(limit)) / 8) + 1;
}

export function corruptHdf5(what: string): VolumeViewError {
  return new VolumeViewError('format/corrupt', `the HDF5 file ${what}; it is damaged or was cut short: fetch it again`);
}

/** @param remedy - what makes a readable file of it */
export function unsupportedHdf5(what: string, remedy: Remedy = 'repack'): VolumeViewError {
  return new VolumeViewError('format/unsupported', `the HDF5 file has ${what}; ${adviceOf(remedy)}`);
}

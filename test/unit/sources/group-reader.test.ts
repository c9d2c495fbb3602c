import { expect } from '@esm-bundle/chai';
import type { DecodeInput } from '../../../src/formats/base/decoded-volume.ts';
import type { ByteStore } from '../../../src/sources/byte-store.ts';
import { GroupReader } from '../../../src/sources/group-reader.ts';

const inputOf = (url: string): DecodeInput => ({ url, bytes: new TextEncoder().encode(url), contentType: '' });

/** A store whose reads are noted. @param isRefused - of several at once */
function noting(isRefused = false): {
  store: ByteStore;
  readOne: (url: string) => Promise<DecodeInput>;
  reads: string[];
} {
  const reads: string[] = [];
  const readOne = async (url: string): Promise<DecodeInput> => {
    reads.push(url);
    return inputOf(url);
  };
  const store: ByteStore = {
    list: async () => null,
    stat: async () => ({ size: null }),
    read: readOne,
    readTogether: async (urls) => {
      reads.push(urls.join('+'));
      return isRefused ? null : urls.map(inputOf);
    },
  };
  return { store, readOne, reads };
}

const names = (count: number): string[] => Array.from({ length: count }, (_, i) => `f${i}`);

describe('a reader of groups of files', () => {
  it('reads what comes next in one piece, up to 32 files', async () => {
    const { store, readOne, reads } = noting();
    const reader = new GroupReader(store, { readOne });
    expect(reader.plan(names(70), () => 10)).to.equal(64);
    for (const url of names(70)) expect((await reader.read(url)).url).to.equal(url);
    expect(reads.map((one) => one.split('+').length)).to.deep.equal([32, 32, 6]);
  });

  it('up to 8 MiB, and larger files by themselves', async () => {
    const { store, readOne, reads } = noting();
    const reader = new GroupReader(store, { readOne });
    expect(reader.plan(names(7), (url) => (url === 'f3' ? 2 ** 24 : 3 * 2 ** 20))).to.equal(6);
    for (const url of names(7)) await reader.read(url);
    expect(reads).to.deep.equal(['f0+f1', 'f2', 'f3', 'f4+f5', 'f6']);
  });

  it('one by one where several can not be read, where none are planned, and again', async () => {
    const { store, readOne, reads } = noting(true);
    const reader = new GroupReader(store, { readOne });
    reader.plan(['a', 'b'], () => 10);
    for (const url of ['a', 'b', 'c', 'a']) expect((await reader.read(url)).url).to.equal(url);
    expect(reads).to.deep.equal(['a+b', 'a', 'b', 'c', 'a']);
  });

  it('one by one in a store without such reads', async () => {
    const { store, readOne, reads } = noting();
    const reader = new GroupReader({ ...store, readTogether: undefined }, { readOne });
    expect(reader.plan(['a', 'b'], () => 10)).to.equal(6);
    for (const url of ['a', 'b']) await reader.read(url);
    expect(reads).to.deep.equal(['a', 'b']);
  });
});

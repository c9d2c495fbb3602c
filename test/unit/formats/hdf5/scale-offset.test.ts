// Chunks that h5py 3.16.0 (HDF5 2.0) packed with scaleoffset=…, and the numbers that it reads of them.
import { expect } from '@esm-bundle/chai';
import { unzlibSync } from 'fflate';
import { Budget } from '../../../../src/formats/base/budget.ts';
import { readAll } from '../../../../src/formats/base/data-tree.ts';
import { undoFilters } from '../../../../src/formats/hdf5/filters.ts';
import { openHdf5 } from '../../../../src/formats/hdf5/hdf5.ts';
import { errorOf } from '../../../helpers/error-of.ts';

const bytesOf = (text: string): Uint8Array<ArrayBuffer> => Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));

interface Case {
  /** Without the words of the fill value: all 0, or those that are given. */
  readonly parameters: readonly number[];
  readonly fill?: number;
  readonly chunk: string;
  readonly isPacked?: true;
  readonly values: readonly number[];
  read(view: DataView, at: number): number;
}

const cases: Readonly<Record<string, Case>> = {
  'numbers of 16 bits with a sign': {
    parameters: [2, 0, 4, 0, 2, 1, 0, 1],
    chunk: 'CgAAAAjT/v///////wAAAAAAAAAAAECwAyEA',
    values: [-300, -290, -301, 500],
    read: (view, at) => view.getInt16(at, true),
  },
  'big-endian numbers, one of which is that of no data': {
    parameters: [2, 0, 5, 0, 2, 0, 1, 1],
    fill: 65_535,
    chunk: 'AwAAAAgHAAAAAAAAAAAAAAAAAAAAC9I=',
    values: [7, 9, 65_535, 12, 8],
    read: (view, at) => view.getUint16(at),
  },
  'numbers of 64 bits': {
    parameters: [2, 0, 3, 0, 8, 1, 0, 1],
    chunk: 'AwAAAAgAAAAAAAEAAAAAAAAAAAAAFYA=',
    values: [2 ** 40, 2 ** 40 + 5, 2 ** 40 + 3],
    read: (view, at) => Number(view.getBigInt64(at, true)),
  },
  'numbers that are all the same': {
    parameters: [2, 0, 4, 0, 1, 0, 0, 1],
    chunk: 'AQAAAAgFAAAAAAAAAAAAAAAAAAAAAA==',
    values: [5, 5, 5, 5],
    read: (view, at) => view.getUint8(at),
  },
  'floats with two digits': {
    parameters: [0, 2, 4, 1, 4, 0, 0, 1],
    chunk: 'DgAAAAgtsrXAAAAAAAAAAAAAAAAACswACl6//wA=',
    values: [1.2319998741149902, -5.677999973297119, 100.50199890136719, 0],
    read: (view, at) => view.getFloat32(at, true),
  },
  'big-endian doubles with three digits, packed by gzip too': {
    parameters: [0, 3, 4, 1, 8, 0, 1, 1],
    chunk: 'eF4TZGBg4Gg+cGqh6zaxAwxQwNvQwGB8I/7/BwB1FQj/',
    isPacked: true,
    values: [1.2350000000000003, -5.678, 100.5, 0],
    read: (view, at) => view.getFloat64(at),
  },
  'numbers of which all bits are kept': {
    parameters: [2, 32, 3, 0, 4, 1, 0, 1],
    chunk: 'AQAAAP7///8DAAAA',
    values: [1, -2, 3],
    read: (view, at) => view.getInt32(at, true),
  },
  'numbers that need all bits': {
    parameters: [2, 0, 3, 0, 4, 0, 0, 1],
    chunk: 'IAAAAAhNAAAAAAAAAAAAAAAAAAAAAAAAAP////9NAAAA',
    values: [0, 4_294_967_295, 77],
    read: (view, at) => view.getUint32(at, true),
  },
};

function unpack({ parameters, fill = 0, isPacked }: Case, chunk: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const filters = [
    { id: 6, name: '', parameters: [...parameters, fill, ...Array.from({ length: 11 }, () => 0)] },
    ...(isPacked ? [{ id: 1, name: '', parameters: [4] }] : []),
  ];
  return undoFilters(chunk, filters, {
    skipped: 0,
    expected: parameters[2] * parameters[4],
    budget: Budget.ofFile(chunk.length),
  });
}

describe('the filter scale-offset of HDF5', () => {
  for (const [name, one] of Object.entries(cases)) {
    it(`is undone: ${name}`, () => {
      const out = unpack(one, bytesOf(one.chunk));
      const view = new DataView(out.buffer, out.byteOffset, out.length);
      const size = one.parameters[4];
      expect(Array.from({ length: out.length / size }, (_, i) => one.read(view, i * size))).to.deep.equal(one.values);
    });

    it(`in a damaged chunk ends in a message: ${name}`, () => {
      const chunk = bytesOf(one.chunk);
      // HDF5 leaves a byte after the last one.
      for (let length = 0; length < chunk.length - 1; length++)
        expect(errorOf(() => unpack(one, chunk.slice(0, length))).code, String(length)).to.equal('format/corrupt');
      const other = chunk.slice();
      other[1] ^= 0xff; // Bits for each number: more than it has.
      if (one.parameters[1] !== 32) expect(errorOf(() => unpack(one, other)).code).to.equal('format/corrupt');
    });
  }

  it('with other parameters than the array has is refused', () => {
    const one = cases['numbers of 16 bits with a sign'];
    const change = (at: number, value: number): Case => ({
      ...one,
      parameters: one.parameters.map((old, i) => (i === at ? value : old)),
    });
    for (const size of [0, 3, 16])
      expect(errorOf(() => unpack(change(4, size), bytesOf(one.chunk))).code).to.equal('format/corrupt');
    const scaled = errorOf(() => unpack({ ...change(0, 1), parameters: [1, 2, 4, 1, 4, 0, 0, 1] }, bytesOf(one.chunk)));
    expect([scaled.code, scaled.message.includes('scale-offset')]).to.deep.equal(['format/unsupported', true]);
  });

  it('may make 10,000 equal numbers of 21 bytes', () => {
    // h5py: create_dataset("d", data=np.full((100, 100), 123456, "<u4"), chunks=(100, 100), scaleoffset=0)
    const file = unzlibSync(
      bytesOf(
        'eNrr9HBx4+WS4mLm4GCAgf9Q8IMHwjeAilfbLevx93AJYmKoYBJCVggDXEwMjAwMbEBtjAyMKZth5nkwUA1I/T5gDHYC0AJGFQYGJiZGxhSoHC6amYeBUQBIs4B5CgysQFcyc3NHMDAyMbIBXSrCwARVKaAOoVmQbGQkw5UcsgxAW5iYGVNSWBh/IJsGC2RHKoTFrnUZnxhGwSgYBaNgFIwCcgCoeuNweMQ4GhKjYBSMgpECAJIjLCw=',
      ),
    );
    const numbers = [...readAll(openHdf5(file).array('d')!)];
    expect([numbers.length, new Set(numbers)]).to.deep.equal([10_000, new Set([123_456])]);
  });
});

import { expect } from '@esm-bundle/chai';
import { zlibSync } from 'fflate';
import { Budget, freeBytes } from '../../../../src/formats/base/budget.ts';
import type { DataArray } from '../../../../src/formats/base/data-tree.ts';
import { readAll } from '../../../../src/formats/base/data-tree.ts';
import { openHdf5 } from '../../../../src/formats/hdf5/hdf5.ts';
import { openNetcdf3 } from '../../../../src/formats/netcdf/netcdf3.ts';
import { errorOf } from '../../../helpers/error-of.ts';
import {
  attribute,
  chunked,
  contiguous,
  Hdf5Builder,
  link,
  message,
  nowhere,
  shape,
  types,
  u16,
  u32,
  u64,
} from '../../../helpers/hdf5-builder.ts';
import type { Message } from '../../../helpers/hdf5-builder.ts';
import { buildNetcdf3 } from '../../../helpers/netcdf3-builder.ts';

/** A file of one group. */
function rootOf(
  links: Record<string, number>,
  builder: Hdf5Builder,
  more: readonly Message[] = [],
): Uint8Array<ArrayBuffer> {
  return builder.build(
    builder.object([...Object.entries(links).map(([name, address]) => link(name, address)), ...more]),
  );
}

function arrayOf(bytes: Uint8Array<ArrayBuffer>, name = 'data', budget?: Budget): DataArray {
  return openHdf5(bytes, budget).array(name)!;
}

const filters = (ids: readonly number[]): Message =>
  message(0x0b, [2, ids.length, ...ids.flatMap((id) => [...u16(id), ...u16(0), ...u16(0)])]);

/** A B-tree of one chunk, at the array's begin. */
const oneChunk = (axes: number, address: number, bytes: number): number[] => [
  ...new TextEncoder().encode('TREE'),
  1,
  0,
  ...u16(1),
  ...u64(nowhere),
  ...u64(nowhere),
  ...u32(bytes),
  ...u32(0),
  ...Array.from({ length: axes + 1 }, () => u64(0)).flat(),
  ...u64(address),
  ...u32(0),
  ...u32(0),
  ...Array.from({ length: axes + 1 }, () => u64(0)).flat(),
];

/** An old group: its names lie in one row of bytes, where they may overlap. */
function oldGroup(builder: Hdf5Builder, names: string, offsets: readonly number[], header: number): Message {
  const bytes = new TextEncoder().encode(names);
  const row = builder.place(bytes);
  const heap = builder.place([
    ...new TextEncoder().encode('HEAP'),
    0,
    0,
    0,
    0,
    ...u64(bytes.length),
    ...u64(0),
    ...u64(row),
  ]);
  const entries = offsets.flatMap((offset) => [...u64(offset), ...u64(header), ...Array.from({ length: 24 }, () => 0)]);
  const node = builder.place([...new TextEncoder().encode('SNOD'), 1, 0, ...u16(offsets.length), ...entries]);
  const tree = builder.place([
    ...new TextEncoder().encode('TREE'),
    0,
    0,
    ...u16(1),
    ...u64(nowhere),
    ...u64(nowhere),
    ...u64(0),
    ...u64(node),
    ...u64(0),
  ]);
  return message(0x11, [...u64(tree), ...u64(heap)]);
}

describe('HDF5 files that ask for more than they hold', () => {
  it('an attribute ends with its message', () => {
    const builder = new Hdf5Builder();
    builder.place(new Uint8Array(5000));
    const bytes = rootOf({}, builder, [attribute('long', { type: types.uint8, shape: shape(4000), data: [1, 2, 3] })]);
    const whole = Uint8Array.from([...bytes, ...new Uint8Array(5000)]);
    expect(errorOf(() => openHdf5(whole).attributes).code).to.equal('format/corrupt');
  });

  it('a text that is referred to again and again counts each time', () => {
    const builder = new Hdf5Builder();
    const long = new Uint8Array(40_000).fill(65);
    const heap = builder.place([
      ...new TextEncoder().encode('GCOL'),
      1,
      0,
      0,
      0,
      ...u64(16 + 16 + long.length),
      ...u16(1),
      ...u16(1),
      ...u32(0),
      ...u64(long.length),
      ...long,
    ]);
    const places = Array.from({ length: 4000 }, () => [...u32(long.length), ...u64(heap), ...u32(1)]).flat();
    const at = builder.place(places);
    const data = builder.array(types.anyText, [4000], [contiguous(at, places.length)]);
    const array = arrayOf(rootOf({ data }, builder));
    // 160 million characters of 104 kB.
    expect(errorOf(() => array.readTexts()).code).to.equal('format/too-large');
  });

  it('names that overlap count each, and have an end', () => {
    const long = 'n'.repeat(60_000);
    const crowd = new Hdf5Builder();
    const bytes = crowd.build(
      crowd.object([
        oldGroup(
          crowd,
          long,
          Array.from({ length: 3000 }, (_, i) => i),
          48,
        ),
      ]),
    );
    expect(errorOf(() => openHdf5(bytes)).code).to.equal('format/too-large');
    const endless = new Hdf5Builder();
    const one = endless.build(endless.object([oldGroup(endless, long + long, [0], 48)]));
    expect(errorOf(() => openHdf5(one)).message).to.contain('a name of more than 65536 bytes');
  });

  it('texts that were never written are counted before they are made', () => {
    const builder = new Hdf5Builder();
    const data = builder.array(types.text(1), [2 ** 22, 4]);
    const array = arrayOf(rootOf({ data }, builder));
    expect(errorOf(() => array.readTexts()).code).to.equal('format/too-large');
  });

  it('numbers that were never written too', () => {
    const builder = new Hdf5Builder();
    const data = builder.array(types.float64, [2 ** 14, 2 ** 10]);
    const array = arrayOf(rootOf({ data }, builder));
    const error = errorOf(() => readAll(array));
    expect(error.code).to.equal('format/too-large');
    expect(error.message).to.contain('/data asks for 128 MiB');
  });

  it('a chunk is not much larger than its array', () => {
    const builder = new Hdf5Builder();
    const packed = zlibSync(new Uint8Array(2 ** 25), { level: 9 });
    const tree = builder.place(oneChunk(2, builder.place(packed), packed.length));
    const data = builder.array(types.uint8, [1, 100], [chunked(tree, [2 ** 15, 2 ** 10], 1), filters([1])]);
    const array = arrayOf(rootOf({ data }, builder));
    const error = errorOf(() => readAll(array));
    expect(error.code).to.equal('format/too-large');
    expect(error.message).to.contain('in chunks of 33,554,432 bytes for an array of 100');
  });

  it('a chunk that is kept is taken from the budget, once for all names of an array', () => {
    const builder = new Hdf5Builder();
    const packed = zlibSync(new Uint8Array(2 ** 20), { level: 9 });
    const tree = builder.place(oneChunk(1, builder.place(packed), packed.length));
    const data = builder.array(types.uint8, [2 ** 20], [chunked(tree, [2 ** 20], 1), filters([1])]);
    const bytes = rootOf(Object.fromEntries(Array.from({ length: 20 }, (_, i) => [`data${i}`, data])), builder);
    const budget = Budget.ofFile(bytes.length);
    const before = budget.leftBytes;
    for (let i = 0; i < 20; i++) expect(readAll(arrayOf(bytes, `data${i}`, budget)).length).to.equal(2 ** 20);
    // Each time the file is opened anew here; within one opening one array is all of them.
    const root = openHdf5(bytes, budget);
    expect(root.array('data3')).to.equal(root.array('data4'));
    expect(before - budget.leftBytes).to.be.within(20 * 2 ** 20, 21 * 2 ** 20);
  });

  it('no array has more than 32 filters, and each of them counts', () => {
    const many = new Hdf5Builder();
    const stored = zlibSync(new Uint8Array(100));
    const array = (count: number, id: number): DataArray => {
      const tree = many.place(oneChunk(1, many.place(stored), stored.length));
      const data = many.array(
        types.uint8,
        [100],
        [chunked(tree, [100], 1), filters(Array.from({ length: count }, () => id))],
      );
      return arrayOf(rootOf({ data }, many));
    };
    expect(errorOf(() => array(255, 2)).message).to.contain('lists 255 filters');
    expect(readAll(array(1, 1))).to.deep.equal(new Uint8Array(100));
  });

  it('what unpacks to more than is expected takes no memory for it', () => {
    const builder = new Hdf5Builder();
    const packed = zlibSync(new Uint8Array(2 ** 22), { level: 9 });
    const tree = builder.place(oneChunk(1, builder.place(packed), packed.length));
    const data = builder.array(types.uint8, [100], [chunked(tree, [100], 1), filters([1])]);
    const array = arrayOf(rootOf({ data }, builder));
    expect(errorOf(() => readAll(array)).message).to.contain('checksum');
  });

  it('a type within a type ends, and so do headers that continue in themselves', () => {
    const nested = new Hdf5Builder();
    const enumerations = Array.from({ length: 6000 }, () => [0x18, 0, 0, 0, ...u32(1)]).flat();
    const data = nested.array([...enumerations, ...types.uint8], [1]);
    const array = arrayOf(rootOf({ data }, nested));
    expect(errorOf(() => readAll(array)).code).to.equal('format/unsupported');
    const circle = new Hdf5Builder();
    const block = circle.place([...new TextEncoder().encode('OCHK')]);
    const own = circle.place([0x10, ...u16(16), 0, ...u64(block), ...u64(28 + 4), 0, 0, 0, 0]);
    expect(own).to.equal(block + 4);
    const bytes = circle.build(circle.object([message(0x10, [...u64(block), ...u64(28 + 4)])]));
    expect(errorOf(() => openHdf5(bytes)).message).to.contain('leads back into itself');
  });

  it('a budget that is used up by one file has nothing for the next', () => {
    const builder = new Hdf5Builder();
    const data = builder.array(types.uint8, [2 ** 20]);
    const bytes = rootOf({ data }, builder);
    const budget = Budget.ofFile(bytes.length);
    budget.take(freeBytes, 'another file');
    expect(errorOf(() => readAll(arrayOf(bytes, 'data', budget))).code).to.equal('format/too-large');
  });
});

describe('NetCDF-3 files that ask for more than they hold', () => {
  it('rows of nothing are none, however many there are', () => {
    // Along the records twice: 4,000,000,000 rows of no values.
    const bytes = buildNetcdf3(
      [0],
      [{ name: 'azimuth', dimensions: [0, 0], data: new Float64Array(0) }],
      4_000_000_000,
    );
    const array = openNetcdf3(bytes).array('azimuth')!;
    expect(array.shape[0]).to.equal(4_000_000_000);
    expect(readAll(array)).to.have.length(0);
  });

  it('what is read is taken from the budget while it is read, and texts for good', () => {
    const bytes = buildNetcdf3([1000], [{ name: 'x', dimensions: [0], data: new Float64Array(1000) }]);
    const budget = Budget.ofFile(bytes.length);
    const array = openNetcdf3(bytes, budget).array('x')!;
    readAll(array);
    expect(budget.leftBytes).to.equal(budget.allowedBytes);
    budget.take(budget.leftBytes - 7999, 'others');
    expect(errorOf(() => readAll(array)).code).to.equal('format/too-large');
  });
});

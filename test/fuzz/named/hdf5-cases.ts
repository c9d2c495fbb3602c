import { deflateSync } from 'node:zlib';
import { latin1, little } from '../bytes.ts';
import { oneFile } from '../fuzz-case.ts';
import type { FilesCase, FuzzCase } from '../fuzz-case.ts';
import { Hdf5Writer, numberType, shapeOf, textElsewhereType, textType } from '../grammars/hdf5-writer.ts';
import type { Message } from '../grammars/hdf5-writer.ts';
import { Random } from '../random.ts';

/** An address that leads to nothing: all bits set. */
const nowhere = 2 ** 64;

class File extends Hdf5Writer {
  constructor() {
    super(new Random(1, [], true));
  }

  dataset(...messages: Message[]): number {
    return this.header(messages);
  }

  group(links: Readonly<Record<string, number>>, ...more: Message[]): number {
    return this.header([
      ...more,
      ...Object.entries(links).map(([name, address]) => ({
        type: 0x06,
        data: little().u8(1, 0, name.length).text(name).u64(address).finish(),
      })),
    ]);
  }

  /** An attribute with its text in itself. */
  inPlace(name: string, text: string): Message {
    const [title, type, sizes] = [latin1(`${name}\0`), textType(text.length), shapeOf(this.random, [])];
    return {
      type: 0x0c,
      data: little()
        .u8(3, 0)
        .u16(title.length, type.length, sizes.length)
        .u8(0)
        .put(title)
        .put(type)
        .put(sizes)
        .text(text)
        .finish(),
    };
  }

  number(name: string, value: number): Message {
    return this.attribute(name, { type: 'f8', numbers: [value] });
  }

  /** An ODIM_H5 volume whose scans are those. */
  odim(scans: Readonly<Record<string, number>>): FilesCase {
    const what = this.group({}, this.inPlace('object', 'PVOL'));
    return oneFile(
      'scan.h5',
      this.finish(this.group({ what, ...scans }, this.attribute('Conventions', 'ODIM_H5/V2_2'))),
    );
  }

  /** A scan of ODIM_H5. */
  scan(data: number, elevation = 0.5): number {
    const what = this.group({}, this.attribute('quantity', 'DBZH'));
    const where = this.group({}, this.number('elangle', elevation), this.number('rscale', 500));
    return this.group({ where, data1: this.group({ what, data }) });
  }

  /** A CfRadial 2 scan with something beside its one sweep, and what it needs. */
  cfradial2(more: Readonly<Record<string, number>>): FilesCase {
    return oneFile('scan.nc', this.finish(this.group({ sweep_0: this.group({}), ...more })));
  }
}

const shape = (...lengths: number[]): Message => ({ type: 0x01, data: shapeOf(new Random(1, [], true), lengths) });
const type = (name: 'f4' | 'u1' | 'f8'): Message => ({ type: 0x03, data: numberType(name) });
const unwritten: Message = { type: 0x08, data: little().u8(3, 1).u64(nowhere, 0).finish() };
const filters = (ids: readonly number[]): Message => ({
  type: 0x0b,
  data: ids.reduce((out, id) => out.u16(id, 0, 1).u32(4), little().u8(2, ids.length)).finish(),
});
/** One chunk, as the newest layout has it. */
const chunk = (
  lengths: readonly number[],
  elementBytes: number,
  stored: { address: number; bytes: number },
): Message => ({
  type: 0x08,
  data: little()
    .u8(4, 2, 2, lengths.length + 1, 8)
    .u64(...lengths, elementBytes)
    .u8(1)
    .u64(stored.bytes)
    .u32(0)
    .u64(stored.address)
    .finish(),
});

function store(file: File, bytes: Uint8Array): { address: number; bytes: number } {
  return { address: file.put(bytes), bytes: bytes.length };
}

/** Attributes in one header, each of which goes on beyond its message to the end of the file. */
function attributeBeyond(i: number, count: number): Message {
  const name = latin1(`a${i}\0`.padEnd(8, '\0'));
  const [numbers, sizes] = [numberType('u1'), shapeOf(new Random(1, [], true), [count])];
  return {
    type: 0x0c,
    data: little()
      .u8(3, 0)
      .u16(name.length, numbers.length, sizes.length)
      .u8(0)
      .put(name)
      .put(numbers)
      .put(sizes)
      .finish(),
  };
}

export const hdf5Cases: Readonly<Record<string, () => FuzzCase>> = {
  'hdf5: 64 scans that are one, none of it written': () => {
    const file = new File();
    const data = file.dataset(shape(1000, 60_000), type('f4'), unwritten);
    return file.odim(
      Object.fromEntries(Array.from({ length: 64 }, (_, i) => [`dataset${i + 1}`, file.scan(data, i / 2)])),
    );
  },
  'hdf5: a chunk of 128 MB for an array of one value': () => {
    const file = new File();
    const stored = store(file, deflateSync(new Uint8Array(2 ** 27), { level: 9 }));
    return file.odim({
      dataset1: file.scan(file.dataset(shape(1, 1), type('f4'), filters([2, 1]), chunk([4096, 8192], 4, stored))),
    });
  },
  'hdf5: 255 filters, each of which moves 16 MB': () => {
    const file = new File();
    const stored = store(file, deflateSync(new Uint8Array(2 ** 24), { level: 9 }));
    return file.odim({
      dataset1: file.scan(
        file.dataset(
          shape(2048, 2048),
          type('f4'),
          filters([...Array.from({ length: 254 }, () => 2), 1]),
          chunk([2048, 2048], 4, stored),
        ),
      ),
    });
  },
  'hdf5: 33 million texts that were never written': () => {
    const file = new File();
    const names = file.dataset(shape(2 ** 25), { type: 0x03, data: textElsewhereType() }, unwritten);
    return file.cfradial2({ sweep_group_name: names });
  },
  'hdf5: 33 million texts of one character that were never written': () => {
    const file = new File();
    const names = file.dataset(shape(2 ** 26), { type: 0x03, data: textType(2) }, unwritten);
    return file.cfradial2({ sweep_group_name: names });
  },
  'hdf5: 500 attributes that go on to the end of the file': () => {
    const file = new File();
    const what = file.header(Array.from({ length: 500 }, (_, i) => attributeBeyond(i, 60_000)));
    file.put(new Uint8Array(60_000));
    return oneFile('scan.h5', file.finish(file.group({ what })));
  },
  'hdf5: 4,000 references to one text of 60 KB': () => {
    const file = new File();
    const text = little()
      .text('GCOL')
      .u8(1, 0, 0, 0)
      .u64(60_064)
      .u16(1, 1)
      .u32(0)
      .u64(60_000)
      .put(new Uint8Array(60_000).fill(0x61))
      .zeros(32);
    const address = file.put(text.finish());
    const places = Array.from({ length: 4000 }).reduce<ReturnType<typeof little>>(
      (out) => out.u32(60_000).u64(address).u32(1),
      little(),
    );
    const [name, elsewhere, sizes] = [latin1('object\0'), textElsewhereType(), shapeOf(file.random, [4000])];
    const data = little()
      .u8(3, 0)
      .u16(name.length, elsewhere.length, sizes.length)
      .u8(0)
      .put(name)
      .put(elsewhere)
      .put(sizes)
      .put(places.finish());
    return oneFile('scan.h5', file.finish(file.group({ what: file.header([{ type: 0x0c, data: data.finish() }]) })));
  },
  'hdf5: 4,000 names that overlap': () => {
    const file = new File();
    const size = 60_000;
    const texts = file.put(new Uint8Array(size).fill(0x61));
    const heap = file.put(little().text('HEAP').u32(0).u64(size, 1, texts).finish());
    const node = little().text('SNOD').u8(1, 0).u16(4000);
    for (let i = 0; i < 4000; i++) node.u64(i, texts).u32(0, 0).zeros(16);
    const leaf = file.put(node.finish());
    const tree = file.put(little().text('TREE').u8(0, 0).u16(1).u64(nowhere, nowhere, 0, leaf, 8).finish());
    return oneFile('scan.h5', file.finish(file.header([{ type: 0x11, data: little().u64(tree, heap).finish() }])));
  },
  'hdf5: a group that holds itself': () => {
    const build = (root: number): { file: File; address: number } => {
      const file = new File();
      const address = file.group(
        { what: root, dataset1: root, data1: root, data: root },
        ...['object', 'quantity'].map((name) => file.inPlace(name, 'PVOL')),
        file.number('elangle', 1),
      );
      return { file, address };
    };
    const { address } = build(0); // Its own address is known once it is written.
    return oneFile('scan.h5', build(address).file.finish(address));
  },
};

import { little } from '../bytes.ts';
import { damage, oneFile } from '../fuzz-case.ts';
import type { Grammar } from '../fuzz-case.ts';
import { Hdf5Writer } from './hdf5-writer.ts';
import type { Message } from './hdf5-writer.ts';
import type { Random } from '../random.ts';
import { makeCfradial1, makeCfradial2, makeMinc, makeOdim } from './radar-trees.ts';
import type { TreeGroup } from './radar-trees.ts';

/** Radar scans in HDF5: links to other parts, parts that overlap, counts at the ends of types, chunks and filters that lie. */
export const hdf5: Grammar = (random) => {
  const make = random.pick([makeOdim, makeOdim, makeCfradial1, makeCfradial2]);
  const file = new Hdf5Writer(random);
  const root = writeGroup(file, make(random));
  return oneFile(
    random.or('scan.h5', 'scan.nc', 'scan'),
    damage(random, file.finish(root)),
    random.isWild() ? { moment: 'DBZH' } : {},
  );
};

/** MINC 2, which is HDF5 too. */
export const minc: Grammar = (random) => {
  const file = new Hdf5Writer(random);
  const root = writeGroup(file, makeMinc(random));
  return oneFile(random.or('a.mnc', 'a'), damage(random, file.finish(root)));
};

function writeGroup(file: Hdf5Writer, { attributes, groups, arrays }: TreeGroup): number {
  const { random } = file;
  const children = [
    ...Object.entries(groups).map(([name, group]) => [name, writeGroup(file, group)] as const),
    ...Object.entries(arrays).map(([name, array]) => [name, file.header(file.array(array))] as const),
  ];
  const links = random
    .shuffle([...children, ...repeatLink(random, children)])
    .map(([name, address]) => [name, file.address(address)] as const);
  const ways = [writeLinks, writeLinks, writeSymbolTable, writeHeap];
  const own = Object.entries(attributes).map(([name, value]) => file.attribute(name, value));
  return file.header([...own, ...(links.length > 0 ? random.pick(ways)(file, links) : [])]);
}

/** Many names for one part, such as dataset1 to dataset300. */
function repeatLink(random: Random, children: Links): Links {
  const numbered = children.filter(([name]) => /\d$/.test(name));
  if (numbered.length === 0 || !random.isHostile()) return [];
  const [name, address] = random.pick(numbered);
  return Array.from(
    { length: random.pick([10, 64, 300]) },
    (_, i) => [name.replace(/\d+$/, String(i + 10)), address] as const,
  );
}

type Links = readonly (readonly [name: string, address: number])[];

/** A message for each. */
function writeLinks(file: Hdf5Writer, links: Links): Message[] {
  return links.map(([name, address]) => ({ type: 0x06, data: packLink(file, name, address) }));
}

function packLink({ random }: Hdf5Writer, name: string, address: number): Uint8Array {
  const isSoft = random.isWild();
  const out = little()
    .u8(1, isSoft ? 8 : random.or(0, 4, 0x10))
    .u8(...(isSoft ? [random.pick([1, 64])] : []))
    .u8(random.size(name.length) & 0xff)
    .text(name);
  return (isSoft ? out.u16(name.length + 1).text(`/${name}`) : out.u64(address)).finish();
}

/** The old way: a B-tree of nodes of names in a heap of texts. */
function writeSymbolTable(file: Hdf5Writer, links: Links): Message[] {
  const { random } = file;
  const names = little().zeros(8);
  const starts = links.map(([name]) => {
    const at = names.length;
    names.text(`${name}\0`).pad(8);
    return at;
  });
  const texts = file.put(names.finish());
  const heap = file.put(
    little().text('HEAP').u32(0).u64(random.size(names.length)).u64(1).u64(file.address(texts)).finish(),
  );
  const node = little().text('SNOD').u8(1, 0).u16(random.size(links.length));
  links.forEach(([, address], i) => node.u64(random.size(starts[i])).u64(address).u32(0, 0).zeros(16));
  const leaf = file.put(node.finish());
  const leaves = random.isWild() ? Array.from({ length: random.pick([2, 200]) }, () => leaf) : [leaf];
  const tree = little()
    .text('TREE')
    .u8(0, random.or(0, 1))
    .u16(random.size(leaves.length))
    .u64(2 ** 64, 2 ** 64)
    .u64(0);
  for (const one of leaves) tree.u64(file.address(one)).u64(8);
  return [
    {
      type: 0x11,
      data: little()
        .u64(file.address(file.put(tree.finish())))
        .u64(file.address(heap))
        .finish(),
    },
  ];
}

/** The new way for many: a heap of messages, and a B-tree of version 2 that lists them. */
function writeHeap(file: Hdf5Writer, links: Links): Message[] {
  const { random } = file;
  const block = little().text('FHDB').u8(0).u64(0).u32(0);
  const places = links.map(([name, address]) => {
    const data = packLink(file, name, address);
    const at = block.length;
    block.put(data);
    return { at, size: data.length };
  });
  const direct = file.put(block.pad(512).finish());
  const heap = little()
    .text('FRHP')
    .u8(0)
    .u16(random.or(7, 8, 65535))
    .u16(0)
    .u8(0)
    .u32(random.size(400))
    .u64(0)
    .u64(2 ** 64)
    .zeros(8 * 9 + 8);
  heap
    .u16(random.size(4))
    .u64(random.size(512))
    .u64(random.size(1024))
    .u16(random.size(32))
    .u16(0)
    .u64(file.address(direct))
    .u16(random.or(0, 1, 65535))
    .u32(0);
  const heapAddress = file.put(heap.finish());
  const listed = random.isWild()
    ? Array.from({ length: random.pick([2, 300]) }, () => random.pick(places))
    : random.shuffle(places);
  const leaf = little().text('BTLF').u8(0, 5);
  for (const { at, size } of listed)
    leaf
      .u32(0)
      .u8(random.or(0, 0x10, 0x20))
      .u32(random.size(at))
      .u16(random.size(size));
  const root = file.put(leaf.finish());
  const tree = little()
    .text('BTHD')
    .u8(0, 5)
    .u32(random.size(512))
    .u16(random.size(11))
    .u16(random.or(0, 1, 32, 33))
    .u8(100, 40)
    .u64(file.address(root))
    .u16(random.size(listed.length))
    .u64(listed.length)
    .u32(0);
  const treeAddress = file.put(tree.finish());
  return [
    { type: 0x02, data: little().u8(0, 0).u64(file.address(heapAddress)).u64(file.address(treeAddress)).finish() },
  ];
}

// A series of DICOM files on the disk, for benches: as many bytes as a real one, and made in seconds.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const syntaxes = { raw: '1.2.840.10008.1.2.1', rle: '1.2.840.10008.1.2.5' };

/** Value representations whose length has four bytes. */
const long = ['OB', 'OW'];

/**
 * Writes a CT of `slices` files, each `edge` x `edge` signed numbers of 16 bits: a ball with waves in it, and a little
 * noise, without which runs would be longer than those of a scan.
 * @param {string} folder - is made
 * @param {{ slices: number, edge: number, packing: 'raw' | 'rle' }} what
 * @returns {string[]} paths, in the order of the slices
 */
export function writeSeries(folder, { slices, edge, packing }) {
  mkdirSync(folder, { recursive: true });
  const shares = Float64Array.from({ length: edge }, (_, i) => (2 * i + 1) / edge - 1);
  const waves = shares.map((x) => Math.cos(8 * Math.PI * x));
  return Array.from({ length: slices }, (_, k) => {
    const numbers = new Int16Array(edge * edge);
    const z = (2 * k + 1) / slices - 1;
    let seed = k + 1;
    for (let j = 0, at = 0; j < edge; j++) {
      for (let i = 0; i < edge; i++, at++) {
        const inside = 0.6 - shares[i] ** 2 - shares[j] ** 2 - z * z;
        seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
        numbers[at] = inside > 0 ? 1000 * inside * (1.2 + waves[i] * waves[j]) + (seed >>> 28) : -1000;
      }
    }
    const file = join(folder, `${k + 1}.dcm`);
    writeFileSync(file, writeSlice(numbers, { edge, k, packing }));
    return file;
  });
}

/**
 * Source: DICOM PS3.5, chapter 7 and annex A.4, and PS3.10, 7.1
 * @param {Int16Array} numbers
 * @param {{ edge: number, k: number, packing: 'raw' | 'rle' }} of
 */
function writeSlice(numbers, { edge, k, packing }) {
  const syntax = element(0x0002, 0x0010, 'UI', text(syntaxes[packing]));
  const pixels = Buffer.from(numbers.buffer);
  return Buffer.concat([
    Buffer.alloc(128),
    Buffer.from('DICM'),
    element(0x0002, 0x0000, 'UL', words(4, syntax.length)),
    syntax,
    element(0x0008, 0x0008, 'CS', text('ORIGINAL\\PRIMARY\\AXIAL')),
    element(0x0008, 0x0016, 'UI', text('1.2.840.10008.5.1.4.1.1.2')),
    element(0x0008, 0x0060, 'CS', text('CT')),
    element(0x0018, 0x0050, 'DS', text('0.6')),
    element(0x0020, 0x000d, 'UI', text('1.2.826.0.1')),
    element(0x0020, 0x000e, 'UI', text('1.2.826.0.1.1')),
    element(0x0020, 0x0013, 'IS', text(String(k + 1))),
    element(0x0020, 0x0032, 'DS', text(`-150\\-150\\${(0.6 * k).toFixed(1)}`)),
    element(0x0020, 0x0037, 'DS', text('1\\0\\0\\0\\1\\0')),
    element(0x0028, 0x0002, 'US', words(2, 1)),
    element(0x0028, 0x0004, 'CS', text('MONOCHROME2')),
    element(0x0028, 0x0010, 'US', words(2, edge)),
    element(0x0028, 0x0011, 'US', words(2, edge)),
    element(0x0028, 0x0030, 'DS', text('0.6\\0.6')),
    element(0x0028, 0x0100, 'US', words(2, 16)),
    element(0x0028, 0x0101, 'US', words(2, 16)),
    element(0x0028, 0x0102, 'US', words(2, 15)),
    element(0x0028, 0x0103, 'US', words(2, 1)),
    element(0x0028, 0x1052, 'DS', text('0')),
    element(0x0028, 0x1053, 'DS', text('1')),
    ...(packing === 'raw' ? [element(0x7fe0, 0x0010, 'OW', pixels)] : writeFragments(packRuns(pixels))),
  ]);
}

/** @param {number} group @param {number} number @param {string} vr @param {Buffer} value */
function element(group, number, vr, value) {
  const head = Buffer.concat([words(2, group, number), Buffer.from(vr)]);
  const length = long.includes(vr) ? Buffer.concat([words(2, 0), words(4, value.length)]) : words(2, value.length);
  return Buffer.concat([head, length, value]);
}

/** @param {Buffer} frame */
function writeFragments(frame) {
  return [
    words(2, 0x7fe0, 0x0010),
    Buffer.from('OB'),
    words(2, 0),
    words(4, 0xffffffff),
    words(2, 0xfffe, 0xe000),
    words(4, 0),
    words(2, 0xfffe, 0xe000),
    words(4, frame.length),
    frame,
    words(2, 0xfffe, 0xe0dd),
    words(4, 0),
  ];
}

/**
 * The high bytes, then the low ones. Source: PS3.5, annex G
 * @param {Buffer} pixels
 */
function packRuns(pixels) {
  const planes = [1, 0].map((first) => {
    const out = Buffer.alloc(pixels.length + 2);
    let size = 0;
    const half = pixels.length / 2;
    const at = (/** @type {number} */ i) => pixels[2 * i + first];
    for (let i = 0; i < half;) {
      let run = 1;
      while (run < 128 && i + run < half && at(i + run) === at(i)) run++;
      if (run > 2) {
        out[size++] = 257 - run;
        out[size++] = at(i);
        i += run;
        continue;
      }
      const start = i;
      while (i < half && i - start < 128 && !(i + 2 < half && at(i) === at(i + 1) && at(i) === at(i + 2))) i++;
      out[size++] = i - start - 1;
      for (let one = start; one < i; one++) out[size++] = at(one);
    }
    return out.subarray(0, size + (size % 2));
  });
  const head = words(4, 2, 64, 64 + planes[0].length, ...Array.from({ length: 13 }, () => 0));
  return Buffer.concat([head, ...planes]);
}

/** @param {string} value */
function text(value) {
  return Buffer.from(
    value.length % 2 ? `${value}${/^[0-9.]+$/.test(value) && value.includes('.') ? '\0' : ' '}` : value,
  );
}

/** @param {number} bytes @param {readonly number[]} numbers */
function words(bytes, ...numbers) {
  const all = Buffer.alloc(bytes * numbers.length);
  numbers.forEach((number, i) => all.writeUIntLE(number, bytes * i, bytes));
  return all;
}

// Floats of 16 bits. The bytes are those that zarr-python 3.1.6 wrote, and the numbers those of NumPy 2.4.6.
import { expect } from '@esm-bundle/chai';
import { chooseBrickNumbers } from '../../../../src/formats/zarr/brick-numbers.ts';
import { readArray } from '../../../../src/formats/zarr/zarr-array.ts';
import { halfFloatBits, readHalfFloats } from '../../../../src/formats/base/half-floats.ts';
import { finishVolume } from '../../../../src/formats/finish-volume.ts';
import { roomyLimits, valuesOf } from '../../../helpers/decode.ts';
import { pyramidFiles } from '../../../helpers/zarr-bytes.ts';
import type { ZarrFiles } from '../../../helpers/zarr-bytes.ts';
import { readStore } from '../../../helpers/zarr-tree.ts';

/** numpy.array([[[0, 1.5, -2], [65504, 6e-8, 0.1]]], 'f2'), and the bits of each */
const values = [0, 1.5, -2, 65504, 5.960464477539063e-8, 0.0999755859375];
const bits = [0x0000, 0x3e00, 0xc000, 0x7bff, 0x0001, 0x2e66];

function chunkBytes(isLittle: boolean): Uint8Array<ArrayBuffer> {
  const view = new DataView(new ArrayBuffer(12));
  for (const [i, one] of bits.entries()) view.setUint16(2 * i, one, isLittle);
  return new Uint8Array(view.buffer);
}

const json = (value: unknown): Uint8Array<ArrayBuffer> => new TextEncoder().encode(JSON.stringify(value));

/** Two chunks, of which the second one is missing. */
function store(version: 2 | 3, isLittle: boolean, fill: number | string): ZarrFiles {
  const [shape, chunk, endian] = [[2, 2, 3], [1, 2, 3], isLittle ? 'little' : 'big'];
  return version === 2
    ? new Map([
        [
          '.zarray',
          json({
            zarr_format: 2,
            shape,
            chunks: chunk,
            dtype: isLittle ? '<f2' : '>f2',
            fill_value: fill,
            order: 'C',
            filters: null,
            compressor: null,
          }),
        ],
        ['0.0.0', chunkBytes(isLittle)],
      ])
    : new Map([
        [
          'zarr.json',
          json({
            zarr_format: 3,
            node_type: 'array',
            shape,
            data_type: 'float16',
            chunk_grid: { name: 'regular', configuration: { chunk_shape: chunk } },
            chunk_key_encoding: { name: 'default', configuration: { separator: '/' } },
            fill_value: fill,
            codecs: [{ name: 'bytes', configuration: { endian } }],
            attributes: {},
          }),
        ],
        ['c/0/0/0', chunkBytes(isLittle)],
      ]);
}

describe('floats of 16 bits in a Zarr', () => {
  for (const version of [2, 3] as const)
    for (const isLittle of [true, false])
      for (const [fill, found] of [
        [0, 0],
        [1.5, 1.5],
        [-0.0999755859375, -0.0999755859375],
        ['NaN', NaN],
      ] as const)
        it(`are read: Zarr ${version}, ${isLittle ? 'little' : 'big'} endian, ${fill} where no chunk is`, async () => {
          const volume = await finishVolume(await readStore(store(version, isLittle, fill)), roomyLimits);
          const read = valuesOf(volume);
          for (const [i, value] of values.entries()) expect(read[i]).to.be.closeTo(value, Math.abs(value) * 1e-6);
          expect(read.slice(6)).to.deep.equal(Array.from({ length: 6 }, () => found));
        });

  it('take as much room as floats of 32 bits where a level is chosen for a device', async () => {
    const pyramid = pyramidFiles({ shape: [8, 8, 8], levels: 2, type: 'uint16' });
    const half: ZarrFiles = new Map(
      [...pyramid].map(([path, bytes]) => [
        path,
        path.endsWith('.zarray') ? json({ ...JSON.parse(new TextDecoder().decode(bytes)), dtype: '<f2' }) : bytes,
      ]),
    );
    const limits = { ...roomyLimits, maxBytes: 4 * 512 - 1 };
    expect((await readStore(pyramid, {}, { limits })).grid.dimensions).to.deep.equal([8, 8, 8]);
    expect((await readStore(half, {}, { limits })).grid.dimensions).to.deep.equal([4, 4, 4]);
  });

  it('come in bricks as floats', () => {
    const [file] = [...store(2, false, 0).values()];
    const { type, littleEndian } = readArray(JSON.parse(new TextDecoder().decode(file)), '', 'the array');
    const numbers = chooseBrickNumbers(type, littleEndian, { slope: 1, intercept: 0 });
    expect(numbers.type).to.equal('float32');
    expect([...numbers.store(chunkBytes(false))]).to.deep.equal(values);
  });
});

describe('the bits of a float of 16 bits', () => {
  it('are those of every one of them', () => {
    const all = Uint16Array.from({ length: 2 ** 16 }, (_, i) => i);
    const numbers = readHalfFloats(new Uint8Array(all.buffer));
    for (const [i, number] of numbers.entries())
      if (!Number.isNaN(number) && i !== 0x8000) expect(halfFloatBits(number)).to.equal(i);
    expect([NaN, 1e9, -1e9].map(halfFloatBits)).to.deep.equal([0x7e00, 0x7c00, 0xfc00]);
  });
});

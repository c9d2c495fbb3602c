import { gzipSync } from 'fflate';
import { expect } from '@esm-bundle/chai';
import { decodeFile } from '../../../../src/formats/decode.ts';
import { finishVolume } from '../../../../src/formats/finish-volume.ts';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { fetchInOrder } from '../../../../src/sources/fetch-files.ts';
import { axialIndexToWorld } from '../../../../src/volume/grid.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { expectError, roomyLimits, urlOf, valuesOf } from '../../../helpers/decode.ts';

type Files = Readonly<Record<string, Uint8Array<ArrayBuffer>>>;

/** Load a manifest, and the files that it names. */
async function load(manifest: object, files: Files): Promise<Volume> {
  const fetchFile = async (url: string) => {
    const bytes = files[new URL(url).pathname.slice(1)];
    if (!bytes) throw new VolumeViewError('source/not-found', url);
    return { bytes: bytes.slice(), url, contentType: '' };
  };
  const input = { bytes: new TextEncoder().encode(JSON.stringify(manifest)), url: urlOf('a.json'), contentType: '' };
  const context = {
    onProgress: () => undefined,
    fetchFile,
    fetchFiles: (urls: readonly string[]) => fetchInOrder(urls, fetchFile, () => undefined),
  };
  return finishVolume(await decodeFile(input, {}, context), roomyLimits);
}

const types = {
  int8: 'setInt8',
  uint8: 'setUint8',
  int16: 'setInt16',
  uint16: 'setUint16',
  int32: 'setInt32',
  uint32: 'setUint32',
  float32: 'setFloat32',
  float64: 'setFloat64',
  int64: 'setBigInt64',
  uint64: 'setBigUint64',
} as const;

/** 3 x 2 x 2 numbers that count up from 40, after some bytes. */
function rawBytes(type: keyof typeof types, isLittle: boolean, before = 0): Uint8Array<ArrayBuffer> {
  const size = Number(/\d+/.exec(type)) / 8;
  const bytes = new Uint8Array(before + 12 * size).fill(0xee);
  const view = new DataView(bytes.buffer);
  for (let i = 0; i < 12; i++) {
    const set = types[type];
    if (set === 'setBigInt64' || set === 'setBigUint64') view[set](before + i * size, BigInt(40 + i), isLittle);
    else view[set](before + i * size, 40 + i, isLittle);
  }
  return bytes;
}
const expected = Array.from({ length: 12 }, (_, i) => 40 + i);

describe('plain numbers, by a manifest', () => {
  for (const type of Object.keys(types) as (keyof typeof types)[]) {
    for (const endian of ['little', 'big'] as const) {
      it(`${type}, ${endian}-endian, after 5 bytes, packed or not`, async () => {
        const bytes = rawBytes(type, endian === 'little', 5);
        const manifest = { image: 'a.raw', raw: { type, endian, dimensions: [3, 2, 2], offset: 5 } };
        for (const file of [bytes, gzipSync(bytes)]) {
          const volume = await load(manifest, { 'a.raw': file });
          expect(valuesOf(volume)).to.deep.equal(expected);
          expect(volume.format).to.equal(`Raw ${type}`);
          expect(volume.grid.indexToWorld).to.deep.equal(axialIndexToWorld([3, 2, 2], [1, 1, 1]));
        }
      });
    }
  }

  it('in several files, with the other fields of the manifest', async () => {
    const bytes = rawBytes('int16', true);
    const raw = { type: 'int16', dimensions: [3, 2, 2] };
    const volume = await load(
      { files: ['1.raw', '2.raw'], raw, spacing: [0.5, 1, -2], slope: 2, intercept: -1, unit: 'HU', title: 'Engine' },
      { '1.raw': bytes.slice(0, 12), '2.raw': bytes.slice(12) },
    );
    expect(valuesOf(volume)).to.deep.equal(expected.map((value) => 2 * value - 1));
    expect(volume.grid.spacing).to.deep.equal([0.5, 1, 2]);
    expect(volume).to.include({ unit: 'HU', title: 'Engine' });
  });

  it('say what follows them', async () => {
    const bytes = new Uint8Array(16);
    const volume = await load({ image: 'a', raw: { type: 'uint8', dimensions: [3, 2, 2] } }, { a: bytes });
    expect(volume.left?.[0]).to.contain('4 bytes after the samples');
  });

  it('are refused in words', async () => {
    const raw = { type: 'uint8', dimensions: [3, 2, 2] };
    for (const [manifest, code, words] of [
      [{ image: 'a', raw: { ...raw, dimensions: [3, 2, 3] } }, 'format/corrupt', /got 12 bytes; .* asks for 18: check/],
      [{ image: 'a', raw: { ...raw, offset: 1 } }, 'format/corrupt', /asks for 13/],
      [{ image: 'a', raw: { ...raw, dimensions: [99999, 99999, 99] } }, 'format/too-large', /99999 x 99999 x 99/],
      [{ files: ['a', 'a', 'a', 'a', 'a'], raw }, 'format/corrupt', /5 data files, which can not hold equal parts/],
      [{ image: 'a', raw: { type: 'int16' } }, 'manifest/invalid', /"raw".*expected an object with "dimensions"/],
      [{ image: 'a', raw: { ...raw, type: 'short' } }, 'manifest/invalid', /as "type" one of int8/],
      [{ image: 'a', raw: { ...raw, endian: 'middle' } }, 'manifest/invalid', /as "endian" "little" or "big"/],
      [{ image: 'a', raw, elevations: [1] }, 'manifest/invalid', /numbers of a radar/],
    ] as const) {
      const error = await expectError(load(manifest, { a: new Uint8Array(12) }));
      expect(error.code, error.message).to.equal(code);
      expect(error.message).to.match(words);
    }
  });
});

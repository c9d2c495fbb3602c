import { expect } from '@esm-bundle/chai';
import { Budget } from '../../../../src/formats/base/budget.ts';
import { crc32 } from '../../../../src/formats/codecs/crc32.ts';
import { unzstd } from '../../../../src/formats/codecs/unzstd.ts';
import { xxh64 } from '../../../../src/formats/codecs/xxh64.ts';
import { decodeBytes, expectError, fetchFixture, valuesOf } from '../../../helpers/decode.ts';

interface Packed {
  readonly name: string;
  readonly length: number;
  readonly crc: number;
  /** Base64. */
  readonly bytes: string;
}

/** Packed by libzstd; test/fixtures/make-zstd-fixtures.py makes them. */
const { files } = JSON.parse(new TextDecoder().decode(await fetchFixture('zstd-fixtures.json'))) as {
  files: Packed[];
};
const bytesOf = (name: string): Uint8Array<ArrayBuffer> =>
  Uint8Array.from(atob(files.find((file) => file.name === name)!.bytes), (sign) => sign.charCodeAt(0));

describe('data that libzstd packed', () => {
  for (const { name, length, crc } of files)
    it(`are unpacked: ${name}`, () => {
      const unpacked = unzstd(bytesOf(name), 1e6);
      expect(unpacked.length).to.equal(length);
      expect(crc32(unpacked)).to.equal(crc);
    });
});

describe('a file that is packed with Zstandard', () => {
  it('is read', async () => {
    const volume = await decodeBytes(bytesOf('NIfTI'), 'head.nii.zst');
    expect(volume.format).to.equal('NIfTI-1');
    expect(valuesOf(volume)).to.deep.equal(Array.from({ length: 24 }, (_, i) => 17 * i - 100));
  });

  it('that is damaged or cut, or holds no volume, is refused in words', async () => {
    const damaged = bytesOf('NIfTI');
    damaged[damaged.length - 1] ^= 1;
    for (const [bytes, code, words] of [
      [damaged, 'format/corrupt', 'wrong checksum'],
      [bytesOf('NIfTI').slice(0, 60), 'format/corrupt', 'Zstandard data ends early'],
      [bytesOf('words, level 3'), 'format/corrupt', 'does not begin with a NIfTI header'],
    ] as const) {
      const error = await expectError(decodeBytes(bytes.slice(), 'head.nii.zst'));
      expect(error.message).to.contain(words);
      expect(error.code).to.equal(code);
    }
  });
});

describe('hostile Zstandard data', () => {
  /** A frame of these blocks: the last three bytes are replaced by its header. */
  const frame = (size: number, ...blocks: readonly (readonly [kind: number, size: number, ...bytes: number[]])[]) =>
    Uint8Array.from([
      ...[0x28, 0xb5, 0x2f, 0xfd, 0xa0],
      ...[0, 8, 16, 24].map((shift) => (size >>> shift) & 0xff),
      ...blocks.flatMap(([kind, length, ...bytes], i) => {
        const head = (length << 3) | (kind << 1) | (i === blocks.length - 1 ? 1 : 0);
        return [head & 0xff, (head >> 8) & 0xff, head >> 16, ...bytes];
      }),
    ]);

  it('that swell end at the limit, before memory is taken', () => {
    const swollen = frame(2 ** 31, ...Array.from({ length: 16_384 }, () => [1, 2 ** 17, 0] as const));
    expect(() => unzstd(swollen, 2 ** 32, Budget.ofFile(swollen.length))).to.throw(/asks for .* of memory/);
    expect(() => unzstd(swollen, 2 ** 20)).to.throw(/more than 1,048,576 bytes/);
  });

  it('whose block asks for 12 GB ends at 128 KB', () => {
    // 98,303 copies of 131,074 bytes: codes that always give the same symbol, and extra bits of 1.
    const block = [0x00, 255, 0xff, 0xff, 0x54, 0, 0, 52, ...Array.from({ length: 60_000 }, () => 0xff)];
    const before = [0, 4, 1, 2, 3, 4] as const;
    expect(() => unzstd(frame(4, before, [2, block.length, ...block]), 1e9)).to.throw(/longer than one may be/);
  });

  it('with a dictionary or a long window are refused in words', () => {
    expect(() => unzstd(Uint8Array.of(0x28, 0xb5, 0x2f, 0xfd, 0x21, 7, 0, 1, 0, 0), 99)).to.throw(/dictionary/);
    expect(() => unzstd(Uint8Array.of(0x28, 0xb5, 0x2f, 0xfd, 0x00, 0xff, 1, 0, 0), 99)).to.throw(/without --long/);
  });

  it('changed at random give bytes or an error with a code, and never hang', () => {
    let seed = 7;
    const draw = (below: number): number => {
      seed = (Math.imul(seed, 1_103_515_245) + 12_345) & 0x7fffffff;
      return (seed >> 8) % below;
    };
    for (const { name } of files.filter(({ length }) => length < 30_000)) {
      for (let i = 0; i < 60; i++) {
        const bytes = bytesOf(name);
        for (let n = draw(3); n >= 0; n--) bytes[draw(bytes.length)] = draw(256);
        try {
          unzstd(bytes.slice(0, draw(4) === 0 ? draw(bytes.length) : undefined), 1e6, Budget.ofFile(bytes.length));
        } catch (error) {
          expect(error, name)
            .to.have.property('code')
            .that.matches(/^format\//);
        }
      }
    }
  });
});

describe('the checksum of Zstandard', () => {
  it('is that of xxhash 4.1.0 (Python), its low 32 bits', () => {
    const bytes = Uint8Array.from({ length: 1000 }, (_, i) => (i * 37 + (i >> 3)) & 0xff);
    expect([0, 1, 7, 31, 32, 33, 64, 100, 999].map((length) => xxh64(bytes.subarray(0, length)))).to.deep.equal([
      1373170073, 3674548072, 776310374, 1725708173, 4200376077, 4232268673, 3519944822, 2516102536, 3486935234,
    ]);
  });
});

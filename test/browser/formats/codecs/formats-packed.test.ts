import { expect } from '@esm-bundle/chai';
import { deflateSync, gzipSync, zlibSync } from 'fflate';
import { Budget } from '../../../../src/formats/base/budget.ts';
import { bunzip2 } from '../../../../src/formats/codecs/bunzip2.ts';
import { gunzip } from '../../../../src/formats/codecs/gunzip.ts';
import { undoFilters } from '../../../../src/formats/hdf5/filters.ts';
import { DeflateError, Inflater } from '../../../../src/formats/codecs/inflate.ts';
import { unpackAll } from '../../../../src/formats/meshes/read-mesh.ts';
import { unpackSeries } from '../../../../src/formats/codecs/unpack-series.ts';
import { unzlib } from '../../../../src/formats/codecs/unzlib.ts';
import { decodeBytes, expectError, fetchFixture, valuesOf } from '../../../helpers/decode.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

function join(...parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

async function collect(pieces: AsyncIterable<Uint8Array> | Iterable<Uint8Array>): Promise<Uint8Array<ArrayBuffer>> {
  const parts: Uint8Array[] = [];
  for await (const piece of pieces) parts.push(piece);
  return join(...parts);
}

/** Half noise and half the same again, so that all kinds of words and blocks occur. */
function mixedBytes(length: number): Uint8Array<ArrayBuffer> {
  const random = randomNumbers(length + 1);
  const bytes = Uint8Array.from({ length }, () => Math.floor(random() ** 3 * 256));
  for (let at = 1000; at + 700 < length; at += 1500) {
    const from = Math.max(0, at - Math.floor(random() * 40_000));
    bytes.copyWithin(at, from, from + 700);
  }
  return bytes;
}

const text = new TextEncoder().encode('This is no gzip.');
const zeros = new Uint8Array(512);

describe('gzip files of several members, or with something after them', () => {
  // Values from nibabel 5.4.2, which reads all three alike: 12 x 11 x 10, 164 at (3, 4, 5).
  for (const name of ['members', 'trailing-zeros', 'trailing-text']) {
    it(`${name}.nii.gz is read as nibabel reads it`, async () => {
      const volume = await decodeBytes(await fetchFixture(`nifti/${name}.nii.gz`), `${name}.nii.gz`);
      expect(volume.grid.dimensions).to.deep.equal([12, 11, 10]);
      expect(valuesOf(volume)[3 + 12 * (4 + 11 * 5)]).to.equal(164);
      expect(volume.range).to.deep.equal([100, 246]);
    });
  }

  const data = mixedBytes(300_000);
  const halves = [gzipSync(data.subarray(0, 123_456)), gzipSync(data.subarray(123_456))];

  for (const [name, packed] of Object.entries({
    'two members': join(...halves),
    'members with names, comments, extra fields and a checksum of the header': join(
      withAllFields(data.subarray(0, 123_456)),
      halves[1],
    ),
    'an empty member at the end, as bgzip writes it': join(...halves, gzipSync(new Uint8Array(0))),
    'zeros between and after members': join(halves[0], zeros, halves[1], zeros),
    'text after': join(...halves, text),
    'the first two bytes of a member after': join(...halves, Uint8Array.of(0x1f, 0x8b)),
    'blocks of 4,000 bytes': join(
      ...Array.from({ length: 75 }, (_, i) =>
        gzipSync(data.subarray(4000 * i, 4000 * (i + 1)), { level: (i % 10) as 0 }),
      ),
    ),
  })) {
    it(name, async () => expect(same(await collect(gunzip(packed)), data)).to.equal(true));
  }

  it('what is whole is given before the error, which says what is wrong', async () => {
    const wrong = join(...halves);
    wrong[wrong.length - 6] ^= 1;
    for (const [packed, message] of [
      [join(halves[0], halves[1].subarray(0, 5000)), /^the gzip file of \d+ bytes ends early; fetch it again/],
      [join(halves[0], halves[1].subarray(0, 5)), /ends early/],
      [join(halves[0].subarray(0, -3)), /ends early/],
      [wrong, /^the gzip file of \d+ bytes is damaged; fetch it again/],
    ] as const) {
      const got: Uint8Array[] = [];
      const error = await expectError(
        (async () => {
          for await (const piece of gunzip(packed)) got.push(piece);
        })(),
      );
      expect(error).to.have.property('code', 'format/corrupt');
      expect(error.message).to.match(message);
      const whole = join(...got);
      if (packed.length > halves[0].length) expect(whole.length).to.be.at.least(123_456);
      expect(same(whole, data.subarray(0, whole.length))).to.equal(true);
    }
  });

  it('limits of size hold over all members', async () => {
    const member = gzipSync(new Uint8Array(2 ** 20), { level: 9 });
    const packed = join(...Array.from({ length: 40 }, () => member));
    const error = await expectError(unpackAll(packed, 2 ** 24));
    expect(error).to.have.property('code', 'format/too-large');
    expect((await unpackAll(packed, 40 * 2 ** 20)).length).to.equal(40 * 2 ** 20);
  });

  it('members without end that hold nothing are damage', async () => {
    const empty = gzipSync(new Uint8Array(0));
    const packed = new Uint8Array(70_000 * empty.length);
    for (let at = 0; at < packed.length; at += empty.length) packed.set(empty, at);
    expect(await expectError(collect(gunzip(packed)))).to.have.property('code', 'format/corrupt');
  });

  it('of what is packed twice, and by other programs, is said what to do', async () => {
    for (const [name, bytes, words] of [
      ['x.nii.gz.gz', gzipSync(gzipSync(data)), /what is packed is a gzip file again.* gzip -d/],
      ['x.Z', join(Uint8Array.of(0x1f, 0x9d, 0x90), text), /compress \(\.Z\).*gzip -d/],
      ['x.nii.xz', join(Uint8Array.of(0xfd, 0x37, 0x7a, 0x58, 0x5a, 0), text), /xz -d/],
    ] as const) {
      const error = await expectError(decodeBytes(bytes, name));
      expect(error.message, name).to.match(words);
    }
  });
});

describe('other packed data with something after them', () => {
  const data = mixedBytes(200_000);

  it('zlib data, as NRRD, MetaImage and GIfTI hold them', async () => {
    for (const after of [zeros, text])
      expect(same(await collect(unzlib(join(zlibSync(data), after))), data)).to.equal(true);
    const wrong = zlibSync(data);
    wrong[wrong.length - 1] ^= 1;
    expect((await expectError(collect(unzlib(join(wrong, zeros))))).message).to.match(
      /^the zlib data of \d+ bytes is damaged|^the zlib data of \d+ bytes are damaged/,
    );
  });

  it('NRRD and MetaImage files', async () => {
    for (const path of ['nrrd/gzip.nrrd', 'nrrd/bzip2.nrrd', 'metaimage/zlib.mha']) {
      const bytes = await fetchFixture(path);
      const plain = valuesOf(await decodeBytes(bytes.slice(), path));
      for (const after of [zeros, text])
        expect(valuesOf(await decodeBytes(join(bytes, after), path)), path).to.deep.equal(plain);
    }
  });

  it('bzip2 data of several streams, as pbzip2 makes them', async () => {
    // Of Python 3.12: bz2.compress(b'volume '), and so for 'view'.
    const [first, second] = await Promise.all(['volume', 'view'].map((name) => fetchFixture(`packed/${name}.bz2`)));
    const unpacked = (bytes: Uint8Array): string => new TextDecoder().decode(bunzip2(bytes, 100));
    expect(unpacked(join(first, second))).to.equal('volume view');
    expect(unpacked(join(first, second, zeros))).to.equal('volume view');
    expect(() => bunzip2(join(first, second), 10)).to.throw('more than 10 bytes');
    expect(() => bunzip2(join(first, second.subarray(0, 20)), 100)).to.throw('the bzip2 data');
  });

  it('chunks of HDF5', () => {
    const filters = [{ id: 1, name: 'deflate', parameters: [] }];
    const undo = (stored: Uint8Array<ArrayBuffer>): Uint8Array =>
      undoFilters(stored, filters, { skipped: 0, expected: data.length, budget: Budget.ofFile(stored.length) });
    const stored = zlibSync(data);
    for (const packed of [stored, join(stored, zeros), join(stored, text)])
      expect(same(undo(packed), data)).to.equal(true);
    stored[stored.length - 1] ^= 1;
    expect(() => undo(join(stored, zeros))).to.throw('wrong checksum');
  });
});

describe('the decoder of deflate', () => {
  it('unpacks what fflate packs, on all levels, and says where it ends', () => {
    const inflater = new Inflater();
    for (const data of [
      new Uint8Array(0),
      Uint8Array.of(7),
      new Uint8Array(400_000),
      mixedBytes(70_000),
      mixedBytes(500_000),
    ]) {
      for (const level of [0, 1, 4, 6, 9] as const) {
        const packed = join(text, deflateSync(data, { level }), text);
        const stream = inflater.unpack(packed, text.length);
        const parts: Uint8Array[] = [];
        let next = stream.next();
        for (; !next.done; next = stream.next()) parts.push(next.value);
        expect(same(join(...parts), data), `${data.length} bytes, level ${level}`).to.equal(true);
        expect(next.value).to.equal(packed.length - text.length);
      }
    }
  });

  it('unpacks what the browser packs', async () => {
    const data = mixedBytes(500_000);
    const packed = new Uint8Array(
      await new Response(new Blob([data]).stream().pipeThrough(new CompressionStream('gzip'))).arrayBuffer(),
    );
    expect(same(await collect(unpackSeries(packed, 'gzip', 'it')), data)).to.equal(true);
  });

  it('ends with an error of its own where a stream is cut or written over', () => {
    const packed = deflateSync(mixedBytes(3000));
    const random = randomNumbers(9);
    const inflater = new Inflater();
    const drain = (bytes: Uint8Array<ArrayBuffer>): void => {
      for (const piece of inflater.unpack(bytes, 0)) expect(piece.length).to.be.greaterThan(0);
    };
    for (let length = 0; length < packed.length; length++)
      expect(() => drain(packed.slice(0, length)), `${length} bytes`).to.throw(DeflateError);
    let refused = 0;
    for (let run = 0; run < 2000; run++) {
      const damaged = packed.slice();
      for (let n = 0; n <= run % 6; n++) damaged[Math.floor(random() * packed.length)] = Math.floor(random() * 256);
      try {
        drain(damaged);
      } catch (error) {
        if (!(error instanceof DeflateError)) throw error;
        refused++;
      }
    }
    expect(refused).to.be.greaterThan(100);
  });
});

function same(a: Uint8Array, b: Uint8Array): boolean {
  return a.length === b.length && a.every((byte, i) => byte === b[i]);
}

/** A member with all that its header may hold. Source: RFC 1952, 2.3 */
function withAllFields(data: Uint8Array): Uint8Array {
  const plain = gzipSync(data);
  const header = Uint8Array.of(
    0x1f,
    0x8b,
    8,
    2 + 4 + 8 + 16,
    0,
    0,
    0,
    0,
    0,
    255,
    6,
    0,
    66,
    67,
    2,
    0,
    1,
    2,
    97,
    0,
    98,
    99,
    0,
    0,
    0,
  );
  return join(header, plain.subarray(10));
}

import { expect } from '@esm-bundle/chai';
import { isInMillimetres } from '../../../../src/volume/world-axes.ts';
import { decodeBytes, expectError, valuesOf } from '../../../helpers/decode.ts';
import { compareValues, readExpected } from '../../../helpers/expected-file.ts';
import type { FormatFile } from '../../../helpers/format-files.ts';
import { mrcBytes } from '../../../helpers/mrc-bytes.ts';
import type { MrcWords } from '../../../helpers/mrc-bytes.ts';

/** What other programs read of a file; test/fixtures/make-mrc-fixtures.py makes the files and asks them. */
const fixtures = await readExpected<FormatFile & { readonly bytes: string }>('mrc-fixtures.json');

describe('MRC files, against mrcfile, gemmi and SimpleITK', () => {
  for (const file of fixtures)
    it(file.path, async () => {
      const volume = await decodeBytes(
        Uint8Array.from(atob(file.bytes), (sign) => sign.charCodeAt(0)),
        file.path,
      );
      compareValues(volume, file);
      // Lengths are of the order of 1e-7 mm, and the header has them as floats of 32 bits.
      file.affine!.forEach((value, i) =>
        expect(volume.grid.indexToWorld[i], `affine[${i}]`).to.be.closeTo(value, i < 12 ? 3e-12 : 0),
      );
      expect(volume.format).to.equal(file.volumes! > 1 ? `MRC, volume 1 of ${file.volumes}` : 'MRC');
      expect([isInMillimetres(volume), volume.anatomical ?? false]).to.deep.equal([true, false]);
    });
});

describe('MRC', () => {
  it('is recognized by its bytes, whatever its name', async () => {
    expect((await decodeBytes(mrcBytes(), 'no-name')).format).to.equal('MRC');
  });

  it('has signed bytes, but unsigned ones where IMOD has written them', async () => {
    const signed = Array.from({ length: 12 }, (_, i) => (20 * i > 127 ? 20 * i - 256 : 20 * i));
    const unsigned = Array.from({ length: 12 }, (_, i) => 20 * i);
    const imod = 1_146_047_817;
    for (const [ints, values] of [
      [{}, signed],
      [{ 39: imod, 40: 1 }, signed],
      [{ 39: imod, 40: 0 }, unsigned],
      [{ 39: imod, 40: 6 }, unsigned],
    ] as const)
      expect(valuesOf(await decodeBytes(mrcBytes({ ints }), 'x.mrc'))).to.deep.equal(values);
  });

  it('is read in its own byte order where the machine stamp is wrong or absent', async () => {
    const samples = Uint8Array.from({ length: 24 }, (_, i) => (i % 2 ? 7 : 1));
    for (const [littleEndian, value] of [
      [true, 0x701],
      [false, 0x107],
    ] as const)
      for (const stamp of [0x44, 0x11, 0])
        expect(
          valuesOf(await decodeBytes(mrcBytes({ ints: { 4: 1 }, littleEndian, stamp, samples }), 'x.mrc')),
        ).to.deep.equal(Array.from({ length: 12 }, () => value));
  });

  it('has steps of 1 Angstrom and right angles where the header says nothing', async () => {
    const { grid } = await decodeBytes(
      mrcBytes({
        ints: { 8: 0, 9: 0, 10: 0, 17: 0, 18: 0, 19: 0 },
        floats: { 11: 0, 12: 0, 13: 0, 14: 0, 15: 0, 16: 0 },
      }),
      'x.mrc',
    );
    expect(grid.indexToWorld).to.deep.equal([1e-7, 0, 0, 0, 0, 1e-7, 0, 0, 0, 0, 1e-7, 0, 0, 0, 0, 1]);
  });

  it('has cubes where one of the lengths is not there, as in a single section', async () => {
    const { grid } = await decodeBytes(mrcBytes({ floats: { 11: 6, 12: 4, 13: 0 } }), 'x.mrc');
    expect([0, 5, 10].map((at) => grid.indexToWorld[at])).to.deep.equal([2e-7, 2e-7, 2e-7]);
  });

  it('is a stack of volumes only with its space group, and only of whole volumes', async () => {
    for (const [ints, sections] of [
      [{ 10: 1, 23: 401 }, 1],
      [{ 10: 1, 23: 1 }, 2],
      [{ 10: 0, 23: 401 }, 2],
      [{ 10: 3, 23: 401 }, 2],
    ] as const)
      expect((await decodeBytes(mrcBytes({ ints }), 'x.mrc')).grid.dimensions).to.deep.equal([3, 2, sections]);
  });
});

describe('MRC files that are refused', () => {
  it('name what was got and what was expected', async () => {
    for (const [words, code, message] of [
      [{ ints: { 4: 4 } }, 'format/unsupported', /Fourier transform.*newstack/],
      [{ ints: { 4: 16 } }, 'format/unsupported', /colours \(RGB\)/],
      [{ ints: { 4: 101 } }, 'format/unsupported', /4 bits/],
      [{ ints: { 4: 77 } }, 'format/corrupt', /mode 77; expected one of 0, 1, 2, 6, 12/],
      [{ ints: { 1: 0 } }, 'format/corrupt', /dimensions 0 x 2 x 2/],
      [{ ints: { 3: -1 } }, 'format/corrupt', /dimensions 3 x 2 x -1/],
      [{ ints: { 24: -4 } }, 'format/corrupt', /extended header of -4 bytes/],
      [{ ints: { 24: 2 ** 30 } }, 'format/corrupt', /ends early/],
      [{ ints: { 3: 3 } }, 'format/corrupt', /ends early/],
      [{ ints: { 1: 100000, 2: 100000, 3: 100000 } }, 'format/too-large', /100000 x 100000 x 100000/],
      [{ floats: { 14: 180, 15: 180, 16: 180 } }, 'format/corrupt', /one plane/],
      [{ floats: { 14: 10, 15: 10, 16: 100 } }, 'format/corrupt', /one plane/],
      [{ floats: { 11: Infinity } }, 'format/corrupt', /finite lengths/],
      [{ floats: { 50: NaN } }, 'format/corrupt', /finite lengths/],
    ] as readonly (readonly [MrcWords, string, RegExp])[]) {
      const error = await expectError(decodeBytes(mrcBytes(words), 'x.mrc'));
      expect([error.code, JSON.stringify(words)]).to.deep.equal([code, JSON.stringify(words)]);
      expect(error.message).to.match(message);
    }
  });

  it('say that a header is cut short, or that there is none', async () => {
    expect((await expectError(decodeBytes(mrcBytes().slice(0, 400), 'x.mrc'))).message).to.match(
      /got 400 bytes; expected 1024/,
    );
    expect((await expectError(decodeBytes(new Uint8Array(2000), 'x.mrc'))).message).to.match(/MAP at byte 208/);
  });
});

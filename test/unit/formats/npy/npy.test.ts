import { expect } from '@esm-bundle/chai';
import { axialIndexToWorld } from '../../../../src/volume/grid.ts';
import { decodeBytes, expectError, fetchFixture, valuesOf } from '../../../helpers/decode.ts';
import { compareValues } from '../../../helpers/expected-file.ts';
import { compareFormatFile, decodeChosen, filesLike, readFormatFile } from '../../../helpers/format-files.ts';

const latin = (text: string): Uint8Array => Uint8Array.from(text, (sign) => sign.charCodeAt(0));

/** An array file with this description. */
function npyBytes(description: string, samples = new Uint8Array(24), version = 1): Uint8Array<ArrayBuffer> {
  const from = version === 1 ? 10 : 12;
  const bytes = new Uint8Array(from + description.length + samples.length);
  bytes.set(latin('\x93NUMPY'));
  bytes[6] = version;
  new DataView(bytes.buffer).setUint16(8, description.length, true);
  bytes.set(latin(description), from);
  bytes.set(samples, from + description.length);
  return bytes;
}
const describeArray = (descr: string, shape: string, order = 'False'): string =>
  `{'descr': ${descr}, 'fortran_order': ${order}, 'shape': (${shape}), }\n`;

describe('arrays of NumPy, against NumPy', () => {
  for (const file of filesLike(/\.npy$/)) {
    it(file.path, async () => {
      const volume = await compareFormatFile(file);
      expect(volume.format).to.match(/^NPY/);
      expect(volume.grid.indexToWorld).to.deep.equal(axialIndexToWorld(volume.grid.dimensions, [1, 1, 1]));
      expect(volume.anatomical ?? false).to.equal(false);
    });
  }
});

describe('an array', () => {
  it('has slices, rows and columns as its axes, whatever its order in memory', async () => {
    const [c, fortran] = [await readFormatFile('i2-le.npy'), await readFormatFile('fortran.npy')];
    expect(valuesOf(fortran)).to.deep.equal(valuesOf(c));
    expect(c.grid.dimensions).to.deep.equal([3, 4, 5]);
  });

  it('of four axes is a series, of which the first volume is shown', async () => {
    expect((await readFormatFile('series-fortran.npy')).left).to.deep.equal(['volume 2 of the file']);
  });

  it('takes spacing from the attribute', async () => {
    const volume = await decodeBytes(await fetchFixture('formats/i2-le.npy'), 'x.npy', { spacing: [0.5, 0.5, -2] });
    expect(volume.grid.spacing).to.deep.equal([0.5, 0.5, 2]);
    expect(volume.grid.indexToWorld[10]).to.equal(-2);
  });

  it('may be the only one of an .npz', async () => {
    const [expected] = filesLike(/one\.npz$/);
    compareValues(await decodeChosen(['one.npz']), expected);
  });

  it('may be packed with gzip, and may have a header of version 2 or 3', async () => {
    const packed = await new Response(
      new Blob([npyBytes(describeArray("'|u1'", '2, 3, 4'), new Uint8Array(24).fill(9))])
        .stream()
        .pipeThrough(new CompressionStream('gzip')),
    ).arrayBuffer();
    expect(valuesOf(await decodeBytes(new Uint8Array(packed), 'x.npy.gz'))).to.deep.equal(
      Array.from({ length: 24 }, () => 9),
    );
    for (const version of [2, 3])
      expect(
        (await decodeBytes(npyBytes(describeArray("'<i2'", '3, 4'), new Uint8Array(24), version), 'x')).grid.dimensions,
      ).to.deep.equal([4, 3, 1]);
  });
});

describe('arrays that are refused', () => {
  it('name what was got and what was expected', async () => {
    for (const [description, code, words] of [
      ["{'descr': '<f4'}", 'format/corrupt', /expected a dictionary of 'descr', 'fortran_order' and 'shape'/],
      [describeArray("[('a', '<f4')]", '4,'), 'format/unsupported', /records of several fields.*array\["field"\]/],
      [describeArray("'|O'", '4,'), 'format/unsupported', /the type "\|O"; .*astype/],
      [describeArray("'<U8'", '4,'), 'format/unsupported', /the type "<U8"/],
      [describeArray("'<f16'", '4,'), 'format/unsupported', /the type "<f16"/],
      [describeArray("'<f4'", '2, 0, 3'), 'format/corrupt', /shape 2 x 0 x 3/],
      [describeArray("'|u1'", '2, 2, 2, 3'), 'format/unsupported', /last axis looks like colours.*array\[\.\.\., 0\]/],
      [describeArray("'<f4'", '100, 100, 100'), 'format/corrupt', /ends early/],
      [describeArray("'<f8'", '100000, 100000, 100000'), 'format/too-large', /100000 x 100000 x 100000/],
      [describeArray("'|u1'", '2000, 2, 3, 5', 'True'), 'format/corrupt', /ends early/],
      [describeArray("'|u1'", `${'1, '.repeat(70)}3`), 'format/corrupt', /shape/],
    ] as const) {
      const error = await expectError(decodeBytes(npyBytes(description), 'x.npy'));
      expect(error.code, error.message).to.equal(code);
      expect(error.message).to.match(words);
    }
  });

  it('say that they are cut short, or of another version', async () => {
    const bytes = await fetchFixture('formats/i2-le.npy');
    for (const length of [6, 11, 60, 129])
      expect((await expectError(decodeBytes(bytes.slice(0, length), 'x.npy'))).code, `${length}`).to.equal(
        'format/corrupt',
      );
    bytes[6] = 9;
    expect((await expectError(decodeBytes(bytes, 'x.npy'))).message).to.contain('version 9; expected 1 to 3');
  });
});

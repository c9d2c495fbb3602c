import { expect } from '@esm-bundle/chai';
import { decodeBytes, decodeStack, expectError, fetchFixture, valuesOf } from '../../../helpers/decode.ts';
import { compareFormatFile, decodeChosen, filesLike, readFormatFile } from '../../../helpers/format-files.ts';

describe('Analyze and NIfTI pairs against nibabel', () => {
  for (const file of filesLike(/\.hdr(\.gz)?$/)) {
    it(`${file.path}, and the same by its samples`, async () => {
      const volume = await compareFormatFile(file);
      expect(volume.format).to.match(file.path.includes('nifti') ? /^NIfTI-[12]/ : /^Analyze 7.5/);
      expect(volume.anatomical).to.equal(file.path.includes('nifti'));
      await compareFormatFile({ ...file, path: file.path.replace('.hdr', '.img') });
    });
  }
});

describe('a volume of two files', () => {
  it('is found among chosen files, in either order', async () => {
    const { dimensions } = (await readFormatFile('analyze-le-i2.hdr')).grid;
    for (const names of [
      ['analyze-le-i2.hdr', 'analyze-le-i2.img'],
      ['nifti-pair-packed.img.gz', 'nifti-pair-packed.hdr.gz'],
    ])
      expect((await decodeChosen(names)).grid.dimensions).to.deep.equal(dimensions);
  });

  it('may be a stack, whatever the names', async () => {
    const volume = await decodeStack(['formats/analyze-be-i2.hdr', 'formats/analyze-be-i2.img']);
    expect(valuesOf(volume)).to.deep.equal(valuesOf(await readFormatFile('analyze-be-i2.hdr')));
  });

  it('says which file is missing', async () => {
    for (const [name, other] of [
      ['analyze-le-i2.hdr', 'file-1.img'],
      ['analyze-le-i2.img', 'file-1.hdr'],
    ]) {
      // Chosen files are named by their number: people call files after patients.
      const error = await expectError(decodeChosen([name]));
      expect(error.code).to.equal('source/not-found');
      expect(error.message).to.contain(`neither ${other} nor ${other}.gz`);
    }
  });

  it('needs names that show the other file', async () => {
    const bytes = await fetchFixture('formats/analyze-le-i2.hdr');
    const error = await expectError(decodeBytes(bytes, 'no-name'));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.contain('.hdr and .img');
  });
});

describe('Analyze headers', () => {
  /** The fixture of 16 bits with bytes written over. */
  const patched = async (write: (view: DataView) => void): Promise<Uint8Array<ArrayBuffer>> => {
    const bytes = await fetchFixture('formats/analyze-le-i2.hdr');
    write(new DataView(bytes.buffer));
    return bytes;
  };
  const read = async (write: (view: DataView) => void) =>
    decodeBytes(await patched(write), 'formats/analyze-le-i2.hdr');

  it('with an orientation of slices are taken as transverse, and that is said', async () => {
    expect((await read((view) => view.setUint8(252, 2))).left?.[0]).to.contain('orient 2');
    expect((await read(() => undefined)).left).to.equal(undefined);
  });

  it('have numbers of 16 bits without sign where SPM says so', async () => {
    const values = valuesOf(await read((view) => view.setInt16(70, 132, true)));
    expect(values[0]).to.equal(2 ** 15);
  });

  it('that lie are refused in words', async () => {
    for (const [write, code, words] of [
      [(view: DataView) => view.setInt16(42, 30_000, true), 'format/corrupt', /ends early/],
      [(view: DataView) => view.setInt16(40, 0, true), 'format/corrupt', /0 axes/],
      [(view: DataView) => view.setInt16(70, 128, true), 'format/unsupported', /RGB24/],
      [(view: DataView) => view.setInt16(70, 99, true), 'format/corrupt', /datatype 99/],
    ] as const) {
      const error = await expectError(read(write));
      expect(error.code).to.equal(code);
      expect(error.message).to.match(words);
    }
    const other = await expectError(decodeBytes(new Uint8Array(300).fill(7), 'formats/u1.img'));
    expect(other.code).to.equal('source/not-found');
  });
});

import { expect } from '@esm-bundle/chai';
import { decodeFile } from '../../../../src/formats/decode.ts';
import type { DecodedVolume } from '../../../../src/formats/base/decoded-volume.ts';
import { decodeStack, expectError, fetchFixture, fixtureContext, urlOf, valuesOf } from '../../../helpers/decode.ts';
import { compareFormatFile, decodeChosen, filesLike, readFormatFile } from '../../../helpers/format-files.ts';

describe('AFNI against nibabel', () => {
  for (const file of filesLike(/\.HEAD$/)) {
    it(`${file.path}, and the same by its samples`, async () => {
      const volume = await compareFormatFile(file);
      expect(volume.format).to.match(/^AFNI/);
      expect(volume.anatomical).to.equal(true);
      const packed = file.path.includes('packed') ? '.gz' : '';
      await compareFormatFile({ ...file, path: file.path.replace('.HEAD', `.BRIK${packed}`) });
    });
  }
});

describe('AFNI', () => {
  // nibabel 5.4 reads neither of these two.
  it('shows the magnitude of complex numbers', async () => {
    const volume = await readFormatFile('afni-complex+orig.HEAD');
    valuesOf(volume).forEach((value, i) => expect(value).to.be.closeTo(Math.hypot(1.5 * i, 30 - i), 1e-4));
    expect(volume.left?.[0]).to.contain('the phase');
  });

  it('of an old header takes the place from the direction, the origin and the step of each axis', async () => {
    // R-to-L, A-to-P, I-to-S: in RAS the first axis runs to the left, the second to the back.
    const { grid } = await readFormatFile('afni-old+orig.HEAD');
    expect(grid.indexToWorld).to.deep.equal([-1.5, 0, 0, 30, 0, 2, 0, -20, 0, 0, 3.5, 10, 0, 0, 0, 1]);
  });

  it('says which volumes are not shown', async () => {
    expect((await readFormatFile('afni-series+orig.HEAD')).left).to.deep.equal(['volumes 2 to 3 of the file']);
  });

  it('is found among chosen files, and may be a stack', async () => {
    const names = ['afni-packed+orig.BRIK.gz', 'afni-packed+orig.HEAD'];
    const expected = valuesOf(await readFormatFile(names[1]));
    expect(valuesOf(await decodeChosen(names))).to.deep.equal(expected);
    expect(valuesOf(await decodeStack(['formats/afni-packed+orig.HEAD', `formats/${names[0]}`]))).to.deep.equal(
      expected,
    );
    const error = await expectError(decodeChosen(['afni-packed+orig.HEAD']));
    expect(error.code).to.equal('source/not-found');
    // Chosen files are named by their number: people call files after patients.
    expect(error.message).to.contain('file-1+orig.BRIK');
  });
});

describe('AFNI headers that lie', () => {
  /** The header with a text replaced. */
  const read = async (from: string | RegExp, to: string): Promise<DecodedVolume> => {
    const text = new TextDecoder().decode(await fetchFixture('formats/afni-le-i2+orig.HEAD'));
    expect(text).to.match(typeof from === 'string' ? new RegExp(from) : from);
    return decodeFile(
      {
        bytes: new TextEncoder().encode(text.replace(from, to)),
        url: urlOf('formats/afni-le-i2+orig.HEAD'),
        contentType: '',
      },
      {},
      fixtureContext(),
    );
  };

  it('are refused in words', async () => {
    for (const [from, to, code, words] of [
      ['3 4 5 0 0', '3 4 6 0 0', 'format/corrupt', /ends early/],
      ['3 4 5 0 0', '3 0 5 0 0', 'format/corrupt', /DATASET_DIMENSIONS 3 x 0 x 5/],
      ['3 4 5 0 0', '3 x 5', 'format/corrupt', /DATASET_DIMENSIONS "3 NaN 5"; expected 3 numbers/],
      ['3 4 5 0 0', '99999 99999 99999', 'format/too-large', /99999 x 99999 x 99999/],
      ['DATASET_DIMENSIONS', 'OTHER', 'format/corrupt', /expected whole numbers from 1/],
      [/(BRICK_TYPES\ncount = 1\n) 1/, '$1 6', 'format/unsupported', /colours \(RGB\).*3dcalc/],
      [/(BRICK_TYPES\ncount = 1\n) 1/, '$1 77', 'format/corrupt', /type 77 in BRICK_TYPES/],
      [/IJK_TO_DICOM_REAL(.|\n)*/, 'X', 'ok', /./],
      [/(IJK_TO_DICOM_REAL\ncount = 12\n)(.|\n)*/, '$1 0 0 0 0 0 0 0 0 0 0 0 0', 'format/corrupt', /one plane/],
    ] as const) {
      if (code === 'ok') {
        await read(from, to);
        continue;
      }
      const error = await expectError(read(from, to));
      expect(error.code, error.message).to.equal(code);
      expect(error.message).to.match(words);
    }
  });
});

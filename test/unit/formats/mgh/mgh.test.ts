import { expect } from '@esm-bundle/chai';
import { labelsIn } from '../../../../src/viewer/loading/label-files.ts';
import type { VolumeViewError } from '../../../../src/core/errors.ts';
import { transformPoint } from '../../../../src/volume/matrix.ts';
import { decodeBytes, expectError, valuesOf } from '../../../helpers/decode.ts';
import { compareFormatFile, filesLike, readFormatFile } from '../../../helpers/format-files.ts';
import { mghBytes } from '../../../helpers/mgh-bytes.ts';
import type { MghFields } from '../../../helpers/mgh-bytes.ts';

describe('MGH and MGZ against nibabel', () => {
  for (const file of filesLike(/\.mg[hz]$/)) {
    it(file.path, async () => {
      const volume = await compareFormatFile(file);
      expect(volume.format).to.match(/^MGH/);
    });
  }
});

describe('MGH', () => {
  it('is recognized by its bytes, packed or not, whatever its name', async () => {
    for (const name of ['u1.mgh', 'packed.mgz']) {
      const { format } = await decodeBytes(
        await (await fetch(`/test/fixtures/formats/${name}`)).arrayBuffer().then((bytes) => new Uint8Array(bytes)),
        'no-name',
      );
      expect(format, name).to.equal('MGH');
    }
  });

  // nibabel 5.4 does not read this type; FreeSurfer's MRI_USHRT has the number 10.
  it('reads unsigned numbers of 16 bits', async () => {
    const samples = Uint8Array.from({ length: 24 }, (_, i) => (i % 2 ? 7 : 250));
    expect(valuesOf(await decodeBytes(mghBytes({ type: 10, samples }), 'x.mgh'))).to.deep.equal(
      Array.from({ length: 12 }, () => 250 * 256 + 7),
    );
  });

  it('has its centre, c_ras, at the index n / 2', async () => {
    const place = [-1, 0, 0, 0, 0, -1, 0, 1, 0, 10, 20, 30];
    const { grid } = await decodeBytes(mghBytes({ place, spacing: [2, 3, 4] }), 'x.mgh');
    expect(transformPoint(grid.indexToWorld, [1.5, 1, 1])).to.deep.equal([10, 20, 30]);
  });

  it('takes a coronal scan of 1 mm without good_ras_flag, whatever the other fields say', async () => {
    const { grid } = await decodeBytes(mghBytes({ isPlaced: false, spacing: [9, 9, 9] }), 'x.mgh');
    expect(grid.indexToWorld).to.deep.equal([-1, 0, 0, 1.5, 0, 0, 1, -1, 0, -1, 0, 1, 0, 0, 0, 1]);
  });

  it('says which frames are not shown', async () => {
    expect((await readFormatFile('frames.mgz')).left).to.deep.equal(['volumes 2 to 3 of the file']);
  });

  it('holds labels with the numbers of FreeSurfer', async () => {
    const { found } = labelsIn(await readFormatFile('labels.mgz'), 'labels.mgz');
    expect([...found.ids]).to.deep.equal([0, 2, 10, 41, 1001, 2035, 12101, 14175]);
  });

  it('accepts the purpose that newer files have in their version', async () => {
    expect((await decodeBytes(mghBytes({ version: 0x201 }), 'x')).format).to.equal('MGH');
  });
});

describe('MGH files that are refused', () => {
  const refuse = async (fields: MghFields): Promise<VolumeViewError> =>
    expectError(decodeBytes(mghBytes(fields), 'x.mgh'));

  it('name what was got and what was expected', async () => {
    for (const [fields, code, words] of [
      [{ version: 3 }, 'format/corrupt', /does not begin with the version 1/],
      [{ dimensions: [0, 2, 2] }, 'format/corrupt', /dimensions 0 x 2 x 2/],
      [{ frames: -1 }, 'format/corrupt', /frames -1/],
      [{ type: 77 }, 'format/corrupt', /type 77; expected one of 0, 1, 3, 4, 10/],
      [{ type: 9 }, 'format/unsupported', /colours \(RGB\).*mri_convert/],
      [{ type: 6 }, 'format/unsupported', /tensors/],
      [{ spacing: [1, 0, 1] }, 'format/corrupt', /spacing 1 x 0 x 1/],
      [{ spacing: [1, NaN, 1] }, 'format/corrupt', /expected finite lengths/],
      [{ place: [1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0] }, 'format/corrupt', /one plane/],
      [{ dimensions: [3, 2, 3] }, 'format/corrupt', /ends early: got .* 296 bytes; its header asks for 302 bytes/],
      [{ dimensions: [100000, 100000, 100000] }, 'format/too-large', /100000 x 100000 x 100000/],
      [{ dimensions: [2000, 1000, 1000] }, 'format/corrupt', /ends early/],
    ] as const) {
      const error = await refuse(fields);
      expect([error.code, JSON.stringify(fields)]).to.deep.equal([code, JSON.stringify(fields)]);
      expect(error.message).to.match(words);
    }
  });

  it('say that a header is cut short', async () => {
    expect((await expectError(decodeBytes(mghBytes().slice(0, 200), 'x.mgh'))).message).to.match(
      /got 200 bytes; expected 284/,
    );
  });

  it('refuse a damaged MGZ by its checksum', async () => {
    const packed = await new Response(
      new Blob([mghBytes()]).stream().pipeThrough(new CompressionStream('gzip')),
    ).arrayBuffer();
    const bytes = new Uint8Array(packed);
    bytes[bytes.length - 6] ^= 1;
    expect((await expectError(decodeBytes(bytes, 'x.mgz'))).code).to.equal('format/corrupt');
  });
});

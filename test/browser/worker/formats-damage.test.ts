import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { decodeBytes, expectError, fetchFixture } from '../../helpers/decode.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

const mosaic = { columns: 3, rows: 2 };
const tooLong = 5000;

/** Decode; a volume or one of our errors is well, anything else, or no answer, is not. */
async function survive(bytes: Uint8Array<ArrayBuffer>, name: string, what: string): Promise<string> {
  const late = new Promise<never>((_, reject) =>
    setTimeout(() => reject(new Error(`${what}: no answer in ${tooLong} ms`)), tooLong),
  );
  try {
    await Promise.race([decodeBytes(bytes, name, { mosaic }), late]);
    return 'volume';
  } catch (error) {
    if (error instanceof VolumeViewError) {
      expect(error.message.length, what).to.be.greaterThan(10);
      expect(error.code, `${what}: ${error.message}`).to.match(/^(format|mosaic|manifest)\//);
      return error.code;
    }
    throw new Error(`${what}: ${String(error)}`, { cause: error });
  }
}

const files = [
  'nifti/v1-le-gz.nii.gz',
  'nifti/v2-be-gz.nii.gz',
  'nifti/v1-le-f4.nii',
  'nifti/v2-be-i8.nii',
  'nifti/v1-be-qform.nii',
  'mosaic/gray-3x2.png',
  'mosaic/gray16-3x2.png',
  'mosaic/palette4-3x2.png',
  'mosaic/bits1-3x2.png',
  'mosaic/flat-3x2.jpg',
  'mosaic/flat-3x2.webp',
];

describe('damaged files', () => {
  it('a gzip file cut anywhere is corrupt', async () => {
    const bytes = await fetchFixture('nifti/v1-le-gz.nii.gz');
    for (let length = 1; length < bytes.length; length++) {
      const error = await expectError(decodeBytes(bytes.slice(0, length), 'x.nii.gz'));
      expect(error.code, `${length} of ${bytes.length} bytes`).to.equal('format/corrupt');
    }
  });

  it('a gzip file with a wrong checksum is corrupt', async () => {
    const bytes = await fetchFixture('nifti/v1-le-gz.nii.gz');
    bytes[bytes.length - 6] ^= 1;
    expect((await expectError(decodeBytes(bytes, 'x.nii.gz'))).code).to.equal('format/corrupt');
  });

  it('a gzip file of something else is unknown', async () => {
    const packed = new Blob(['{}'.repeat(1000)]).stream().pipeThrough(new CompressionStream('gzip'));
    const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
    expect((await expectError(decodeBytes(bytes, 'x.nii.gz'))).code).to.equal('format/unknown');
  });

  for (const path of files) {
    it(`${path}: cut anywhere, a volume or an error with a code`, async () => {
      const bytes = await fetchFixture(path);
      const step = Math.max(1, Math.floor(bytes.length / 60));
      for (let length = 0; length < bytes.length; length += step)
        await survive(bytes.slice(0, length), path, `${length} bytes`);
    });

    it(`${path}: random bytes written over, a volume or an error with a code`, async () => {
      const bytes = await fetchFixture(path);
      const random = randomNumbers(bytes.length);
      const answers = new Set<string>();
      for (let run = 0; run < 60; run++) {
        const damaged = bytes.slice();
        for (let n = 0; n <= run % 8; n++) damaged[Math.floor(random() * bytes.length)] = Math.floor(random() * 256);
        answers.add(await survive(damaged, path, `run ${run}`));
      }
      expect(answers.size).to.be.greaterThan(0);
    });
  }

  it('headers full of noise', async () => {
    const bytes = await fetchFixture('nifti/v1-le-i2.nii');
    const random = randomNumbers(7);
    for (let run = 0; run < 200; run++) {
      const noisy = bytes.slice();
      for (let i = 40; i < 344; i++) if (random() < 0.3) noisy[i] = Math.floor(random() * 256);
      await survive(noisy, 'x.nii', `run ${run}`);
    }
  });
});

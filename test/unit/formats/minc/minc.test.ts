import { expect } from '@esm-bundle/chai';
import { decodeBytes, expectError, fetchFixture } from '../../../helpers/decode.ts';
import { buildNetcdf3 } from '../../../helpers/netcdf3-builder.ts';
import { compareFormatFile, filesLike, readFormatFile } from '../../../helpers/format-files.ts';

describe('MINC 2 against nibabel', () => {
  for (const file of filesLike(/\.mnc$/)) {
    it(file.path, async () => {
      const volume = await compareFormatFile(file);
      expect(volume.format).to.match(/^MINC 2/);
      expect(volume.anatomical).to.equal(true);
    });
  }
});

describe('MINC 2', () => {
  it('says which volumes are not shown', async () => {
    expect((await readFormatFile('minc-time.mnc')).left).to.deep.equal(['volumes 2 to 3 of the file']);
  });

  it('keeps small whole numbers of one scale as they are', async () => {
    expect((await readFormatFile('minc-u1.mnc')).samples).to.be.instanceOf(Uint8Array);
  });

  it('of version 1, which is NetCDF, is refused in words, and not called a radar', async () => {
    const values = (name: string) => ({ name, dimensions: [0], data: Float64Array.of(1, 2) });
    const bytes = buildNetcdf3([2], [values('image-max'), values('image-min'), values('image')]);
    const error = await expectError(decodeBytes(bytes, 'x.mnc'));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.contain('MINC 1').and.to.contain('mincconvert -2');
  });

  it('is refused in words with uneven slices', async () => {
    const error = await expectError(decodeBytes(await fetchFixture('formats/minc-irregular.bad'), 'x.mnc'));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.match(/uneven distances along zspace.*mincresample/);
  });

  it('is refused in words with other axes than those of space', async () => {
    const bytes = await fetchFixture('formats/minc-u1.mnc');
    const at = new TextDecoder('latin1').decode(bytes).indexOf('zspace,yspace,xspace');
    bytes.set(new TextEncoder().encode('zspace,yspace,vector'), at);
    const error = await expectError(decodeBytes(bytes, 'x.mnc'));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.match(/"zspace,yspace,vector"; expected xspace, yspace and zspace/);
  });

  it('damaged anywhere is an error in words, or a volume', async () => {
    const bytes = await fetchFixture('formats/minc-slices.mnc');
    for (let at = 0; at < bytes.length; at += 37) {
      const damaged = bytes.slice();
      damaged[at] ^= 0xff;
      const result = await decodeBytes(damaged, 'x.mnc').catch((error: unknown) => error);
      expect((result as { code?: string }).code ?? 'format/', `byte ${at}`).to.match(/^format\//);
    }
  });
});

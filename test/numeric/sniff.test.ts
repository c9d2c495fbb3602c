import { expect } from '@esm-bundle/chai';
import { nameOf, sniffFile } from '../../src/formats/sniff.ts';
import { fetchFixture } from '../helpers/decode.ts';

const kindOf = async (name: string): Promise<string> => sniffFile({ bytes: await fetchFixture(name), url: 'https://example.org/no-name', contentType: '' });

describe('what a file is, by its bytes alone', () => {
  it('radar files, whatever their name', async () => {
    // The first one has a block of its user's before the HDF5 file.
    for (const version of ['2.1', '2.0', '2.2', '2.3']) expect(await kindOf(`radar/odim-${version}.h5`), version).to.equal('hdf5');
    expect(await kindOf('radar/cfradial1-nc4.nc')).to.equal('hdf5');
    for (const form of ['classic', 'records', 'cdf5']) expect(await kindOf(`radar/cfradial1-${form}.nc`), form).to.equal('netcdf3');
    for (const name of ['message-31.ar2v', 'message-1.gz']) expect(await kindOf(`nexrad/${name}`), name).to.equal('nexrad');
  });

  it('images, manifests and NIfTI', async () => {
    expect(await kindOf('mosaic/gray-3x2.png')).to.equal('png');
    expect(await kindOf('mosaic/gray-3x2.json')).to.equal('manifest');
    expect(await kindOf('nifti/v1-le-gz.nii.gz')).to.equal('nifti-gz');
    expect(await kindOf('nifti/one-row.nii')).to.equal('nifti');
  });
});

describe('what messages call a file', () => {
  it('is the last part of its path, the type of a data: URL, and a blob: URL\'s fragment', () => {
    expect(nameOf('https://example.org/a/scan.h5?time=1#top')).to.equal('scan.h5');
    expect(nameOf('data:image/png;base64,AAAA')).to.equal('data:image/png;base64,');
    expect(nameOf('blob:https://example.org/d11a9b9a#40%20degrees.h5')).to.equal('40 degrees.h5');
    expect(nameOf('blob:https://example.org/d11a9b9a#100%')).to.equal('100%');
    expect(nameOf('blob:https://example.org/d11a9b9a')).to.equal('d11a9b9a');
  });
});

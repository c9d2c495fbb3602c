import { expect } from '@esm-bundle/chai';
import { nameOf } from '../../src/formats/name-of.ts';
import { allFormats } from '../../src/formats/registry.ts';
import { sniffFile } from '../../src/formats/sniff.ts';
import { fetchFixture } from '../helpers/decode.ts';

const kindOf = async (name: string): Promise<string> => {
  const input = { bytes: await fetchFixture(name), url: 'https://example.org/no-name', contentType: '' };
  return (await sniffFile(input, allFormats)).name;
};

describe('what a file is, by its bytes alone', () => {
  it('radar files, whatever their name', async () => {
    // The first one has a block of its user's before the HDF5 file.
    for (const version of ['2.1', '2.0', '2.2', '2.3']) expect(await kindOf(`radar/odim-${version}.h5`), version).to.equal('HDF5');
    expect(await kindOf('radar/cfradial1-nc4.nc')).to.equal('HDF5');
    for (const form of ['classic', 'records', 'cdf5']) expect(await kindOf(`radar/cfradial1-${form}.nc`), form).to.equal('NetCDF-3');
    for (const name of ['message-31.ar2v', 'message-1.gz']) expect(await kindOf(`nexrad/${name}`), name).to.equal('NEXRAD Level II');
  });

  it('NRRD and MetaImage, with their data and without', async () => {
    for (const name of ['i2-big.nrrd', 'crlf.nrrd', 'detached.nhdr']) expect(await kindOf(`nrrd/${name}`), name).to.equal('NRRD');
    for (const name of ['i2-big.mha', 'by-itk.mhd', 'colons.mha']) expect(await kindOf(`metaimage/${name}`), name).to.equal('MetaImage');
  });

  it('images, manifests and NIfTI', async () => {
    expect(await kindOf('mosaic/gray-3x2.png')).to.equal('PNG');
    expect(await kindOf('mosaic/gray-3x2.json')).to.equal('manifest');
    expect(await kindOf('nifti/v1-le-gz.nii.gz')).to.equal('NIfTI, gzip');
    expect(await kindOf('nifti/one-row.nii')).to.equal('NIfTI');
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

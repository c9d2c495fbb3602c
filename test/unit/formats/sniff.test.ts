import { expect } from '@esm-bundle/chai';
import { findForeign } from '../../../src/formats/base/foreign-formats.ts';
import { nameOf } from '../../../src/formats/base/name-of.ts';
import { allFormats } from '../../../src/formats/registry.ts';
import { sniffFile } from '../../../src/formats/sniff.ts';
import { decodeBytes, expectError, fetchFixture } from '../../helpers/decode.ts';

const kindOf = async (name: string): Promise<string> => {
  const input = { bytes: await fetchFixture(name), url: 'https://example.org/no-name', contentType: '' };
  return (await sniffFile(input, allFormats)).name;
};

describe('what a file is, by its bytes alone', () => {
  it('radar files, whatever their name', async () => {
    // The first one has a block of its user's before the HDF5 file.
    for (const version of ['2.1', '2.0', '2.2', '2.3'])
      expect(await kindOf(`radar/odim-${version}.h5`), version).to.equal('HDF5');
    expect(await kindOf('radar/cfradial1-nc4.nc')).to.equal('HDF5');
    for (const form of ['classic', 'records', 'cdf5'])
      expect(await kindOf(`radar/cfradial1-${form}.nc`), form).to.equal('NetCDF-3');
    for (const name of ['message-31.ar2v', 'message-1.gz'])
      expect(await kindOf(`nexrad/${name}`), name).to.equal('NEXRAD Level II');
  });

  it('NRRD and MetaImage, with their data and without', async () => {
    for (const name of ['i2-big.nrrd', 'crlf.nrrd', 'detached.nhdr'])
      expect(await kindOf(`nrrd/${name}`), name).to.equal('NRRD');
    for (const name of ['i2-big.mha', 'by-itk.mhd', 'colons.mha'])
      expect(await kindOf(`metaimage/${name}`), name).to.equal('MetaImage');
  });

  it('images, manifests and NIfTI', async () => {
    expect(await kindOf('mosaic/gray-3x2.png')).to.equal('PNG');
    expect(await kindOf('mosaic/gray-3x2.json')).to.equal('manifest');
    for (const name of ['v1-le-gz.nii.gz', 'v2-be-gz.nii.gz', 'one-row.nii'])
      expect(await kindOf(`nifti/${name}`), name).to.equal('NIfTI');
  });
});

describe('files of formats that are not read', () => {
  const bytesOf = (...parts: readonly (string | number)[]): Uint8Array<ArrayBuffer> =>
    Uint8Array.from(
      parts.flatMap((part) =>
        typeof part === 'number'
          ? Array.from({ length: part }, () => 0)
          : Array.from(part, (sign) => sign.charCodeAt(0)),
      ),
    );
  const gif = bytesOf('GIF89a', 30);
  // What each begins with. Sources: VTK file formats; GRIB2 and BUFR of WMO-No. 306
  const cases: readonly (readonly [string, Uint8Array<ArrayBuffer>, RegExp])[] = [
    ['VTK', bytesOf('# vtk DataFile Version 3.0\nx\n'), /VTK/],
    ['VTU', bytesOf('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid">'), /VTK/],
    ['PAR', bytesOf('# === DATA DESCRIPTION FILE ===='), /PAR/],
    ['GIF', gif, /GIF, .* PNG/],
    ['AVIF', bytesOf('\0\0\0\x20ftypavif', 30), /AVIF/],
    ['GRIB', bytesOf('GRIB', 30), /GRIB/],
    ['BUFR', bytesOf('BUFR', 30), /BUFR .* ODIM_H5/],
    ['HDF4', bytesOf('\x0e\x03\x13\x01', 30), /HDF4 .* h4toh5/],
    ['DORADE', bytesOf('SSWB\0\0\0\xc4', 40), /DORADE .* RadxConvert/],
    ['IRIS', bytesOf('\x1b\0\x08\0\0\x60\x39\0\0\0\0\0\x1a\0\x06\0', 700), /IRIS .* xradar/],
    ['zip', bytesOf('PK\x03\x04', 30), /unpack/],
  ];
  for (const [name, bytes, words] of cases) {
    it(`are named, with what makes a file that is read: ${name}`, async () => {
      const error = await expectError(
        sniffFile({ bytes, url: 'https://example.org/scan.x', contentType: '' }, allFormats),
      );
      expect(error).to.have.property('code', 'format/unsupported');
      expect(error.message).to.match(words);
    });
  }

  it('are named where they are packed, too', async () => {
    const packed = new Uint8Array(
      await new Response(new Blob([gif]).stream().pipeThrough(new CompressionStream('gzip'))).arrayBuffer(),
    );
    const error = await expectError(decodeBytes(packed, 'scan.gz'));
    expect(error).to.have.property('code', 'format/unsupported');
    expect(error.message).to.match(/GIF, .* PNG/);
  });

  it('no file that is read is taken for one of them', async () => {
    for (const name of [
      'nifti/v1-le-gz.nii.gz',
      'nifti/one-row.nii',
      'nrrd/i2-big.nrrd',
      'radar/odim-2.1.h5',
      'radar/cfradial1-classic.nc',
      'nexrad/message-1.gz',
    ]) {
      const bytes = await fetchFixture(name);
      expect(findForeign({ bytes, unpacked: null, text: '' }), name).to.equal(null);
    }
  });
});

describe('what messages call a file', () => {
  it("is the last part of its path, the type of a data: URL, and a blob: URL's fragment", () => {
    expect(nameOf('https://example.org/a/scan.h5?time=1#top')).to.equal('scan.h5');
    expect(nameOf('data:image/png;base64,AAAA')).to.equal('data:image/png;base64,');
    expect(nameOf('blob:https://example.org/d11a9b9a#40%20degrees.h5')).to.equal('40 degrees.h5');
    expect(nameOf('blob:https://example.org/d11a9b9a#100%')).to.equal('100%');
    expect(nameOf('blob:https://example.org/d11a9b9a')).to.equal('d11a9b9a');
  });
});

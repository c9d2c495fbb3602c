import { expect } from '@esm-bundle/chai';
import { decodeBase64Parts } from '../../../../src/formats/vti/base64-parts.ts';
import { decodeBytes, expectError, fetchFixture, valuesOf } from '../../../helpers/decode.ts';
import { compareFormatFile, filesLike, readFormatFile } from '../../../helpers/format-files.ts';

const encode = (text: string): Uint8Array<ArrayBuffer> => new TextEncoder().encode(text);

/** A file of 2 x 2 x 2 points in text. */
function vtiText({
  image = 'WholeExtent="0 1 0 1 0 1"',
  file = '',
  piece = '',
  array = '<DataArray type="UInt8" Name="a" format="ascii">1 2 3 4 5 6 7 8</DataArray>',
  appended = '',
} = {}): Uint8Array<ArrayBuffer> {
  return encode(
    `<VTKFile type="ImageData" ${file}><ImageData ${image}><Piece ${piece}><PointData>${array}</PointData></Piece></ImageData>${appended}</VTKFile>`,
  );
}

describe('VTI against VTK', () => {
  for (const file of filesLike(/\.vti$/)) {
    it(file.path, async () => {
      const volume = await compareFormatFile(file);
      expect(volume.format).to.equal('VTI');
    });
  }
});

describe('VTI', () => {
  it('says which arrays are not shown', async () => {
    expect((await readFormatFile('several.vti')).left).to.deep.equal([
      'the arrays "array 0", "array 2"; "array 1" is shown',
    ]);
  });

  it('needs no extent of its piece, and text within an array may hold more elements', async () => {
    const array =
      '<DataArray type="Float32" Name="a" format="ascii"><InformationKey name="k">9</InformationKey>1 2 3 4 5 6 7 nan</DataArray>';
    const volume = await decodeBytes(vtiText({ array }), 'x');
    expect(valuesOf(volume)).to.deep.equal([1, 2, 3, 4, 5, 6, 7, NaN]);
    expect(volume.grid.indexToWorld).to.deep.equal([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
  });

  it('takes vectors only where there is nothing else', async () => {
    const vectors = '<DataArray type="UInt8" Name="v" NumberOfComponents="3" format="ascii">1</DataArray>';
    const volume = await decodeBytes(
      vtiText({ array: `${vectors}<DataArray type="UInt8" Name="a" format="ascii">1 2 3 4 5 6 7 8</DataArray>` }),
      'x.vti',
    );
    expect(valuesOf(volume)).to.deep.equal([1, 2, 3, 4, 5, 6, 7, 8]);
    const error = await expectError(decodeBytes(vtiText({ array: vectors }), 'x.vti'));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.contain('Calculator');
  });

  it('decodes Base64 in several parts, and refuses other letters', () => {
    const parts = (text: string): number[] | null => {
      const bytes = decodeBase64Parts(encode(text), Infinity);
      return bytes && [...bytes];
    };
    expect(parts('AQ==Ag==')).to.deep.equal([1, 2]);
    expect(parts('AQ\n IDBA==')).to.deep.equal([1, 2, 3, 4]);
    expect(parts('AQI=\n</A>')).to.deep.equal([1, 2]);
    expect(parts('?')).to.equal(null);
  });
});

describe('VTI files that are refused', () => {
  it('name what was got and what was expected', async () => {
    const appendedArray = (offset: number): string =>
      `<DataArray type="UInt8" Name="a" format="appended" offset="${offset}"/>`;
    const raw = '<AppendedData encoding="raw">_\x08\0\0\0\x01\x02\x03</AppendedData>';
    for (const [fields, code, words] of [
      [{ image: 'WholeExtent="0 -1 0 1 0 1"' }, 'format/corrupt', /Extent 0 -1 0 1 0 1/],
      [{ image: 'WholeExtent="0 1"' }, 'format/corrupt', /WholeExtent "0 1"; expected 6 numbers/],
      [{ image: 'WholeExtent="0 1 0 1 0 1" Spacing="1 0 1"' }, 'format/corrupt', /Spacing 1 0 1/],
      [{ image: 'WholeExtent="0 9 0 9 0 9"' }, 'format/corrupt', /asks for 1000 numbers/],
      [{ image: 'WholeExtent="0 99999 0 99999 0 99999"' }, 'format/too-large', /100000 x 100000 x 100000/],
      [{ array: '' }, 'format/corrupt', /no array/],
      [{ array: '<DataArray type="String" Name="a"/>' }, 'format/unsupported', /the type "String"/],
      [{ array: appendedArray(0) }, 'format/corrupt', /at the offset 0/],
      [{ array: appendedArray(999), appended: raw }, 'format/corrupt', /at the offset 999/],
      [{ array: appendedArray(0), appended: raw.replace('_\x08', '_\x09') }, 'format/corrupt', /9 bytes.* ask for 8/],
      [
        { array: appendedArray(0), appended: raw, file: 'compressor="vtkLZ4DataCompressor"' },
        'format/unsupported',
        /vtkLZ4DataCompressor.*ZLib/,
      ],
      [
        { array: appendedArray(0), appended: raw, file: 'compressor="vtkZLibDataCompressor"' },
        'format/corrupt',
        /8 packed blocks/,
      ],
      [{ array: appendedArray(0), appended: raw, file: 'header_type="Int8"' }, 'format/corrupt', /header_type "Int8"/],
      [{ array: '<DataArray type="UInt8" format="binary">*</DataArray>' }, 'format/corrupt', /no Base64/],
      [{ piece: '/><Piece' }, 'format/unsupported', /2 pieces.*ParaView/],
      [{ array: '<a>' }, 'format/corrupt', /no XML/],
    ] as const) {
      const error = await expectError(decodeBytes(vtiText(fields), 'x.vti'));
      expect(error.code, error.message).to.equal(code);
      expect(error.message).to.match(words);
    }
  });

  it('say that packed data are damaged or cut short', async () => {
    const bytes = await fetchFixture('formats/raw-zlib-32-le.vti');
    const text = new TextDecoder('latin1').decode(bytes);
    const start = text.indexOf('_', text.indexOf('<AppendedData')) + 1;
    for (const at of [start, start + 8, start + 12, start + 40]) {
      const damaged = bytes.slice();
      damaged[at] ^= 0x55;
      expect((await expectError(decodeBytes(damaged, 'x.vti'))).code, `byte ${at}`).to.equal('format/corrupt');
    }
    expect((await expectError(decodeBytes(bytes.slice(0, start + 30), 'x.vti'))).code).to.equal('format/corrupt');
  });
});

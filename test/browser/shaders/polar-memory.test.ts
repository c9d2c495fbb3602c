import { expect } from '@esm-bundle/chai';
import type { Volume } from '../../../src/volume/volume.ts';
import { finishUpload } from '../../../src/renderer/textures/fill-texture.ts';
import { uploadPolarVolume } from '../../../src/radar/gpu/polar-field-module.ts';
import { uploadCells } from '../../../src/renderer/textures/cell-texture.ts';
import { countGpuBytes } from '../../bench/count-gpu-bytes.mjs';
import { decodeBytes } from '../../helpers/decode.ts';
import { createGl, releaseGl } from '../../helpers/gl.ts';
import { fetchSharedData } from '../../helpers/shared-data.ts';
import { radarVolume, unequalSweeps } from '../../helpers/synthetic-radar.ts';

const scans = [
  'cfradial_klbb_converted/KLBB20160601_150025_cfradial1.nc',
  'cfradial_pyart/example_cfradial_cr_raster.nc',
  'nexrad/KLBB20160601_150025_V06',
  'nexrad/KLIX20050828_180149.gz',
  'odim_au40_captainsflat/40_20181220_060630.pvol.h5',
  'odim_au40_captainsflat/40_20181220_061230.pvol.h5',
  // One time of the series: all others have the same sweeps, and take the same bytes.
  ...['dbzh', 'vrad'].map((moment) => `odim_behel_series/20200207130000.rad.behel.pvol.${moment}.scanz.hdf`),
  'odim_belgium_20190606/behel.pvol.hdf',
  'odim_belgium_20190606/bewid.pvol.hdf',
];

/** Bytes on the GPU, as the calls of WebGL tell: gates, table, and how empty the macrocells are. */
function countBytes(volume: Volume, version: 1 | 2): number {
  const { gl, device } = createGl(version);
  try {
    const { bytes } = finishUpload(uploadPolarVolume(gl, volume, device));
    const { macrocells } = volume;
    uploadCells(gl, new Uint8Array(macrocells.low.length), macrocells, {
      previous: null,
      device,
      samplerName: 'uEmptySpaceDistance',
    });
    const { textures } = (window as unknown as { gpuBytes(): { textures: number } }).gpuBytes();
    expect(bytes, 'what the product says').to.be.at.most(textures);
    return textures;
  } finally {
    releaseGl({ gl, device, version });
  }
}

describe('the memory of a radar volume', () => {
  before(countGpuBytes);

  const check = (volume: Volume): void => {
    const { samples, macrocells } = volume;
    const shares = ([1, 2] as const).map((version) => countBytes(volume, version) / samples.byteLength);
    const page =
      (samples.buffer.byteLength + macrocells.low.buffer.byteLength + macrocells.high.buffer.byteLength) /
      samples.byteLength;
    console.log(
      `GPU ${shares.map((share) => share.toFixed(3)).join(' and ')}, page ${page.toFixed(3)} times ${samples.byteLength} bytes`,
    );
    for (const share of shares) expect(share, 'the GPU').to.be.within(1, 1.3);
    expect(page, 'the page').to.be.within(1, 1.2);
    expect(samples.buffer.byteLength, 'what the samples are a part of').to.equal(samples.byteLength);
  };

  it('sweeps that differ in gates: at most 1.3 times the samples on the GPU, and little more than them in the page', () =>
    check(radarVolume(unequalSweeps)));

  for (const scan of scans) {
    it(`the same of ${scan}`, async function () {
      check(await decodeBytes(new Uint8Array(await fetchSharedData(this, `radar/${scan}`)), scan));
    });
  }
});

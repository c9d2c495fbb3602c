// Volumes in colours: what a device holds of them, what is gray all the same, and what a file's slices do to them.
import { expect } from '@esm-bundle/chai';
import type { DecodedCartesianVolume } from '../../../../src/formats/base/decoded-volume.ts';
import { fitColors } from '../../../../src/formats/base/fit-colors.ts';
import { finishVolume } from '../../../../src/formats/finish-volume.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../../src/volume/grid.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { colorSliceStops, sliceStops } from '../../../../src/volume/slice-stops.ts';
import { rgbOf } from '../../../helpers/channels.ts';
import { roomyLimits } from '../../../helpers/decode.ts';

const dimensions: Vector3 = [8, 4, 2];
/** Two columns of voxels are red, two green, and so on: 2 x 2 x 2 voxels have one colour. */
const colors = [
  [240, 0, 0],
  [0, 240, 0],
  [0, 0, 240],
  [200, 200, 200],
];
const rgb = Uint8Array.from({ length: 3 * 64 }, (_, at) => colors[Math.floor((Math.floor(at / 3) % 8) / 2)][at % 3]);

const decoded = (values: Uint8Array<ArrayBuffer>): DecodedCartesianVolume => ({
  grid: cartesianGrid(dimensions, axialIndexToWorld(dimensions, [1, 1, 1])),
  samples: new Uint8Array(64).fill(9),
  slope: 1,
  intercept: 0,
  unit: '',
  format: 'test',
  colors: { rgb: values, range: [0, 255] },
});

describe('volumes in colours', () => {
  it('of one slice are opaque, also where they are black', () => {
    const slice = { ...decoded(rgb), grid: cartesianGrid([8, 8, 1], axialIndexToWorld([8, 8, 1], [1, 1, 1])) };
    expect(fitColors(slice, roomyLimits).transferFunction).to.equal(colorSliceStops);
    expect(fitColors(decoded(rgb), roomyLimits).transferFunction).to.match(/^0 white 0,/);
  });

  it('of one slice that are all gray are shown as they are, also where they are dark', async () => {
    const grid = cartesianGrid([8, 8, 1], axialIndexToWorld([8, 8, 1], [1, 1, 1]));
    const dark = { ...decoded(new Uint8Array(3 * 64).fill(30)), grid };
    const volume = await finishVolume(dark, roomyLimits);
    expect(volume).to.deep.include({ transferFunction: sliceStops, window: [0, 255] });
    // Of numbers of 16 bits not all may be in use.
    const ofMore = fitColors({ ...dark, colors: { rgb: dark.colors!.rgb, range: [0, 65535] } }, roomyLimits);
    expect(ofMore.window).to.equal(undefined);
  });

  it('have the mean of colours where a device holds fewer voxels, at the same places', () => {
    // Brightness and colours of a voxel take five bytes: 8 voxels have room.
    const volume = fitColors(decoded(rgb), { ...roomyLimits, maxBytes: 40 });
    expect(volume.grid.dimensions).to.deep.equal([4, 2, 1]);
    expect(volume.reduced).to.deep.equal({ from: dimensions, to: [4, 2, 1] });
    expect(rgbOf(volume as never)).to.deep.equal([...colors.flat(), ...colors.flat()]);
    expect(volume.samples).to.have.length(8);
    expect(volume.grid.spacing).to.deep.equal([2, 2, 2]);
  });

  it('whose colours are all gray are as any other volume, up to what packing leaves', async () => {
    const gray = rgb.map((_, at) => 100 + Math.floor(at / 3) + 7 * Number(at % 3 === 2));
    const volume = await finishVolume(decoded(gray), roomyLimits);
    expect(volume.channels).to.equal(undefined);
    expect(volume).not.to.have.property('colors');
  });

  it('are sent to the page without what they were read from, and white by default', async () => {
    const volume = await finishVolume(decoded(rgb), roomyLimits);
    expect(volume).not.to.have.property('colors');
    expect(volume.window).to.deep.equal([0, 255]);
    expect(volume.transferFunction).to.match(/^0 white 0, .*, 255 white 0\.2$/);
    expect(volume.channels!.infos.map(({ name }) => name)).to.deep.equal(['R', 'G', 'B']);
    expect(structuredClone(volume)).to.have.nested.property('channels.full', 255);
  });
});

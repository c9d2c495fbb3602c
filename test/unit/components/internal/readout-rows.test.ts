// What a readout says, word for word.
import { expect } from '@esm-bundle/chai';
import { listRows } from '../../../../components/internal/volume-readout-rows.ts';
import { nearestVoxel } from '../../../../src/viewer/picking/pick-voxel.ts';
import { projectPlace } from '../../../../src/viewer/camera/project-place.ts';
import { describeVolume } from '../../../../src/viewer/model/volume-info.ts';
import type { VolumeInfo } from '../../../../src/viewer/model/volume-info.ts';
import type { RadarPlace, VolumePick } from '../../../../src/viewer/model/volume-pick.ts';
import { english as companions } from '../../../../src/messages/english-companions.ts';
import { english } from '../../../../src/messages/english-readout.ts';
import { messages as arabic } from '../../../../src/messages/locales/ar.ts';
import { Language } from '../../../../src/messages/language.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const info = (more: Partial<VolumeInfo> = {}): VolumeInfo => ({
  ...describeVolume(syntheticVolume({ dimensions: [4, 4, 4] })),
  format: 'NIfTI-1',
  anatomical: true,
  ...more,
});
const pick: VolumePick = {
  value: 12345.5,
  interpolated: 12000,
  unit: 'HU',
  voxel: [10, 20, 30],
  world: [-23.14, -4, 55.25],
  opacity: 0.5,
  color: '#ff0000',
  radar: null,
};
const style = (code = 'en', coordinates: string | null = null) => ({
  language: new Language(code, companions),
  messages: english,
  coordinates,
});
const write = (...args: Parameters<typeof listRows>): string =>
  listRows(...args)
    .map(({ name, text }) => `${name}: ${text}`)
    .join(' | ');

const place: RadarPlace = {
  range: 48_250,
  azimuth: 206.53,
  elevation: 1.296,
  heightAboveAntenna: 1213.4,
  heightAboveSea: 1534.4,
  latitude: -35.66,
  longitude: 149.5126,
  gate: { sweep: 2, radial: 206, gate: 96, range: 48_250, azimuth: 206.5, elevation: 1.3 },
};

describe('the rows of a readout', () => {
  it("have the letters of the patient's sides", () => {
    expect(write(pick, info(), style())).to.equal(
      'Value: 12345.5 HU | Place: L 23.1 P 4.0 S 55.3 mm | Voxel: 10, 20, 30',
    );
    expect(write({ ...pick, world: [0, 1, -2], unit: '' }, info(), style())).to.equal(
      'Value: 12345.5 | Place: R 0.0 A 1.0 I 2.0 mm | Voxel: 10, 20, 30',
    );
  });

  it('have as many decimals as the voxels are fine', () => {
    for (const [spacing, text] of [
      [10, 'L 23 P 4 S 55 mm'],
      [1, 'L 23.1 P 4.0 S 55.3 mm'],
      [0.1, 'L 23.14 P 4.00 S 55.25 mm'],
      [1e-9, 'L 23.140000 P 4.000000 S 55.250000 mm'],
    ] as const) {
      expect(listRows(pick, info({ spacing: [20, spacing, 30] }), style())[1].text).to.equal(text);
    }
  });

  it('have places in the unit that suits the size of the volume', () => {
    const seen = { ...pick, world: [-0.02314, -0.004, 0.0052] as const };
    const cells = (spacing: number, coordinates: string | null = null, code = 'en'): string =>
      listRows(
        seen,
        info({
          format: 'OME-Zarr 0.5',
          anatomical: undefined,
          dimensions: [100, 80, 40],
          spacing: [spacing, spacing, spacing],
        }),
        { ...style(code, coordinates), messages: code === 'ar' ? { ...english, ...arabic } : english },
      )[1].text;
    expect(cells(2e-4)).to.equal('x −23.14 y −4.00 z 5.20 µm');
    expect(cells(1e-3)).to.equal('x −23.1 y −4.0 z 5.2 µm');
    expect(cells(5e-6)).to.equal('x −23140 y −4000 z 5200 nm');
    expect(cells(0.02), 'micro-CT').to.equal('x −0.023 y −0.004 z 0.005 mm');
    expect(cells(1e-3, 'patient')).to.equal('L 23.1 P 4.0 S 5.2 µm');
    expect(cells(1e-3, 'xyz'), 'what attributes have').to.equal('x −0.0231 y −0.0040 z 0.0052');
    expect(cells(1e-3, null, 'ar')).to.equal('x \u200e−23.1 y \u200e−4.0 z 5.2 ميكرومتر');
  });

  it('have the colours of channels', () => {
    const channels = [
      { number: 1, name: 'DNA', color: [0, 0, 1] as const, window: [0, 1] as const },
      { number: 3, name: '', color: [1, 0.5, 0] as const, window: [0, 1] as const },
    ];
    const layers = [{ name: 'DNA', value: 7, unit: '', channel: 1 }];
    const rows = (found: VolumePick | null) => listRows(found, info({ channels }), style()).slice(0, 3);
    expect(rows({ ...pick, layers })).to.deep.equal([
      { name: 'DNA', text: '7', color: 'rgb(0 0 255)' },
      { name: 'Channel 3', text: '–', color: 'rgb(255 128 0)' },
      { name: 'Place', text: 'L 23.1 P 4.0 S 55.3 mm' },
    ]);
    expect(rows(null).map(({ color }) => color)).to.deep.equal(['', '', undefined]);
  });

  it("have letters where the file is a patient's, or the author says so", () => {
    const plain = 'x −23.1 y −4.0 z 55.3';
    expect(listRows(pick, info({ format: 'PNG mosaic', anatomical: undefined }), style())[1].text).to.equal(plain);
    // A NIfTI file with the codes of sform and qform 0 says lengths, and not whose axes they are along (nifti1.h, method 1).
    expect(listRows(pick, info({ anatomical: false }), style())[1].text, 'nobody says whose axes').to.equal(
      `${plain} mm`,
    );
    expect(listRows(pick, info({ anatomical: false }), style('en', 'patient'))[1].text).to.equal(
      'L 23.1 P 4.0 S 55.3 mm',
    );
    expect(listRows(pick, info({ unit: 'dBZ' }), style())[1].text, 'a storm').to.equal(plain);
    expect(listRows(pick, info(), style('en', 'xyz'))[1].text).to.equal(plain);
    expect(listRows(pick, info({ format: 'PNG mosaic' }), style('en', ' Patient '))[1].text).to.equal(
      'L 23.1 P 4.0 S 55.3 mm',
    );
  });

  it('are as many where nothing is', () => {
    expect(write(null, info(), style())).to.equal('Value: – | Place: – | Voxel: –');
    expect(
      write({ ...pick, value: NaN, interpolated: NaN, voxel: null }, info(), style()),
      "on a surface or a layer beside the volume's data",
    ).to.equal('Value: – | Place: L 23.1 P 4.0 S 55.3 mm | Voxel: –');
    expect(
      listRows(null, info({ moment: 'DBZH', site: { height: 1, latitude: 1, longitude: 1 } }), style()),
    ).to.have.length(7);
  });

  it('name a label and interpolate nothing', () => {
    expect(listRows({ ...pick, label: '17', value: 17 }, info(), style())[0]).to.deep.equal({
      name: 'Label',
      text: '17',
    });
  });

  it('say of a radar what it knows of its own place', () => {
    const radar = { ...pick, value: 41.5, unit: 'dBZ', voxel: null, radar: place };
    const seen = 'Value: 41.5 dBZ | Range: 48.25 km | Azimuth: 206.5° | Elevation: 1.30°';
    expect(write(radar, info({ moment: 'DBZH', site: {} }), style())).to.equal(
      `${seen} | Height above antenna: 1213 m`,
    );
    expect(
      write(radar, info({ moment: 'DBZH', site: { height: 321, latitude: -35, longitude: 149 } }), style()),
    ).to.equal(`${seen} | Height above sea: 1534 m | Height above antenna: 1213 m | Position: 35.660° S 149.513° E`);
  });

  it('write numbers as the language does', () => {
    expect(listRows(pick, info(), style('de')).map(({ text }) => text)).to.deep.equal([
      '12345,5 HU',
      'L 23,1 P 4,0 S 55,3 mm',
      '10, 20, 30',
    ]);
  });
});

describe('the nearest voxel', () => {
  const volume = (values: readonly number[]) => ({
    ...syntheticVolume({ dimensions: [2, 2, 1], kind: 'float32' }),
    samples: Float32Array.from(values),
    slope: 2,
    intercept: 1,
  });

  it('is the one around the place', () => {
    for (const [place2, index, value] of [
      [[0.1, 0.1, 0.5], [0, 0, 0], 3],
      [[0.9, 0.2, 0], [1, 0, 0], 5],
      [[0.5, 0.5, 1], [1, 1, 0], 9],
      [[-1, 2, 0.5], [0, 1, 0], 7],
    ] as const) {
      expect(nearestVoxel(volume([1, 2, 3, 4]), place2)).to.deep.equal({ index, value });
    }
  });

  it('is the nearest one that has data', () => {
    expect(nearestVoxel(volume([NaN, 2, 3, 4]), [0.3, 0.45, 0.5])).to.deep.equal({ index: [0, 1, 0], value: 7 });
    expect(nearestVoxel(volume([NaN, NaN, NaN, NaN]), [0.3, 0.3, 0.5])).to.equal(null);
    expect(nearestVoxel(volume([NaN, 2, 3, 4]), [0, 0, 0.5]), 'nothing else is near').to.equal(null);
  });
});

describe('a place in the picture', () => {
  const camera = { eye: [0, -10, 0], target: [0, 0, 0], up: [0, 0, 1], fieldOfView: Math.PI / 2 } as const;

  it('is where the camera sees it, from the left and the top', () => {
    const size = { width: 400, height: 200 };
    const at = projectPlace(camera, [5, 0, 5], size)!;
    expect(at[0]).to.be.closeTo(250, 1e-9);
    expect(at[1]).to.be.closeTo(50, 1e-9);
    expect(projectPlace(camera, [0, -11, 0], size)).to.equal(null);
  });
});

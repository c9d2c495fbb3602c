import { expect } from '@esm-bundle/chai';
import { ctSlice, dicomBytes, pixelFields } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { decodeFields, decodeSeries } from '../../../helpers/dicom-series.ts';
import type { Scan } from '../../../helpers/dicom-series.ts';
import { expectError, valuesOf } from '../../../helpers/decode.ts';
import { transformPoint } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';

/** Each slice has its own numbers, from 100 times its place on. */
const slice = (place: number, z: number, fields: DicomFields = {}): DicomFields => ctSlice(z, fields, 100 * place);
const firstOfSlices = ({ grid: { dimensions }, ...volume }: Scan): number[] =>
  Array.from({ length: dimensions[2] }, (_, k) => valuesOf({ ...volume, grid: null! })[12 * k] + 1024);
const at = ({ grid }: Scan, point: Vector3): number[] =>
  transformPoint(grid.indexToWorld, point).map((x) => Number(x.toFixed(9)));

describe('slices of DICOM', () => {
  it('are sorted by their places, whatever their names and numbers', async () => {
    const volume = await decodeFields([
      slice(3, 10, { InstanceNumber: '1' }),
      slice(1, 0, { InstanceNumber: '2' }),
      slice(2, 5, { InstanceNumber: '3' }),
    ]);
    expect(firstOfSlices(volume)).to.deep.equal([100, 200, 300]);
    expect(volume.grid.spacing).to.deep.equal([0.5, 0.75, 5]);
    expect(volume.left).to.equal(undefined);
    expect(volume.anatomical).to.equal(true);
  });

  it('have the world of the patient: to the right, to the front, to the head', async () => {
    const volume = await decodeFields([slice(1, 7), slice(2, 12)]);
    expect(at(volume, [0, 0, 0])).to.deep.equal([10, 20, 7]);
    expect(at(volume, [3, 2, 1])).to.deep.equal([10 - 1.5, 20 - 1.5, 12]);
  });

  it('are sheared where the gantry was tilted, and keep every value', async () => {
    // 20 degrees about the left-right axis: rows go to the left, columns to the back and up; the table moves along z.
    const tilt = { ImageOrientationPatient: [1, 0, 0, 0, 0.9396926, 0.3420201] };
    const volume = await decodeFields([0, 5, 10, 15].map((z, k) => slice(k, z, tilt)));
    expect(volume.left).to.equal(undefined);
    expect(firstOfSlices(volume)).to.deep.equal([0, 100, 200, 300]);
    for (const [k, z] of [0, 5, 10, 15].entries()) expect(at(volume, [0, 0, k])).to.deep.equal([10, 20, z]);
    const [along, down] = [at(volume, [0, 0, 1]), at(volume, [0, 1, 0])].map((p) =>
      p.map((x, i) => x - [10, 20, 0][i]),
    );
    expect(along[1] * down[1] + along[2] * down[2], 'the axes are oblique').to.be.closeTo(5 * 0.75 * 0.3420201, 1e-6);
  });

  it('that are missing are no data', async () => {
    const volume = await decodeFields([0, 5, 15, 20, 25].map((z, k) => slice(k, z)));
    expect(firstOfSlices(volume)).to.deep.equal([0, 100, NaN, 200, 300, 400]);
    expect(volume.grid.spacing[2]).to.equal(5);
    expect(volume.left).to.deep.equal(['1 of 6 slices are missing between the others, and shown as no data']);
  });

  it('up to 2 % away from their places are even', async () => {
    const volume = await decodeFields([0, 5.07, 9.95, 15].map((z, k) => slice(k, z)));
    expect(volume.grid.spacing[2]).to.equal(5);
    expect(volume.left).to.equal(undefined);
    expect(firstOfSlices(volume)).to.deep.equal([0, 100, 200, 300]);
  });

  it('at uneven distances are computed between those that are there, and this is said', async () => {
    const volume = await decodeFields([0, 2, 5, 10].map((z, k) => slice(k, z)));
    expect(volume.grid.dimensions[2]).to.equal(6);
    expect(volume.grid.spacing[2]).to.equal(2);
    const expected = [0, 2, 4, 6, 8, 10].map(
      (z) => 100 * (z <= 2 ? z / 2 : z <= 5 ? 1 + (z - 2) / 3 : 2 + (z - 5) / 5),
    );
    firstOfSlices(volume).forEach((value, k) => expect(value).to.be.closeTo(expected[k], 1e-3));
    expect(volume.left?.join()).to.contain('2 to 5 mm apart').and.to.contain('6 slices');
  });

  it('that are thicker where they lie further apart are no gaps', async () => {
    const files = (thickness: readonly number[]) =>
      [0, 5, 10, 20, 30].map((z, k) => slice(k, z, { SliceThickness: [thickness[k]] }));
    const volume = await decodeFields(files([5, 5, 5, 10, 10]));
    expect(volume.grid.spacing[2]).to.equal(5);
    firstOfSlices(volume).forEach((value, k) =>
      expect(value, `slice ${k}`).to.be.closeTo([0, 100, 200, 250, 300, 350, 400][k], 1e-3),
    );
    expect(volume.left).to.deep.equal([
      'the slices are 5 to 10 mm apart: values are computed between them (linearly) for 7 slices 5 mm apart',
    ]);
    // Of slices that are too thin, and of those of a scan with overlaps, some are missing.
    for (const thickness of [[5, 5, 5, 8, 8], Array<number>(5).fill(10)]) {
      const gaps = await decodeFields(files(thickness));
      expect(firstOfSlices(gaps)).to.deep.equal([0, 100, 200, NaN, 300, NaN, 400]);
      expect(gaps.left!.join()).to.contain('2 of 7 slices are missing');
    }
  });

  // Two slabs of 5 mm slices, 88 mm from each other: nothing was measured between them.
  it('far apart, as two slabs, have no data between them', async () => {
    const files = [0, 5, 10, 98, 103, 108].map((z, k) => slice(k, z));
    const volume = await decodeFields(files);
    const { dimensions, spacing } = volume.grid;
    const places = Array.from({ length: dimensions[2] }, (_, k) => k * spacing[2]);
    expect(spacing[2]).to.be.closeTo(5, 0.15);
    expect(at(volume, [0, 0, dimensions[2] - 1])[2]).to.equal(108);
    const expected = places.map((z) =>
      z <= 10 ? 20 * z : z <= 12.5 ? 200 : z < 95.5 ? NaN : z <= 98 ? 300 : 300 + 20 * (z - 98),
    );
    firstOfSlices(volume).forEach((value, k) =>
      Number.isNaN(expected[k])
        ? expect(value, `${places[k]} mm`).to.deep.equal(NaN)
        : expect(value, `${places[k]} mm`).to.be.closeTo(expected[k], 1e-3),
    );
    expect(volume.left!.join()).to.contain('are 5 mm apart').and.to.contain('a gap of 88 mm between the slices');
    // Each detail of the slabs is there, however far they lie apart.
    expect(
      (
        await decodeFields(
          files.map((one, k) => ({ ...one, ...(k > 2 ? { ImagePositionPatient: [-10, -20, 72.3 + 5 * k] } : {}) })),
        )
      ).grid.spacing[2],
    ).to.be.closeTo(5, 0.2);
    const far = await expectError(decodeFields([0, 5, 10, 1003.3, 1008.3].map((z, k) => slice(k, z))));
    expect(far.message).to.contain('are missing between the others');
  });

  it('between two gaps are shown, and none of the steps is made longer for them', async () => {
    const thin = { SliceThickness: [1] };
    const files = async (places: readonly number[]): Promise<Scan> =>
      decodeFields(places.map((z, k) => slice(k, z, thin)));
    const alone = await files([0, 1, 2, 3, 5.7, 9.4, 10.4, 11.4]);
    expect(firstOfSlices(alone)).to.include(400);
    const steps = await files([0, 3, 6, 9.5, 13, 30, 33]);
    expect(steps.grid.spacing[2]).to.equal(3);
  });

  it('of two scans that lie between each other have no gaps', async () => {
    for (const thickness of [undefined, [5]]) {
      const files = [0, 1, 5, 6, 10, 11, 15, 16].map((z, k) =>
        slice(k, z + (k % 2) / 3, { SliceThickness: thickness }),
      );
      expect(firstOfSlices(await decodeFields(files)).some(Number.isNaN)).to.equal(false);
    }
  });

  it('of an uneven stack of which one is lost are computed between the others', async () => {
    const volume = await decodeFields([0, 4.8, 10, 20.2, 25].map((z, k) => slice(k, z)));
    expect(firstOfSlices(volume).some(Number.isNaN)).to.equal(false);
  });

  describe('of several stacks in one file', () => {
    /** @param frames - of each the name of its stack and its place */
    const file = (frames: readonly (readonly [stack: string, position: readonly number[]])[]): DicomFields => ({
      ...slice(0, 0),
      ImagePositionPatient: undefined,
      ImageOrientationPatient: undefined,
      NumberOfFrames: String(frames.length),
      PixelData: new Uint8Array(new Uint16Array(12 * frames.length).buffer),
      SharedFunctionalGroupsSequence: [{ PlaneOrientationSequence: [{ ImageOrientationPatient: [1, 0, 0, 0, 1, 0] }] }],
      PerFrameFunctionalGroupsSequence: frames.map(([stack, position]) => ({
        FrameContentSequence: [{ StackID: stack }],
        PlanePositionSequence: [{ ImagePositionPatient: position }],
      })),
    });
    const depthOf = async (...frames: Parameters<typeof file>[0]) => {
      const { grid, left } = await decodeFields([file(frames)]);
      return [grid.dimensions[2], left?.join().slice(0, 14)];
    };

    it('are volumes of their own where they lie apart', async () => {
      expect(
        await depthOf(['1', [0, 0, 0]], ['1', [0, 0, 3]], ['1', [0, 0, 6]], ['2', [50, 0, 1]], ['2', [50, 0, 8]]),
      ).to.deep.equal([3, 'another series']);
    });

    it('are one volume where they continue each other, or have a frame each', async () => {
      for (const names of ['1122', '1234', '1212'])
        expect(await depthOf(...Array.from(names, (name, k) => [name, [0, 0, 3 * k]] as const)), names).to.deep.equal([
          4,
          undefined,
        ]);
    });
  });

  it('far from each other are refused in words', async () => {
    const error = await expectError(decodeFields([0, 5, 1e7].map((z, k) => slice(k, z))));
    expect(error.code).to.equal('format/corrupt');
    expect(error.message).to.contain('10,000,000 mm').and.to.contain('3 slices');
  });

  it('of other kinds say the size of their pixels elsewhere, or no more than a ratio', async () => {
    const none = { PixelSpacing: undefined, SliceThickness: undefined };
    // PS3.3, C.7.6.3.1.7: height and width of a pixel.
    const ratio = await decodeFields([slice(1, 0, { ...none, PixelAspectRatio: [3, 2] })]);
    expect(ratio.grid.spacing.slice(0, 2)).to.deep.equal([1, 1.5]);
    expect(ratio.left).to.deep.equal(['the size of a pixel, which the file does not say: 1 mm is taken']);
    // A scanned film, and a picture of a treatment beam.
    for (const fields of [{ NominalScannedPixelSpacing: [0.2, 0.1] }, { ImagePlanePixelSpacing: [0.2, 0.1] }]) {
      const volume = await decodeFields([slice(1, 0, { ...none, ...fields })]);
      expect(volume.grid.spacing.slice(0, 2)).to.deep.equal([0.1, 0.2]);
      expect(volume.left).to.equal(undefined);
    }
  });

  it('without places come in the order of their numbers', async () => {
    const none = { ImagePositionPatient: undefined, ImageOrientationPatient: undefined };
    const volume = await decodeFields([
      slice(2, 0, { ...none, InstanceNumber: '10' }),
      slice(1, 0, { ...none, InstanceNumber: '9' }),
    ]);
    expect(firstOfSlices(volume)).to.deep.equal([100, 200]);
    expect(volume.anatomical).to.equal(false);
    expect(volume.grid.spacing).to.deep.equal([0.5, 0.75, 5]);
    expect(volume.left?.join()).to.contain('where the slices lie').and.to.contain('5 mm');
  });
});

describe('files of several kinds', () => {
  it('are divided by series: the one with the most voxels is shown', async () => {
    const volume = await decodeFields([
      slice(9, 0, { SeriesInstanceUID: '9.9' }),
      ...[0, 5, 10].map((z, k) => slice(k, z)),
      slice(9, 5, { SeriesInstanceUID: '9.9' }),
    ]);
    expect(firstOfSlices(volume)).to.deep.equal([0, 100, 200]);
    expect(volume.left).to.deep.equal([
      'another series, or a part of another orientation or size, with 2 pictures: the one with the most voxels is shown',
    ]);
  });

  for (const [what, other] of [
    ['orientation', { ImageOrientationPatient: [0, 1, 0, 0, 0, -1] }],
    ['pixel spacing', { PixelSpacing: [0.75, 0.6] }],
    ['size', pixelFields(new Uint16Array(16))],
  ] as const) {
    it(`are divided by ${what}`, async () => {
      const volume = await decodeFields([...[0, 5, 10].map((z, k) => slice(k, z)), slice(9, 2, other)]);
      expect(firstOfSlices(volume)).to.deep.equal([0, 100, 200]);
      expect(volume.left?.join()).to.contain('1 picture');
    });
  }

  it('leave localizers out', async () => {
    const localizer = { ImageType: 'ORIGINAL\\PRIMARY\\LOCALIZER' };
    const volume = await decodeFields([
      ...[0, 5].map((z, k) => slice(k, z)),
      ...[0, 1, 2, 3].map((z) => slice(9, z, localizer)),
    ]);
    expect(firstOfSlices(volume)).to.deep.equal([0, 100]);
    expect(volume.left).to.deep.equal(['4 pictures that only show where the slices lie (LOCALIZER)']);
  });

  it('of one place are one of each, and what differs is said', async () => {
    const volume = await decodeFields(
      [0, 5].flatMap((z, k) => [
        slice(k, z, { EchoTime: [80], TriggerTime: [z] }),
        slice(5 + k, z, { EchoTime: [20], TriggerTime: [z] }),
      ]),
    );
    expect(firstOfSlices(volume)).to.deep.equal([500, 600]);
    expect(volume.left).to.deep.equal([
      'up to 2 pictures at each place, which differ in: echo time. One of them is shown',
    ]);
  });

  it('that are there twice are one', async () => {
    const volume = await decodeFields([slice(0, 0), slice(1, 5), slice(1, 5)]);
    expect(firstOfSlices(volume)).to.deep.equal([0, 100]);
  });

  it('leave out reports and pictures in colours, and say so', async () => {
    const report = dicomBytes({ Modality: 'SR', SeriesInstanceUID: '5' });
    const colours = dicomBytes(slice(0, 3, { PhotometricInterpretation: 'RGB', SamplesPerPixel: [3] }));
    const volume = await decodeSeries([report, ...[0, 5].map((z, k) => dicomBytes(slice(k, z))), colours]);
    expect(firstOfSlices(volume)).to.deep.equal([0, 100]);
    expect(volume.left).to.have.length(2);
    expect(volume.left![0]).to.contain('1 file of 4').and.to.contain('file 4 of 4 is in colours (RGB)');
    expect(volume.left![1]).to.contain('1 file of 4 without a picture');
  });

  it('are refused in words where all are', async () => {
    const colours = await expectError(decodeFields([slice(0, 3, { PhotometricInterpretation: 'PALETTE COLOR' })]));
    expect(colours.message).to.contain('in colours (PALETTE COLOR)').and.to.contain('gray');
    const report = await expectError(decodeFields([{ Modality: 'SR' }, { Modality: 'SR' }]));
    expect(report.code).to.equal('format/unsupported');
    expect(report.message).to.contain('the 2 DICOM files hold no picture').and.to.contain('DICOMDIR');
  });
});

describe('files with several frames', () => {
  const all = pixelFields(Uint16Array.from({ length: 36 }, (_, i) => 100 * Math.floor(i / 12)));
  const frames = { ...all, Rows: [3], NumberOfFrames: '3' };
  const places = [10, 0, 5];
  const enhanced: DicomFields = {
    ...slice(0, 0, frames),
    ImagePositionPatient: undefined,
    ImageOrientationPatient: undefined,
    PixelSpacing: undefined,
    RescaleSlope: undefined,
    RescaleIntercept: undefined,
    Modality: 'MR',
    SharedFunctionalGroupsSequence: [
      {
        PlaneOrientationSequence: [{ ImageOrientationPatient: [1, 0, 0, 0, 1, 0] }],
        PixelMeasuresSequence: [{ PixelSpacing: [2, 1], SliceThickness: [4], SpacingBetweenSlices: [5] }],
      },
    ],
    PerFrameFunctionalGroupsSequence: places.map((z, i) => ({
      FrameContentSequence: [{ TemporalPositionIndex: [1] }],
      PlanePositionSequence: [{ ImagePositionPatient: [-1, -2, z] }],
      PixelValueTransformationSequence: [{ RescaleIntercept: [i], RescaleSlope: [1], RescaleType: 'US' }],
    })),
  };

  for (const [what, form] of [
    ['explicit', {}],
    ['explicit with marks', { hasMarks: true }],
    ['implicit', { isImplicit: true }],
    ['implicit with marks', { isImplicit: true, hasMarks: true }],
    ['deflated', { isDeflated: true, hasMarks: true }],
  ] as const) {
    it(`have the place and the scale of each frame (${what})`, async () => {
      const volume = await decodeFields([enhanced], form);
      expect(valuesOf(volume).filter((_, i) => i % 12 === 0)).to.deep.equal([101, 202, 0]);
      expect(volume.grid.spacing).to.deep.equal([1, 2, 5]);
      expect(at(volume, [0, 0, 0])).to.deep.equal([1, 2, 0]);
      expect(volume.left).to.equal(undefined);
    });
  }

  it('of several times are those of the first one', async () => {
    const times = [0, 0, 5].map((z, i) => ({
      FrameContentSequence: [{ TemporalPositionIndex: [[2], [1], [1]][i] }],
      PlanePositionSequence: [{ ImagePositionPatient: [-1, -2, z] }],
    }));
    const volume = await decodeFields([{ ...enhanced, PerFrameFunctionalGroupsSequence: times }]);
    expect(valuesOf(volume).filter((_, i) => i % 12 === 0)).to.deep.equal([100, 200]);
    expect(volume.left).to.deep.equal([
      'up to 2 pictures at each place, which differ in: position in time. One of them is shown',
    ]);
  });

  it('of a dose lie where its offsets say, in gray', async () => {
    const dose: DicomFields = {
      ...slice(0, 7, frames),
      Modality: 'RTDOSE',
      DoseUnits: 'GY',
      DoseGridScaling: '0.25',
      RescaleSlope: undefined,
      RescaleIntercept: undefined,
      GridFrameOffsetVector: [0, 2.5, 5],
    };
    const volume = await decodeFields([dose]);
    expect(volume.unit).to.equal('Gy');
    expect(valuesOf(volume).filter((_, i) => i % 12 === 0)).to.deep.equal([0, 25, 50]);
    expect(at(volume, [0, 0, 2])).to.deep.equal([10, 20, 12]);
  });

  // PS3.3, C.8.8.3.2: a) offsets along the normal, b) z of each frame. Rows run to the right, or columns to the front: the normal points
  // to the feet.
  for (const [what, orientation, offsets, z] of [
    ['along the normal', [1, 0, 0, 0, 1, 0], [0, 2.5, 5], [7, 9.5, 12]],
    ['along a normal to the feet', [1, 0, 0, 0, -1, 0], [0, 2.5, 5], [7, 4.5, 2]],
    ['against the normal', [1, 0, 0, 0, 1, 0], [0, -2.5, -5], [7, 4.5, 2]],
    ['heights', [1, 0, 0, 0, 1, 0], [7, 9.5, 12], [7, 9.5, 12]],
    ['heights, with a normal to the feet', [1, 0, 0, 0, -1, 0], [7, 9.5, 12], [7, 9.5, 12]],
    ['heights, of a patient who lies on the belly', [-1, 0, 0, 0, -1, 0], [7, 9.5, 12], [7, 9.5, 12]],
    ['heights downwards, with a normal to the feet', [-1, 0, 0, 0, 1, 0], [7, 4.5, 2], [7, 4.5, 2]],
  ] as const)
    it(`of a dose lie where its offsets say: ${what}`, async () => {
      const volume = await decodeFields([
        {
          ...slice(0, 7, frames),
          Modality: 'RTDOSE',
          DoseGridScaling: '1',
          RescaleSlope: undefined,
          RescaleIntercept: undefined,
          ImageOrientationPatient: orientation,
          GridFrameOffsetVector: offsets,
        },
      ]);
      // Frames have 0, 100 and 200; slices come in ascending order along the normal.
      const shown = valuesOf(volume).filter((_, i) => i % 12 === 0);
      const found = [0, 100, 200].map((value) => at(volume, [0, 0, shown.indexOf(value)])[2]);
      expect(found).to.deep.equal(z);
    });

  it('as tiles of a mosaic are slices around the middle of the picture', async () => {
    // 2 x 2 tiles of 4 x 3 pixels, of which 3 are used.
    const tiles = Uint16Array.from({ length: 48 }, (_, i) => 10 * (2 * Math.floor(i / 24) + ((i % 8) >> 2)));
    const fields: DicomFields = {
      ...slice(0, 7, pixelFields(tiles)),
      Columns: [8],
      Rows: [6],
      Modality: 'MR',
      ImageType: 'ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC',
      NumberOfImagesInMosaic: [3],
      SpacingBetweenSlices: [4],
    };
    const volume = await decodeFields([fields]);
    expect(volume.grid.dimensions).to.deep.equal([4, 3, 3]);
    expect(firstOfSlices(volume)).to.deep.equal([0, 10, 20]);
    expect(at(volume, [0, 0, 0])).to.deep.equal([10 - 0.5 * 2, 20 - 0.75 * 1.5, 7]);
    expect(at(volume, [0, 0, 2])[2]).to.equal(15);
  });

  // dcm2niix 1.0.20260724 puts the first pixels of the tiles at these places, for files with the same numbers.
  const normal = [-0.18597052, 0.18063714, 0.96580808];
  for (const [what, sign, second] of [
    ['up', 1, [22.9045, 23.6133, -6.4663]],
    ['down', -1, [21.0448, 25.4197, -16.1244]],
  ] as const) {
    it(`as tiles of a mosaic run ${what} where the header of Siemens says so`, async () => {
      const tiles = Uint16Array.from({ length: 1024 }, (_, i) => 2 * Math.floor(i / 512) + ((i % 32) >> 4));
      const fields: DicomFields = {
        ...slice(0, 0, pixelFields(tiles)),
        Modality: 'MR',
        RescaleSlope: undefined,
        RescaleIntercept: undefined,
        ImageType: 'ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC',
        Rows: [32],
        Columns: [32],
        PixelSpacing: [3, 2.5],
        SpacingBetweenSlices: [5],
        ImagePositionPatient: [-40, -50, -10],
        ImageOrientationPatient: [0.98034318, 0.10003502, 0.17005953, -0.06589557, 0.97844941, -0.19568988],
        SiemensImageHeader: siemensHeader({
          NumberOfImagesInMosaic: ['3'],
          SliceNormalVector: normal.map((x) => (sign * x).toFixed(8)),
        }),
      };
      const volume = await decodeFields([fields]);
      expect(volume.grid.dimensions).to.deep.equal([16, 16, 3]);
      const values = valuesOf(volume);
      for (const [value, place] of [
        [0, [21.9746, 24.5165, -11.2954]],
        [1, second],
      ] as const) {
        const k = values.indexOf(value) / 256;
        transformPoint(volume.grid.indexToWorld, [0, 0, k]).forEach((x, axis) =>
          expect(x).to.be.closeTo(place[axis], 1e-4),
        );
      }
    });
  }
});

/** The header of Siemens' scanners: fields of texts. */
function siemensHeader(fields: Readonly<Record<string, readonly string[]>>): Uint8Array {
  const number = (value: number): number[] => [value & 0xff, value >> 8, 0, 0];
  const padded = (text: string, bytes: number): number[] =>
    Array.from({ length: bytes }, (_, i) => (i < text.length ? text.charCodeAt(i) : 0));
  const written = Object.entries(fields).flatMap(([name, values]) => [
    ...padded(name, 64),
    ...[1, 0, 0, values.length, 77].flatMap(number),
    ...values.flatMap((text) => [
      ...[text.length, text.length, 77, text.length].flatMap(number),
      ...padded(text, 4 * Math.ceil(text.length / 4)),
    ]),
  ]);
  return Uint8Array.from([
    ...padded('SV10', 4),
    ...[4, 3, 2, 1],
    ...number(Object.keys(fields).length),
    ...number(77),
    ...written,
  ]);
}

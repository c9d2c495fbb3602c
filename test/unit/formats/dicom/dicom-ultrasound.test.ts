// Ultrasound: volumes whose places are those of a probe, and the size of pixels that is said of parts of a picture.
import { expect } from '@esm-bundle/chai';
import { dicomBytes, pixelFields } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { valuesOf } from '../../../helpers/decode.ts';
import { decodeFields } from '../../../helpers/dicom-series.ts';
import { openScans } from '../../../helpers/scans-of.ts';

/** Two times of three slices and two kinds of data; the first number of a frame is 100 t + 10 k + 1, and of flow 500 more. */
function volumeFields(fields: (time: number, slice: number) => DicomFields = () => ({})): DicomFields {
  const frames = [0, 1].flatMap((t) => [2, 1, 0].flatMap((k) => [true, false].map((isFlow) => ({ t, k, isFlow }))));
  const numbers = frames.flatMap(({ t, k, isFlow }) =>
    Array.from({ length: 12 }, (_, i) => 100 * t + 10 * k + (isFlow ? 501 : 1) + (i % 3)),
  );
  return {
    SOPClassUID: '1.2.840.10008.5.1.4.1.1.6.2',
    SeriesInstanceUID: '1.2.3',
    Modality: 'US',
    DimensionOrganizationType: '3D_TEMPORAL',
    NumberOfFrames: String(frames.length),
    ...pixelFields(Uint16Array.from(numbers)),
    Rows: [3],
    SharedFunctionalGroupsSequence: [
      {
        PixelMeasuresSequence: [{ PixelSpacing: [0.75, 0.5], SliceThickness: [2] }],
        PlaneOrientationVolumeSequence: [{ ImageOrientationVolume: [1, 0, 0, 0, 1, 0] }],
      },
    ],
    PerFrameFunctionalGroupsSequence: frames.map(({ t, k, isFlow }) => ({
      PlanePositionVolumeSequence: [{ ImagePositionVolume: [-10, -20, 2 * k + 7] }],
      TemporalPositionSequence: [{ TemporalPositionTimeOffset: [0.25 * t] }],
      ImageDataTypeSequence: [{ DataType: isFlow ? 'FLOW_VELOCITY' : 'TISSUE_INTENSITY' }],
      ...fields(t, k),
    })),
  };
}

describe('ultrasound in three dimensions', () => {
  // PS3.3, C.7.6.16.2.21 and C.7.6.16.2.22: Plane Position (Volume), Plane Orientation (Volume).
  it('has its slices where they lie in its volume, and its times; tissue is shown', async () => {
    const { first, times, read } = await openScans(dicomBytes(volumeFields()), '1.dcm');
    expect(times).to.deep.equal(['0 s', '0.25 s']);
    expect(first.grid).to.deep.include({ dimensions: [4, 3, 3] });
    expect(first).to.have.property('anatomical', false);
    expect(first.left).to.deep.equal([
      'up to 4 pictures at each place, which differ in: kind of data. One of them is shown',
    ]);
    for (const t of [0, 1]) {
      const volume = await read(t);
      const firsts = valuesOf(volume).filter((_, i) => i % 12 === 0);
      expect(firsts).to.deep.equal([0, 1, 2].map((k) => 100 * t + 10 * k + 1));
    }
    const { indexToWorld } = (await decodeFields([volumeFields()])).grid;
    expect(indexToWorld.map((value) => value + 0)).to.deep.equal([
      -0.5, 0, 0, 10, 0, -0.75, 0, 20, 0, 0, 2, 7, 0, 0, 0, 1,
    ]);
  });

  it('has the places of the patient where it says them', async () => {
    const fields = volumeFields((_t, k) => ({
      PlanePositionSequence: [{ ImagePositionPatient: [0, 0, 5 * k] }],
      PlaneOrientationSequence: [{ ImageOrientationPatient: [1, 0, 0, 0, 1, 0] }],
    }));
    const volume = await decodeFields([fields]);
    expect([volume.grid.indexToWorld[10], volume.grid.indexToWorld[11]]).to.deep.equal([5, 0]);
    expect(volume).to.have.property('anatomical', true);
  });
});

describe('the size of pixels of ultrasound', () => {
  const region: DicomFields = {
    RegionSpatialFormat: [1],
    RegionLocationMaxX1: [3],
    RegionLocationMaxY1: [2],
    PhysicalUnitsXDirection: [3],
    PhysicalUnitsYDirection: [3],
    PhysicalDeltaX: [0.05],
    PhysicalDeltaY: [0.0375],
  };
  const spacingOf = async (...regions: readonly DicomFields[]): Promise<readonly number[] | null> => {
    const { grid, left = [] } = await decodeFields([
      {
        SOPClassUID: '1.2.840.10008.5.1.4.1.1.6.1',
        SeriesInstanceUID: '1.2.3',
        Modality: 'US',
        ...pixelFields(Uint16Array.from({ length: 12 }, (_, i) => i)),
        Rows: [3],
        SequenceOfUltrasoundRegions: regions,
      },
    ]);
    if (left.join().includes('the size of a pixel, which the file does not say')) return null;
    return [-grid.indexToWorld[0], -grid.indexToWorld[5]];
  };

  // Centimetres for a pixel: PS3.3, C.8.5.5.1.15 to C.8.5.5.1.18.
  it('is that of its regions in centimetres', async () => {
    expect(await spacingOf(region)).to.deep.equal([0.5, 0.375]);
    // A spectrum: seconds, and centimetres for a second.
    const spectrum = { ...region, RegionSpatialFormat: [3], PhysicalUnitsXDirection: [4], PhysicalDeltaX: [0.001] };
    expect(await spacingOf(spectrum, region, region)).to.deep.equal([0.5, 0.375]);
  });

  it('is not known where regions differ, are in other units, or lie outside the picture', async () => {
    expect(await spacingOf(region, { ...region, PhysicalDeltaX: [0.1] })).to.equal(null);
    expect(await spacingOf({ ...region, PhysicalUnitsXDirection: [4] })).to.equal(null);
    expect(await spacingOf({ ...region, RegionLocationMaxX1: [9] })).to.equal(null);
    expect(await spacingOf({ ...region, PhysicalDeltaY: undefined })).to.equal(null);
    expect(await spacingOf()).to.equal(null);
  });
});

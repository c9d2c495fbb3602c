// Frames that are no slices of a volume: times of a film, views of a camera, projections.
import { expect } from '@esm-bundle/chai';
import { colorSliceStops, sliceStops } from '../../../../src/volume/slice-stops.ts';
import { rgbOf } from '../../../helpers/channels.ts';
import { dicomBytes, pixelFields } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields, DicomForm } from '../../../helpers/dicom-bytes.ts';
import { expectError, urlOf, valuesOf } from '../../../helpers/decode.ts';
import { decodeFields, decodeSeries } from '../../../helpers/dicom-series.ts';
import { openScans } from '../../../helpers/scans-of.ts';
import type { OpenScans } from '../../../helpers/scans-of.ts';

const classes = {
  nuclear: '1.2.840.10008.5.1.4.1.1.20',
  ultrasound: '1.2.840.10008.5.1.4.1.1.3.1',
  angiography: '1.2.840.10008.5.1.4.1.1.12.1',
  radiography: '1.2.840.10008.5.1.4.1.1.1',
  mr: '1.2.840.10008.5.1.4.1.1.4',
} as const;

/** A file of frames of 4 x 3 pixels, of which the first number of each is 10 times its number from 0, plus 1. */
const film = (frames: number, fields: DicomFields): DicomFields => ({
  SOPInstanceUID: '1.2.3.4',
  SeriesInstanceUID: '1.2.3',
  NumberOfFrames: String(frames),
  PixelSpacing: [2, 2],
  ...pixelFields(Uint16Array.from({ length: 12 * frames }, (_, i) => 10 * Math.floor(i / 12) + 1 + (i % 12))),
  Rows: [3],
  ...fields,
});

async function open(files: readonly DicomFields[], form: DicomForm = {}): Promise<OpenScans> {
  const bytes = files.map((fields) => dicomBytes(fields, form));
  const urls = bytes.map((_, i) => urlOf(`${i + 1}.dcm`));
  return openScans(bytes[0].slice(), '1.dcm', {
    ...(files.length > 1 ? { files: urls } : {}),
    fetchFile: async (url) => ({ bytes: bytes[urls.indexOf(url)].slice(), url, contentType: '' }),
  });
}

/** The first number of each picture at its time, from 0; each is one slice. */
async function framesOf({ times, read }: OpenScans): Promise<number[]> {
  const frames: number[] = [];
  for (const i of times.keys()) {
    const volume = await read(i);
    expect(volume.grid).to.deep.include({ dimensions: [4, 3, 1] });
    frames.push((valuesOf(volume)[0] - 1) / 10);
  }
  return frames;
}

describe('frames of nuclear medicine', () => {
  const nuclear = (kind: string, frames: number, fields: DicomFields): DicomFields =>
    film(frames, {
      SOPClassUID: classes.nuclear,
      Modality: 'NM',
      ImageType: `ORIGINAL\\PRIMARY\\${kind}\\EMISSION`,
      ...fields,
    });

  // The example of PS3.3, C.8.4.8: two phases of five and two frames, from each of two detectors.
  const dynamic = nuclear('DYNAMIC', 14, {
    FrameIncrementPointer: [0x00540010, 0x00540020, 0x00540030, 0x00540100],
    EnergyWindowVector: Array<number>(14).fill(1),
    DetectorVector: [1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2],
    PhaseVector: [1, 1, 1, 1, 1, 2, 2, 1, 1, 1, 1, 1, 2, 2],
    TimeSliceVector: [1, 2, 3, 4, 5, 1, 2, 1, 2, 3, 4, 5, 1, 2],
    PhaseInformationSequence: [
      { PhaseDelay: '300', ActualFrameDuration: '1000', PauseBetweenFrames: '100', NumberOfFramesInPhase: [5] },
      { PhaseDelay: '500', ActualFrameDuration: '10000', PauseBetweenFrames: '2000', NumberOfFramesInPhase: [2] },
    ],
    DetectorInformationSequence: [
      { ImagePositionPatient: [0, 0, 100], ImageOrientationPatient: [1, 0, 0, 0, 0, -1] },
      { ImagePositionPatient: [0, 200, 100], ImageOrientationPatient: [-1, 0, 0, 0, 0, -1] },
    ],
  });

  it('of a dynamic study are times, with the pauses of its phases, of one detector', async () => {
    const opened = await open([dynamic]);
    expect(opened.times).to.deep.equal(['0 s', '1.1 s', '2.2 s', '3.3 s', '4.4 s', '5.9 s', '17.9 s']);
    expect(await framesOf(opened)).to.deep.equal([0, 1, 2, 3, 4, 5, 6]);
    expect(opened.first.left).to.deep.equal([
      'another series, or a part of another orientation, size, view or film, with 7 pictures: the one with the most voxels is shown',
    ]);
    expect(opened.first.series).to.have.length(2);
  });

  it('of another detector have its place, and are chosen by the number of the series', async () => {
    const volume = await decodeFields([dynamic]);
    const { indexToWorld } = volume.grid;
    expect([indexToWorld[0], indexToWorld[3] + 0, indexToWorld[7] + 0]).to.deep.equal([-2, 0, 0]);
    expect(volume.left!.join()).to.contain('7 pictures of other times or views, which are no slices of a volume');
    const other = await decodeSeries([dicomBytes(dynamic)], { series: 2 });
    expect(valuesOf(other)[0]).to.equal(71);
    expect([other.grid.indexToWorld[0], other.grid.indexToWorld[7]]).to.deep.equal([2, -200]);
  });

  it('of a gated study are parts of a heartbeat', async () => {
    const gated = nuclear('GATED', 3, {
      FrameIncrementPointer: [0x00540010, 0x00540020, 0x00540060, 0x00540070],
      EnergyWindowVector: [1, 1, 1],
      DetectorVector: [1, 1, 1],
      RRIntervalVector: [1, 1, 1],
      TimeSlotVector: [1, 2, 3],
      GatedInformationSequence: [{ DataInformationSequence: [{ FrameTime: '40' }] }],
    });
    const opened = await open([gated]);
    expect(opened.times).to.deep.equal(['0 s', '0.04 s', '0.08 s']);
    expect(await framesOf(opened)).to.deep.equal([0, 1, 2]);
  });

  for (const kind of ['STATIC', 'WHOLE BODY'])
    it(`of detectors and windows of energy are pictures of their own: ${kind}`, async () => {
      const fields = nuclear(kind, 4, {
        FrameIncrementPointer: [0x00540010, 0x00540020],
        EnergyWindowVector: [1, 1, 2, 2],
        DetectorVector: [1, 2, 1, 2],
      });
      const volume = await decodeFields([fields]);
      expect(volume.grid.dimensions).to.deep.equal([4, 3, 1]);
      expect(volume.series).to.have.length(4);
      for (const series of [1, 2, 3, 4])
        expect(valuesOf(await decodeSeries([dicomBytes(fields)], { series }))[0]).to.equal(10 * series - 9);
    });

  for (const kind of ['TOMO', 'GATED TOMO'])
    it(`of a camera that turned are projections, and have no place: ${kind}`, async () => {
      const fields = nuclear(kind, 3, {
        FrameIncrementPointer: [0x00540010, 0x00540020, 0x00540050, 0x00540090],
        EnergyWindowVector: [1, 1, 1],
        DetectorVector: [1, 1, 1],
        RotationVector: [1, 1, 1],
        AngularViewVector: [1, 2, 3],
        DetectorInformationSequence: [
          { ImagePositionPatient: [0, 0, 100], ImageOrientationPatient: [1, 0, 0, 0, 0, -1] },
        ],
      });
      const opened = await open([fields]);
      expect(opened.times).to.deep.equal([null, null, null]);
      expect(await framesOf(opened)).to.deep.equal([0, 1, 2]);
      expect(opened.first.left!.join()).to.match(/^projections from several sides .* are no slices/);
      expect(opened.first).to.have.property('anatomical', false);
    });

  it('that were reconstructed are slices, also where the kind of picture is missing', async () => {
    const sliced = {
      FrameIncrementPointer: [0x00540080],
      SliceVector: [1, 2, 3],
      SpacingBetweenSlices: [5],
    };
    for (const kind of ['RECON TOMO', 'RECON_TOMO', 'TOMO', '']) {
      const volume = await decodeFields([nuclear(kind, 3, sliced)]);
      expect(volume.grid.dimensions).to.deep.equal([4, 3, 3]);
    }
    // A list of slices to which nothing points; and a file that says no more than how far they are apart.
    const unpointed = { SliceVector: [1, 2, 3], SpacingBetweenSlices: [5] };
    const apart = { FrameIncrementPointer: [0x00540020], DetectorVector: [1, 1, 1], SpacingBetweenSlices: [5] };
    for (const fields of [nuclear('TOMO', 3, unpointed), nuclear('', 3, apart)])
      expect((await decodeFields([fields])).grid.dimensions).to.deep.equal([4, 3, 3]);
  });

  it('that were reconstructed of several detectors have the place of the first one, whatever the list says', async () => {
    for (const detector of [0, 2, 3]) {
      const volume = await decodeFields([
        nuclear('RECON TOMO', 3, {
          FrameIncrementPointer: [0x00540080],
          SliceVector: [1, 2, 3],
          DetectorVector: [detector, detector, detector],
          SpacingBetweenSlices: [5],
          DetectorInformationSequence: [
            { ImagePositionPatient: [0, 0, 100], ImageOrientationPatient: [1, 0, 0, 0, 1, 0] },
            {},
          ],
        }),
      ]);
      expect(volume.left, `${detector}`).to.equal(undefined);
      expect(volume.grid.indexToWorld[11], `${detector}`).to.equal(100);
    }
  });

  it('of several detectors are listed in no more time than those of one', async function () {
    this.timeout(5000);
    const frames = 10_000;
    const volume = await decodeFields([
      film(frames, {
        SOPClassUID: classes.nuclear,
        ImageType: 'ORIGINAL\\PRIMARY\\DYNAMIC\\EMISSION',
        DetectorVector: Array.from({ length: frames }, (_, i) => 1 + (i % 2)),
        DetectorInformationSequence: [{}, {}],
      }),
    ]);
    expect(volume.series).to.have.length(2);
  });
});

describe('frames of a film', () => {
  for (const [what, fields] of [
    ['ultrasound', { SOPClassUID: classes.ultrasound, Modality: 'US' }],
    ['angiography', { SOPClassUID: classes.angiography, Modality: 'XA' }],
    ['a heart in MR that has one place', { SOPClassUID: classes.mr, Modality: 'MR', ImagePositionPatient: [0, 0, 0] }],
    ['no known class', { Modality: 'OT' }],
  ] as const)
    it(`are times: ${what}`, async () => {
      const opened = await open([film(3, { ...fields, FrameIncrementPointer: [0x00181063], FrameTime: '33.5' })]);
      expect(opened.times).to.deep.equal(['0 s', '0.0335 s', '0.067 s']);
      expect(await framesOf(opened)).to.deep.equal([0, 1, 2]);
      expect(opened.first.left ?? []).to.deep.equal([]);
    });

  it('are times in colours, too', async () => {
    const rgb = Uint8Array.from({ length: 72 }, (_, i) => (37 * i) % 256);
    const fields = film(2, {
      SOPClassUID: classes.ultrasound,
      FrameIncrementPointer: [0x00181063],
      FrameTime: '40',
      SamplesPerPixel: [3],
      PhotometricInterpretation: 'RGB',
      PlanarConfiguration: [0],
      BitsAllocated: [8],
      BitsStored: [8],
      HighBit: [7],
      PixelData: rgb,
    });
    const { times, read } = await open([fields]);
    expect(times).to.deep.equal(['0 s', '0.04 s']);
    for (const i of [0, 1]) {
      const volume = await read(i);
      expect(rgbOf(volume)).to.deep.equal([...rgb.subarray(36 * i, 36 * (i + 1))]);
      // As they are: no gray multiplies them.
      expect(volume).to.deep.include({ transferFunction: colorSliceStops, window: [0, 255] });
    }
    // A time without colours is as bright as the others.
    const mixed = await open([{ ...fields, PixelData: rgb.map((value, i) => (i < 36 ? value : 40 + (i % 12))) }]);
    expect(await mixed.read(1)).to.deep.include({ transferFunction: sliceStops, window: [0, 255] });
  });

  it('of 8 bits are grays of a screen at all times', async () => {
    const gray = Uint8Array.from({ length: 24 }, (_, i) => 3 * i + (i < 12 ? 0 : 150));
    const { read } = await open([
      film(2, {
        SOPClassUID: classes.ultrasound,
        FrameIncrementPointer: [0x00181063],
        FrameTime: '40',
        BitsAllocated: [8],
        BitsStored: [8],
        HighBit: [7],
        PixelData: gray,
      }),
    ]);
    for (const i of [0, 1]) {
      const { transferFunction, window, isDiscrete } = await read(i);
      expect({ transferFunction, window, isDiscrete }).to.deep.equal({
        transferFunction: sliceStops,
        window: [0, 255],
        isDiscrete: undefined,
      });
    }
  });

  // Increments between frames, of which the first one is 0 (PS3.3, C.7.6.5.1.2).
  it('have the times of a list', async () => {
    const opened = await open([
      film(4, {
        SOPClassUID: classes.angiography,
        FrameIncrementPointer: [0x00181065],
        FrameTimeVector: [0, 500, 250, 1000],
      }),
    ]);
    expect(opened.times).to.deep.equal(['0 s', '0.5 s', '0.75 s', '1.75 s']);
  });

  it('are read in big endian, and where the class alone says what they are', async () => {
    const fields = film(2, { SOPClassUID: classes.ultrasound });
    expect((await open([fields])).times).to.deep.equal([null, null]);
    const frames = { ...fields, SOPClassUID: undefined, FrameIncrementPointer: [0x00181063], FrameTime: '10' };
    expect((await open([frames], { isBigEndian: true })).times).to.deep.equal(['0 s', '0.01 s']);
  });

  it('are times of an enhanced file, which says when each was measured', async () => {
    const fields = film(3, {
      SOPClassUID: '1.2.840.10008.5.1.4.1.1.12.1.1',
      PerFrameFunctionalGroupsSequence: [0, 1, 2].map((i) => ({
        FrameContentSequence: [{ FrameAcquisitionDateTime: `2020010112000${i}.5` }],
      })),
    });
    const opened = await open([fields]);
    expect(opened.times).to.deep.equal(['0 s', '1 s', '2 s']);
    expect(await framesOf(opened)).to.deep.equal([0, 1, 2]);
  });

  it('are pages of a document, which are no slices', async () => {
    const opened = await open([film(2, { FrameIncrementPointer: [0x00182001] })]);
    expect(await framesOf(opened)).to.deep.equal([0, 1]);
  });

  it('are one film for each file, and pictures of a series that are none are one after another', async () => {
    const cine = { SOPClassUID: classes.ultrasound, FrameIncrementPointer: [0x00181063], FrameTime: '10' };
    const [a, b] = [film(2, { ...cine, SOPInstanceUID: '1.1' }), film(3, { ...cine, SOPInstanceUID: '1.2' })];
    const two = await open([a, b]);
    expect(two.times).to.have.length(2);
    expect(two.first.series).to.have.length(2);
    const still = (number: string): DicomFields =>
      film(1, { SOPClassUID: classes.radiography, NumberOfFrames: undefined, InstanceNumber: number });
    const stills = await open([still('2'), still('1')]);
    expect(stills.times).to.deep.equal([null, null]);
    expect(stills.first.grid).to.deep.include({ dimensions: [4, 3, 1] });
  });

  it('are slices where the file says so, or nothing else', async () => {
    // Slice Location Vector, Spacing Between Slices; and a file without any pointer.
    for (const fields of [
      { FrameIncrementPointer: [0x00182005] },
      { SOPClassUID: classes.ultrasound, FrameIncrementPointer: [0x00180088] },
      {},
    ]) {
      const volume = await decodeFields([film(3, { ...fields, SpacingBetweenSlices: [3] })]);
      expect(volume.grid.dimensions).to.deep.equal([4, 3, 3]);
    }
    const slices = [0, 1].map((i) =>
      film(1, { SOPClassUID: classes.radiography, NumberOfFrames: undefined, SliceLocation: [5 * i] }),
    );
    expect((await decodeFields(slices)).grid.dimensions).to.deep.equal([4, 3, 2]);
    const empty = slices.map((fields) => ({ ...fields, SliceLocation: [] }));
    expect((await decodeFields(empty)).grid.dimensions).to.deep.equal([4, 3, 1]);
  });

  // Slices of a breast as X-ray pictures, or of an organ as ultrasound.
  it('are slices where they have a thickness, or a step, and no time', async () => {
    const fields = { SOPClassUID: classes.ultrasound, SpacingBetweenSlices: [3] };
    expect((await decodeFields([film(3, fields)])).grid.spacing[2]).to.equal(3);
    const films = { ...fields, FrameIncrementPointer: [0x00181063], FrameTime: '40' };
    expect((await decodeFields([film(3, films)])).grid.dimensions).to.deep.equal([4, 3, 1]);
    const slices = ['1', '2'].map((number) =>
      film(1, {
        SOPClassUID: classes.radiography,
        NumberOfFrames: undefined,
        InstanceNumber: number,
        SliceThickness: [1],
      }),
    );
    expect((await decodeFields(slices)).grid.dimensions).to.deep.equal([4, 3, 2]);
  });

  it('are slices where a program wrote a stack with places as a film', async () => {
    const fields = {
      FrameIncrementPointer: [0x00181063],
      FrameTime: '1',
      ImagePositionPatient: [0, 0, 7],
      ImageOrientationPatient: [1, 0, 0, 0, 1, 0],
      SpacingBetweenSlices: [3],
    };
    const dimensionsOf = async (more: DicomFields): Promise<readonly number[]> =>
      (await decodeFields([film(3, { ...fields, ...more })])).grid.dimensions;
    expect(await dimensionsOf({ Modality: 'CT' })).to.deep.equal([4, 3, 3]);
    // Films have that spacing, too.
    expect(await dimensionsOf({ Modality: 'MR', SOPClassUID: classes.mr })).to.deep.equal([4, 3, 1]);
    expect(await dimensionsOf({ Modality: 'XA', SOPClassUID: classes.angiography })).to.deep.equal([4, 3, 1]);
  });
});

describe('frames of one place', () => {
  it('that all of them share are times', async () => {
    const fields = film(3, {
      SOPClassUID: classes.mr,
      SpacingBetweenSlices: [3],
      SharedFunctionalGroupsSequence: [
        {
          PlanePositionSequence: [{ ImagePositionPatient: [0, 0, 7] }],
          PlaneOrientationSequence: [{ ImageOrientationPatient: [1, 0, 0, 0, 1, 0] }],
        },
      ],
      PerFrameFunctionalGroupsSequence: [1, 2, 3].map((at) => ({
        FrameContentSequence: [{ TemporalPositionIndex: [at] }],
      })),
    });
    const opened = await open([fields]);
    expect(opened.times).to.deep.equal([null, null, null]);
    expect(await framesOf(opened)).to.deep.equal([0, 1, 2]);
  });
});

describe('the tiles of a slide', () => {
  // VL Whole Slide Microscopy Image Storage, and a parametric map of a slide.
  for (const [what, fields] of [
    [
      'TILED_FULL',
      { DimensionOrganizationType: 'TILED_FULL', TotalPixelMatrixColumns: [8], TotalPixelMatrixRows: [5] },
    ],
    ['without that word', { TotalPixelMatrixColumns: [8], TotalPixelMatrixRows: [5] }],
    ['TILED_SPARSE', { DimensionOrganizationType: 'TILED_SPARSE' }],
  ] as const)
    it(`are refused, as they are no slices: ${what}`, async () => {
      const error = await expectError(
        decodeFields([film(4, { SOPClassUID: '1.2.840.10008.5.1.4.1.1.77.1.6', ...fields })]),
      );
      expect(error.code).to.equal('format/unsupported');
      expect(error.message).to.match(/in tiles, such as a slide of a microscope, and no volume/);
    });

  it('are a picture where there is one', async () => {
    const volume = await decodeFields([
      film(1, { DimensionOrganizationType: 'TILED_FULL', TotalPixelMatrixColumns: [4], TotalPixelMatrixRows: [3] }),
    ]);
    expect(volume.grid.dimensions).to.deep.equal([4, 3, 1]);
  });
});

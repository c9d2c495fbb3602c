// Series in which each place was measured several times: scans, with times from the first one on.
import { expect } from '@esm-bundle/chai';
import { ctSlice, dicomBytes } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { valuesOf } from '../../../helpers/decode.ts';
import { openScans } from '../../../helpers/scans-of.ts';
import type { OpenScans } from '../../../helpers/scans-of.ts';
import { urlOf } from '../../../helpers/decode.ts';
import { decodeFields } from '../../../helpers/dicom-series.ts';
import { findPhases } from '../../../../src/formats/dicom/find-phases.ts';
import type { Frame } from '../../../../src/formats/dicom/frame.ts';

const mr = { Modality: 'MR', RescaleIntercept: undefined, RescaleSlope: undefined, WindowCenter: undefined };

/** Opens files as a page does. @param index - the scan that is wanted */
async function open(files: readonly DicomFields[], index = 0): Promise<OpenScans> {
  const bytes = files.map((fields) => dicomBytes(fields));
  const urls = bytes.map((_, i) => urlOf(`${i + 1}.dcm`));
  return openScans(bytes[0].slice(), '1.dcm', {
    scan: { index },
    ...(files.length > 1 ? { files: urls } : {}),
    fetchFile: async (url) => ({ bytes: bytes[urls.indexOf(url)].slice(), url, contentType: '' }),
  });
}

/** Three slices at each of some times, in an order that files may have; the first number of a slice is 100 t + 10 k + 1. */
function series(
  count: number,
  fieldsOf: (time: number, slice: number) => DicomFields,
  common: DicomFields = mr,
): DicomFields[] {
  const all = [0, 1, 2].flatMap((k) =>
    Array.from({ length: count }, (_, t) => ctSlice(5 * k, { ...common, ...fieldsOf(t, k) }, 100 * t + 10 * k + 1)),
  );
  return all.map((_, i) => all[(7 * i) % all.length]);
}

async function expectTimes(files: readonly DicomFields[], times: readonly (string | null)[]): Promise<OpenScans> {
  const last = times.length - 1;
  const opened = await open(files, last);
  expect(opened.times).to.deep.equal(times);
  for (let t = 0; t <= last; t++) {
    const volume = await opened.read(t);
    const firsts = valuesOf(volume).filter((_, i) => i % 12 === 0);
    expect(firsts, `time ${t}`).to.deep.equal([0, 1, 2].map((k) => 100 * t + 10 * k + 1));
    expect(volume.format).to.equal(`DICOM, MR, volume ${t + 1} of ${times.length}`);
    expect(volume.grid).to.deep.equal(opened.first.grid);
    expect(volume.window).to.deep.equal(opened.first.window);
    if (t === last) expect(valuesOf(opened.first)).to.deep.equal(valuesOf(volume));
  }
  return opened;
}

describe('a DICOM series of several times', () => {
  it('has the seconds of trigger times, as of a beating heart', async () => {
    const { first } = await expectTimes(
      series(4, (t) => ({ TriggerTime: String(12.5 + 40 * t) })),
      ['0 s', '0.04 s', '0.08 s', '0.12 s'],
    );
    expect(first.left).to.equal(undefined);
  });

  it('has the seconds of the day from the first one on, whichever slice comes first, and no time of the day', async () => {
    // Of each time the last slice was measured first; the minute and the hour change.
    const files = series(3, (t, k) => ({
      AcquisitionTime: `1059${['57.25', '58.25', '59.25'][t]}`,
      InstanceNumber: String(3 * k + t),
    }));
    const { times } = await expectTimes(files, ['0 s', '1 s', '2 s']);
    expect(JSON.stringify(times)).not.to.contain('10');
    await expectTimes(
      series(3, (t, k) => ({ AcquisitionTime: ['105958', '105959.5', '110001'][t] + (t === 1 ? `${k}` : '') })),
      ['0 s', '1.5 s', '3 s'],
    );
  });

  it('has positions in time alone where nothing says when they were', async () => {
    const frames = [0, 0, 5, 5].map((z, i) => ({
      FrameContentSequence: [{ TemporalPositionIndex: [[2], [1], [1], [2]][i] }],
      PlanePositionSequence: [{ ImagePositionPatient: [-1, -2, z] }],
    }));
    const enhanced: DicomFields = {
      ...ctSlice(0, mr),
      ImagePositionPatient: undefined,
      NumberOfFrames: '4',
      PixelData: Uint8Array.from(
        new Uint8Array(Int16Array.from({ length: 48 }, (_, i) => 100 * Math.floor(i / 12) + 1).buffer),
      ),
      SharedFunctionalGroupsSequence: [
        {
          PlaneOrientationSequence: [{ ImageOrientationPatient: [1, 0, 0, 0, 1, 0] }],
          PixelMeasuresSequence: [{ PixelSpacing: [1, 1], SpacingBetweenSlices: '5' }],
        },
      ],
      PerFrameFunctionalGroupsSequence: frames,
    };
    const { times, read } = await open([enhanced]);
    expect(times).to.deep.equal([null, null]);
    const firsts = async (t: number): Promise<number[]> => valuesOf(await read(t)).filter((_, i) => i % 12 === 0);
    expect(await firsts(0)).to.deep.equal([101, 201]);
    expect(await firsts(1)).to.deep.equal([1, 301]);
  });

  it('has each time on its own scale, and one type where a time has no data', async () => {
    const files = series(2, (t) => ({
      TriggerTime: String(100 * t),
      RescaleSlope: ['1', '0.5'][t],
      RescaleIntercept: ['0', '-3'][t],
    }));
    const { read } = await open(files);
    expect(valuesOf(await read(0))[0]).to.equal(1);
    expect(valuesOf(await read(1))[0]).to.equal(0.5 * 101 - 3);
    const padded = series(2, (t) => ({ TriggerTime: String(100 * t), ...(t ? { PixelPaddingValue: [101] } : {}) }));
    const opened = await open(padded);
    expect(valuesOf(await opened.read(0))[0]).to.equal(1);
    expect(valuesOf(await opened.read(1))[0]).to.deep.equal(NaN);
    expect(valuesOf(await opened.read(1))[1]).to.equal(102);
  });

  it('of two echoes shows the times of one, and says so', async () => {
    const files = [10, 20].flatMap((echo) =>
      series(2, (t) => ({ TriggerTime: String(50 * t), EchoTime: String(echo) })),
    );
    const { times, first } = await open(files);
    expect(times).to.deep.equal(['0 s', '0.05 s']);
    expect(first.left).to.deep.equal([
      'up to 4 pictures at each place, which differ in: echo time. One of them is shown',
    ]);
  });

  for (const [what, fieldsOf, times] of [
    ['by positions in time', (t) => ({ TemporalPositionIdentifier: String(t + 1) }), [null, null]],
    ['by times that their slices share', (t) => ({ TriggerTime: String(50 * t) }), ['0 s', '0.05 s']],
    ['by times of their slices', (t, k) => ({ AcquisitionTime: `12000${t}.${k}` }), ['0 s', '1 s']],
    ['by the numbers of pictures', (t, k) => ({ InstanceNumber: String(3 * t + k + 1) }), [null, null]],
  ] as const satisfies readonly (readonly [
    string,
    (t: number, k: number) => DicomFields,
    readonly (string | null)[],
  ])[])
    it(`has the complete ones where the last one lacks slices, ${what}`, async () => {
      const all = [0, 1, 2].flatMap((t) =>
        [0, 1, 2].map((k) => ctSlice(5 * k, { ...mr, ...fieldsOf(t, k) }, 100 * t + 10 * k + 1)),
      );
      const { first } = await expectTimes(all.slice(0, -1), times);
      expect(first.left).to.deep.equal([
        '2 pictures of times in which some slices are missing: 2 complete times are shown',
      ]);
    });

  it('has the complete ones of as many slices as files have, in no time', () => {
    const frameAt = (time: number): Frame => ({ traits: new Map([['position in time', time]]) }) as unknown as Frame;
    const all = Array.from({ length: 20_000 }, (_, k) => (k > 0 ? [1, 2, 3] : [1, 2]).map(frameAt));
    const start = performance.now();
    expect(findPhases(all, ['position in time'])!.frames).to.have.length(2);
    expect(performance.now() - start).to.be.lessThan(1500);
  });

  it('has no time with a slice of another one, where one in the midst is missing', async () => {
    const all = (fieldsOf: (t: number, k: number) => DicomFields): DicomFields[] =>
      [0, 1, 2].flatMap((t) =>
        [0, 1, 2].map((k) => ctSlice(5 * k, { ...mr, ...fieldsOf(t, k) }, 100 * t + 10 * k + 1)),
      );
    // The first slice of the second time is missing. Times that slices share say which one that is.
    const shared = await open(
      all((t) => ({ TriggerTime: String(50 * t) })).filter((_, i) => i !== 3),
      1,
    );
    expect(shared.times).to.deep.equal(['0 s', '0.1 s']);
    expect(valuesOf(shared.first).filter((_, i) => i % 12 === 0)).to.deep.equal([201, 211, 221]);
    // Others do not: whichever slice is missing, also where they follow each other without a pause.
    for (const pause of [0.1, 1 / 3])
      for (const missing of [0, 1, 2, 3, 4, 5]) {
        const own = all((t, k) => ({ AcquisitionTime: `12000${(t + pause * k).toFixed(3)}` }));
        const { times, first } = await open(own.filter((_, i) => i !== missing));
        expect(times, `${missing}`).to.deep.equal([]);
        expect(first.left!.join()).to.contain('One of them is shown');
      }
  });

  it('is one volume where places have different numbers of times, or differ in what is no time', async () => {
    const uneven = series(2, (t) => ({ TriggerTime: String(50 * t) })).slice(1);
    for (const files of [uneven, series(2, (t) => ({ EchoTime: String(10 + t) }))]) {
      const { times, first } = await open(files);
      expect(times).to.deep.equal([]);
      expect(first.left!.join()).to.contain('One of them is shown');
    }
  });

  it('is one volume for labels, layers and panes, which want no scans', async () => {
    const files = series(2, (t) => ({ TriggerTime: String(50 * t) }));
    const { left } = await decodeFields(files);
    expect(left!.join()).to.contain('trigger time');
  });
});

/** One file of two times and three slices; the first number of a frame is 100 t + 10 k + 1. @param groupOf - what a frame says of itself */
function enhanced(groupOf: (time: number, slice: number) => DicomFields): DicomFields {
  const frames = [0, 1, 2].flatMap((k) => [1, 0].map((t) => ({ t, k })));
  const numbers = frames.flatMap(({ t, k }) => Array.from({ length: 12 }, (_, i) => 100 * t + 10 * k + 1 + i));
  return {
    ...ctSlice(0, mr),
    ImagePositionPatient: undefined,
    NumberOfFrames: '6',
    PixelData: new Uint8Array(Int16Array.from(numbers).buffer),
    SharedFunctionalGroupsSequence: [
      {
        PlaneOrientationSequence: [{ ImageOrientationPatient: [1, 0, 0, 0, 1, 0] }],
        PixelMeasuresSequence: [{ PixelSpacing: [1, 1] }],
      },
    ],
    PerFrameFunctionalGroupsSequence: frames.map(({ t, k }) => ({
      PlanePositionSequence: [{ ImagePositionPatient: [-1, -2, 5 * k] }],
      ...groupOf(t, k),
    })),
  };
}

describe('times of DICOM frames that say them in another way', () => {
  const content = (fields: DicomFields): DicomFields => ({ FrameContentSequence: [fields] });
  for (const [what, groupOf, times] of [
    [
      'how long after a heartbeat each was measured',
      (t) => ({ CardiacSynchronizationSequence: [{ NominalCardiacTriggerDelayTime: [40 * t] }] }),
      ['0 s', '0.04 s'],
    ],
    [
      'how long after the start each was measured',
      (t) => ({ TemporalPositionSequence: [{ TemporalPositionTimeOffset: [2.5 * t] }] }),
      ['0 s', '2.5 s'],
    ],
    [
      'which share of a heartbeat each is',
      (t) => ({ CardiacSynchronizationSequence: [{ NominalPercentageOfCardiacPhase: [50 * t] }] }),
      [null, null],
    ],
    [
      'date and time, over midnight',
      (t) => content({ FrameAcquisitionDateTime: ['20200131235958.5', '20200201000001+0100'][t] }),
      ['0 s', '2.5 s'],
    ],
    ['the number of the acquisition', (t) => content({ FrameAcquisitionNumber: [t + 1] }), [null, null]],
  ] as const satisfies readonly (readonly [string, (t: number) => DicomFields, readonly (string | null)[]])[])
    it(`of one file: ${what}`, async () => {
      await expectTimes([enhanced(groupOf)], times);
    });

  for (const [what, fieldsOf, times] of [
    ['date and time', (t) => ({ AcquisitionDateTime: `2020010112000${t}.5` }), ['0 s', '1 s']],
    ['the time of a frame of PET', (t) => ({ FrameReferenceTime: String(30_000 + 60_000 * t) }), ['0 s', '60 s']],
    ['which share of a heartbeat each is', (t) => ({ NominalPercentageOfCardiacPhase: [50 * t] }), [null, null]],
    ['when the content was made', (t, k) => ({ ContentTime: `1200${t}${k}.5` }), [null, null]],
    ['nothing but their numbers', (t, k) => ({ InstanceNumber: String(1 + 3 * t + k) }), [null, null]],
    [
      'dates and times, over midnight',
      (t) => ({ AcquisitionDate: `2020013${t}`, AcquisitionTime: ['235959', '000001'][t] }),
      ['0 s', '2 s'],
    ],
  ] as const satisfies readonly (readonly [
    string,
    (t: number, k: number) => DicomFields,
    readonly (string | null)[],
  ])[])
    it(`of several files: ${what}`, async () => {
      await expectTimes(series(2, fieldsOf), times);
    });

  it('are those of the trait in which all differ, where another one changes once', async () => {
    // As of a contrast agent, which is given after the first acquisition.
    const fieldsOf = (t: number): DicomFields => ({
      AcquisitionNumber: t > 0 ? '2' : '1',
      AcquisitionTime: `12000${t}`,
    });
    const { first } = await expectTimes(series(3, fieldsOf), ['0 s', '1 s', '2 s']);
    expect(first.left).to.equal(undefined);
  });

  it('are none where places have one slice each, whose times differ', async () => {
    const files = series(1, (_t, k) => ({
      AcquisitionTime: `12000${k}`,
      ContentTime: `12010${k}`,
      InstanceNumber: String(k + 1),
    }));
    const { times, first } = await open(files);
    expect([times, first.left]).to.deep.equal([[], undefined]);
  });

  it('are none of copies of one file', async () => {
    const files = series(2, () => ({ InstanceNumber: '1' }));
    const { times, first } = await open(files);
    expect(times).to.deep.equal([]);
    expect(first.left).to.deep.equal([
      'pictures at the place of another one, from which they do not differ by what they say',
    ]);
  });

  it('are none of magnitude and phase, of which the magnitude is shown', async () => {
    const { times, first } = await open([
      enhanced((t) => ({ MRImageFrameTypeSequence: [{ ComplexImageComponent: ['MAGNITUDE', 'PHASE'][t] }] })),
    ]);
    expect(times).to.deep.equal([]);
    expect(valuesOf(first).filter((_, i) => i % 12 === 0)).to.deep.equal([1, 11, 21]);
    expect(first.left!.join()).to.contain('differ in: part of complex numbers');
  });
});

describe('times of a gated SPECT', () => {
  /** Two times of three slices, whose first numbers are 100 t + 10 k + 1. */
  const gated = (fields: DicomFields): DicomFields => {
    const numbers = [0, 1].flatMap((t) =>
      [0, 1, 2].flatMap((k) => Array.from({ length: 12 }, (_, i) => 100 * t + 10 * k + 1 + i)),
    );
    return {
      ...ctSlice(0, { ...mr, Modality: 'NM' }),
      ImageType: 'ORIGINAL\\PRIMARY\\RECON GATED TOMO\\EMISSION',
      ImagePositionPatient: undefined,
      ImageOrientationPatient: undefined,
      NumberOfFrames: '6',
      SpacingBetweenSlices: [5],
      DetectorInformationSequence: [
        { ImagePositionPatient: [-10, -20, 0], ImageOrientationPatient: [1, 0, 0, 0, 1, 0] },
      ],
      SliceVector: [1, 2, 3, 1, 2, 3],
      PixelData: new Uint8Array(Int16Array.from(numbers).buffer),
      ...fields,
    };
  };
  const read = async (fields: DicomFields): Promise<number[][]> => {
    const opened = await open([gated(fields)]);
    expect(opened.times).to.deep.equal([null, null]);
    expect(opened.first.grid.dimensions).to.deep.equal([4, 3, 3]);
    const both = [await opened.read(0), await opened.read(1)];
    return both.map((volume) => valuesOf(volume).filter((_, i) => i % 12 === 0));
  };

  it('are the parts of a heartbeat, each with all slices', async () => {
    const expected = [
      [1, 11, 21],
      [101, 111, 121],
    ];
    expect(await read({ TimeSlotVector: [1, 1, 1, 2, 2, 2] })).to.deep.equal(expected);
    expect(await read({ TimeSliceVector: [1, 1, 1, 2, 2, 2] })).to.deep.equal(expected);
    expect(await read({ TimeSlotVector: [2, 2, 2, 1, 1, 1] })).to.deep.equal([expected[1], expected[0]]);
  });

  // The length of a part of a heartbeat, in milliseconds: PS3.3, C.8.4.13, Frame Time.
  it('have the seconds after a heartbeat where the file says how long its parts are', async () => {
    const opened = await open([
      gated({
        TimeSlotVector: [1, 1, 1, 2, 2, 2],
        GatedInformationSequence: [{ DataInformationSequence: [{ FrameTime: '62.5' }] }],
      }),
    ]);
    expect(opened.times).to.deep.equal(['0 s', '0.0625 s']);
  });

  it('are the frames in their order where the file says no more than their slices', async () => {
    expect(await read({ SliceVector: [3, 2, 1, 1, 2, 3] })).to.deep.equal([
      [21, 11, 1],
      [101, 111, 121],
    ]);
  });

  it('are none where the list of slices is of another length: then each frame is a slice', async () => {
    const { times, first } = await open([gated({ SliceVector: [1, 2, 3] })]);
    expect([times, first.grid.dimensions]).to.deep.equal([[], [4, 3, 6]]);
  });
});

// Series in which each place was measured several times: scans, with times from the first one on.
import { expect } from '@esm-bundle/chai';
import { ctSlice, dicomBytes } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { valuesOf } from '../../../helpers/decode.ts';
import { openScans } from '../../../helpers/scans-of.ts';
import type { OpenScans } from '../../../helpers/scans-of.ts';
import { urlOf } from '../../../helpers/decode.ts';
import { decodeFields } from '../../../helpers/dicom-series.ts';

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

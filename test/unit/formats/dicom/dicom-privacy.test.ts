// What a file says about a patient, and how it is called, is in no message, event or property.
import { expect } from '@esm-bundle/chai';
import { decodeHere } from '../../../../src/worker/decode-here.ts';
import { takeOrders } from '../../../../src/worker/take-orders.ts';
import type { WorkerScope } from '../../../../src/worker/take-orders.ts';
import type { WorkerReport } from '../../../../src/worker/worker-messages.ts';
import { ctSlice, dicomBytes } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields, DicomForm } from '../../../helpers/dicom-bytes.ts';
import { expectError, roomyLimits } from '../../../helpers/decode.ts';
import { pageOrigin } from '../../../helpers/fake-fetch.ts';

const [name, birth, number, uid, folder] = ['Geheim^Erna', '19010203', 'PID4711', '1.2.77.4711', 'Ordner_Geheim'];
const secrets = /geheim|erna|1901|4711|77\.|ordner/i;

/** A secret in every element that holds text, and in those that are meant to be codes. */
const planted: DicomFields = {
  StudyDate: birth,
  AccessionNumber: number,
  InstitutionName: name,
  ReferringPhysicianName: name,
  SeriesDescription: name,
  PatientName: name,
  PatientID: number,
  PatientBirthDate: birth,
  PatientComments: name,
  ImageComments: name,
  StudyInstanceUID: uid,
  SeriesInstanceUID: uid,
  SOPInstanceUID: uid,
};
const codes: DicomFields = {
  SOPClassUID: uid,
  ImageType: `ORIGINAL\\PRIMARY\\${name}`,
  Modality: name,
  RescaleType: name,
  WindowCenter: '40\\-600',
  WindowWidth: '400\\1500',
  WindowCenterWidthExplanation: `${name}\\LUNG ${name}`,
  VOILUTFunction: name,
  VOILUTSequence: [{ LUTDescriptor: [4, 0, 16], LUTExplanation: name, LUTData: Uint8Array.of(0, 0, 1, 0, 2, 0, 3, 0) }],
  Units: name,
  DoseUnits: name,
  BurnedInAnnotation: 'YES',
};
const base = 'https://local-1.invalid/';

/** Files as if a person had chosen a folder, called after a patient. */
function filesOf(all: readonly Uint8Array<ArrayBuffer>[]): File[] {
  return all.map((bytes, i) => {
    const file = new File([bytes], `${name}-${i}.dcm`);
    Object.defineProperty(file, 'webkitRelativePath', { value: `${folder}/${name}-${i}.dcm` });
    return file;
  });
}

/** All that a worker sends to its page, as text. */
async function listReports(files: readonly File[]): Promise<{ text: string; types: string[] }> {
  const reports: WorkerReport[] = [];
  let end = (): void => undefined;
  const ended = new Promise<void>((resolve) => (end = resolve));
  const scope: WorkerScope = {
    onmessage: null,
    postMessage: (report) => {
      if (report.type !== 'stopped') reports.push(report);
      if (['done', 'failed', 'needs-main-thread'].includes(report.type)) end();
    },
  };
  takeOrders(scope);
  const send = (data: unknown): void => scope.onmessage!({ data } as MessageEvent);
  send({ request: { url: base, local: { base, files } }, pageOrigin });
  send({ limits: roomyLimits });
  await ended;
  return { text: reports.map(printAll).join('\n'), types: reports.map(({ type }) => type) };
}

/** Bytes that are numbers of pixels are text too here: no element may lie in a buffer that is sent. */
function printAll(value: unknown): string {
  return JSON.stringify(value, (_key, one: unknown) => {
    if (!ArrayBuffer.isView(one)) return one;
    return new TextDecoder('latin1').decode(new Uint8Array(one.buffer));
  });
}

const slices = (fields: DicomFields, form?: DicomForm): Uint8Array<ArrayBuffer>[] =>
  [0, 5, 10].map((z) => dicomBytes(ctSlice(z, { ...planted, ...fields, SOPInstanceUID: `${uid}.${z}` }), form));

describe('what DICOM files say of a patient stays in the worker', () => {
  it('the planted words are in the files', () => {
    const [first] = slices(codes);
    expect(new TextDecoder('latin1').decode(first)).to.match(secrets);
  });

  for (const [what, fields] of [
    ['with usual codes', {}],
    ['with codes that are no codes', codes],
  ] as const) {
    it(`of a series ${what}`, async () => {
      const { text, types } = await listReports(filesOf(slices(fields)));
      expect(types).to.include('done');
      expect(text).not.to.match(secrets);
    });
  }

  it('of a series with a damaged file, which has its number', async () => {
    const [first, second, third] = slices({});
    const { text, types } = await listReports(filesOf([first, second.slice(0, -9), third]));
    expect(types).to.include('done');
    expect(text).to.contain('file 2 of 3: damaged').and.not.to.match(secrets);
  });

  const series = slices({});
  for (const [what, files] of [
    ['cut files', [series[0], ...series.slice(1).map((bytes) => bytes.slice(0, -9))]],
    ['colours', slices({ PhotometricInterpretation: name, SamplesPerPixel: [3] })],
    ['an unknown transfer syntax', slices({}, { syntax: uid })],
    ['a length beyond the end', slices({}, { raw: [{ tag: 0x00100010, vr: 'UT', value: name, length: 0xffffff0 }] })],
    ['text for a number', slices({}, { raw: [{ tag: 0x00280010, vr: 'LO', value: name }] })],
    ['no pixels', slices({ PixelData: undefined })],
    ['a single file', [series[0].slice(0, -9)]],
  ] as const) {
    it(`of an error: ${what}`, async () => {
      const { text, types } = await listReports(filesOf(files));
      expect(types).to.include('failed');
      expect(text).not.to.match(secrets);
    });
  }

  it('of a file that the disk no longer gives', async () => {
    const files = filesOf(series);
    const gone = (): never => {
      throw new DOMException(`${name} is gone`, 'NotReadableError');
    };
    let reads = 0;
    const { slice } = files[1];
    files[1].slice = (...range) => (reads++ > 0 ? gone() : slice.apply(files[1], range));
    files[1].stream = files[1].arrayBuffer = gone;
    const native = globalThis.Response;
    globalThis.Response = class extends native {
      constructor(body?: BodyInit | null, options?: ResponseInit) {
        super(
          body === files[1]
            ? new ReadableStream({
                start: (controller) => controller.error(new DOMException(name, 'NotReadableError')),
              })
            : body,
          options,
        );
      }
    };
    try {
      const error = await expectError(
        decodeHere(
          { url: base, local: { base, files }, limits: roomyLimits },
          { pageOrigin, onProgress: () => undefined },
        ),
      );
      expect(error.code).to.equal('source/not-found');
      expect(error.message).to.contain('file 2 of 3').and.not.to.match(secrets);
    } finally {
      globalThis.Response = native;
    }
  });

  it('and a warning says that words may be in the pixels', async () => {
    const { text } = await listReports(filesOf(slices({ BurnedInAnnotation: 'YES' })));
    expect(text).to.contain('BurnedInAnnotation');
    expect((await listReports(filesOf(slices({ BurnedInAnnotation: 'NO' })))).text).not.to.contain(
      'BurnedInAnnotation',
    );
  });
});

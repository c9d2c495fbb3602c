// Series of several times on DICOMweb servers: they are opened, and each time is shown as a page does. In Node.
import { expect } from '@esm-bundle/chai';
import type { ScanTimes } from '../../src/formats/base/choose-scan.ts';
import type { ScanData } from '../../src/formats/base/scan-data.ts';
import { decodeRequest } from '../../src/worker/decode-request.ts';
import type { RequestEnvironment } from '../../src/worker/decode-request.ts';
import { roomyLimits, urlOf } from './decode.ts';
import type { Scan } from './dicom-series.ts';
import { openScans } from './scans-of.ts';
import type { OpenScans } from './scans-of.ts';

/** Opens a series of several times. @param index - the one that is wanted */
export async function openTimes(
  url: string,
  index: number,
  environment: Partial<RequestEnvironment> = {},
): Promise<{ readonly volume: Scan; readonly times: ScanTimes; show(time: number): Promise<Scan> }> {
  let [times, scans]: [ScanTimes, readonly ScanData[]] = [[], []];
  const whole = { pageOrigin: new URL(url).origin, onProgress: () => undefined, ...environment };
  const volume = (await decodeRequest(
    { url, limits: roomyLimits, scan: { index } },
    { ...whole, onScans: (found, data = []) => ([times, scans] = [found, structuredClone(data)]) },
  )) as Scan;
  return {
    volume,
    times,
    show: (time) => decodeRequest({ url, limits: roomyLimits, data: scans[time] }, whole) as Promise<Scan>,
  };
}

/** What the files of a series show at each time. */
export async function timesOfFiles(files: readonly Uint8Array<ArrayBuffer>[]): Promise<OpenScans> {
  const urls = files.map((_, i) => urlOf(`${i}.dcm`));
  return openScans(files[0].slice(), '0.dcm', {
    ...(files.length > 1 && { files: urls }),
    fetchFile: async (url) => ({ bytes: files[urls.indexOf(url)].slice(), url, contentType: '' }),
  });
}

/** A time is that of the files to the bit. */
export async function expectTime(volume: Scan, time: number, { read }: OpenScans): Promise<void> {
  const expected = (await read(time)) as Scan;
  expect([...volume.samples]).to.deep.equal([...expected.samples]);
  for (const name of ['grid', 'slope', 'intercept', 'unit', 'window', 'format', 'left'] as const)
    expect(JSON.stringify(volume[name]), name).to.equal(JSON.stringify(expected[name]));
}

// A chosen file of several volumes is read in parts: each volume that is shown is a part of it.
import { expect } from '@esm-bundle/chai';
import { decodeRequest } from '../../../src/worker/decode-request.ts';
import type { LoadRequest } from '../../../src/formats/base/load-request.ts';
import type { ScanData } from '../../../src/formats/base/scan-data.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { sendFiles } from '../../../src/worker/send-files.ts';
import { roomyLimits } from '../../helpers/decode.ts';

const base = 'https://local-8.invalid/';
const edge = 96;
const times = 4;
const voxels = edge ** 3;

/** NIfTI-1 of 4 x 1.7 MB, of one value at each time. Source: nifti1.h */
function fourTimes(): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(352 + times * voxels * 2);
  const view = new DataView(bytes.buffer);
  view.setInt32(0, 348, true);
  [4, edge, edge, edge, times, 1, 1, 1].forEach((n, i) => view.setInt16(40 + 2 * i, n, true));
  view.setInt16(70, 4, true);
  view.setInt16(72, 16, true);
  for (let i = 1; i < 5; i++) view.setFloat32(76 + 4 * i, 1, true);
  view.setFloat32(108, 352, true);
  bytes.set([0x6e, 0x2b, 0x31, 0], 344);
  const numbers = new Int16Array(bytes.buffer, 352);
  for (let t = 0; t < times; t++) for (let i = 0; i < voxels; i++) numbers[t * voxels + i] = 100 * t + (i % 7);
  return bytes;
}

/** As browsers read a file of a disk: Node gives all of it at once. */
function inPieces(file: File): File {
  const native = file.stream.bind(file);
  const cut = new TransformStream<Uint8Array, Uint8Array>({
    transform(all, controller) {
      for (let at = 0; at < all.length; at += 2 ** 16) controller.enqueue(all.subarray(at, at + 2 ** 16));
    },
  });
  return Object.assign(file, { stream: () => native().pipeThrough(cut) });
}

const whole = fourTimes();
const environment = { pageOrigin: 'https://example.test', onProgress: () => undefined };

for (const [what, others] of [
  ['alone', 0],
  ['among many files', 60],
] as const)
  describe(`a chosen NIfTI of several times, ${what}`, function () {
    this.timeout(20_000);

    it('is read in parts, and a new time needs none of the chosen files', async () => {
      const files = [
        inPieces(new File([whole], 'Geheim.nii')),
        ...Array.from({ length: others }, (_, i) => new File([`${i}`], `note ${i}.txt`)),
      ];
      let scans: readonly ScanData[] = [];
      const first = await decodeRequest(
        { url: base, local: { base, files }, scan: { index: 1 }, limits: roomyLimits },
        { ...environment, onScans: (_times, data = []) => (scans = structuredClone(data)) },
      );
      const valueOf = ({ samples, slope, intercept }: Volume): number => slope * samples[1] + intercept;
      expect(valueOf(first)).to.equal(101);
      expect(scans).to.have.length(times);
      for (const time of [3, 0]) {
        const request = sendFiles(
          { url: base, local: { base, files }, data: scans[time] },
          new AbortController().signal,
        );
        expect((request as LoadRequest).local).to.deep.equal({ base, files: [] });
        const volume = await decodeRequest({ ...(request as LoadRequest), limits: roomyLimits }, environment);
        expect(valueOf(volume)).to.equal(100 * time + 1);
      }
    });
  });

// Series of several times on a DICOMweb server: what is asked for at the first picture, and what when another time is shown.
import { expect } from '@esm-bundle/chai';
import type { CoarseVolume } from '../../../src/formats/base/load-request.ts';
import { expectError, valuesOf } from '../../helpers/decode.ts';
import { ctSlice, dicomBytes, packRle } from '../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../helpers/dicom-bytes.ts';
import { mosaicFields, timedFields, timedFrames, valuesAt } from '../../helpers/dicom-frames.ts';
import { withWeb } from '../../helpers/dicomweb-server.ts';
import type { WebInstance } from '../../helpers/dicomweb-server.ts';
import { expectTime, openTimes, timesOfFiles } from '../../helpers/dicomweb-times.ts';

// Node 20 has none.
if (!('navigator' in globalThis)) Object.assign(globalThis, { navigator: { onLine: true } });

/** Frames that are asked for, from 1, with the instances that they are of. */
const framesAsked = (asked: readonly string[]): { readonly instance: string; readonly frame: number }[] =>
  asked.flatMap((path) => {
    const [, instance, list] = /\/instances\/([\d.]+)\/frames\/([\d,]+)$/.exec(path) ?? [];
    return list ? list.split(',').map((frame) => ({ instance, frame: Number(frame) })) : [];
  });

describe('a series of several times on a DICOMweb server', () => {
  const count = { times: 3, slices: 9 };
  /** The instances of all times, slice by slice. */
  const made: WebInstance[] = Array.from({ length: count.times * count.slices }, (_, i) => {
    const [t, k] = [i % count.times, Math.floor(i / count.times)];
    const times = { SOPInstanceUID: `1.2.4.${t}.${k}`, TriggerTime: String(40 * t) };
    return { fields: ctSlice(5 * k, times, 100 * t + 10 * k) };
  });

  it('asks for the slices of the time that is shown, and for those of another one when it is shown', async () => {
    await withWeb(made, {}, async ({ url, asked, most }) => {
      const expected = await timesOfFiles(made.map(({ fields }) => dicomBytes(fields)));
      const { volume, times, show } = await openTimes(url, 1);
      expect(times).to.deep.equal(['0 s', '0.04 s', '0.08 s']);
      await expectTime(volume, 1, expected);
      expect(volume.source).to.deep.equal({ kind: 'DICOMweb', count: 27 });
      // The list, three slices of each time for one window, and the slices of one time.
      expect(asked).to.have.length(1 + 3 * count.times + count.slices);
      for (const time of [2, 0, 1]) {
        const before = asked.length;
        await expectTime(await show(time), time, expected);
        const frames = framesAsked(asked.slice(before));
        expect(asked).to.have.length(before + count.slices);
        expect(frames.map(({ instance }) => instance.split('.').at(-2))).to.deep.equal(
          Array(count.slices).fill(String(time)),
        );
      }
      expect(most()).to.be.at.most(6);
    });
  });

  const size = { times: 5, slices: 33, edge: 8 };
  const enhanced: DicomFields = { ...timedFields(size), SOPInstanceUID: '1.2.5' };
  const packed = {
    syntax: '1.2.840.10008.1.2.5',
    type: 'image/dicom-rle',
    frames: timedFrames(size).map((numbers) => packRle(numbers)),
  };
  for (const [what, one] of [
    ['not packed', { fields: enhanced }],
    ['packed by runs', { fields: enhanced, packed }],
  ] as const) {
    it(`asks for the frames of the time that is shown, in few answers: ${what}`, async () => {
      await withWeb([one], {}, async ({ url, asked }) => {
        const coarse: CoarseVolume[] = [];
        const expected = await timesOfFiles([dicomBytes(enhanced)]);
        const { volume, times, show } = await openTimes(url, 2, { onCoarse: (one) => one && coarse.push(one) });
        expect(times).to.deep.equal(Array(size.times).fill(null));
        await expectTime(volume, 2, expected);
        expect([...valuesOf(volume)]).to.deep.equal(valuesAt(2, size));
        expect(coarse).to.have.length(1);
        const opened = framesAsked(asked);
        // Three frames of each of five times for one window, and those of one time.
        expect(opened).to.have.length(3 * size.times + size.slices);
        expect(asked).to.have.length(1 + size.times + 2);
        for (const time of [4, 0]) {
          const before = asked.length;
          await expectTime(await show(time), time, expected);
          const frames = framesAsked(asked.slice(before)).map(({ frame }) => (frame - 1) % size.times);
          expect(frames).to.deep.equal(Array(size.slices).fill(time));
          expect(asked).to.have.length(before + 1);
        }
      });
    });
  }

  it('asks with the function of the page, and says what is wrong without an address', async () => {
    const tokens: string[] = ['Bearer x'];
    const own: typeof fetch = (address, options) =>
      fetch(address, {
        ...options,
        headers: { ...Object.fromEntries(new Headers(options?.headers)), Authorization: tokens[0] },
      });
    await withWeb(made, { token: 'Bearer x' }, async ({ url }) => {
      const { show } = await openTimes(url, 0, { fetch: own });
      expect((await show(2)).format).to.equal('DICOM, CT, volume 3 of 3');
      tokens[0] = 'Bearer old';
      const { code, message } = await expectError(show(1));
      expect(code).to.equal('source/not-found');
      expect(message).to.match(/^frames of the DICOMweb series got HTTP status 401 Unauthorized/);
      expect(message).not.to.match(/1\.2\./);
    });
  });

  it('asks for a frame that is cut short once more, also later', async () => {
    const faults = { cut: { place: 2, times: 0 } };
    await withWeb(made, faults, async ({ url, asked }) => {
      const { show } = await openTimes(url, 0);
      faults.cut.times = 1;
      const before = asked.length;
      expect((await show(2)).left).to.equal(undefined);
      expect(asked).to.have.length(before + count.slices + 1);
    });
  });

  it('may have a picture of each time in one frame, as mosaics of a head are', async () => {
    const mosaics = [0, 1, 2].map((time): WebInstance => ({ fields: mosaicFields(time, { edge: 16, count: 4 }) }));
    await withWeb(mosaics, {}, async ({ url, asked }) => {
      const expected = await timesOfFiles(mosaics.map(({ fields }) => dicomBytes(fields)));
      const { volume, times, show } = await openTimes(url, 1);
      expect(times).to.deep.equal(['0 s', '2 s', '4 s']);
      expect(volume.grid.dimensions).to.deep.equal([8, 8, 4]);
      await expectTime(volume, 1, expected);
      expect(asked).to.have.length(1 + 3 + 1);
      const before = asked.length;
      await expectTime(await show(2), 2, expected);
      expect(asked).to.have.length(before + 1);
    });
  });
});

import { expect } from '@esm-bundle/chai';
import { ScanSequence } from '../../../../src/viewer/loading/scan-sequence.ts';
import type { LoadScan } from '../../../../src/viewer/loading/scan-sequence.ts';
import type { ScanSource } from '../../../../src/viewer/model/scans-of-view.ts';
import { followModel } from '../../../../src/viewer/model/scan-model.ts';
import { english } from '../../../../src/messages/english-companions.ts';
import { Language } from '../../../../src/messages/language.ts';
import { describeScan, labelScans } from '../../../../src/messages/name-scans.ts';
import { VolumeCache } from '../../../../src/viewer/model/volume-cache.ts';
import { chooseScan } from '../../../../src/formats/base/choose-scan.ts';
import { decodeBytes, expectError, fetchFixture } from '../../../helpers/decode.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { fakeOf } from '../../../helpers/fake.ts';

const at = (minute: number): string => `2018-12-20T06:${String(minute).padStart(2, '0')}:00Z`;
const ms = (minute: number): number => Date.parse(at(minute));

/** A volume of so many bytes; nothing else of it matters here. */
const volumeOf = (byteLength: number, time?: string): Volume =>
  fakeOf<Volume>('Volume', {
    samples: { byteLength } as Volume['samples'],
    radar: time === undefined ? undefined : { time },
  });

describe('chooseScan', () => {
  const times = [at(0), at(10), null, at(20)];

  it('takes the last one that is not after a time, and the first where all are', () => {
    const chosen = [-5, 0, 9.99, 10, 19, 20, 59].map(
      (minute) => chooseScan(times, { time: Date.parse(at(0)) + minute * 60_000 }).index,
    );
    expect(chosen).to.deep.equal([0, 0, 0, 1, 1, 3, 3]);
    expect(chooseScan([null, null], { time: ms(5) })).to.deep.equal({ index: 0, certain: true });
  });

  it('takes a number as it is, and refuses one beyond the last', () => {
    expect(chooseScan(times, { index: 3 })).to.deep.equal({ index: 3, certain: true });
    expect(() => chooseScan(times, { index: 4 })).to.throw('time got "4"; expected the number of a scan, from 0 to 3');
  });

  it('takes a time with the unit of the file, in seconds or milliseconds, and refuses another unit', () => {
    const times = ['0 s', '2 s', '4.5 s'];
    for (const [time, index] of [
      ['2 s', 1],
      ['4499 ms', 1],
      ['4.5s', 2],
      ['99 s', 2],
      ['0 s', 0],
    ] as const)
      expect(chooseScan(times, { time })).to.deep.equal({ index, certain: true });
    for (const time of ['2 Hz', 'noon', ms(0)])
      expect(() => chooseScan(times, { time })).to.throw(`time got "${time}"; expected the number of a scan`);
  });

  it('asks for as few unknown times as halving takes, and never for one that can not matter', () => {
    const truth = Array.from({ length: 50 }, (_, i) => at(i));
    for (const minute of [-1, 0, 17.5, 32, 48, 49]) {
      const known: (string | undefined)[] = truth.map(() => undefined);
      const target = { time: ms(0) + minute * 60_000 };
      let asked = 0;
      for (let choice = chooseScan(known, target); ; choice = chooseScan(known, target)) {
        if (choice.certain) {
          expect(choice.index).to.equal(Math.max(0, Math.floor(minute)));
          break;
        }
        expect(known[choice.index]).to.equal(undefined);
        known[choice.index] = truth[choice.index];
        asked++;
      }
      expect(asked).to.be.at.most(6);
    }
  });
});

describe('the cache of volumes', () => {
  it('keeps five; the one that was not used for the longest time goes', () => {
    const cache = new VolumeCache();
    for (let i = 0; i < 5; i++) cache.set(i, volumeOf(10));
    expect(cache.get(0)).to.not.equal(null);
    cache.set(5, volumeOf(10));
    expect([0, 1, 2, 3, 4, 5].map((i) => cache.has(i))).to.deep.equal([true, false, true, true, true, true]);
    expect(cache.get(1)).to.equal(null);
  });

  it('keeps 512 MB, and the newest whatever its size', () => {
    const cache = new VolumeCache();
    const mega = 2 ** 20;
    for (const [i, size] of [200, 200, 100].entries()) cache.set(i, volumeOf(size * mega));
    expect([0, 1, 2].map((i) => cache.has(i))).to.deep.equal([true, true, true]);
    cache.set(3, volumeOf(20 * mega));
    expect([0, 1, 2, 3].map((i) => cache.has(i))).to.deep.equal([false, true, true, true]);
    cache.set(4, volumeOf(900 * mega));
    expect([0, 1, 2, 3, 4].map((i) => cache.has(i))).to.deep.equal([false, false, false, false, true]);
  });
});

describe('a sequence of scans', () => {
  /** Loads that end when the test says so. */
  function controlled(): {
    load: LoadScan;
    begun: number[];
    aborted: number[];
    end: (scan: number, time?: string) => Promise<void>;
  } {
    const ends = new Map<number, (volume: Volume) => void>();
    const begun: number[] = [];
    const aborted: number[] = [];
    const load: LoadScan = ({ url }, signal) =>
      new Promise((resolve, reject) => {
        const scan = Number(url);
        begun.push(scan);
        ends.set(scan, resolve);
        signal.addEventListener('abort', () => {
          aborted.push(scan);
          reject(signal.reason as Error);
        });
      });
    const end = async (scan: number, time?: string): Promise<void> => {
      ends.get(scan)!(volumeOf(1, time));
      await new Promise((resolve) => setTimeout(resolve));
    };
    return { load, begun, aborted, end };
  }
  const sources = (count: number): ScanSource[] => Array.from({ length: count }, (_, i) => ({ url: String(i) }));

  it('loads one at a time ahead, and the one that is being loaded is not loaded twice', async () => {
    const { load, begun, end } = controlled();
    const scans = new ScanSequence(sources(4), load);
    const first = scans.get(1);
    await end(1);
    await first;
    void scans.prefetch(false);
    expect(begun).to.deep.equal([1, 2]);
    const next = scans.get(2);
    await end(2);
    await next;
    expect(begun).to.deep.equal([1, 2]);
  });

  it('wraps around only where it loops', async () => {
    for (const [loops, expected] of [
      [false, [3, 2]],
      [true, [3, 0, 2]],
    ] as const) {
      const { load, begun, end } = controlled();
      const scans = new ScanSequence(sources(4), load);
      const last = scans.get(3);
      await end(3);
      await last;
      void scans.prefetch(loops);
      await end(begun.at(-1)!);
      expect(begun).to.deep.equal(expected);
      scans.stop();
    }
  });

  it('gives up a load that is neither wanted nor next to it', async () => {
    const { load, begun, aborted } = controlled();
    const scans = new ScanSequence(sources(9), load);
    const unwanted = scans.get(2).then(
      () => 'loaded',
      () => 'given up',
    );
    void scans.get(3).catch(() => {});
    expect(aborted).to.deep.equal([]);
    void scans.get(6).catch(() => {});
    expect(aborted).to.deep.equal([2, 3]);
    expect(await unwanted).to.equal('given up');
    scans.stop();
    expect(aborted).to.deep.equal([2, 3, 6]);
    expect(begun).to.deep.equal([2, 3, 6]);
  });

  it('finds a time that only the files know', async () => {
    const loaded: number[] = [];
    const load: LoadScan = async ({ url }) => {
      loaded.push(Number(url));
      return volumeOf(1, at(Number(url) * 5));
    };
    const scans = new ScanSequence(sources(8), load);
    expect(await scans.find({ time: ms(22) }, new AbortController().signal)).to.equal(4);
    expect(loaded.length).to.be.at.most(3);
    expect(scans.times.filter((time) => time !== null)).to.have.lengthOf(loaded.length);
  });
});

describe('what stays from scan to scan', () => {
  const box = (height: number, unit = 'dBZ'): Volume => ({ ...syntheticVolume({ dimensions: [8, 8, height] }), unit });

  it("is the first scan's, without its samples, until one is twice as large or of another unit", () => {
    const model = followModel(null, box(8));
    expect('samples' in model || 'macrocells' in model).to.equal(false);
    expect(followModel(model, box(14))).to.equal(model);
    expect(followModel(model, box(40))).to.not.equal(model);
    expect(followModel(model, box(8, 'm/s')).unit).to.equal('m/s');
  });
});

describe('words of the timeline', () => {
  it('are in UTC, with seconds where they are needed', () => {
    const language = new Language('en-GB', english);
    expect(labelScans([at(6), at(12)], language)).to.deep.equal(['06:06', '06:12']);
    expect(labelScans(['2018-12-20T06:06:28Z', '2018-12-20T06:06:58Z', null], language)).to.deep.equal([
      '06:06:28',
      '06:06:58',
      '3',
    ]);
    expect(language.day(at(0))).to.equal('20 Dec 2018');
    expect(describeScan([at(6), at(12)], 1, language)).to.equal('06:12 UTC, 20 Dec 2018, scan 2 of 2');
    expect(describeScan([null, null], 0, language)).to.equal('scan 1 of 2');
    expect(labelScans(['0 s', '12.5 s'], language)).to.deep.equal(['0 s', '12.5 s']);
    expect(describeScan(['0 s', '12.5 s'], 1, language)).to.equal('12.5 s, scan 2 of 2');
    // Sydney has daylight saving time in December: 11 hours before UTC. So it is the next day there.
    const sydney = new Language('en-GB', english, 'Australia/Sydney');
    expect(describeScan([at(6), '2018-12-20T16:30:00Z'], 1, sydney)).to.match(
      /^03:30 (AEDT|GMT\+11), 21 Dec 2018, scan 2 of 2$/,
    );
    expect(labelScans([at(6), at(12)], sydney)).to.deep.equal(['17:06', '17:12']);
    expect(describeScan([at(6)], 0, language)).to.equal('06:06 UTC, 20 Dec 2018');
  });
});

describe('a manifest of scans', () => {
  const scans = [
    { image: 'nifti/v1-le-scaled.nii', time: at(0) },
    { image: 'mosaic/gray-3x2.png', time: at(10), unit: 'own' },
  ];
  const bytes = new TextEncoder().encode(
    JSON.stringify({ mosaic: '3x2', slices: 5, unit: 'shared', title: 'T', scans }),
  );

  it('gives the one that is wanted, with what it shares with the others', async () => {
    expect(await decodeBytes(bytes, 'a.json')).to.deep.include({ unit: 'shared', title: 'T', format: 'NIfTI-1' });
    const second = await decodeBytes(bytes, 'a.json', { scan: { time: ms(15) } });
    expect(second).to.deep.include({ unit: 'own', title: 'T', format: 'PNG mosaic' });
    expect(second.samples).to.deep.equal(
      (
        await decodeBytes(await fetchFixture('mosaic/gray-3x2.png'), 'b.png', {
          mosaic: { columns: 3, rows: 2 },
          slices: 5,
        })
      ).samples,
    );
  });

  it('has no more than it lists', async () => {
    expect((await expectError(decodeBytes(bytes, 'a.json', { scan: { index: 2 } }))).code).to.equal(
      'attribute/invalid',
    );
  });
});

import { expect } from '@esm-bundle/chai';
import type { ScanData } from '../../../../src/formats/base/scan-data.ts';
import type { ScanTimes } from '../../../../src/formats/base/choose-scan.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { loadVolume } from '../../../../src/worker/load.ts';
import type { LoadRequest } from '../../../../src/worker/load.ts';
import { endSpare } from '../../../../src/worker/spare-worker.ts';
import { expectError, roomyLimits } from '../../../helpers/decode.ts';

const urlOfVideo = (name: string): string => new URL(`/test/fixtures/video/${name}`, location.href).href;

/** A manifest as a URL. */
const urlOf = (manifest: object): string =>
  URL.createObjectURL(new Blob([JSON.stringify(manifest)], { type: 'application/json' }));

interface Loaded {
  readonly volume: Volume;
  readonly times: ScanTimes;
  readonly data: readonly ScanData[];
}

/** Loads in a worker, as an element does. */
async function load(manifest: object, request: Partial<LoadRequest> = {}): Promise<Loaded> {
  let [times, data]: [ScanTimes, readonly ScanData[]] = [[], []];
  const volume = await loadVolume(
    { url: urlOf(manifest), limits: roomyLimits, scan: { index: 0 }, ...request },
    {
      signal: new AbortController().signal,
      onProgress: () => undefined,
      onScans: (found, where) => ([times, data] = [found, where ?? []]),
    },
  );
  return { volume, times, data };
}

const heart = {
  video: urlOfVideo('vp9-lossless.webm'),
  mosaic: '4x3',
  spacing: [1, 1, 2],
  slope: 2,
  intercept: -100,
  unit: 'HU',
  window: [0, 300],
  lossy: { rms: 0.5, p99: 1, max: 3 },
};

/** In the last slice, where the fixture has the number of the frame. */
const numberOf = ({ samples }: Pick<Volume, 'samples'>): number => (samples[11 * 256] - 10) / 20;

describe('a manifest with a video', () => {
  it('has a scan for each frame, with the times of the video', async () => {
    const { volume, times, data } = await load(heart, { scan: { index: 5 } });
    expect(times).to.deep.equal(Array.from({ length: 12 }, (_, i) => `${i / 5} s`));
    expect(volume).to.deep.include({
      unit: 'HU',
      slope: 2,
      intercept: -100,
      lossy: heart.lossy,
      format: 'VP9 video mosaic',
    });
    expect(volume.window).to.deep.equal([0, 300]);
    expect(volume.grid.dimensions).to.deep.equal([16, 16, 12]);
    expect(numberOf(volume)).to.equal(5);
    // In any order, from what was opened: the manifest and the file are not fetched again.
    for (const index of [11, 0, 7, 6, 3]) {
      const again = await load(heart, { url: 'https://example.invalid/gone.json', scan: { index }, data: data[index] });
      expect(numberOf(again.volume)).to.equal(index);
      expect(again.volume.lossy).to.deep.equal(heart.lossy);
      expect(again.times).to.deep.equal([]);
    }
  });

  it('has no data where pixels are below a number', async () => {
    const { volume } = await load({ ...heart, noDataBelow: 60 }, { scan: { index: 2 } });
    expect(Number.isNaN(numberOf(volume)), '50').to.equal(true);
    expect(volume.hasNoData).to.equal(true);
    expect(numberOf((await load({ ...heart, noDataBelow: 60 }, { scan: { index: 3 } })).volume)).to.equal(3);
  });

  it('finds a scan by its time', async () => {
    expect(numberOf((await load(heart, { scan: { time: '1.3 s' } })).volume)).to.equal(6);
    const scans = Array.from({ length: 12 }, (_, i) => ({ time: `2020-02-07T13:${10 + i}:00Z`, title: `Scan ${i}` }));
    const { volume, times } = await load({ ...heart, scans }, { scan: { time: Date.parse('2020-02-07T13:14:30Z') } });
    expect(times[4]).to.equal('2020-02-07T13:14:00Z');
    expect(numberOf(volume)).to.equal(4);
    expect(volume.title).to.equal('Scan 4');
  });

  it("shows a radar's mosaic", async () => {
    const storm = {
      video: heart.video,
      mosaic: '4x3',
      elevations: Array.from({ length: 12 }, (_, i) => i + 0.5),
      range: [250, 500],
      slope: 0.5,
      intercept: -32,
      unit: 'dBZ',
      moment: 'DBZH',
      site: { latitude: 50, longitude: 6, height: 100 },
      lossy: heart.lossy,
      scans: Array.from({ length: 12 }, (_, i) => ({ time: `2020-02-07T13:${10 + i}:00Z` })),
    };
    const { volume, data } = await load(storm, { scan: { index: 3 } });
    expect(volume.grid.kind).to.equal('polar');
    expect(volume).to.deep.include({ unit: 'dBZ', lossy: heart.lossy });
    expect(volume.radar?.time).to.equal('2020-02-07T13:13:00Z');
    expect(numberOf(volume)).to.equal(3);
    const again = await load(storm, { scan: { index: 8 }, data: data[8] });
    expect(again.volume.radar?.time).to.equal('2020-02-07T13:18:00Z');
    expect(numberOf(again.volume)).to.equal(8);
  });

  it('is refused where scans and frames differ in number, and where the layout does not fit', async () => {
    const few = await expectError(load({ ...heart, scans: [{}, {}] }));
    expect(few.code).to.equal('manifest/invalid');
    expect(few.message).to.contain('2 scans').and.to.contain('12 frames');
    expect((await expectError(load({ ...heart, mosaic: '4x3', slices: 13 }))).code).to.equal('mosaic/layout');
    expect((await expectError(load({ ...heart, video: urlOfVideo('none.webm') }))).code).to.equal('source/not-found');
    expect((await expectError(load({ ...heart, video: 'file:///etc/passwd' }))).code).to.equal('manifest/invalid');
    const image = await expectError(
      load({ ...heart, video: new URL('/test/fixtures/mosaic/gray-3x2.png', location.href).href }),
    );
    expect(image.code).to.equal('format/unsupported');
  });

  it('without workers and WebCodecs, the player of the page shows the frames, and says so', async () => {
    const native = { VideoDecoder: globalThis.VideoDecoder, Worker: globalThis.Worker };
    // No worker, and a page without WebCodecs, as on http.
    endSpare();
    Object.assign(globalThis, {
      Worker: function refuse() {
        throw new DOMException('no workers', 'SecurityError');
      },
    });
    Reflect.deleteProperty(globalThis, 'VideoDecoder');
    try {
      const { volume, data } = await load(heart, { scan: { index: 2 } });
      expect(Math.round(numberOf(volume))).to.equal(2);
      expect(volume.left?.join()).to.contain('WebCodecs');
      const again = await load(heart, { scan: { index: 9 }, data: data[9] });
      expect(Math.round(numberOf(again.volume))).to.equal(9);
    } finally {
      Object.assign(globalThis, native);
    }
  });
});

// What an element says of a picture of a video that lost something, against the picture of the scan before.
import { expect } from '@esm-bundle/chai';
import { Budget } from '../../../../src/formats/base/budget.ts';
import { openVideo } from '../../../../src/formats/video/open-video.ts';
import { readFrame } from '../../../../src/formats/video/read-frame.ts';
import { comparePictures } from '../../../../src/prepare/compare-pictures.ts';
import { LossySum } from '../../../../src/prepare/video-codes.ts';
import type { RenderStats } from '../../../../src/viewer/model/render-stats.ts';
import type { GrayImage } from '../../../../src/volume/mosaic.ts';
import type { Lossy, LossyError } from '../../../../src/volume/volume.ts';
import { placeElement, takeAtRest } from '../../../accuracy/element-picture.ts';
import type { ShownPicture } from '../../../accuracy/element-picture.ts';
import { loadHere, sightOf } from '../../../accuracy/small-page.ts';
import { compareCovered } from '../../../helpers/covered-error.ts';
import type { CoveredError } from '../../../helpers/covered-error.ts';
import { fetchFixture } from '../../../helpers/decode.ts';

const pixels = 120;
const originals = 'vp9-lossless.webm';
const changed = 'vp9-lossy.webm';

const common = { mosaic: '4x3', spacing: [1, 1, 1.3], window: [40, 255], slope: 1, intercept: 0 };
const urlOf = (video: string, more: object = {}): string => {
  const manifest = { video: new URL(`/test/fixtures/video/${video}`, location.href).href, ...common, ...more };
  return URL.createObjectURL(new Blob([JSON.stringify(manifest)], { type: 'application/json' }));
};

async function frameOf(name: string, frame: number): Promise<GrayImage> {
  const bytes = await fetchFixture(`video/${name}`);
  const budget = Budget.ofFile(bytes.length);
  return readFrame(await openVideo(bytes, budget, true), frame, { budget });
}

/** What the program that encodes a video would write into its manifest, of the first frame. */
async function measureLoss(): Promise<Lossy> {
  const [was, is] = [await frameOf(originals, 0), await frameOf(changed, 0)];
  const sum = new LossySum({ slope: 1, intercept: 0, first: 0, noDataBelow: 0 });
  sum.add(Float64Array.from(was.data), is.data as Uint8Array);
  const picture = await comparePictures(await loadHere(urlOf(originals)), is, common, 64);
  return { ...sum.error, picture };
}

let lossy: Lossy;

async function take(src: string, attributes: Record<string, string>): Promise<ShownPicture> {
  const volume = await loadHere(urlOf(originals));
  const sight = sightOf(volume, { pixels, pixelsPerVoxel: 5, theta: 30, phi: 70, ratio: 1 }, 0);
  const element = placeElement({ src, sight, pixels, ratio: 1, attributes });
  try {
    return await takeAtRest(element, pixels);
  } finally {
    element.remove();
  }
}

/** What is stated of the first frame, and what is true. */
async function compare(attributes: Record<string, string>): Promise<{ stated: RenderStats; known: CoveredError }> {
  const original = await take(urlOf(originals), attributes);
  const { data, stats } = await take(urlOf(changed, { lossy }), attributes);
  return { stated: stats, known: compareCovered(data, original.data, 1) };
}

const lost = ({ error }: RenderStats): Pick<LossyError, 'rms' | 'p99'> => error!.parts!.lossy!;

describe('the error of a picture of a lossy video', () => {
  before(async function () {
    this.timeout(60_000);
    lossy = await measureLoss();
    console.log(`lost: ${JSON.stringify(lossy)}`);
  });

  for (const [name, attributes] of Object.entries<Record<string, string>>({
    'the look of a page that says nothing': {},
    'half the window': { 'value-window': '90 200' },
    'twice the window': { 'value-window': '-60 360' },
    'colours, unlit': { 'transfer-function': 'viridis' },
    'the largest value of each ray': { projection: 'max' },
    'thin fog': { 'transfer-function': 'gray', 'opacity-factor': '0.3' },
  }))
    it(`${name}: what the video lost is stated within a factor of two`, async function () {
      this.timeout(120_000);
      const { stated, known } = await compare(attributes);
      const { error } = stated;
      console.log(
        `${name}: lost ${lost(stated).rms.toFixed(2)}, p99 ${lost(stated).p99.toFixed(1)}; true ${known.rms.toFixed(2)}, p99 ${known.p99.toFixed(1)}, max ${known.max}; steps ${error!.parts!.steps.rms.toFixed(2)}`,
      );
      expect(lost(stated).rms / known.rms).to.be.within(0.5, 2);
      expect(error!.rms).to.be.closeTo(Math.hypot(error!.parts!.steps.rms, lost(stated).rms), 1e-9);
      expect(error!.max, 'a bound').to.equal(null);
    });

  it('takes no more steps for what they can not mend, and says that max-error is not kept', async function () {
    this.timeout(120_000);
    const asked = { 'max-error': '0.5' };
    const { stats: whole } = await take(urlOf(changed, { lossy }), asked);
    const { stats: unsaid } = await take(urlOf(changed), asked);
    expect(unsaid.keepsMaxError).to.equal(true);
    expect(unsaid.error!.parts).to.equal(undefined);
    expect(whole.keepsMaxError).to.equal(false);
    expect([whole.steps, whole.substeps, whole.rays]).to.deep.equal([unsaid.steps, unsaid.substeps, unsaid.rays]);
    expect(whole.error!.parts!.steps).to.deep.equal({
      rms: unsaid.error!.rms,
      p99: unsaid.error!.p99,
      max: unsaid.error!.max,
    });
  });

  it('says it of steps that the author gives, too, and nothing where no pictures were compared', async function () {
    this.timeout(120_000);
    const { stats } = await take(urlOf(changed, { lossy }), { steps: '60' });
    expect(lost(stats).rms).to.be.above(0);
    const { picture: _picture, ...values } = lossy;
    const { stats: unknown } = await take(urlOf(changed, { lossy: values }), { steps: '60' });
    expect(unknown.error!.parts).to.equal(undefined);
  });
});

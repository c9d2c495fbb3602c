// Picks after a new volume has come and before its first picture: the scene still has the cuts of the volume before.
import { expect } from '@esm-bundle/chai';
import { x3dScenes } from '../../../../components/internal/x3d-scenes.ts';
import { noCuts } from '../../../../src/viewer/cuts/cuts.ts';
import type { Cuts } from '../../../../src/viewer/cuts/cuts.ts';
import type { VolumeOptics } from '../../../../src/viewer/model/volume-info.ts';
import type { VolumePick } from '../../../../src/viewer/model/volume-pick.ts';
import { pick } from '../../../../src/viewer/picking/pick.ts';
import { Visibility } from '../../../../src/viewer/scenes/visibility.ts';
import { Viewer } from '../../../../src/viewer/view/viewer.ts';
import { longestDiagonal } from '../../../../src/volume/grid.ts';
import { cutRegion } from '../../../../src/volume/region.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';
import { radarVolume } from '../../../helpers/synthetic-radar.ts';

const places = [
  [20, 15],
  [15, 12],
  [26, 19],
] as const;

const opticsOf = ({ range: [low, high], grid }: Volume): VolumeOptics => ({
  window: [low, high],
  projection: null,
  shading: 'unlit',
  surfaces: null,
  transferFunction: [
    { value: low, color: [0.2, 0.2, 0.2], opacity: 0.9 },
    { value: high, color: [1, 1, 1], opacity: 0.9 },
  ],
  referenceLength: longestDiagonal(grid) / 20,
  opacityFactor: 1,
  lightFactor: 1,
});

/** Let no frame of the page come. @returns a function that lets them come */
function holdFrames(): () => void {
  const own = window.requestAnimationFrame;
  const held: FrameRequestCallback[] = [];
  window.requestAnimationFrame = (callback) => held.push(callback);
  return () => {
    window.requestAnimationFrame = own;
    held.forEach((callback) => own.call(window, callback));
  };
}

/** What is at some places as soon as the second volume has come, and when its picture is final. */
async function pickTwice(
  first: { volume: Volume; cuts: Cuts },
  second: { volume: Volume; cuts: Cuts },
): Promise<Record<'atOnce' | 'atRest', (VolumePick | null)[]>> {
  const host = document.createElement('div');
  host.style.cssText = 'width: 40px; height: 30px';
  const container = host.appendChild(document.createElement('div'));
  document.body.append(host);
  const visibility = new Visibility(() => {});
  const viewer = new Viewer(
    { host, container, visibility, scenes: x3dScenes },
    {
      rendered: () => {},
      cameraMoved: () => {},
      labelRing: () => '',
      drawingFailed: (error) => {
        throw error;
      },
    },
  );
  viewer.setQuality({ steps: 40, maxError: 1, isFree: false, targetFps: 30 });
  const pickAll = (): Promise<(VolumePick | null)[]> => Promise.all(places.map((place) => pick(viewer, place)));
  try {
    return await visibility.ask(async () => {
      await viewer.show(first.volume, opticsOf(first.volume), () => first.cuts);
      await viewer.settled();
      await pickAll(); // The code that picks is loaded now.
      const release = holdFrames();
      await viewer.show(second.volume, opticsOf(second.volume), () => second.cuts);
      const picks = pickAll();
      setTimeout(release, 200);
      expect(viewer.drawn, 'the first picture is still to come').to.equal(first.volume);
      const atOnce = await picks;
      await viewer.settled();
      return { atOnce, atRest: await pickAll() };
    });
  } finally {
    viewer.dispose();
    host.remove();
  }
}

function expectSame({ atOnce, atRest }: Awaited<ReturnType<typeof pickTwice>>): void {
  expect(atRest.some((one) => one !== null)).to.equal(true);
  expect(atOnce).to.deep.equal(atRest);
}

describe('a pick between a new volume and its first picture', () => {
  it('of a radar with fewer sweeps does not look for the sweep that was shown', async () => {
    const sweeps = [1, 4, 12].map((elevation) => ({ elevation, kind: 'float32' as const }));
    const [high, low] = [radarVolume({ sweeps }), radarVolume({ sweeps: sweeps.slice(0, 1), beamWidth: 4 })];
    expectSame(
      await pickTwice(
        { volume: high, cuts: { ...noCuts, slices: [{ kind: 'cone', sweep: 2 }] } },
        { volume: low, cuts: { ...noCuts, slices: [{ kind: 'cone', sweep: 0 }] } },
      ),
    );
  });

  it('goes through the whole of it where only a part of the one before was shown', async () => {
    const make = (spacing: number): Volume =>
      syntheticVolume({ dimensions: [16, 16, 16], spacing: [spacing, spacing, spacing] });
    const [small, large] = [make(1), make(2)];
    const region = cutRegion(small.grid, [-8, -8, -8, 0, 0, 0]);
    expectSame(await pickTwice({ volume: small, cuts: { ...noCuts, region } }, { volume: large, cuts: noCuts }));
  });
});

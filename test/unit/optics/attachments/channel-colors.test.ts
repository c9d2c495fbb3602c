// Channels as one volume, against the same channels as media of their own, whose extinctions and lights add along a ray; and colours of a file.
import { expect } from '@esm-bundle/chai';
import { channelField, channelShade } from '../../../../src/optics/attachments/channel-colors.ts';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { castRay } from '../../../../src/optics/rays/cast-ray.ts';
import { interpolate } from '../../../../src/optics/rays/interpolate.ts';
import { rayThrough, setUpRays } from '../../../../src/optics/rays/rays.ts';
import { stagesOf } from '../../../../src/optics/reference.ts';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { boundingSphere, longestDiagonal } from '../../../../src/volume/grid.ts';
import { planesOf } from '../../../../src/volume/channels.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { channelColors, channelVolume, channelVolumes, colorVolume } from '../../../helpers/channels.ts';

const dimensions: Vector3 = [24, 20, 16];
const volume = channelVolume(dimensions);
const diagonal = longestDiagonal(volume.grid);

/** White, so that the extinction of a brightness is that of a channel of this share, times a constant. */
const opacity = 0.02;
const transferFunction: TransferFunction = Array.from({ length: 31 }, (_, i) => ({
  value: i / 10,
  color: [1, 1, 1],
  opacity: 1 - (1 - opacity) ** (i / 10),
}));

const rays = setUpRays(
  volume.grid,
  viewMatrix(orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, boundingSphere(volume.grid).center, 0.6)),
  projectionMatrix(0.6, 1, 1, 2),
  null,
)!;
const referenceLength = diagonal / 60;

/** What a place has for a reference length: its extinction, and its light. */
type Medium = (place: Vector3) => { readonly extinction: number; readonly light: Vector3 };

/** The largest difference of rays to midpoints of many short pieces, which need none of the code above. */
function compareRays(shown: Volume, functionOfIt: TransferFunction, medium: Medium): { worst: number; most: number } {
  const scene = {
    ...shown,
    grid: volume.grid,
    transferFunction: functionOfIt,
    referenceLength,
    stepLength: diagonal / 400,
    opacityFactor: 1,
    lightFactor: 1,
    moreFields: [channelField(shown.channels!, dimensions)],
    shades: [channelShade],
  };
  const stages = stagesOf(scene, rays);
  let [worst, most] = [0, 0];
  for (const x of [-0.7, -0.3, 0, 0.2, 0.6])
    for (const y of [-0.5, 0.1, 0.4]) {
      const ray = rayThrough(rays, x, y);
      const got = castRay(stages, ray);
      const [seen, box] = [[0, 0, 0, 0], stages.intervals[0](ray, { entry: rays.eyeT, exit: 1e30, behind: null })];
      const [n, span] = [4000, box.exit - box.entry];
      if (!(span > 0)) continue;
      for (let i = 0; i < n; i++) {
        const place = ray.point.map((one, a) => one + (box.entry + ((i + 0.5) / n) * span) * ray.direction[a]);
        const { extinction, light } = medium(place as unknown as Vector3);
        const references = ((span / n) * ray.lengthPerT * rays.diameter) / referenceLength;
        const through = 1 - seen[3];
        for (let c = 0; c < 3; c++) seen[c] += through * references * light[c];
        seen[3] += through * -Math.expm1(-references * extinction);
      }
      most = Math.max(most, seen[3]);
      for (let c = 0; c < 4; c++) worst = Math.max(worst, Math.abs(got[c] - seen[c]));
    }
  return { worst, most };
}

const extinctionOf = -Math.log1p(-opacity);

describe('the colours of channels', () => {
  it('are those of media in one place, whose extinctions and lights add', () => {
    const media = channelVolumes(dimensions);
    const { worst, most } = compareRays(volume, transferFunction, (place) => {
      const shares = media.map((one) => one.slope * interpolate(one.samples, dimensions, place));
      const sum = (of: (m: number) => number): number =>
        extinctionOf * shares.reduce((all, share, m) => all + share * of(m), 0);
      return { extinction: sum(() => 1), light: [0, 1, 2].map((c) => sum((m) => channelColors[m][c])) as never };
    });
    expect(most, 'it is not thin').to.be.above(0.4);
    // Rounding of each channel to 255 steps of the brightest place.
    expect(worst).to.be.below(1.5 / 255);
  });

  it('of a file are those of its voxels, and its brightness makes them opaque', () => {
    const colored = colorVolume(dimensions);
    const planes = planesOf(colored.channels!);
    const { worst, most } = compareRays(
      colored,
      Array.from({ length: 31 }, (_, i) => ({
        value: 8.5 * i,
        color: [1, 1, 1],
        opacity: 1 - (1 - opacity) ** (i / 10),
      })),
      (place) => {
        const extinction = (extinctionOf * interpolate(colored.samples, dimensions, place)) / 85;
        const light = planes.slice(0, 3).map((plane) => (extinction * interpolate(plane, dimensions, place)) / 255);
        return { extinction, light: light as unknown as Vector3 };
      },
    );
    expect(most, 'it is not thin').to.be.above(0.4);
    expect(worst).to.be.below(0.25 / 255);
  });

  it('change nothing where there is no light', () => {
    const end = { value: 0, valid: true, channels: [0, 0, 0, 0] };
    const ray = { point: [0, 0, 0], direction: [0, 0, 1], lengthPerT: 1 } as const;
    const seen = [0.1, 0.2, 0.3, 0.4] as const;
    expect(channelShade({ front: end, back: end, begin: 0, span: 1 }, seen as never, ray)).to.deep.equal(seen);
  });
});

// Random scenes of all kinds, the same in every run.
import { reduceTo } from '../../demos/accuracy/derive-volumes.ts';
import { boundingSphere } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { randomNumbers } from '../helpers/synthetic.ts';
import type { Sight } from './element-picture.ts';
import { loadHere } from './small-page.ts';
import { smoothNoise, VoxelBlock } from './voxel-block.ts';

/** A scene, and what an element is told of it. */
export interface StatedScene {
  readonly name: string;
  readonly volume: Volume;
  readonly transferFunction: string;
  readonly maxError: number;
  readonly sight: Sight;
  /** Device pixels along each side. */
  readonly pixels: number;
}

const volumeKinds = ['brain', 'phantom', 'noise', 'shell', 'labels'] as const;
type VolumeKind = (typeof volumeKinds)[number];

/** By what share of the volume's range they do what. */
const functionKinds: Readonly<Record<string, string>> = {
  smooth: '10% #200 0, 45% #c52 4%, 75% #fd9 20%, 100% white 50%',
  peaks:
    '24.5% #48c 0, 25% #48c 60%, 25.5% #48c 0, 49.5% #f93 0, 50% #f93 60%, 50.5% #f93 0, 74.5% #fff 0, 75% #fff 60%, 75.5% #fff 0',
  'opaque step': '0% #2a4a7a 0, 20% #2a4a7a 3%, 45% #2a4a7a 3%, 45% #ffe8c0 100%, 100% white 100%',
  threshold: '0% #b22 0, 60% #b22 0, 60% #f62 40%, 100% #ff8 70%',
  veil: '5% #68a 0, 15% #68a 1%, 100% #bdf 2%',
};

const errors: readonly number[] = [8, 4, 2, 1, 0.5];

const made: Readonly<Record<VolumeKind, () => Promise<Volume>>> = {
  brain: async () => reduceTo(await loadHere('/demos/data/mni152-t1.nii.gz'), 50),
  phantom: () => loadHere('/demos/data/ct-phantom.nii.gz'),
  noise: () => {
    const noise = smoothNoise(56, 4, randomNumbers(41));
    return Promise.resolve(
      new VoxelBlock(56, (i, j, k) => Math.min(255, Math.max(0, 128 + 360 * (noise(i, j, k) - 0.5)))).toVolume(),
    );
  },
  shell: () =>
    Promise.resolve(
      new VoxelBlock(
        64,
        (i, j, k) => 255 * Math.exp(-(((Math.hypot(i - 31.5, j - 31.5, k - 31.5) - 22) / 1.5) ** 2)),
      ).toVolume(),
    ),
  labels: () => Promise.resolve(makeLabels(48)),
};

/** Regions around random points, each of one value; outside of a ball there is nothing. */
function makeLabels(edge: number): Volume {
  const random = randomNumbers(17);
  const points = Array.from({ length: 40 }, (_, n) => ({
    at: [0, 1, 2].map(() => random() * edge),
    value: 40 * (1 + (n % 6)),
  }));
  return new VoxelBlock(edge, (i, j, k) => {
    if (Math.hypot(i - edge / 2, j - edge / 2, k - edge / 2) > 0.46 * edge) return 0;
    const far = ({ at }: (typeof points)[number]): number => Math.hypot(i - at[0], j - at[1], k - at[2]);
    return points.reduce((a, b) => (far(b) < far(a) ? b : a)).value;
  }).toVolume();
}

/** Of transfer functions and distances; `max-error` goes along. */
const combinations = 20;

/** So many scenes, the volume kinds one after the other, so that each is made once. */
export async function* eachStatedScene(count: number): AsyncGenerator<StatedScene> {
  for (const [n, kind] of volumeKinds.entries()) {
    const volume = await made[kind]();
    // A short run takes some of each kind from the whole list.
    const each = Math.round(count / volumeKinds.length);
    for (let i = 0; i < each; i++)
      yield describeScene(volume, kind, 1000 * n + (each < combinations ? (6 * i + n) % combinations : i));
  }
}

function describeScene(volume: Volume, kind: VolumeKind, number: number): StatedScene {
  const random = randomNumbers(number);
  const pick = <T>(list: readonly T[], n: number): T => list[n % list.length];
  const i = number % 1000;
  const name = pick(Object.keys(functionKinds), i);
  const { center, radius } = boundingSphere(volume.grid);
  // Every fifth is far away: it covers less than a tenth of the picture. The others fill it, or are larger.
  const distance = Math.floor(i / 5) % 4 === 3 ? 9 + 4 * random() : 1.6 + 2 * random();
  return {
    name: `${kind}, ${name}`,
    volume,
    transferFunction: functionKinds[name],
    maxError: pick(errors, Math.floor(i / 5) + i),
    sight: {
      theta: Math.round(360 * random()),
      phi: Math.round(15 + 150 * random()),
      radius: radius * distance,
      target: center,
    },
    pixels: 16 * Math.round(4 + 6 * random()),
  };
}

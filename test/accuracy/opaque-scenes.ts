// Volumes and views whose transfer functions jump to what is opaque, made to break what is said of their errors.
import { orbitCamera } from '../../src/optics/rays/camera.ts';
import { parseTransferFunction } from '../../src/optics/transfer/parse-transfer-function.ts';
import { boundingSphere } from '../../src/volume/grid.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import type { RestScene } from '../helpers/at-rest.ts';
import { obliqueAffine, randomNumbers } from '../helpers/synthetic.ts';
import type { SyntheticOptions } from '../helpers/synthetic.ts';
import { marschnerLobb } from './error-scenes.ts';
import { byIndex, noise, scatter, withVoxels } from './hard-volumes.ts';
import { opaqueOthers } from './opaque-others.ts';
import { loadHere } from './small-page.ts';
import { smoothNoise } from './voxel-block.ts';

/** A scene, and how a table names it. */
export interface OpaqueScene {
  /** made, measured by a scanner, or one of opaque-others.ts, of which no ray-caster of exact cells knows. */
  readonly kind: 'made' | 'real' | 'others';
  readonly name: string;
  readonly scene: RestScene;
}

/** What is opaque: a function of where its threshold is, as shares of the volume's range. */
const looks: Readonly<Record<string, (at: number) => string>> = {
  step: (at) => `${at} #ffe8c0 0, ${at} #ffe8c0 100%, 1 #c04020 100%`,
  'step behind a veil': (at) =>
    `0 #2a4a7a 0, ${0.4 * at} #2a4a7a 0, ${at} #2a4a7a 3%, ${at} #ffe8c0 100%, 1 white 100%`,
  'narrow ramp': (at) => `${at - 0.01} #ffd0a0 0, ${at + 0.01} #ffd0a0 100%, 1 #fff 100%`,
  shell: (at) => `${at} #fa6 0, ${at} #fa6 100%, ${at + 0.06} #fa6 100%, ${at + 0.06} #fa6 0`,
  'two steps': (at) => `${0.7 * at} #38c 0, ${0.7 * at} #38c 35%, ${at} #38c 35%, ${at} #fec 100%, 1 #fec 100%`,
  ramp: (at) => `${0.8 * at} #a42 0, ${at} #ffd 100%, 1 #fff 100%`,
};

/** How much of something there is at a place, by its distance from a surface in voxels. */
const within = (distance: number, soft = 1): number => Math.min(1, Math.max(0, 0.5 - distance / soft));

type Field = (i: number, j: number, k: number) => number;

function made(dimensions: Vector3, of: Field, more: Partial<SyntheticOptions> = {}): Volume {
  return byIndex(dimensions, (...at) => Math.min(1, Math.max(0, of(...at))), more);
}

/** Grey tissue in folds within a skull, with the noise of a scanner. */
function head(edge: number, grain: number, more: Partial<SyntheticOptions> = {}): Volume {
  const random = randomNumbers(edge);
  const folds = smoothNoise(edge, 7, random);
  const middle = (edge - 1) / 2;
  return made(
    [edge, edge, edge],
    (i, j, k) => {
      const far = Math.hypot(i - middle, 1.15 * (j - middle), k - middle);
      const brain = within(far - 0.36 * edge, 2) * (0.45 + 0.25 * Math.sin(24 * folds(i, j, k)));
      return brain + 0.7 * within(Math.abs(far - 0.45 * edge) - 1.2, 1.5) + grain * (random() + random() - 1);
    },
    more,
  );
}

/** A trunk with bones in it: thin ribs, a spine, and a cloud of contrast. */
function trunk(edge: number, grain: number): Volume {
  const random = randomNumbers(edge + 1);
  const middle = (edge - 1) / 2;
  return made(
    [edge, edge, edge],
    (i, j, k) => {
      const [x, y] = [i - middle, j - middle];
      const far = Math.hypot(x, 1.4 * y);
      const ribs =
        within(Math.abs(far - 0.38 * edge) - 1, 1.2) * within(Math.abs(((k + 0.3 * x) % 9) - 4.5) - 1.4, 1.2);
      const spine = within(Math.hypot(x, y + 0.22 * edge) - 3.5, 1.5);
      return 0.35 * within(far - 0.44 * edge, 2) + 0.5 * Math.max(ribs, spine) + grain * (random() + random() - 1);
    },
    { kind: 'uint16' },
  );
}

const cube = (edge: number): Vector3 => [edge, edge, edge];

function clouds(edge: number, apart: readonly number[], more: Partial<SyntheticOptions> = {}): Volume {
  const layers = apart.map((n, layer) => smoothNoise(edge, n, randomNumbers(90 + layer)));
  return made(cube(edge), (i, j, k) => layers.reduce((sum, of, n) => sum + (of(i, j, k) - 0.5) / 2 ** n, 0.5), more);
}

/** Volumes that are made here, and where something is opaque in them. */
const volumes: Readonly<Record<string, { readonly make: () => Volume; readonly at: readonly number[] }>> = {
  'smooth clouds': { make: () => clouds(64, [9]), at: [0.5, 0.6, 0.42] },
  'clouds of three scales': { make: () => clouds(72, [16, 6, 3], { kind: 'uint16' }), at: [0.5, 0.6, 0.66] },
  noise: { make: () => noise([28, 28, 28]), at: [0.6, 0.9, 0.97] },
  'clouds in thick slices': { make: () => clouds(48, [5], { spacing: [1, 1, 4] }), at: [0.55, 0.62, 0.5] },
  'thin sheets': {
    make: () =>
      made(cube(60), (i, j, k) => 0.9 * within(Math.abs(((0.3 * i + 0.8 * j + 0.5 * k) % 11) - 5) - 0.4, 1.4)),
    at: [0.4, 0.62, 0.75],
  },
  'shells that rays touch': {
    make: () => made(cube(64), (i, j, k) => 0.5 + 0.5 * Math.sin(0.9 * Math.hypot(i - 31.5, j - 31.5, k - 31.5))),
    at: [0.93, 0.8, 0.97],
  },
  'balls that fill cells': {
    make: () => made(cube(64), (i, j, k) => within(Math.hypot((i % 8) - 3.5, (j % 8) - 3.5, (k % 8) - 3.5) - 2.6, 1.5)),
    at: [0.5, 0.8, 0.2],
  },
  checkers: {
    make: () =>
      made(cube(40), (i, j, k) => 0.5 + 0.3 * ((((i >> 1) + (j >> 1) + (k >> 1)) % 2) - 0.5) + 0.2 * Math.sin(i / 5)),
    at: [0.6, 0.66, 0.5],
  },
  'bright specks near the threshold': {
    make: () => withVoxels(cube(56), scatter(cube(56), 260), { around: 0.1, value: 0.62 }),
    at: [0.6, 0.4, 0.55],
  },
  'tips of specks': { make: () => withVoxels(cube(56), scatter(cube(56), 400, { seed: 12 })), at: [0.9, 0.96, 0.8] },
  'a head as MRI sees it': { make: () => head(80, 0.03), at: [0.45, 0.6, 0.35] },
  'a noisy head': { make: () => head(72, 0.12, { kind: 'uint16' }), at: [0.5, 0.62, 0.4] },
  'a trunk as CT sees it': { make: () => trunk(84, 0.02), at: [0.5, 0.3, 0.65] },
  "waves at the grid's limit": {
    make: () => made(cube(41), (i, j, k) => marschnerLobb(i / 40, j / 40, k / 40)),
    at: [0.5, 0.45, 0.6],
  },
  'a sheared cloud': {
    make: () => clouds(48, [5, 3], { indexToWorld: obliqueAffine(randomNumbers(4), [1, 1.5, 2]) }),
    at: [0.5, 0.6, 0.65],
  },
  wires: {
    make: () =>
      made(cube(64), (i, j, k) =>
        Math.max(
          within(Math.hypot(((i + 0.2 * k) % 12) - 6, ((j + 0.1 * k) % 12) - 6) - 0.6, 1.6),
          within(Math.hypot(((k + 0.15 * i) % 12) - 6, ((j - 0.2 * i + 64) % 12) - 6) - 0.6, 1.6),
        ),
      ),
    at: [0.4, 0.6, 0.72],
  },
};

/** Files of volumes, and shares of their range where something is opaque. Those in ../shared/data are left out where it is absent. */
const files: Readonly<Record<string, { readonly url: string; readonly at: readonly number[] }>> = {
  'MRI, MNI152': { url: '/demos/data/mni152-t1.nii.gz', at: [0.45, 0.6, 0.72] },
  'CT phantom': { url: '/demos/data/ct-phantom.nii.gz', at: [0.55, 0.35, 0.7] },
  'MRI, anatomical': { url: '/shared-data/medical/nibabel_4d/anatomical.nii', at: [0.25, 0.4, 0.55] },
  'MRI, ch2': { url: '/shared-data/medical/ch2_mricron/ch2.nii.gz', at: [0.35, 0.5, 0.62] },
  'CTA, stent': { url: '/shared-data/medical/stent_nrrd/stent.nrrd', at: [0.3, 0.45, 0.6] },
  'CT, skull': { url: '/shared-data/medical/cranium_ct/cranium_ct.nii.gz', at: [0.35, 0.5, 0.28] },
  'white matter, MNI152': {
    url: '/shared-data/medical/mni152_nilearn/mni_icbm152_wm_tal_nlin_sym_09a_converted.nii.gz',
    at: [0.5, 0.8, 0.95],
  },
};

/** Scenes of a volume: its thresholds, looks and views are taken in turns, so that each volume has others. */
function* listScenes(
  kind: 'made' | 'real',
  called: string,
  { volume, at }: { readonly volume: Volume; readonly at: readonly number[] },
  number: number,
): Generator<OpaqueScene> {
  const random = randomNumbers(100 + number);
  const names = Object.keys(looks);
  const [low, high] = volume.range;
  const { center, radius } = boundingSphere(volume.grid);
  for (const [n, threshold] of at.entries()) {
    const appearance = names[(number + 2 * n + (n > 1 ? 1 : 0)) % names.length];
    // Those of the picture's sizes are in turns: all of a small picture's pixels are probed, and few of a large one's.
    const side = [120, 200, 260, 160][(number + n) % 4];
    const distance = [2.6, 1.7, 3.4, 2.1][(number + 2 * n) % 4] + 0.3 * random();
    const camera = orbitCamera(
      { theta: 6.28 * random(), phi: 0.3 + 2.5 * random(), radius: radius * distance },
      center,
      0.7,
    );
    const stops = looks[appearance](threshold).replace(
      /(^|, )([\d.]+)/g,
      (_, begin: string, share: string) => `${begin}${(low + Number(share) * (high - low)).toPrecision(7)}`,
    );
    yield {
      kind,
      name: `${called}, ${appearance} at ${threshold}, ${side} × ${side}`,
      scene: {
        volume,
        style: null,
        transferFunction: parseTransferFunction(stops, [low, high]),
        camera,
        size: { width: side, height: side },
        optics: { referenceLength: radius / 60 },
      },
    };
  }
}

/** All names of volumes. */
export const opaqueVolumes: readonly string[] = [
  ...Object.keys(volumes),
  ...Object.keys(files),
  ...Object.keys(opaqueOthers),
];

/** The scenes of a volume; null where there is no such file. */
export async function listOpaqueScenes(called: string): Promise<readonly OpaqueScene[] | null> {
  const number = opaqueVolumes.indexOf(called);
  const other = opaqueOthers[called];
  if (other) return [{ kind: 'others', name: called, scene: other() }];
  const own = volumes[called];
  if (own) return [...listScenes('made', called, { volume: own.make(), at: own.at }, number)];
  const { url, at } = files[called];
  if (!(await fetch(url, { method: 'HEAD' })).ok) return null;
  return [...listScenes('real', called, { volume: await loadHere(url), at }, number)];
}

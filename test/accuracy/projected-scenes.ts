// Projections that were made to break what is said of their largest errors.
import { orbitCamera } from '../../src/optics/rays/camera.ts';
import { parseTransferFunction } from '../../src/optics/transfer/parse-transfer-function.ts';
import { projectionKinds } from '../../src/optics/rays/ray-style.ts';
import type { ProjectionKind } from '../../src/optics/rays/ray-style.ts';
import { boundingSphere } from '../../src/volume/grid.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import type { RestScene } from '../helpers/at-rest.ts';
import { obliqueAffine, randomNumbers } from '../helpers/synthetic.ts';
import { ball, byIndex, holes, noise, scatter, sheared, withVoxels } from './hard-volumes.ts';

/** A view of a projection. */
export interface ProjectedScene {
  readonly kind: ProjectionKind;
  readonly name: string;
  readonly make: () => RestScene;
}

const block: Vector3 = [28, 28, 28];

/** Wires one voxel thin along axes and diagonals, and one that runs askew. */
function wires(more: Parameters<typeof withVoxels>[2] = {}): Volume {
  const along = (count: number, of: (n: number) => Vector3): Vector3[] =>
    Array.from({ length: count }, (_, n) => of(n));
  return withVoxels(
    block,
    [
      ...along(20, (n) => [4 + n, 6, 20]),
      ...along(20, (n) => [20, 4 + n, 8]),
      ...along(18, (n) => [5 + n, 5 + n, 5 + n]),
      ...along(20, (n) => [4 + n, 14, Math.round(6 + 0.37 * n)]),
    ],
    more,
  );
}

const volumes: Readonly<Record<string, () => Volume>> = {
  'one voxel': () => withVoxels(block, [[13, 15, 12]]),
  specks: () => withVoxels(block, scatter(block, 25)),
  wires: () => wires(),
  'wires of 16 bits': () => wires({ kind: 'uint16' }),
  'wires between long voxels': () => wires({ spacing: [0.5, 0.5, 3] }),
  noise: () => noise(block),
  'noise in floats': () => noise([19, 23, 17], 5, { kind: 'float32' }),
  'a comb': () => byIndex(block, (i) => i % 2),
  'a chessboard': () => byIndex(block, (i, j, k) => (i + j + k) % 2),
  'a ball': () => ball(28, 9, 1),
  shells: () => byIndex(block, (i, j, k) => 0.5 + 0.5 * Math.cos(2.2 * Math.hypot(i - 13.5, j - 13.5, k - 13.5))),
  sheets: () => byIndex(block, (i, j, k) => Number((i + 2 * j + k) % 9 === 0)),
  askew: () => sheared(block, scatter(block, 20), [1, 2, 0.7]),
  'noise askew': () => noise([20, 16, 24], 9, { indexToWorld: obliqueAffine(randomNumbers(4), [1, 1.3, 0.6]) }),
  'a thin sheet': () => noise([30, 30, 2], 6),
  'dark voxels in light': () => withVoxels(block, scatter(block, 25, { seed: 11 }), { value: 0, around: 1 }),
  holes: () => holes(24, 12),
  waves: () =>
    byIndex(block, (i, j, k) => 0.5 + 0.25 * Math.sin(0.9 * i + 0.4 * j) + 0.25 * Math.sin(1.3 * k - 0.5 * i), {
      kind: 'float32',
    }),
};

/** Grey, steep ones, ones that are not monotone, and jumps. */
const looks = [
  '0 black 100%, 1 white 100%',
  '0 #000 0, 1 #fff 100%',
  '0.45 #0cf 0, 0.5 #0cf 60%, 0.55 #0cf 0',
  '0.3 #fa6 0, 1 #fa6 60%',
  '0.9 #fff 0, 1 #fff 99%',
  '0 #246 1%, 0.6 #c85 30%, 0.6 #fff 60%, 1 #fff 60%',
] as const;

/** Thin: of emission and absorption next to nothing could be missed. To projections neither length nor factor matters. */
const optics = { referenceLength: 400, opacityFactor: 0.1 } as const;

/** So many that not all pixels are probed. */
const size = { width: 150, height: 130 } as const;

/** Each volume in each projection, from four sides: far, near, and with the eye inside; looks take turns. */
export const projectedScenes: readonly ProjectedScene[] = Object.entries(volumes).flatMap(([name, make], n) =>
  projectionKinds.flatMap((kind, k) =>
    [2.4, 1.7, 3.5, 0.6].map((far, i) => {
      const appearance = looks[(n + k + i) % looks.length];
      return {
        kind,
        name: `${name}, ${appearance}, ${i}`,
        make: () => sceneOf(make(), { kind, look: appearance, far, seed: 100 * n + 10 * k + i }),
      };
    }),
  ),
);

function sceneOf(
  volume: Volume,
  {
    kind,
    look: appearance,
    far,
    seed,
  }: { readonly kind: ProjectionKind; readonly look: string; readonly far: number; readonly seed: number },
): RestScene {
  const random = randomNumbers(seed);
  const { center, radius } = boundingSphere(volume.grid);
  const camera = orbitCamera({ theta: 6.2 * random(), phi: 0.3 + 2.5 * random(), radius: far * radius }, center, 0.7);
  return {
    volume,
    style: { projection: kind },
    transferFunction: parseTransferFunction(
      appearance,
      volume.range[0] < 0 || volume.range[1] > 1 ? volume.range : [0, 1],
    ),
    camera,
    size,
    optics,
  };
}

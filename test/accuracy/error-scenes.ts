import { orbitCamera } from '../../src/optics/rays/camera.ts';
import type { Camera } from '../../src/optics/rays/camera.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { longestDiagonal } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { randomNumbers, smoothField, syntheticVolume } from '../helpers/synthetic.ts';

/** A scene whose error is estimated and known. */
export interface ErrorScene {
  readonly name: string;
  readonly volume: Volume;
  readonly transferFunction: TransferFunction;
  readonly camera: Camera;
  readonly steps: number;
}

/** Marschner and Lobb's test signal, 1994: frequencies up to the grid's own. */
export function marschnerLobb(x: number, y: number, z: number): number {
  const [px, py, pz] = [2 * x - 1, 2 * y - 1, 2 * z - 1];
  const wave = Math.cos(2 * Math.PI * 6 * Math.cos((Math.PI * Math.hypot(px, py)) / 2));
  return (1 - Math.sin((Math.PI * pz) / 2) + 0.25 * (1 + wave)) / 2.5;
}

/** Thin shells around the centre. */
function shells(x: number, y: number, z: number): number {
  const r = Math.hypot(x - 0.5, y - 0.5, z - 0.5);
  return 0.5 + 0.5 * Math.sin(40 * r) * (r < 0.5 ? 1 : 0);
}

/** A value a voxel with nothing in common with its neighbours'. */
function noise(): () => number {
  return randomNumbers(31);
}

const fields = [
  { name: 'smooth', field: smoothField, dimensions: [40, 34, 28] as const },
  { name: 'Marschner-Lobb', field: marschnerLobb, dimensions: [41, 41, 41] as const },
  { name: 'shells', field: shells, dimensions: [48, 48, 48] as const },
  { name: 'noise', field: noise(), dimensions: [20, 24, 22] as const },
];

const peak = (value: number, color: readonly [number, number, number]): TransferFunction => [
  { value: value - 0.005, color, opacity: 0 },
  { value, color, opacity: 0.7 },
  { value: value + 0.005, color, opacity: 0 },
];

const transferFunctions: Record<string, TransferFunction> = {
  smooth: [
    { value: 0.2, color: [0, 0, 0.3], opacity: 0 },
    { value: 0.5, color: [0.9, 0.4, 0.1], opacity: 0.05 },
    { value: 0.9, color: [1, 1, 0.8], opacity: 0.3 },
  ],
  peaks: [...peak(0.35, [1, 0.2, 0.1]), ...peak(0.5, [0.2, 1, 0.3]), ...peak(0.65, [1, 1, 1])],
  jumps: [
    { value: 0.4, color: [0.2, 0.4, 0.8], opacity: 0 },
    { value: 0.4, color: [0.2, 0.4, 0.8], opacity: 0.05 },
    { value: 0.6, color: [0.2, 0.4, 0.8], opacity: 0.05 },
    { value: 0.6, color: [1, 0.8, 0.2], opacity: 0.4 },
  ],
  opaque: [
    { value: 0.45, color: [0.7, 0.2, 0.2], opacity: 0 },
    { value: 0.5, color: [1, 0.8, 0.6], opacity: 0.9 },
    { value: 0.55, color: [1, 1, 1], opacity: 1 },
  ],
};

/** Four fields, four transfer functions, a coarse and a fine step each, from as many sides. */
export function errorScenes(): ErrorScene[] {
  const random = randomNumbers(5);
  return fields.flatMap(({ name, field, dimensions }) => {
    const volume = syntheticVolume({ dimensions, field, kind: 'uint16' });
    return Object.entries(transferFunctions).flatMap(([kind, transferFunction]) =>
      [30, 90].map((steps) => ({
        name: `${name}, ${kind}, ${steps} steps`,
        volume,
        transferFunction,
        camera: orbitCamera(
          { theta: random() * 6, phi: 0.5 + random() * 2, radius: longestDiagonal(volume.grid) * 1.6 },
          [0, 0, 0],
          0.5,
        ),
        steps,
      })),
    );
  });
}

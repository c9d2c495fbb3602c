import type { LabelMap, LabelStyle, ShownLabels } from '../../src/volume/labels.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { randomNumbers } from './synthetic.ts';

/** A map of what each voxel is of, told by its index. @param count - labels in all; more than 256 take two bytes */
export function labelMap(dimensions: Vector3, numberOf: (i: number, j: number, k: number) => number, count = 256): LabelMap {
  const [nx, ny, nz] = dimensions;
  const numbers = new (count > 256 ? Uint16Array : Uint8Array)(nx * ny * nz);
  for (let k = 0, at = 0; k < nz; k++) for (let j = 0; j < ny; j++) for (let i = 0; i < nx; i++, at++) numbers[at] = numberOf(i, j, k);
  return { dimensions, numbers, ids: Array.from({ length: count }, (_, i) => 7 * i) };
}

export const plainLook: LabelStyle = { color: [1, 1, 1], opacityFactor: 1 };

/** Looks of all kinds that are the same in every run: some hidden, some denser than the volume, some as it is. */
export function mixedLooks(map: LabelMap): ShownLabels {
  const random = randomNumbers(5);
  const factors = [1, 0, 0.3, 2.5];
  return { map, styles: map.ids.map((_, i) => (i === 0 ? plainLook : { color: [random(), random(), random()], opacityFactor: factors[i % 4] })) };
}

/** Blocks of voxels, each of another thing. @param count - see `labelMap` */
export function blocks(dimensions: Vector3, count: number, edge = 4): LabelMap {
  const random = randomNumbers(9);
  const across = dimensions.map((n) => Math.ceil(n / edge));
  const things = Array.from({ length: across[0] * across[1] * across[2] }, () => Math.floor(random() * count));
  return labelMap(dimensions, (...at) => {
    const [i, j, k] = at.map((x) => Math.floor(x / edge));
    return things[i + across[0] * (j + across[1] * k)];
  }, count);
}

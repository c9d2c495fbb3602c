import { parseTransferFunction } from '../../src/optics/transfer/parse-transfer-function.ts';
import type { LabelMap, LabelStyle, ShownLabels } from '../../src/volume/labels.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { randomNumbers } from './synthetic.ts';

/** A label map, computed from the voxels' indices. @param count - the number of labels; more than 256 need two bytes */
export function labelMap(
  dimensions: Vector3,
  numberOf: (i: number, j: number, k: number) => number,
  count = 256,
): LabelMap {
  const [nx, ny, nz] = dimensions;
  const numbers = new (count > 256 ? Uint16Array : Uint8Array)(nx * ny * nz);
  for (let k = 0, at = 0; k < nz; k++)
    for (let j = 0; j < ny; j++) for (let i = 0; i < nx; i++, at++) numbers[at] = numberOf(i, j, k);
  return { dimensions, numbers, ids: Array.from({ length: count }, (_, i) => 7 * i) };
}

export const plainAppearance: LabelStyle = { color: [1, 1, 1], opacityFactor: 1 };

/** Label styles of all kinds, the same in every run: some hidden, some denser than the volume, some unchanged. */
export function mixedAppearances(map: LabelMap): ShownLabels {
  const random = randomNumbers(5);
  const factors = [1, 0, 0.3, 2.5];
  return {
    map,
    styles: map.ids.map((_, i) =>
      i === 0 ? plainAppearance : { color: [random(), random(), random()], opacityFactor: factors[i % 4] },
    ),
  };
}

/**
 * Label styles of all kinds in five groups. Their transfer functions: dense where the volume is not, one with a jump, one that shows
 * little, and one that is mostly outside of the volume's own domain.
 */
export function mixedGroups(map: LabelMap): ShownLabels {
  const { styles } = mixedAppearances(map);
  const functions = [
    '0 #08f 30%, 0.4 #08f 0',
    '0.2 #fff 0, 0.5 #fff 0, 0.5 #0f8 97%, 0.9 #f0f 20%',
    '0 #ff0 1%, 1 #f80 2%',
    '-2 #f00 0, 3 #0ff 60%',
  ];
  return {
    map,
    styles: styles.map((style, i) => ({ ...style, group: i % 5 })),
    functions: functions.map((text) => parseTransferFunction(text, [0, 1])),
  };
}

/** Blocks of voxels, each with another label. @param count - see `labelMap` */
export function blocks(dimensions: Vector3, count: number, edge = 4): LabelMap {
  const random = randomNumbers(9);
  const across = dimensions.map((n) => Math.ceil(n / edge));
  const things = Array.from({ length: across[0] * across[1] * across[2] }, () => Math.floor(random() * count));
  return labelMap(
    dimensions,
    (...at) => {
      const [i, j, k] = at.map((x) => Math.floor(x / edge));
      return things[i + across[0] * (j + across[1] * k)];
    },
    count,
  );
}

import type { LabelStyle, ShownLabels } from '../../src/volume/labels.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { labelMap } from '../helpers/labels.ts';
import { randomNumbers } from '../helpers/synthetic.ts';

/** Regions around random points, in blocks of voxels; of the second one half is hidden. */
export function listAtlases({
  grid: { dimensions },
}: Volume): { readonly name: string; readonly labels: ShownLabels }[] {
  const [random, count, edge] = [randomNumbers(4), 100, 4];
  const points = Array.from({ length: count }, () => dimensions.map((n) => (random() * n) / edge));
  const across = dimensions.map((n) => Math.ceil(n / edge));
  const far = (place: readonly number[], n: number): number =>
    Math.hypot(...place.map((x, axis) => x - points[n][axis]));
  const regions = Uint8Array.from({ length: across[0] * across[1] * across[2] }, (_, at) => {
    const place = [at % across[0], Math.floor(at / across[0]) % across[1], Math.floor(at / across[0] / across[1])];
    let nearest = 0;
    for (let n = 1; n < count; n++) if (far(place, n) < far(place, nearest)) nearest = n;
    return nearest;
  });
  const map = labelMap(
    dimensions,
    (i, j, k) => regions[(i >> 2) + across[0] * ((j >> 2) + across[1] * (k >> 2))],
    count,
  );
  const styles = map.ids.map((): LabelStyle => ({ color: [random(), random(), random()], opacityFactor: 1 }));
  const half = styles.map((style, n) => ({ ...style, opacityFactor: n % 2 }));
  return [
    { name: 'an atlas of 100 labels', styles },
    { name: 'the same, half of it hidden', styles: half },
  ].map((one) => ({ name: one.name, labels: { map, styles: one.styles } }));
}

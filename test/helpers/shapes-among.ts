import { boundingSphere } from '../../src/volume/grid.ts';
import type { GridFrame } from '../../src/volume/grid.ts';

const color = '<appearance><material emissiveColor="1 0.6 0" diffuseColor="0 0 0"></material></appearance>';

/** Opaque shapes of several kinds inside a volume, as X3D, by their names. */
export function shapesAmong(grid: GridFrame): Readonly<Record<string, string>> {
  const { center, radius } = boundingSphere(grid);
  const at = (x: number, y: number, z: number): string =>
    [x, y, z].map((share, axis) => center[axis] + share * radius).join(' ');
  const put = (place: string, shape: string, turn = '1 0 0 0'): string =>
    `<transform translation="${place}" rotation="${turn}"><shape>${color}${shape}</shape></transform>`;
  const line = (points: readonly string[]): string =>
    `<shape>${color}<indexedlineset coordIndex="${points.map((_, i) => i).join(' ')} -1"><coordinate point="${points.join(' ')}"></coordinate></indexedlineset></shape>`;
  const ring = (share: number): string =>
    line(
      Array.from({ length: 61 }, (_, i) =>
        at(share * Math.cos((i * Math.PI) / 30), share * Math.sin((i * Math.PI) / 30), -0.05),
      ),
    );
  const marker = put(at(0.2, 0.1, 0.2), `<sphere radius="${0.05 * radius}"></sphere>`);
  const lines = line([at(-1, -0.8, -0.2), at(1, 0.9, 0.3)]) + line([at(0.1, -0.9, 0.4), at(0.1, 0.9, -0.4)]);
  const rings = [0.15, 0.3, 0.45, 0.6].map(ring).join('');
  const ball = put(at(0, 0, -0.2), `<sphere radius="${0.4 * radius}"></sphere>`);
  return {
    'a marker': marker,
    'thin lines': lines,
    rings,
    'a plane across': put(at(0, 0, 0), `<box size="${2 * radius} ${0.001 * radius} ${2 * radius}"></box>`, '1 0 0 0.4'),
    'a large ball': ball,
    points: `<shape>${color}<pointset><coordinate point="${Array.from({ length: 40 }, (_, i) => at(0.6 * Math.sin(7 * i), 0.6 * Math.sin(11 * i + 1), 0.6 * Math.sin(13 * i + 2))).join(' ')}"></coordinate></pointset></shape>`,
    'several of them': marker + lines + rings + ball,
  };
}

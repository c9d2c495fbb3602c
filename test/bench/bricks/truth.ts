// The error of a picture whose volume is resident at mixed levels, against the float64 reference over the finest level.
import { castSeen, findSeenCells } from '../../../src/prepare/cast-seen.ts';
import type { SeenCells } from '../../../src/prepare/cast-seen.ts';
import { stagesOf } from '../../../src/optics/reference.ts';
import type { RaySetup } from '../../../src/optics/rays/rays.ts';
import type { Premultiplied, TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { finestSpacing } from '../../../src/volume/grid.ts';
import { buildMacrocells } from '../../../src/volume/macrocells.ts';
import type { Macrocells } from '../../../src/volume/macrocells.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { compareCovered } from '../../helpers/covered-error.ts';
import type { CoveredError } from '../../helpers/covered-error.ts';
import type { Pyramid } from '../../../src/bricks/pyramid.ts';
import { countBricks, toLevel } from '../../../src/bricks/pyramid.ts';
import { cellFinder, residentField } from '../../../src/bricks/resident-field.ts';
import type { BrickScene } from './scenes.ts';

/** Errors of pictures of a view, by the level of each cell. */
export interface Judge {
  errorOf(levelOf: Uint8Array): CoveredError;
}

/** The macrocells of each level. */
export const macrocellsOf = ({ levels }: Pyramid): Macrocells[] =>
  levels.map(({ samples, dimensions }) => buildMacrocells(samples, dimensions));

/** @param size - rays across and down */
export function judgeView(
  scene: BrickScene,
  pyramid: Pyramid,
  macrocells: readonly Macrocells[],
  {
    transferFunction,
    rays,
    size,
  }: { readonly transferFunction: TransferFunction; readonly rays: RaySetup; readonly size: number },
): Judge {
  const { slope, intercept } = scene;
  // Whether a level shows something near a place: of all levels, as a neighbour may be at any.
  const seen = macrocells.map((cells, level) => {
    const { dimensions } = pyramid.levels[level];
    const volume = { macrocells: cells, grid: { ...scene.grid, dimensions }, slope, intercept } as Volume;
    return { isSeen: findSeenCells(volume, transferFunction), scale: toLevel(pyramid, level) };
  });
  const isSeen: SeenCells = (x, y, z) =>
    seen.some(({ isSeen: shows, scale: [sx, sy, sz] }) => shows(x * sx, y * sy, z * sz));
  const levels = new Uint8Array(countCells(pyramid));
  const field = residentField(pyramid, levels, scene);
  const cellAt = cellFinder(pyramid);
  let visited = new Set<number>();
  const stages = stagesOf(
    {
      ...scene,
      transferFunction,
      opacityFactor: 1,
      lightFactor: 1,
      stepLength: finestSpacing(scene.grid),
      field: {
        ...field,
        sampleAt: (place) => {
          visited.add(cellAt(...place));
          return field.sampleAt(place);
        },
      },
    },
    rays,
  );
  const cast = castSeen(stages, rays, isSeen);
  // A ray whose cells all have the levels of its last cast shows the same again.
  const memory: {
    readonly cells: readonly number[];
    readonly levels: readonly number[];
    readonly color: Premultiplied;
  }[] = [];
  const colorOf = (pixel: number): Premultiplied => {
    const last = memory[pixel];
    if (last?.cells.every((cell, n) => levels[cell] === last.levels[n])) return last.color;
    visited = new Set();
    const color = cast((2 * (pixel % size) + 1) / size - 1, 1 - (2 * Math.floor(pixel / size) + 1) / size);
    const cells = [...visited];
    memory[pixel] = { cells, levels: cells.map((cell) => levels[cell]), color };
    return color;
  };
  const draw = (levelOf: Uint8Array): Float64Array => {
    levels.set(levelOf);
    const pixels = new Float64Array(4 * size * size);
    for (let pixel = 0; pixel < size * size; pixel++) pixels.set(colorOf(pixel), 4 * pixel);
    return pixels;
  };
  const exact = draw(new Uint8Array(levels.length));
  return { errorOf: (levelOf) => compareCovered(draw(levelOf), exact, 255) };
}

const countCells = (pyramid: Pyramid): number => countBricks(pyramid, 0).reduce((a, b) => a * b);

import { VolumeViewError } from '../../core/errors.ts';
import type { PlaneSlab, PlaneSlice } from '../../optics/attachments/plane-slices.ts';
import { grayLevels, grayRange } from '../../panes/gray-levels.ts';
import { planeOf } from '../../panes/slice-plane.ts';
import { SlicedVolume } from '../../panes/slice-field.ts';
import { suitingWindow, suitsColors } from '../../panes/suiting-window.ts';
import { createPlanes } from '../../renderer/ray/modules/plane-slices.ts';
import type { RayCut } from '../../renderer/ray/ray-module.ts';
import { corners } from '../../volume/grid.ts';
import { scale, transformDirection } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import { findWindow } from '../appearance/find-window.ts';
import type { WindowSetting } from '../model/parse-attributes.ts';
import { middleAlong, planeInCube } from './plane-in-cube.ts';
import { SliceReader } from './slice-attributes.ts';

/** The maximum number of planes in the shader. */
const maxPlanes = 4;

/** Slices through a volume in world coordinates, and the first error; slices that can't be read are left out. */
export interface ReadPlanes {
  readonly cuts: readonly RayCut[];
  readonly error: VolumeViewError | null;
}

/** @param window - what the page gives for the volume; null where it gives none */
export function readPlanes(elements: readonly Element[], volume: Volume, window: WindowSetting | null): ReadPlanes {
  const planes: PlaneSlice[] = [];
  let error: VolumeViewError | null = null;
  for (const element of elements.slice(0, maxPlanes)) {
    try {
      planes.push(readPlane(element, volume, window));
    } catch (thrown) {
      error ??= thrown as VolumeViewError;
    }
  }
  if (elements.length > maxPlanes) {
    error ??= new VolumeViewError(
      'attribute/invalid',
      `volume-view got ${elements.length} volume-slice elements; expected at most ${maxPlanes}. Set "hidden" on those that are not needed.`,
    );
  }
  return { cuts: planes.length > 0 ? [{ create: createPlanes, items: planes }] : [], error };
}

function readPlane(element: Element, volume: Volume, shared: WindowSetting | null): PlaneSlice {
  const {
    type,
    normal: along,
    at,
    colors,
    thickness,
    projection,
    window: own,
    windowFunction,
  } = new SliceReader((name) => element.getAttribute(name), ' of a volume-slice').plane();
  const { grid } = volume;
  if (grid.kind === 'polar')
    throw new VolumeViewError(
      'attribute/invalid',
      `volume-slice type="${type}" got a radar scan, which has no such slices; expected ppi, cappi, rhi or section.`,
    );
  const { normal } = planeOf(type, along);
  const sliced = new SlicedVolume(volume, grid);
  const middle = at ?? middleAlong(normal, corners(grid));
  const thick = sliced.thicknessAt(middle, { normal, thickness, projection });
  const isColored = (colors ?? (suitsColors(volume) ? 'volume' : 'gray')) === 'volume';
  return {
    kind: 'plane',
    ...planeInCube(normal, middle, grid),
    slab: thick > 0 ? slabOf(normal, thick, { kind: projection, sliced }) : null,
    window: isColored
      ? null
      : grayRange(grayLevels(findWindow(own ?? shared, volume) ?? suitingWindow(volume), windowFunction, volume)),
  };
}

function slabOf(
  normal: Vector3,
  thickness: number,
  { kind, sliced }: { readonly kind: PlaneSlab['kind']; readonly sliced: SlicedVolume },
): PlaneSlab {
  const way = transformDirection(sliced.worldToIndex, scale(normal, thickness));
  return { kind, way: way.map((x, axis) => x / sliced.grid.dimensions[axis]) as unknown as Vector3 };
}

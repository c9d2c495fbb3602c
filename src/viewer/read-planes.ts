import { VolumeViewError } from '../errors.ts';
import type { PlaneSlice } from '../optics/plane-slices.ts';
import { grayRange, windowFunctions } from '../panes/gray-levels.ts';
import { planeOf, sliceTypes } from '../panes/slice-plane.ts';
import type { SliceType } from '../panes/slice-plane.ts';
import { suitingWindow, suitsColors } from '../panes/suiting-window.ts';
import { createPlanes } from '../renderer/ray/modules/plane-slices.ts';
import type { RayCut } from '../renderer/ray/ray-module.ts';
import { corners, unitToWorld } from '../volume/grid.ts';
import { longest } from '../volume/grid-limits.ts';
import { dot, scale } from '../volume/matrix.ts';
import type { Vector3 } from '../volume/matrix.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import { invalid, isNumber, parseNumbers, parseWindow, parseWord } from './parse-attributes.ts';

/** A program knows no more. */
const maxPlanes = 4;

/** Slices through a volume in world coordinates, and the first error; those that can't be read are left out. */
export interface ReadPlanes {
  readonly cuts: readonly RayCut[];
  readonly error: VolumeViewError | null;
}

/** @param window - data values of black and white that the page gives the volume; null where it says nothing */
export function readPlanes(elements: readonly Element[], volume: Volume, window: readonly [number, number] | null): ReadPlanes {
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
    error ??= new VolumeViewError('attribute/invalid', `volume-view got ${elements.length} volume-slice elements; expected at most ${maxPlanes}. Set "hidden" on those that are not needed.`);
  }
  return { cuts: planes.length > 0 ? [{ create: createPlanes, items: planes }] : [], error };
}

function readPlane(element: Element, volume: Volume, window: readonly [number, number] | null): PlaneSlice {
  const read = <T>(name: string, parse: (text: string) => T): T | null => {
    const text = element.getAttribute(name);
    return text === null || text.trim() === '' ? null : parse(text);
  };
  const type = parseWord('type of a volume-slice', element.getAttribute('type') ?? '', sliceTypes);
  if (isPolar(volume)) throw new VolumeViewError('attribute/invalid', `volume-slice type="${type}" got a radar scan, which has no such slices; expected ppi, cappi, rhi or section.`);
  const { normal } = planeOf(type, read('normal', (text) => parseNormal(text)) ?? undefined);
  const at = read('at', (text) => parseAt(text, type)) ?? middleAlong(normal, volume);
  const isColored = read('colors', (text) => parseWord('colors of a volume-slice', text, ['gray', 'volume']));
  const windowFunction = read('window-function', (text) => parseWord('window-function of a volume-slice', text, windowFunctions)) ?? 'linear-exact';
  const own = read('value-window', parseWindow) ?? window ?? suitingWindow(volume);
  return {
    kind: 'plane',
    ...inUnitCube(normal, at, volume),
    window: (isColored ?? (suitsColors(volume) ? 'volume' : 'gray')) === 'volume' ? null : grayRange({ window: own, windowFunction }),
  };
}

function parseNormal(text: string): Vector3 {
  const normal = parseNumbers('normal of a volume-slice', text, 3) as unknown as Vector3;
  const most = Math.max(...normal.map(Math.abs));
  if (!(most > 0 && most <= longest)) throw invalid('normal of a volume-slice', text, 'a direction, like "0 1 1"; it may not be 0 0 0');
  return normal;
}

function parseAt(text: string, type: SliceType): number {
  const at = isNumber(text.trim()) ? Number(text) : NaN;
  if (!(Math.abs(at) <= longest)) throw invalid(`at of volume-slice type="${type}"`, text, 'a place along the slice\'s normal in world units, like "-12.5"');
  return at;
}

/** Half way through the volume's box. */
function middleAlong(normal: Vector3, { grid }: Volume): number {
  const places = corners(grid).map((corner) => dot(normal, corner));
  return (Math.min(...places) + Math.max(...places)) / 2;
}

/** The same plane in the grid's unit cube, its normal of a size that floats like. */
function inUnitCube(normal: Vector3, at: number, { grid }: Volume): Pick<PlaneSlice, 'normal' | 'offset'> {
  const m = unitToWorld(grid);
  const turned = [0, 1, 2].map((column) => dot(normal, [m[column], m[4 + column], m[8 + column]])) as unknown as Vector3;
  const size = Math.max(...turned.map(Math.abs));
  return { normal: scale(turned, 1 / size), offset: (at - dot(normal, [m[3], m[7], m[11]])) / size };
}

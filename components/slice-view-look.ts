import { VolumeViewError } from '../src/errors.ts';
import { dragKinds } from '../src/panes/pane-input.ts';
import type { DragKind } from '../src/panes/pane-input.ts';
import { slabProjections } from '../src/panes/fill-slice.ts';
import { windowFunctions } from '../src/panes/gray-levels.ts';
import type { SliceLook } from '../src/panes/slice-pane.ts';
import { sliceTypes } from '../src/panes/slice-plane.ts';
import { suitingWindow, suitsColors } from '../src/panes/suiting-window.ts';
import { defaultPreset } from '../src/optics/default-preset.ts';
import { resolveTransferFunction } from '../src/optics/resolve-transfer-function.ts';
import { invalid, isNumber, parseFactor, parseNumbers, parseWindow, parseWord } from '../src/viewer/parse-attributes.ts';
import type { VolumeOptics } from '../src/viewer/volume-info.ts';
import { longest } from '../src/volume/grid-limits.ts';
import type { Vector3 } from '../src/volume/matrix.ts';
import { isPolar } from '../src/volume/volume.ts';
import type { Volume } from '../src/volume/volume.ts';

/** What the attributes of a pane say, whatever the volume. What is null follows from it. */
export interface SliceAttributes extends Omit<SliceLook, 'window' | 'colors'> {
  readonly window: readonly [number, number] | null;
  readonly colors: 'gray' | 'volume' | null;
  readonly drag: DragKind;
  readonly cursor: Vector3 | null;
  /** World units along the normal. */
  readonly at: number | null;
}

/** @param text - of an attribute, null where it is absent @throws {VolumeViewError} `attribute/invalid` */
export function readSliceAttributes(text: (name: string) => string | null): SliceAttributes {
  const read = <T>(name: string, parse: (text: string) => T): T | null => {
    const given = text(name);
    return given === null || given.trim() === '' ? null : parse(given);
  };
  const word = <const Word extends string>(name: string, words: readonly Word[]): Word | null => read(name, (given) => parseWord(name, given, words));
  return {
    type: word('type', sliceTypes) ?? 'axial',
    normal: read('normal', parseNormal) ?? [0, 0, 1],
    thickness: read('thickness', (given) => parseFactor('thickness', given)) ?? 0,
    projection: word('projection', slabProjections) ?? 'average',
    window: read('value-window', parseWindow),
    windowFunction: word('window-function', windowFunctions) ?? 'linear-exact',
    isNearest: word('interpolation', ['linear', 'nearest']) === 'nearest',
    colors: word('colors', ['gray', 'volume']),
    drag: word('drag', dragKinds) ?? 'cursor',
    cursor: read('cursor', (given) => parsePlace('cursor', given)),
    at: read('at', parseAt),
  };
}

function parsePlace(name: string, text: string): Vector3 {
  const place = parseNumbers(name, text, 3) as unknown as Vector3;
  if (Math.max(...place.map(Math.abs)) > longest) throw invalid(name, text, 'a place nearer than 1e12');
  return place;
}

function parseNormal(text: string): Vector3 {
  const normal = parsePlace('normal', text);
  if (!(Math.max(...normal.map(Math.abs)) > 0)) throw invalid('normal', text, 'a direction, like "0 1 1"; it may not be 0 0 0');
  return normal;
}

function parseAt(text: string): number {
  const at = isNumber(text.trim()) ? Number(text) : NaN;
  if (!(Math.abs(at) <= longest)) throw invalid('at', text, 'a place along the slice\'s normal in world units, like "-12.5"');
  return at;
}

/** Whose colours and window a pane may share. */
export interface SharedLook {
  readonly optics: VolumeOptics | null;
  /** As the page gives it to the <volume-view>. */
  readonly window: readonly [number, number] | null;
}

/** How a volume's slices look: what the pane says, else its <volume-view>, else what suits the values. @throws {VolumeViewError} */
export async function resolveSliceLook({ window, colors, ...attributes }: SliceAttributes, volume: Volume, shared: SharedLook | null): Promise<SliceLook> {
  const isColored = (colors ?? (suitsColors(volume) ? 'volume' : 'gray')) === 'volume';
  return { ...attributes, window: window ?? shared?.window ?? suitingWindow(volume), colors: isColored ? await colorsOf(volume, shared) : null };
}

async function colorsOf({ window, range, transferFunction }: Volume, shared: SharedLook | null): Promise<SliceLook['colors']> {
  return shared?.optics?.transferFunction ?? resolveTransferFunction(transferFunction ?? defaultPreset, window ?? range);
}

/** @throws {VolumeViewError} of a volume that has no such slices */
export function refuseNoSlices(volume: Volume): void {
  if (isPolar(volume)) {
    throw new VolumeViewError('format/unsupported', 'a radar scan has no axial, coronal or sagittal slices; put <volume-slice type="cappi"> or another one into its <volume-view>');
  }
}

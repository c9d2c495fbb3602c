import { windowFunctions } from '../../panes/gray-levels.ts';
import type { WindowFunction } from '../../panes/gray-levels.ts';
import { sliceTypes } from '../../panes/slice-plane.ts';
import type { SliceType } from '../../panes/slice-plane.ts';
import { projectionKinds } from '../../optics/rays/ray-style.ts';
import type { ProjectionKind } from '../../optics/rays/ray-style.ts';
import { longest } from '../../volume/grid-limits.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { invalid, isNumber, parseFactor, parseNumbers, parseWindow, parseWord } from '../model/parse-attributes.ts';
import type { WindowSetting } from '../model/parse-attributes.ts';

/** What attributes say about a plane through a volume, in a pane or in the picture. The volume determines what is null. */
export interface PlaneAttributes {
  readonly type: SliceType;
  readonly normal: Vector3;
  /** World units along the normal. */
  readonly at: number | null;
  /** Data values of black and white. */
  readonly window: WindowSetting | null;
  readonly windowFunction: WindowFunction;
  readonly colors: 'gray' | 'volume' | null;
  /** World units; 0 for only the values on the plane. */
  readonly thickness: number;
  /** Which of the values across a thick slice is shown. */
  readonly projection: ProjectionKind;
}

/** Reads an element's attributes; its errors name them. */
export class SliceReader {
  /**
   * @param text - returns the text of an attribute, null where it is absent
   * @param owner - the text after the attribute's name in messages
   */
  constructor(
    readonly text: (name: string) => string | null,
    readonly owner = '',
  ) {}

  /** null where the attribute is absent or empty. @throws {VolumeViewError} `attribute/invalid` */
  read<T>(name: string, parse: (name: string, text: string) => T): T | null {
    const given = this.text(name);
    return given === null || given.trim() === '' ? null : parse(name + this.owner, given);
  }

  word<Word extends string>(name: string, words: readonly Word[]): Word | null {
    return this.read(name, (said, text) => parseWord(said, text, words));
  }

  /** @throws {VolumeViewError} `attribute/invalid` */
  plane(): PlaneAttributes {
    return {
      type: this.word('type', sliceTypes) ?? 'axial',
      normal: this.read('normal', parseNormal) ?? [0, 0, 1],
      at: this.read('at', parseAt),
      window: this.read('value-window', (_, text) => parseWindow(text)),
      windowFunction: this.word('window-function', windowFunctions) ?? 'linear-exact',
      colors: this.word('colors', ['gray', 'volume']),
      thickness: this.read('thickness', parseFactor) ?? 0,
      projection: this.word('projection', projectionKinds) ?? 'average',
    };
  }
}

export function parsePlace(name: string, text: string): Vector3 {
  const place = parseNumbers(name, text, 3) as unknown as Vector3;
  if (Math.max(...place.map(Math.abs)) > longest) throw invalid(name, text, 'a place nearer than 1e12');
  return place;
}

function parseNormal(name: string, text: string): Vector3 {
  const normal = parseNumbers(name, text, 3) as unknown as Vector3;
  const max = Math.max(...normal.map(Math.abs));
  if (!(max > 0 && max <= longest)) throw invalid(name, text, 'a direction, like "0 1 1"; it may not be 0 0 0');
  return normal;
}

function parseAt(name: string, text: string): number {
  const at = isNumber(text.trim()) ? Number(text) : NaN;
  if (!(Math.abs(at) <= longest))
    throw invalid(name, text, 'a place along the slice\'s normal in world units, like "-12.5"');
  return at;
}

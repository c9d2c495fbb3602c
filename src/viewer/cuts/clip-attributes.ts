import { longest } from '../../volume/grid-limits.ts';
import { normalize, scale } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { ClipShape } from '../model/clip-source.ts';
import { invalid, isNumber, parseNumbers, parseWord } from '../model/parse-attributes.ts';

/** What the attributes of a <volume-clip> say; the volume determines a place that is null. */
export type ClipAttributes =
  | Extract<ClipShape, { kind: 'plane' }>
  | (Omit<Extract<ClipShape, { kind: 'box' }>, 'box'> & { readonly box: readonly number[] | null });

/**
 * @param text - returns the text of an attribute, null where it is absent
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function readClipAttributes(text: (name: string) => string | null): ClipAttributes {
  const said = <T>(name: string, parse: (name: string, text: string) => T): T | null => {
    const given = text(name);
    return given === null || given.trim() === '' ? null : parse(`${name} of a volume-clip`, given);
  };
  const kind = said('type', (name, given) => parseWord(name, given, ['plane', 'box'])) ?? 'plane';
  if (kind === 'plane') return { kind, normal: said('normal', parseNormal) ?? [0, 0, 1], at: said('at', parseAt) };
  return {
    kind,
    box: said('box', parseBox),
    keep: said('keep', (name, given) => parseWord(name, given, ['inside', 'outside'])) ?? 'inside',
  };
}

function parseNormal(name: string, text: string): Vector3 {
  const normal = parseNumbers(name, text, 3) as unknown as Vector3;
  const max = Math.max(...normal.map(Math.abs));
  if (!(max > 0)) throw invalid(name, text, 'a direction, like "0 1 1"; it may not be 0 0 0');
  return normalize(scale(normal, 1 / max));
}

function parseAt(name: string, text: string): number {
  const at = isNumber(text.trim()) ? Number(text) : NaN;
  if (!(Math.abs(at) <= longest)) throw invalid(name, text, 'a place along the normal in world units, like "-12.5"');
  return at;
}

function parseBox(name: string, text: string): number[] {
  const box = parseNumbers(name, text, 6);
  if (!box.every((x) => Math.abs(x) <= longest)) throw invalid(name, text, 'corners nearer than 1e12');
  return box;
}

import { parseCssColor } from '../../optics/transfer/css-color.ts';
import { invalidAttribute } from '../../core/errors.ts';
import type { VolumeViewError } from '../../core/errors.ts';
import { childrenOf } from '../../page/page-children.ts';
import { isNumber, parseFactor } from '../model/parse-attributes.ts';
import type { LabelOverride } from '../model/view-labels.ts';

/** The overrides in the `<volume-label>` children of an element. */
export interface LabelChildren {
  /** By id; if several children have the same id, the first one counts. */
  readonly overrides: ReadonlyMap<number, LabelOverride>;
  /** The error of the first child that can't be read; such children are left out. */
  readonly error: VolumeViewError | null;
}

/** The labels that an author shows, and nothing else. */
export interface OnlyLabels {
  readonly ids: ReadonlySet<number>;
  /** Whether everything else is a grey trace. */
  readonly ghost: boolean;
}

/**
 * The attribute `only`: ids, and the word `ghost`.
 * @param text - null where the attribute is absent
 * @param ids - of the file, with that of "no label"; empty before it is loaded
 * @returns a value of null where all labels are shown, and the error where the text can't be read
 */
export function readOnly(
  text: string | null,
  ids: readonly number[],
): { readonly value: OnlyLabels | null; readonly error: VolumeViewError | null } {
  if (text === null || ids.length === 0) return { value: null, error: null };
  const words = text
    .trim()
    .toLowerCase()
    .split(/[\s,]+/);
  const asked = words.filter((word) => word !== 'ghost');
  const known = new Set(ids);
  const wrong = asked.find((word) => !isNumber(word) || !known.has(Number(word)));
  if (asked.length > 0 && wrong === undefined)
    return { value: { ids: new Set(asked.map(Number)), ghost: asked.length < words.length }, error: null };
  const error = invalidAttribute(
    'only of <volume-labels>',
    wrong ?? text,
    'ids of labels in the file, like "17 18", or "17 18 ghost", which shows the rest as a grey trace',
  );
  return { value: null, error };
}

export function readLabelChildren(parent: Element): LabelChildren {
  const overrides = new Map<number, LabelOverride>();
  let error: VolumeViewError | null = null;
  for (const child of childrenOf(parent, 'volume-label', 'volume-labels')) {
    try {
      const id = readLabelId(child);
      if (!overrides.has(id)) overrides.set(id, readOverride(child, id));
    } catch (thrown) {
      error ??= thrown as VolumeViewError;
    }
  }
  return { overrides, error };
}

/** The id of the label that a child describes. @throws {VolumeViewError} `attribute/invalid` */
function readLabelId(child: Element): number {
  const text = child.getAttribute('value') ?? '';
  const id = isNumber(text.trim()) ? Number(text) : NaN;
  if (!Number.isSafeInteger(id))
    throw invalidAttribute('value of a volume-label', text, 'a whole number, the label\'s in the file, like "17"');
  return id;
}

function readOverride(child: Element, id: number): LabelOverride {
  const name = child.getAttribute('name')?.trim();
  const colored = child.getAttribute('color')?.trim();
  const transferFunction = child.getAttribute('transfer-function')?.trim();
  const faint = child.getAttribute('opacity')?.trim();
  const color = colored ? parseCssColor(colored) : null;
  if (colored && !color)
    throw invalidAttribute(`color of volume-label value="${id}"`, colored, 'a CSS colour, like "#ff8800" or "orange"');
  const opacity = faint ? parseFactor(`opacity of volume-label value="${id}"`, faint) : 1;
  if (opacity > 1) throw invalidAttribute(`opacity of volume-label value="${id}"`, faint!, 'a number from 0 to 1');
  return {
    ...(name ? { name } : {}),
    ...(transferFunction ? { transferFunction } : {}),
    ...(color ? { color: color.color } : {}),
    ...(faint || (color && color.alpha < 1) ? { opacity: opacity * (color?.alpha ?? 1) } : {}),
    ...(child.hasAttribute('hidden') ? { hidden: true as const } : {}),
  };
}

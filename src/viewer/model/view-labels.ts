import { paletteColor } from '../../optics/transfer/label-stops.ts';
import type { Color } from '../../optics/transfer/transfer-function.ts';
import type { LabelStyle, ShownLabels } from '../../volume/labels.ts';
import type { LabelTable } from '../../formats/label-tables/label-table.ts';

/** The labels of a volume in an element, as its picture and its picks need them. */
export interface ViewLabels {
  /** null where the volume itself is the labels. */
  readonly shown: ShownLabels | null;
  /** What a label is called; null where there is none of this id, or it stands for nothing. */
  nameOf(id: number): string | null;
}

/** What an author says of a label, beside its table or instead of it. What is undefined is the table's matter. */
export interface LabelOverride {
  readonly name?: string;
  readonly color?: Color;
  /** 0..1 */
  readonly opacity?: number;
  readonly hidden?: true;
  readonly transferFunction?: string;
}

/** One label, with all that is known of it. */
export interface LabelEntry {
  readonly id: number;
  /** '' of what has no label. */
  readonly name: string;
  /** sRGB, 0..1 */
  readonly color: Color;
  readonly opacity: number;
  readonly hidden: boolean;
  /** Hidden, but seen as a trace: of what a part lies in. */
  readonly isGhost?: boolean;
  /** Its own, as it is written; null where it has the volume's. */
  readonly transferFunction: string | null;
}

/** Where what is said of labels comes from. */
export interface LabelSources {
  readonly table: LabelTable | null;
  readonly overrides: ReadonlyMap<number, LabelOverride>;
  /** Whether a person or a script has hidden a label, or shown it: more than table and author say. */
  readonly chosen: ReadonlyMap<number, boolean>;
  /** Of all labels of which nothing else is said. */
  readonly transferFunction?: string | null;
  /** Whether what is hidden is a ghost. */
  readonly ghosts?: boolean;
}

/** A ghost: its grey, and how much is left of its extinction. */
export const ghost = { color: [0.75, 0.75, 0.75], opacityFactor: 0.05 } as const;

/** What has no label looks as it does without any. */
const plain = { name: '', color: [1, 1, 1], opacity: 1, hidden: false } as const;

/**
 * The labels of a file: what its author says of them, else its table, else a colour of a palette and their number.
 * @param ids - of the file, the first of which is of what has no label
 */
export function describeLabels(ids: readonly number[], { table, overrides, chosen, transferFunction = null, ghosts = false }: LabelSources): LabelEntry[] {
  return ids.map((id, number) => {
    const row = number === 0 ? plain : table?.rows.get(id);
    const said = overrides.get(id);
    const hidden = chosen.get(id) ?? said?.hidden ?? row?.hidden ?? false;
    return {
      id,
      name: said?.name ?? (row?.name || (number === 0 ? '' : String(id))),
      color: said?.color ?? row?.color ?? paletteColor(number - 1),
      opacity: said?.opacity ?? row?.opacity ?? 1,
      hidden,
      ...(ghosts && hidden && { isGhost: true }),
      transferFunction: said?.transferFunction ?? (number === 0 ? null : transferFunction),
    };
  });
}

/** @param groups - numbers of those that have transfer functions of their own, which bring their own colours */
export function styleLabels(entries: readonly LabelEntry[], groups?: ReadonlyMap<string, number>): LabelStyle[] {
  return entries.map(({ color, opacity, hidden, isGhost, transferFunction }) => {
    if (isGhost) return ghost;
    const group = groups?.get(transferFunction ?? '');
    return { ...(group ? { group, color: plain.color } : { color }), opacityFactor: hidden ? 0 : opacity };
  });
}

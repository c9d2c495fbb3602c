import { paletteColor } from '../../optics/transfer/label-stops.ts';
import type { Color } from '../../optics/transfer/transfer-function.ts';
import type { LabelStyle, ShownLabels } from '../../volume/labels.ts';
import type { LabelTable } from '../../formats/label-tables/label-table.ts';

/** The labels of a volume in an element, with what its picture and its picks need. */
export interface ViewLabels {
  /** null where the volume itself is the labels. */
  readonly shown: ShownLabels | null;
  /** The name of a label; null where no label has this id, or the id stands for "no label". */
  nameOf(id: number): string | null;
}

/** What an author says about a label, in addition to its table or instead of it. Where a member is undefined, the table decides. */
export interface LabelOverride {
  readonly name?: string;
  readonly color?: Color;
  /** 0..1 */
  readonly opacity?: number;
  readonly hidden?: true;
  readonly transferFunction?: string;
}

/** One label, with all its properties. */
export interface LabelEntry {
  readonly id: number;
  /** '' for the id of "no label". */
  readonly name: string;
  /** sRGB, 0..1 */
  readonly color: Color;
  readonly opacity: number;
  readonly hidden: boolean;
  /** Hidden, but still faintly visible: it shows the surroundings of a part. */
  readonly isGhost?: boolean;
  /** The label's own transfer function, as it is written; null where it uses the volume's. */
  readonly transferFunction: string | null;
}

/** The sources of what is known about labels. */
export interface LabelSources {
  readonly table: LabelTable | null;
  readonly overrides: ReadonlyMap<number, LabelOverride>;
  /** Whether a person or a script has hidden a label, or shown it: this overrides the table and the author. */
  readonly chosen: ReadonlyMap<number, boolean>;
  /** For all labels that have no transfer function of their own. */
  readonly transferFunction?: string | null;
  /** The ids of the labels that the author shows, and no others; absent where hidden labels say it. */
  readonly only?: ReadonlySet<number>;
  /** Whether hidden labels appear as ghosts. */
  readonly ghosts?: boolean;
}

/** A ghost: its grey, and the factor of its extinction. */
export const ghost = { color: [0.75, 0.75, 0.75], opacityFactor: 0.05 } as const;

/** A place without a label looks as it does in a volume without labels. */
const plain = { name: '', color: [1, 1, 1], opacity: 1, hidden: false } as const;

/**
 * The labels of a file, as the author describes them; else as the table does; else with a palette colour, and their number as
 * name.
 * @param ids - of the file; the first one means "no label"
 */
export function describeLabels(
  ids: readonly number[],
  { table, overrides, chosen, transferFunction = null, only, ghosts = false }: LabelSources,
): LabelEntry[] {
  return ids.map((id, number) => {
    const row = number === 0 ? plain : table?.rows.get(id);
    const said = overrides.get(id);
    const hidden = chosen.get(id) ?? (only ? !only.has(id) : (said?.hidden ?? row?.hidden ?? false));
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

/**
 * The same labels, hidden or shown as a person or a script has chosen. Entries that stay as they are remain the same objects: an atlas may
 * have 65,536, and a choice changes few.
 */
export function hideChosen(
  entries: readonly LabelEntry[],
  { chosen, ghosts = false }: Pick<LabelSources, 'chosen' | 'ghosts'>,
): LabelEntry[] {
  return entries.map((entry) => {
    const { id, isGhost: _before, ...rest } = entry;
    const hidden = chosen.get(id) ?? entry.hidden;
    const isGhost = ghosts && hidden;
    if (hidden === entry.hidden && isGhost === (entry.isGhost ?? false)) return entry;
    return { id, ...rest, hidden, ...(isGhost && { isGhost }) };
  });
}

/** @param groups - numbers of the transfer functions that single labels have; such labels take the colours of these functions */
export function styleLabels(entries: readonly LabelEntry[], groups?: ReadonlyMap<string, number>): LabelStyle[] {
  return entries.map(({ color, opacity, hidden, isGhost, transferFunction }) => {
    if (isGhost) return ghost;
    const group = groups?.get(transferFunction ?? '');
    return { ...(group ? { group, color: plain.color } : { color }), opacityFactor: hidden ? 0 : opacity };
  });
}

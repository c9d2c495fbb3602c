import { cellsOf, colorOf, columnsOf, quote, TableRows } from './label-table.ts';
import type { LabelTable } from './label-table.ts';

/** Whether a text begins with the columns of a color table of 3D Slicer. */
export function isSlicerTable(text: string): boolean {
  const columns = columnsOf(text, ',');
  return columns.includes('labelvalue') && (columns.includes('name') || columns.includes('color_r'));
}

/**
 * Reads a color table of 3D Slicer: columns `LabelValue`, `Name`, `Color_R`, `Color_G`, `Color_B`, `Color_A` (0..255, 255 is opaque) and terms,
 * of which that of the type is the name where there is no other.
 * Source: 3D Slicer, developer guide, "Color table CSV file format"
 */
export function readSlicerTable(text: string): LabelTable {
  const rows = new TableRows();
  for (const { where, cell } of cellsOf(text, ',')) {
    const id = cell('labelvalue');
    if (!/^[+-]?\d+$/.test(id)) {
      rows.refuse(where, `the LabelValue ${quote(id)}`, 'a whole number');
      continue;
    }
    const channels = ['color_r', 'color_g', 'color_b'].map(cell);
    const color = channels.includes('') ? null : colorOf(channels.map(Number));
    if (!color && channels.some((one) => one !== ''))
      rows.report(`${where} got no colour from 0 to 255. Another one is chosen`);
    const alpha = cell('color_a') === '' ? 255 : Number(cell('color_a'));
    const opacity = alpha >= 0 && alpha <= 255 ? alpha / 255 : 1;
    rows.add(where, { id: Number(id), name: cell('name') || cell('type_codemeaning'), color, opacity, hidden: false });
  }
  return rows.finish('3D Slicer');
}

import { colorOf, maxRows, quote, TableRows } from './label-table.ts';
import type { LabelTable } from './label-table.ts';

export function isNiiVueTable(text: string): boolean {
  return text.trimStart().startsWith('{');
}

/**
 * Reads a label colormap of NiiVue: lists `R`, `G`, `B` and the optional `A` (0..255, 255 is opaque), `I` (ids) and
 * `labels` (names). Without `I` ids count from 0; without `A` all are opaque.
 * Source: NiiVue, "Labeled atlases", and `makeLabelLut` of its colortables
 * @throws {SyntaxError} if the text is not JSON
 */
export function readNiiVueTable(text: string): LabelTable {
  const parsed: unknown = JSON.parse(text);
  const rows = new TableRows();
  const list = (name: string): readonly unknown[] => {
    const value = (parsed as Readonly<Record<string, unknown>>)[name];
    if (value === undefined) return [];
    if (Array.isArray(value)) return value;
    rows.report(`${name} got ${quote(JSON.stringify(value))}; expected a list`);
    return [];
  };
  const [red, green, blue, alphas, ids, names] = ['R', 'G', 'B', 'A', 'I', 'labels'].map(list);
  const count = Math.max(red.length, ids.length, names.length);
  for (let i = 0; i < Math.min(count, maxRows + 1); i++) {
    const id = ids.length === 0 ? i : ids[i];
    const where = `entry ${i + 1}`;
    if (typeof id !== 'number') {
      rows.refuse(where, `the id ${quote(JSON.stringify(id ?? null))}`, 'a whole number in "I"');
      continue;
    }
    const color = colorOf([red[i], green[i], blue[i]].map((channel) => (typeof channel === 'number' ? channel : NaN)));
    if (!color && red.length > 0)
      rows.report(`${where} got no colour from 0 to 255 in "R", "G" and "B". Another one is chosen`);
    const alpha = alphas[i];
    const opacity = typeof alpha === 'number' && alpha >= 0 && alpha <= 255 ? alpha / 255 : 1;
    rows.add(where, {
      id,
      name: typeof names[i] === 'string' ? (names[i] as string) : '',
      color,
      opacity,
      hidden: false,
    });
  }
  return rows.finish('NiiVue');
}

import type { DataSet } from './data-set.ts';
import { tags } from './tags.ts';

/** The codes that may leave the reader: any other text may be anything. Source: PS3.3, C.7.3.1.1.1 */
const kinds: readonly string[] = [
  'CR',
  'CT',
  'DX',
  'MG',
  'MR',
  'NM',
  'OCT',
  'OPT',
  'PT',
  'RF',
  'RTDOSE',
  'RTIMAGE',
  'SC',
  'US',
  'XA',
];

/** The code of the kind of device; '' where it is none of those that are known. */
export function modalityOf(set: DataSet): string {
  const code = set.text(tags.modality).toUpperCase();
  return kinds.includes(code) ? code : '';
}

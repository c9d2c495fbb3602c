// Texts that people read, of which we show one kind: the names of segments and regions.
import { cleanName } from '../base/clean-name.ts';
import type { DataSet } from './data-set.ts';
import type { Tag } from './tags.ts';
import { tags } from './tags.ts';

/** What browsers call the character sets. Those of ISO 2022 change the set inside a text. Source: PS3.3, C.12.1.1.2 */
const encodings: Readonly<Record<string, string>> = {
  'ISO_IR 101': 'iso-8859-2',
  'ISO_IR 109': 'iso-8859-3',
  'ISO_IR 110': 'iso-8859-4',
  'ISO_IR 144': 'iso-8859-5',
  'ISO_IR 127': 'iso-8859-6',
  'ISO_IR 126': 'iso-8859-7',
  'ISO_IR 138': 'iso-8859-8',
  'ISO_IR 148': 'windows-1254',
  'ISO_IR 203': 'iso-8859-15',
  'ISO_IR 13': 'shift_jis',
  'ISO_IR 166': 'windows-874',
  'ISO_IR 192': 'utf-8',
  GB18030: 'gb18030',
  GBK: 'gbk',
  'ISO 2022 IR 87': 'iso-2022-jp',
  'ISO 2022 IR 149': 'euc-kr',
  'ISO 2022 IR 58': 'gb2312',
};

/** Reads names of a file. Letters of a set that is not known come out wrong, and harm no one. */
export function nameReader(file: DataSet): (set: DataSet, tag: Tag) => string {
  // A set of ISO 2022 that no browser knows alone is its plain form.
  const sets = file
    .texts(tags.characterSet)
    .map((name) => encodings[name] ?? encodings[name.replace('ISO 2022 IR', 'ISO_IR')]);
  const decoder = new TextDecoder(sets.find((one) => one !== undefined) ?? 'latin1');
  return (set, tag) =>
    cleanName(
      decoder
        .decode(set.bytesOf(tag).subarray(0, 4096))
        .replace(/[\s\0]+$/, '')
        .trim(),
    );
}

import { VolumeViewError } from '../../core/errors.ts';
import { isBidsTable, readBidsTable } from './bids-table.ts';
import { isFreeSurferTable, readFreeSurferTable } from './freesurfer-table.ts';
import { isItkSnapTable, readItkSnapTable } from './itk-snap-table.ts';
import type { LabelTable } from './label-table.ts';
import { isNiiVueTable, readNiiVueTable } from './niivue-table.ts';
import { isSlicerTable, readSlicerTable } from './slicer-table.ts';

/** Maximum bytes of a table. */
export const maxTableBytes = 2 ** 22;

/** The formats of tables that can be read, recognized by their content. */
const readers = [
  { matches: isNiiVueTable, read: readNiiVueTable },
  { matches: isBidsTable, read: readBidsTable },
  { matches: isSlicerTable, read: readSlicerTable },
  { matches: isItkSnapTable, read: readItkSnapTable },
  { matches: isFreeSurferTable, read: readFreeSurferTable },
] as const;

const expected =
  'expected names and colours of labels as BIDS (columns index, name, color), FreeSurfer (No. Name R G B A), ITK-SNAP (IDX R G B A VIS MSH "LABEL"), 3D Slicer (LabelValue, Name, Color_R …) or NiiVue (JSON with R, G, B, I, labels) write them';

/**
 * Reads a table of label names and colours in any of the known formats.
 * @param name - of the file, for messages
 * @throws {VolumeViewError} `format/unknown`, `format/corrupt` or `format/too-large`
 */
export function readLabelTable(bytes: Uint8Array, name: string): LabelTable {
  if (bytes.length > maxTableBytes)
    throw new VolumeViewError(
      'format/too-large',
      `the table ${name} has ${bytes.length.toLocaleString('en')} bytes; expected at most ${maxTableBytes.toLocaleString('en')}`,
    );
  const text = new TextDecoder().decode(bytes); // Without byte order mark.
  const reader = readers.find(({ matches }) => matches(text));
  if (!reader)
    throw new VolumeViewError('format/unknown', `the table ${name} is of no kind that is known; ${expected}`);
  const table = read(reader.read, text, name);
  if (table.rows.size > 0) return table;
  throw new VolumeViewError(
    'format/corrupt',
    `the table ${name} has no label that can be read; ${expected}.${table.problems.length > 0 ? ` The first problem: ${table.problems[0]}.` : ''}`,
  );
}

function read(reader: (text: string) => LabelTable, text: string, name: string): LabelTable {
  try {
    return reader(text);
  } catch (cause) {
    throw new VolumeViewError('format/corrupt', `the table ${name} is no JSON that can be read; ${expected}`, {
      cause,
    });
  }
}

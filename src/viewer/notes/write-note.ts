// The tag of a note, as an author writes it: the other direction of `readNotePlace`.
import type { NotePlace } from './note-place.ts';

/** A place on Earth is written to about a metre, degrees. */
const earthDecimals = 5;

/** A number without exponent, rounded: as few characters as it needs. */
function writeNumber(value: number, decimals: number): string {
  const text = value.toFixed(decimals);
  const short = text.includes('.') ? text.replace(/\.?0+$/, '') : text;
  return short === '-0' ? '0' : short;
}

/** A tenth of a voxel is kept, so that the pin does not move. @param spacing - the shortest side of a voxel, or of a gate */
function decimalsFor(spacing: number): number {
  const decimals = Math.ceil(-Math.log10(spacing / 10) - 1e-9);
  return Number.isFinite(decimals) ? Math.min(12, Math.max(0, decimals)) : 3;
}

/** The attributes of a place, in their order. @param spacing - in world units, of the volume */
export function writeNotePlace(place: NotePlace, spacing: number): readonly (readonly [name: string, text: string])[] {
  switch (place.kind) {
    case 'world':
      return [['position', place.at.map((x) => writeNumber(x, decimalsFor(spacing))).join(' ')]];
    case 'label':
      return [['of', String(place.id)]];
    case 'earth':
      return [
        ['latitude', writeNumber(place.latitude, earthDecimals)],
        ['longitude', writeNumber(place.longitude, earthDecimals)],
        ['height', writeNumber(place.height, 0)],
      ];
  }
}

/**
 * The tag of a note.
 * @param label - as a person has typed it; it is escaped
 * @param spacing - the shortest side of a voxel, or of a gate, in world units
 */
export function writeNote(place: NotePlace, label: string, spacing: number): string {
  const name = label.trim().replace(/\s+/g, ' ');
  const attributes = [...writeNotePlace(place, spacing), ...(name ? ([['label', name]] as const) : [])];
  return `<volume-note ${attributes.map(([attribute, text]) => `${attribute}="${escape(text)}"`).join(' ')}></volume-note>`;
}

/** A text for an attribute in double quotes. */
function escape(text: string): string {
  return text.replace(/&/g, '&amp;').replace(/"/g, '&quot;').replace(/</g, '&lt;').replace(/>/g, '&gt;');
}

import { expect } from '@esm-bundle/chai';
import { readNotePlace } from '../../../../src/viewer/notes/note-place.ts';
import type { NotePlace } from '../../../../src/viewer/notes/note-place.ts';
import { writeNote } from '../../../../src/viewer/notes/write-note.ts';

/** The attributes of a tag, as a parser of HTML reads them: entities and all. */
function attributesOf(tag: string): Record<string, string> {
  const entities: Record<string, string> = { amp: '&', quot: '"', lt: '<', gt: '>' };
  const found = [...tag.matchAll(/ ([a-z]+)="([^"]*)"/g)];
  expect(tag).to.match(/^<volume-note( [a-z]+="[^"<>]*")+><\/volume-note>$/);
  return Object.fromEntries(
    found.map(([, name, text]) => [name, text.replace(/&(\w+);/g, (_, entity: string) => entities[entity])]),
  );
}

const back = (tag: string): NotePlace => readNotePlace((name) => attributesOf(tag)[name] ?? null);

describe('the tag of a note', () => {
  it('has the place and the name', () => {
    expect(writeNote({ kind: 'world', at: [12.04, -40, 30.5] }, 'LAD', 1)).to.equal(
      '<volume-note position="12 -40 30.5" label="LAD"></volume-note>',
    );
    expect(writeNote({ kind: 'label', id: 23 }, '', 1)).to.equal('<volume-note of="23"></volume-note>');
    expect(
      writeNote({ kind: 'earth', latitude: -35.6614721, longitude: 149.5121, height: 1234.6 }, ' A \n cell ', 250),
    ).to.equal('<volume-note latitude="-35.66147" longitude="149.5121" height="1235" label="A cell"></volume-note>');
  });

  it('keeps a tenth of a voxel, without exponents and without zeros that say nothing', () => {
    const at = [123.456789, -0.000004, 1000] as const;
    const cases: [spacing: number, text: string][] = [
      [250, '123 0 1000'],
      [10, '123 0 1000'],
      [1, '123.5 0 1000'],
      [0.5, '123.46 0 1000'],
      [1e-5, '123.456789 -0.000004 1000'],
      [0, '123.457 0 1000'],
      [NaN, '123.457 0 1000'],
    ];
    for (const [spacing, text] of cases)
      expect(writeNote({ kind: 'world', at: [...at] }, '', spacing)).to.equal(
        `<volume-note position="${text}"></volume-note>`,
      );
    for (const spacing of [1e-9, 0.03, 0.7, 1, 3, 40, 1000]) {
      const place = at.map((x) => x * spacing) as unknown as [number, number, number];
      const read = back(writeNote({ kind: 'world', at: place }, '', spacing));
      if (read.kind !== 'world') throw new Error('it is another kind of place');
      place.forEach((x, axis) => expect(Math.abs(read.at[axis] - x)).to.be.at.most(0.0501 * spacing));
    }
  });

  it('is read as it was written', () => {
    const places: NotePlace[] = [
      { kind: 'world', at: [1.5, -2, 0] },
      { kind: 'label', id: -7 },
      { kind: 'earth', latitude: 48.04217, longitude: 10.21924, height: -3 },
    ];
    for (const place of places) expect(back(writeNote(place, 'A name', 0.1))).to.deep.equal(place);
  });

  it('escapes names: they stay texts', () => {
    const names = [
      '"><img src=x onerror=alert(1)>',
      "' onfocus='alert(1)",
      'a & b &amp; <c> "d"',
      '</volume-note><script>alert(1)</script>',
      '日本 – “Herz”',
    ];
    for (const name of names)
      expect(attributesOf(writeNote({ kind: 'label', id: 1 }, name, 1))).to.deep.equal({ of: '1', label: name });
  });
});

import { expect } from '@esm-bundle/chai';
import { raysPerPicture, SightTurns } from '../../../../src/viewer/notes/sight-turns.ts';

describe('turns of notes to be looked at while the camera moves', () => {
  const notes = Array.from({ length: 100 }, (_, i) => ({ i }));

  it('are a few rays in a picture, and each note has one in every round', () => {
    const turns = new SightTurns<object>();
    const counts = new Map<object, number>();
    const rounds = 3;
    for (let picture = 0; picture < (rounds * notes.length) / raysPerPicture; picture++) {
      const now = turns.next(notes);
      expect(now.length).to.equal(raysPerPicture);
      for (const note of now) counts.set(note, (counts.get(note) ?? 0) + 1);
      turns.seen(now);
    }
    expect([...counts.values()].every((count) => count === rounds)).to.equal(true);
    expect(counts.size).to.equal(100);
  });

  it('go to those that were looked at longest ago, and first to new ones', () => {
    const turns = new SightTurns<object>();
    turns.seen(notes.slice(0, 50));
    turns.seen(notes.slice(50, 99));
    expect(turns.next(notes, 3)).to.deep.equal([{ i: 99 }, { i: 0 }, { i: 1 }]);
    // All are looked at together when the camera rests.
    turns.seen(notes);
    expect(turns.next(notes, 2)).to.deep.equal([{ i: 0 }, { i: 1 }]);
    expect(turns.next(notes.slice(0, 1))).to.deep.equal([{ i: 0 }]);
    expect(turns.next([])).to.deep.equal([]);
  });
});

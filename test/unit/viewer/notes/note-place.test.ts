import { expect } from '@esm-bundle/chai';
import { locateNote, readNoteHide, readNotePlace } from '../../../../src/viewer/notes/note-place.ts';
import { axialIndexToWorld } from '../../../../src/volume/grid.ts';
import { transformPoint } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { sightOf } from '../../../../src/viewer/notes/see-places.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const read = (attributes: Record<string, string>) => readNotePlace((name) => attributes[name] ?? null);
const dimensions = [6, 5, 4] as const;
const volume = syntheticVolume({ dimensions, spacing: [1, 2, 3] });
const nothing = { volume, labels: null, labelsMayCome: false };

describe('the place of a note', () => {
  it('is what position says', () => {
    expect(read({ position: ' 12 -40,30.5 ' })).to.deep.equal({ kind: 'world', at: [12, -40, 30.5] });
    expect(locateNote(read({ position: '12 -40 30' }), nothing)).to.deep.equal([12, -40, 30]);
  });

  it('is refused in words', () => {
    const cases: [Record<string, string>, RegExp][] = [
      [{}, /^<volume-note> got no place; expected position="x y z"/],
      [{ position: '1 2' }, /^position of <volume-note> got "1 2"; expected 3 numbers/],
      [{ position: '1 2 3 4' }, /expected 3 numbers/],
      [{ position: '1 2 NaN' }, /expected 3 numbers/],
      [{ position: '1 2 1e13' }, /expected a place nearer than 1e12/],
      [{ of: 'heart' }, /^of of <volume-note> got "heart"; expected the number of a label/],
      [{ latitude: '48' }, /^longitude of <volume-note> got ""; expected degrees/],
      [{ latitude: '99', longitude: '1' }, /^latitude of <volume-note> got "99"/],
      [{ latitude: '9', longitude: '1', height: 'low' }, /^height of <volume-note> got "low"; expected metres/],
      [{ position: '<img src=x onerror=alert(1)>' }, /expected 3 numbers/],
    ];
    for (const [attributes, message] of cases) expect(() => read(attributes)).to.throw(message);
    expect(() => readNoteHide('sometimes')).to.throw(
      /^hide of <volume-note> got "sometimes"; expected never or veiled or hidden/,
    );
    expect([readNoteHide(null), readNoteHide(' Never ')]).to.deep.equal(['hidden', 'never']);
  });

  it('of a label is the middle of its largest part', () => {
    const numbers = new Uint8Array(120);
    for (const i of [1, 2, 3]) numbers[i + 6 * (2 + 5 * 2)] = 2;
    numbers[119] = 2;
    const labels = { map: { dimensions, numbers, ids: [0, 7, 23] }, styles: [] };
    const place = read({ of: '23' });
    expect(locateNote(place, { ...nothing, labels })).to.deep.equal(
      transformPoint(axialIndexToWorld(dimensions, [1, 2, 3]), [2, 2, 2]),
    );
    expect(() => locateNote(read({ of: '7' }), { ...nothing, labels })).to.throw(
      /got "7"; expected a label that the volume has/,
    );
    expect(() => locateNote(read({ of: '8' }), { ...nothing, labels })).to.throw(/a label that the volume has/);
    expect(() => locateNote(place, nothing)).to.throw(/add <volume-labels> to the <volume-view>/);
    expect(locateNote(place, { ...nothing, labelsMayCome: true })).to.equal(null);
  });

  it('is found in a volume that is labels itself', () => {
    const samples = new Uint8Array(120);
    samples[0] = 1;
    const itself = { ...volume, samples, isDiscrete: true, ids: [0, 300] } as Volume;
    expect(locateNote(read({ of: '300' }), { ...nothing, volume: itself })).to.deep.equal(
      transformPoint(axialIndexToWorld(dimensions, [1, 2, 3]), [0, 0, 0]),
    );
  });

  it('on Earth needs a radar that says where it is', () => {
    expect(() => locateNote(read({ latitude: '48', longitude: '11' }), nothing)).to.throw(
      /does not say where on Earth it is/,
    );
  });
});

describe('how well a note is seen', () => {
  it('is plain from half of the light on, and hidden below 5 %', () => {
    expect([null, 1, 0.5, 0.49, 0.05, 0.049, 0].map(sightOf)).to.deep.equal([
      'plain',
      'plain',
      'plain',
      'veiled',
      'veiled',
      'hidden',
      'hidden',
    ]);
  });
});

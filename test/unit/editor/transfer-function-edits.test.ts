import { expect } from '@esm-bundle/chai';
import { nameColor } from '../../../src/editor/color-names.ts';
import { english } from '../../../src/messages/english-companions.ts';
import { EditHistory } from '../../../src/editor/edit-history.ts';
import {
  addStop,
  addStopBeside,
  changeStop,
  colorAt,
  removeStop,
  simplifyStops,
  stopBounds,
} from '../../../src/editor/transfer-function-edits.ts';
import { colorTableStops } from '../../../src/optics/transfer/color-tables.ts';
import { parseTransferFunction } from '../../../src/optics/transfer/parse-transfer-function.ts';
import { resolveTransferFunction } from '../../../src/optics/transfer/resolve-transfer-function.ts';
import { evaluate } from '../../../src/optics/transfer/transfer-function.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { writeColor, writeTransferFunction } from '../../../src/optics/transfer/write-transfer-function.ts';
import { expectNear } from '../../helpers/emission.ts';

const stops: TransferFunction = [
  { value: 0, color: [0, 0, 1], opacity: 0 },
  { value: 10, color: [1, 0, 0], opacity: 0.5 },
  { value: 30, color: [1, 1, 1], opacity: 1 },
];

const values = (of: TransferFunction) => of.map(({ value }) => value);

/** The largest difference of a premultiplied channel between two functions. */
function findDifference(a: TransferFunction, b: TransferFunction, [low, high]: [number, number]): number {
  const places = Array.from({ length: 997 }, (_, i) => low + ((high - low) * i) / 996);
  return Math.max(
    ...places.flatMap((value) => evaluate(a, value).map((channel, i) => Math.abs(channel - evaluate(b, value)[i]))),
  );
}

describe('edits of a transfer function', () => {
  it('move a stop as far as its neighbours, which it may reach: a jump', () => {
    expect(stopBounds(stops, 0)).to.deep.equal([-Infinity, 10]);
    expect(stopBounds(stops, 1)).to.deep.equal([0, 30]);
    expect(values(changeStop(stops, 1, { value: 20 }))).to.deep.equal([0, 20, 30]);
    expect(values(changeStop(stops, 1, { value: 99 }))).to.deep.equal([0, 30, 30]);
    expect(values(changeStop(stops, 1, { value: -99 }))).to.deep.equal([0, 0, 30]);
    expect(values(changeStop(stops, 2, { value: 99 }))).to.deep.equal([0, 10, 99]);
    expect(values(stops)).to.deep.equal([0, 10, 30]);
  });

  it('keep an opacity between 0 and 1, and the same stops where nothing changes', () => {
    expect(changeStop(stops, 1, { opacity: 7 })[1].opacity).to.equal(1);
    expect(changeStop(stops, 1, { opacity: -7 })[1].opacity).to.equal(0);
    expect(changeStop(stops, 0, { opacity: -7 })).to.equal(stops);
    expect(changeStop(stops, 1, { color: [1, 0, 0] })).to.equal(stops);
    expect(changeStop(stops, 1, { color: [0, 1, 0] })[1]).to.deep.equal({ value: 10, color: [0, 1, 0], opacity: 0.5 });
  });

  it('add a stop with the colour at its value, in order, after another of the same value', () => {
    const { stops: more, index } = addStop(stops, 20, 0.1);
    expect([values(more), index]).to.deep.equal([[0, 10, 20, 30], 2]);
    expect(more[2].opacity).to.equal(0.1);
    expectNear(more[2].color, [1, 2 / 3, 2 / 3]); // premultiplied: (0.5 red + 1 white) / 1.5
    expect(addStop(stops, 10, 0).index).to.equal(2);
    expect(addStop(stops, -5, 0).index).to.equal(0);
    expect(addStop(stops, 55, 0).index).to.equal(3);
  });

  it('add a stop next to another on the curve, which stays as it is', () => {
    for (const [index, value, at] of [
      [0, 5, 1],
      [1, 20, 2],
      [2, 20, 2],
    ]) {
      const added = addStopBeside(stops, index, [0, 40]);
      expect([added.stops[at].value, added.index]).to.deep.equal([value, at]);
      expect(findDifference(added.stops, stops, [-5, 45])).to.be.below(1e-12);
    }
    expect(values(addStopBeside([stops[1]], 0, [0, 40]).stops)).to.deep.equal([10, 25]);
    expect(values(addStopBeside([{ ...stops[1], value: 40 }], 0, [0, 40]).stops)).to.deep.equal([20, 40]);
  });

  it('remove a stop, but not the last one', () => {
    expect(values(removeStop(stops, 1))).to.deep.equal([0, 30]);
    expect(removeStop([stops[0]], 0)).to.deep.equal([stops[0]]);
  });

  it('know the colour also where it is transparent', () => {
    expectNear(colorAt(stops, -3), [0, 0, 1]);
    expectNear(colorAt(stops, 5), [1, 0, 0]);
    const clear = stops.map((stop) => ({ ...stop, opacity: 0 }));
    expectNear(colorAt(clear, 5), [0.5, 0, 0.5]);
  });
});

describe('fewer stops for a hand', () => {
  for (const table of ['viridis', 'turbo', 'magma'] as const) {
    it(`draw ${table} with 24 stops within 2/255`, () => {
      const many = colorTableStops(table, [0, 100]);
      const few = simplifyStops(many, 24);
      expect(few.length).to.be.within(5, 24);
      expect(findDifference(few, many, [0, 100])).to.be.below(2 / 255);
      expect([few[0], few.at(-1)]).to.deep.equal([many[0], many.at(-1)]);
    });
  }

  it('leave few stops alone', () => {
    expect(simplifyStops(stops, 3)).to.equal(stops);
  });

  it('keep jumps, and a colour that changes where nothing is seen', () => {
    const clear = { value: 0, color: [1, 0, 0], opacity: 0 } as const;
    const many: TransferFunction = [
      ...Array.from({ length: 30 }, (_, i) => ({ ...clear, value: i })),
      { ...clear, value: 40, color: [0, 0, 1] },
      { ...clear, value: 50, color: [0, 1, 0] },
      { value: 50, color: [0, 1, 0], opacity: 0.9 },
      { value: 60, color: [0, 1, 0], opacity: 0.9 },
    ];
    const few = simplifyStops(many, 24);
    expect(values(few)).to.deep.equal([0, 29, 40, 50, 50, 60]);
  });

  it('come to an end with noise that no few stops can draw', () => {
    let seed = 1;
    const next = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
    const noise = Array.from({ length: 1024 }, (_, value) => ({
      value,
      color: [next(), next(), next()] as const,
      opacity: next(),
    }));
    expect(simplifyStops(noise, 24).length).to.be.within(2, 24);
  });
});

describe('a transfer function as text', () => {
  it('is what the parser reads', () => {
    expect(writeTransferFunction(stops)).to.equal('0 #0000ff 0%, 10 #ff0000 50%, 30 #ffffff 100%');
    expect(writeColor([0.5, 1, 0])).to.equal('#80ff00');
  });

  it('is read back within a ten-thousandth of the span and 1/255', async () => {
    const windows: [number, number][] = [
      [-1024, 3071],
      [0, 1],
      [1e-9, 3e-9],
      [-5e6, 7e8],
    ];
    for (const window of windows) {
      const original = await resolveTransferFunction('mri', window);
      const read = parseTransferFunction(writeTransferFunction(original), [0, 1]);
      const span = window[1] - window[0];
      original.forEach(({ value, color, opacity }, i) => {
        expect(Math.abs(read[i].value - value)).to.be.at.most(span / 1e4);
        expect(read[i].opacity).to.be.closeTo(opacity, opacity * 1e-3 + 1e-12);
        color.forEach((channel, c) => expect(read[i].color[c]).to.be.closeTo(channel, 0.5 / 255 + 1e-9));
      });
    }
  });

  it('keeps a single stop, and a jump', () => {
    expect(writeTransferFunction([{ value: 1 / 3, color: [0, 0, 0], opacity: 1 / 3 }])).to.equal(
      '0.333333333 #000000 33.33%',
    );
    const jump = [{ ...stops[0], value: 7.123456 }, { ...stops[1], value: 7.123456 }, stops[1]];
    const read = parseTransferFunction(writeTransferFunction(jump), [0, 1]);
    expect(read[0].value).to.equal(read[1].value);
  });
});

describe('the history of edits', () => {
  it('goes back and forth, and forgets what was undone when something else is done', () => {
    const history = new EditHistory('a');
    history.push('b');
    history.push('c');
    expect([history.undo(), history.undo(), history.undo()]).to.deep.equal(['b', 'a', 'a']);
    expect([history.canUndo, history.canRedo]).to.deep.equal([false, true]);
    expect([history.redo(), history.canUndo]).to.deep.equal(['b', true]);
    history.push('d');
    expect([history.redo(), history.undo(), history.undo()]).to.deep.equal(['d', 'b', 'a']);
  });

  it('makes no step of the same state, and knows where it began', () => {
    const history = new EditHistory('a');
    history.push('a');
    expect(history.canUndo).to.equal(false);
    history.replace('A');
    expect([history.first, history.present]).to.deep.equal(['A', 'A']);
    history.push('b');
    history.replace('B');
    expect([history.first, history.present, history.undo()]).to.deep.equal(['A', 'B', 'A']);
  });

  it('is bounded', () => {
    const history = new EditHistory(0);
    for (let i = 1; i <= 1000; i++) history.push(i);
    let steps = 0;
    while (history.canUndo) steps += history.undo() >= 0 ? 1 : 0;
    expect(steps).to.equal(200);
  });
});

describe('names of colours', () => {
  const names: Record<string, [number, number, number]> = {
    red: [1, 0, 0],
    green: [0, 0.6, 0],
    blue: [0, 0, 1],
    yellow: [0.95, 0.9, 0],
    white: [1, 1, 1],
    black: [0, 0, 0],
    grey: [0.5, 0.5, 0.5],
    orange: [1, 0.6, 0.05],
    brown: [0.5, 0.25, 0.05],
    turquoise: [0, 0.9, 0.9],
    pink: [1, 0, 0.8],
    violet: [0.55, 0.2, 0.9],
    'light blue': [0.75, 0.8, 1],
    'dark red': [0.4, 0, 0],
  };
  for (const [name, color] of Object.entries(names)) {
    it(`${name} is ${color.join(' ')}`, () => expect(nameColor(color, english)).to.equal(name));
  }
});

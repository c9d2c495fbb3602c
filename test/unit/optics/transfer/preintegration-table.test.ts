import { expect } from '@esm-bundle/chai';
import { colorTableStops } from '../../../../src/optics/transfer/color-tables.ts';
import { emission, meanOverSpan } from '../../../../src/optics/transfer/emission.ts';
import { exactMeans } from '../../../../src/optics/transfer/exact-means.ts';
import { attenuate } from '../../../../src/optics/rays/segment.ts';
import {
  buildPreintegrationTable,
  spanOfRow,
  preintegrationTableSize,
  tableMeans,
} from '../../../../src/optics/transfer/preintegration-table.ts';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { expectNear, worstDifference } from '../../../helpers/emission.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

const smooth: TransferFunction = [
  { value: -100, color: [0, 0, 1], opacity: 0 },
  { value: 20, color: [1, 0.2, 0], opacity: 0.04 },
  { value: 300, color: [0.9, 1, 0.5], opacity: 0.09 },
];
/** Clear, with peaks that are one percent of the domain wide at their feet. */
const peaks: TransferFunction = [
  { value: 0, color: [1, 1, 0], opacity: 0 },
  ...[0.2, 0.5, 0.83].flatMap((at): TransferFunction => [
    { value: at - 0.005, color: [1, 0.5, 0], opacity: 0 },
    { value: at, color: [1, 0.5, 0], opacity: 0.6 },
    { value: at + 0.005, color: [1, 0.5, 0], opacity: 0 },
  ]),
  { value: 1, color: [1, 1, 0], opacity: 0 },
];
const jumps: TransferFunction = [
  { value: 0, color: [0, 0, 0], opacity: 0 },
  { value: 0.3, color: [0, 0, 1], opacity: 0 },
  { value: 0.3, color: [0, 0, 1], opacity: 0.02 },
  { value: 0.71, color: [0, 0, 1], opacity: 0.02 },
  { value: 0.71, color: [1, 0, 0], opacity: 0.9 },
  { value: 1, color: [1, 0, 0], opacity: 0.9 },
];
const jumpAtEnd: TransferFunction = [
  { value: 0, color: [0.2, 0.4, 1], opacity: 0.02 },
  { value: 1, color: [0.2, 0.4, 1], opacity: 0.02 },
  { value: 1, color: [1, 0.8, 0.2], opacity: 0.9 },
];
const jumpAtStart: TransferFunction = [
  { value: 0, color: [1, 0.8, 0.2], opacity: 0.9 },
  { value: 0, color: [0.2, 0.4, 1], opacity: 0.02 },
  { value: 1, color: [0.2, 0.4, 1], opacity: 0.02 },
];
const opaqueRamp: TransferFunction = [
  { value: 0, color: [0, 0, 1], opacity: 0 },
  { value: 0.5, color: [1, 1, 1], opacity: 1 },
  { value: 1, color: [1, 0, 0], opacity: 0.5 },
];
const one: TransferFunction = [{ value: 42, color: [0.4, 0.5, 0.6], opacity: 0.3 }];
const onlyJump: TransferFunction = [
  { value: 42, color: [0.4, 0.5, 0.6], opacity: 0.3 },
  { value: 42, color: [1, 1, 1], opacity: 0.6 },
];

/** Spans of any width, in and around a domain. */
function spans(low: number, high: number, widths: readonly number[]): [number, number][] {
  const random = randomNumbers(34);
  return widths.flatMap((width) =>
    Array.from({ length: 400 }, (): [number, number] => {
      const from = low + (random() * (1.2 + width) - 0.1 - width) * (high - low);
      return [from, from + width * (high - low)];
    }),
  );
}

/** Largest differences, in 1/255, between what segments of each width and of one reference length show by the table and exactly. */
function worstOf(transferFunction: TransferFunction, widths: readonly number[]): number[] {
  const [table, exact] = [tableMeans(buildPreintegrationTable(transferFunction)), exactMeans(transferFunction)];
  return widths.map((width) =>
    Math.max(
      ...spans(exact.low, exact.high, [width]).map((span) => {
        const [got, expected] = [table, exact].map((means) => attenuate(means.mean(...span), 1));
        return worstDifference(got, expected) * 255;
      }),
    ),
  );
}

describe('the table of means over spans', () => {
  it('holds the means over spans around its columns, as wide as its rows', () => {
    for (const transferFunction of [smooth, peaks, opaqueRamp]) {
      const { texels, columns, rows, low, high } = buildPreintegrationTable(transferFunction);
      expect([columns, rows]).to.deep.equal([preintegrationTableSize.columns, preintegrationTableSize.rows]);
      expect(texels.length).to.equal(columns * rows * 4);
      for (const row of [1, 17, 40, 63]) {
        for (const column of [0, 300, 1024, 1500, 2047]) {
          const middle = low + ((high - low) * column) / (columns - 1);
          const reach = (spanOfRow(row, rows) * (high - low)) / 2;
          // Spans that end within the domain; the rows beside it are never read but as neighbours.
          if (middle - reach < low || middle + reach > high) continue;
          const expected = meanOverSpan(transferFunction, middle - reach, middle + reach);
          // Half a cell of the running integral at each end, taken as a straight line, and float32.
          const tolerance = (row === 1 ? 2e-2 : 2e-3) * Math.max(1, expected[3]);
          expectNear(
            [...texels.subarray((row * columns + column) * 4, (row * columns + column) * 4 + 4)],
            expected,
            tolerance,
          );
        }
      }
    }
  });

  it('begins with spans of no width, which are single values: at a jump the later stop holds, except one at the high end', () => {
    for (const transferFunction of [smooth, peaks]) {
      const { texels, columns, low, high } = buildPreintegrationTable(transferFunction, { columns: 1024, rows: 16 });
      expect(columns).to.equal(1024);
      for (const column of [0, 1, 300, 800, 1022, 1023]) {
        expectNear(
          [...texels.subarray(column * 4, column * 4 + 4)],
          emission(transferFunction, low + ((high - low) * column) / 1023),
          1e-7,
        );
      }
    }
    const jump: TransferFunction = [
      { value: 0, color: [1, 1, 1], opacity: 0.2 },
      { value: 0.5, color: [1, 1, 1], opacity: 0.2 },
      { value: 0.5, color: [1, 1, 1], opacity: 0.8 },
      { value: 1, color: [1, 1, 1], opacity: 0.8 },
    ];
    const { texels } = buildPreintegrationTable(jump, { columns: 1025, rows: 16 });
    expect(texels[511 * 4 + 3]).to.be.closeTo(emission(jump, 0)[3], 1e-6);
    expect(texels[512 * 4 + 3]).to.be.closeTo(emission(jump, 1)[3], 1e-6);
    expect(buildPreintegrationTable(jumpAtEnd, { columns: 1025, rows: 16 }).texels[1024 * 4 + 3]).to.be.closeTo(
      emission(jumpAtEnd, 0)[3],
      1e-6,
    );
  });

  it('knows what holds for all values beyond its ends, where these are jumps too', () => {
    for (const transferFunction of [smooth, peaks, jumps, opaqueRamp, jumpAtEnd, jumpAtStart]) {
      const table = buildPreintegrationTable(transferFunction);
      const means = tableMeans(table);
      expectNear(table.first, emission(transferFunction, -1e9), 0);
      expectNear(table.last, emission(transferFunction, 1e9), 0);
      for (const [from, to] of [
        [-1e30, -1e29],
        [table.low - 5, table.low - 5],
        [table.low - 3, table.low - 1e-9],
      ]) {
        expectNear(means.mean(from, to), table.first, 1e-12);
        expectNear(means.mean(to, from), table.first, 1e-12);
      }
      for (const [from, to] of [
        [1e29, 1e30],
        [table.high + 5, table.high + 5],
        [table.high, table.high],
        [table.high, table.high + 3],
      ]) {
        expectNear(means.mean(from, to), table.last, 1e-12);
      }
    }
  });

  it('has nothing of what lies beyond a jump at its end in spans that end there', () => {
    const [start, end] = [jumpAtStart, jumpAtEnd].map((transferFunction) =>
      tableMeans(buildPreintegrationTable(transferFunction)),
    );
    for (const width of [0, 1e-9, 1e-5, 1e-3, 0.01, 0.3, 1]) {
      expectNear(start.mean(0, width), emission(jumpAtStart, 0), 1e-6);
      expectNear(end.mean(1 - width - 1e-12, 1 - 1e-12), emission(jumpAtEnd, 0), 1e-6);
    }
  });

  it('weights the pieces of a span inside, below and above', () => {
    const means = tableMeans(buildPreintegrationTable(smooth));
    const random = randomNumbers(35);
    for (let i = 0; i < 300; i++) {
      const [from, to] = [random() * 2000 - 800, random() * 2000 - 800];
      // The widest rows are the farthest from straight lines: 4 % of the domain between two of them.
      expectNear(means.mean(from, to), meanOverSpan(smooth, from, to), 1e-3);
      expectNear(means.mean(from, to), means.mean(to, from), 0);
    }
  });

  it('of one stop is that stop everywhere, and of a jump alone has its two sides', () => {
    const means = tableMeans(buildPreintegrationTable(one));
    expect(means.low).to.be.below(42);
    expect(means.high).to.be.above(42);
    for (const [from, to] of [
      [42, 42],
      [0, 0],
      [99, 99],
      [0, 99],
      [41, 42],
      [-1e9, 1e9],
    ]) {
      expectNear(means.mean(from, to), emission(one, 42), 1e-7);
    }
    const jump = tableMeans(buildPreintegrationTable(onlyJump));
    expectNear(jump.mean(0, 41), emission(onlyJump, 41), 1e-7);
    expectNear(jump.mean(43, 99), emission(onlyJump, 43), 1e-7);
    for (const share of [0.1, 0.5, 0.8]) {
      // The jump lies a millionth of its value early.
      expectNear(jump.mean(42 - share, 43 - share), meanOverSpan(onlyJump, 42 - share, 43 - share), 1e-4);
    }
  });

  it('refuses to be of no stop', () => {
    expect(() => buildPreintegrationTable([])).to.throw(RangeError, /expected 1 or more/);
  });

  it('shows the same pictures as the exact means: a table of its errors', () => {
    const table64 = colorTableStops('viridis', [-10, 70]);
    expect(table64.length).to.equal(65);
    const functions: [string, TransferFunction][] = [
      ['smooth', smooth],
      ['1 % peaks', peaks],
      ['jumps', jumps],
      ['jump at end', jumpAtEnd],
      ['to opacity 1', opaqueRamp],
      ['one stop', one],
      ['64 stops', table64],
    ];
    const widths = [1e-4, 1e-3, 0.005, 0.01, 0.02, 0.05, 0.2, 0.7, 1.5];
    console.log(
      ['one reference length, 1/255:'.padEnd(14), ...widths.map((w) => `${w * 100} %`.padStart(8))].join(' '),
    );
    const errors = new Map<string, number[]>();
    for (const [name, transferFunction] of functions) {
      const row = worstOf(transferFunction, widths);
      errors.set(name, row);
      console.log([name.padEnd(14), ...row.map((x) => x.toFixed(3).padStart(8))].join(' '));
    }
    const worst = (name: string): number => Math.max(...errors.get(name)!);
    for (const name of ['smooth', 'jump at end', 'one stop', '64 stops']) expect(worst(name), name).to.be.below(0.02);
    expect(worst('to opacity 1')).to.be.below(1);
    // Single segments; along a ray such errors have both signs and cancel. Rows: straight lines between widths.
    expect(worst('jumps')).to.be.below(4);
    // Spans narrower than a column see its kinks rounded off: a quarter of a column's rise, a fortieth of a peak.
    expect(Math.max(...errors.get('1 % peaks')!.slice(0, 2))).to.be.below(255 / 40);
    expect(Math.max(...errors.get('1 % peaks')!.slice(2))).to.be.below(1.5);
  });
});

import { expect } from '@esm-bundle/chai';
import type { VolumeViewError } from '../../../../src/core/errors.ts';
import type { LabelRow } from '../../../../src/formats/label-tables/label-table.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { evaluate } from '../../../../src/optics/transfer/transfer-function.ts';
import { paneLabels } from '../../../../src/panes/pane-labels.ts';
import { readLabelChildren } from '../../../../src/viewer/attachments/label-children.ts';
import { LabelFunctions } from '../../../../src/viewer/attachments/label-functions.ts';
import { ownLabelsAppearance } from '../../../../src/viewer/appearance/own-labels-appearance.ts';
import { describeLabels, styleLabels } from '../../../../src/viewer/model/view-labels.ts';
import type { LabelEntry, LabelSources } from '../../../../src/viewer/model/view-labels.ts';
import { invertAffine, transformPoint } from '../../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../../src/volume/matrix.ts';

const row = (id: number, more: Partial<LabelRow> = {}): [number, LabelRow] => [
  id,
  { id, name: '', color: null, opacity: 1, hidden: false, ...more },
];
const table = {
  format: 'BIDS',
  problems: [],
  rows: new Map([
    row(0, { name: 'Unknown', color: [0, 0, 0], opacity: 0, hidden: true }),
    row(2, { name: 'two', color: [1, 0, 0], opacity: 0.5 }),
    row(3, { hidden: true }),
    row(99, { name: 'absent' }),
  ]),
};
const nothing: LabelSources = { table: null, overrides: new Map(), chosen: new Map() };

/** The children of an element, as an author writes them. */
function childrenOf(html: string): ReturnType<typeof readLabelChildren> {
  const parent = document.createElement('volume-labels');
  parent.innerHTML = html;
  return readLabelChildren(parent);
}

describe('what is said of labels', () => {
  it("is the table's: but what has no label stays as it is, and what the table lacks has its number and a colour of its own", () => {
    const [none, two, three, four] = describeLabels([0, 2, 3, 4], { ...nothing, table });
    expect(none).to.deep.equal({
      id: 0,
      name: '',
      color: [1, 1, 1],
      opacity: 1,
      hidden: false,
      transferFunction: null,
    });
    expect(two).to.deep.equal({
      id: 2,
      name: 'two',
      color: [1, 0, 0],
      opacity: 0.5,
      hidden: false,
      transferFunction: null,
    });
    expect([three.name, three.hidden]).to.deep.equal(['3', true]);
    expect(four.name).to.equal('4');
    expect(four.color).to.not.deep.equal(three.color);
    expect(styleLabels([none, two, three])).to.deep.equal([
      { color: [1, 1, 1], opacityFactor: 1 },
      { color: [1, 0, 0], opacityFactor: 0.5 },
      { color: three.color, opacityFactor: 0 },
    ]);
  });

  it("is the author's where a child says more, and a person's choice before both", () => {
    const { overrides, error } = childrenOf(
      '<volume-label value="0" opacity="0.1"></volume-label><volume-label value="2" name=" Two " color="rgb(0 255 0 / 50%)"></volume-label>' +
        '<volume-label value="2" name="again"></volume-label><volume-label value="3" color="#f80" opacity="0.25"></volume-label><volume-label value="4" hidden></volume-label>',
    );
    expect(error).to.equal(null);
    const entries = describeLabels([0, 2, 3, 4], {
      table,
      overrides,
      chosen: new Map([
        [3, false],
        [2, true],
      ]),
    });
    expect(entries.map(({ name, opacity, hidden }) => [name, opacity, hidden])).to.deep.equal([
      ['', 0.1, false],
      ['Two', 0.5, true],
      ['3', 0.25, false],
      ['4', 1, true],
    ]);
    expect(entries[1].color).to.deep.equal([0, 1, 0]);
    expect(entries[2].color.map((c) => Math.round(255 * c))).to.deep.equal([255, 136, 0]);
  });

  it("of a child that can't be read is left out and reported", () => {
    const wrong: [string, RegExp][] = [
      ['value="1.5"', /value of a volume-label got "1.5"; expected a whole number/],
      ['name="x"', /value of a volume-label got ""/],
      ['value="7" color="blau"', /color of volume-label value="7" got "blau"/],
      ['value="7" opacity="2"', /opacity of volume-label value="7" got "2"; expected a number from 0 to 1/],
    ];
    for (const [attributes, message] of wrong) {
      const { overrides, error } = childrenOf(
        `<volume-label ${attributes}></volume-label><volume-label value="8" name="eight"></volume-label>`,
      );
      expect(error?.code).to.equal('attribute/invalid');
      expect(error?.message).to.match(message);
      expect([...overrides.keys()]).to.deep.equal([8]);
    }
  });
});

describe('transfer functions of labels', () => {
  const entriesOf = (html: string, transferFunction: string | null = null): LabelEntry[] =>
    describeLabels([0, 2, 3, 4, 5, 6, 7], {
      ...nothing,
      table,
      overrides: childrenOf(html).overrides,
      transferFunction,
    });
  const label = (value: number, text: string): string =>
    `<volume-label value="${value}" transfer-function="${text}"></volume-label>`;

  it("are groups of those that say the same, with the functions' own colours; all but what has no label have that of the labels", async () => {
    const entries = entriesOf(label(3, ' ct-bone ') + label(0, '0% #fff 0, 100% #fff 1%'), 'gray');
    const { numbers, functions, error } = (await new LabelFunctions().read(entries, [0, 50]))!;
    expect(error).to.equal(null);
    expect([...numbers]).to.deep.equal([
      ['0% #fff 0, 100% #fff 1%', 1],
      ['gray', 2],
      ['ct-bone', 3],
    ]);
    expect(functions[0]).to.deep.equal(parseTransferFunction('0 #fff 0, 50 #fff 1%', [0, 50]));
    const styles = styleLabels(entries, numbers);
    expect(styles.slice(0, 3)).to.deep.equal([
      { group: 1, color: [1, 1, 1], opacityFactor: 1 },
      { group: 2, color: [1, 1, 1], opacityFactor: 0.5 },
      { group: 3, color: [1, 1, 1], opacityFactor: 0 },
    ]);
    expect(styleLabels(entries)[1].color, 'in panes').to.deep.equal([1, 0, 0]);
  });

  it('are not read where there are none, are kept while they are the same, and span the window', async () => {
    const reader = new LabelFunctions();
    expect(reader.read(entriesOf(''), [0, 1])).to.equal(null);
    const first = await reader.read(entriesOf(label(2, 'gray')), [0, 1]);
    expect(await reader.read(entriesOf(label(2, 'gray') + label(3, 'gray')), [0, 1])).to.equal(first);
    const wider = await reader.read(entriesOf(label(2, 'gray')), [0, 2]);
    expect(wider!.functions[0].at(-1)!.value).to.equal(2 * first!.functions[0].at(-1)!.value);
  });

  it("are four at most, and one that can't be read leaves its labels as they are", async () => {
    const texts = ['gray', 'ct-bone', 'viridis', 'magma', 'turbo'];
    const many = (await new LabelFunctions().read(
      entriesOf(texts.map((text, i) => label(i + 2, text)).join('')),
      [0, 1],
    ))!;
    expect(many.functions.length).to.equal(4);
    expect([...many.numbers.keys()]).to.not.include('turbo');
    expect((many.error as Error).message).to.equal(
      'transfer-function of the label 6 got "turbo"; expected one of the 4 that labels before it have. Labels have at most 4 different ones in addition to the volume\'s own.',
    );
    const wrong = (await new LabelFunctions().read(entriesOf(label(2, '0 blau 1') + label(3, 'gray')), [0, 1]))!;
    expect([...wrong.numbers]).to.deep.equal([['gray', 1]]);
    expect((wrong.error as VolumeViewError).code).to.equal('transfer-function/syntax');
    expect((wrong.error as Error).message).to.match(/^transfer-function of the label 2: .*"blau"/);
  });
});

it('a volume that is labels itself has a stop for each: its colour, none of the hidden ones and of what has no label', () => {
  const entries = describeLabels([0, 5, 2, 9], { ...nothing, table, chosen: new Map([[5, true]]) });
  const stops = ownLabelsAppearance(entries)!;
  const at = (value: number): number[] => evaluate(stops, value).map((x) => Math.round(x * 1000) / 1000);
  expect(at(0)[3]).to.equal(0);
  expect(at(2)).to.deep.equal([0.11, 0, 0, 0.11]);
  expect(at(5)[3]).to.equal(0);
  expect(at(9)[3]).to.equal(0.22);
});

it('what is hidden can be a ghost: grey, of which little is left, over a volume and in one that is labels', () => {
  const chosen = new Map([
    [0, true],
    [2, true],
    [5, true],
  ]);
  const entries = describeLabels([0, 2, 5, 9], { ...nothing, table, chosen, ghosts: true });
  expect(
    styleLabels(entries, new Map([['gray', 1]])).map(({ opacityFactor, group }) => [opacityFactor, group]),
  ).to.deep.equal([
    [0.05, undefined],
    [0.05, undefined],
    [0.05, undefined],
    [1, undefined],
  ]);
  expect(styleLabels(entries)[1].color).to.deep.equal([0.75, 0.75, 0.75]);
  expect(evaluate(ownLabelsAppearance(entries)!, 5)[3]).to.be.closeTo(0.0055, 1e-9);
  expect(evaluate(ownLabelsAppearance(entries)!, 0)[3], 'nothing stays nothing').to.equal(0);
  expect(styleLabels(describeLabels([0, 2, 5, 9], { ...nothing, table, chosen }))[1].opacityFactor).to.equal(0);
});

it('panes colour each pixel by the label of the voxel that it is in, and name it', () => {
  const indexToWorld: Matrix4 = [-2, 0.1, 0, 5, 0, 1.5, 0.2, -3, 0.3, 0, 1, 1, 0, 0, 0, 1];
  const worldToIndex = invertAffine(indexToWorld)!;
  const dimensions: Vector3 = [5, 4, 3];
  const numbers = Uint8Array.from({ length: 60 }, (_, i) => (i * 7) % 4);
  const styles = styleLabels(
    describeLabels([0, 2, 3, 4], {
      ...nothing,
      table,
      chosen: new Map([
        [3, false],
        [4, true],
      ]),
    }),
  );
  const labels = paneLabels(
    { map: { dimensions, numbers, ids: [0, 2, 3, 4] }, styles },
    { worldToIndex, nameOf: (id) => `label ${id}`, opacity: 0.6 },
  );
  const [width, height] = [24, 18];
  const pixels = {
    width,
    height,
    first: [-5, -4.2, 1.4] as Vector3,
    across: [0.5, 0.02, 0.03] as Vector3,
    down: [-0.01, 0.45, 0.04] as Vector3,
  };
  const picture = new Uint8ClampedArray(4 * width * height).fill(100);
  labels.paint(pixels, picture, [0, 9]);
  labels.paint(pixels, picture, [9, height]);
  const met = new Set<number>();
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const place = pixels.first.map(
        (x, axis) => x + column * pixels.across[axis] + row * pixels.down[axis],
      ) as unknown as Vector3;
      const [i, j, k] = transformPoint(worldToIndex, place).map(Math.round);
      const inside = [i, j, k].every((index, axis) => index >= 0 && index < dimensions[axis]);
      const number = inside ? numbers[i + 5 * (j + 4 * k)] : 0;
      met.add(number);
      const share = [0, 0.6 * 0.5, 0.6, 0][number]; // None, half opaque, opaque, hidden.
      const wanted = styles[number].color.map((c) => 100 + share * (255 * c - 100));
      const at = 4 * (row * width + column);
      wanted.forEach((value, channel) => expect(picture[at + channel]).to.be.closeTo(value, 0.51));
      expect(picture[at + 3]).to.equal(100);
      expect(labels.nameAt(place)).to.equal(number === 0 ? null : `label ${[0, 2, 3, 4][number]}`);
    }
  }
  expect(met.size).to.equal(4);
});

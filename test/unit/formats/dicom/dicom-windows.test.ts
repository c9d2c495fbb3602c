// The windows of DICOM files: black, white and name of each.
import { expect } from '@esm-bundle/chai';
import { findWindow } from '../../../../src/viewer/appearance/find-window.ts';
import { english } from '../../../../src/messages/english-slices.ts';
import { grayLevels, grayRange } from '../../../../src/panes/gray-levels.ts';
import { ctSlice } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { decodeFields } from '../../../helpers/dicom-series.ts';

const several: DicomFields = {
  WindowCenter: '40\\-600\\300\\80',
  WindowWidth: '400\\1500\\2000\\80',
  WindowCenterWidthExplanation: 'MEDIASTINUM\\Lungs\\BONE \\Erna Geheim',
};

const read = async (fields: DicomFields): ReturnType<typeof decodeFields> => decodeFields([ctSlice(0, fields)]);

/** Shares of white of some values: pydicom 3.0.2, `apply_voi_lut` of float values, less its smallest output and divided by their range. */
const pydicom: readonly (readonly [string, DicomFields, values: readonly number[], shares: readonly number[]])[] = [
  [
    'without a function',
    { WindowCenter: [40], WindowWidth: [400] },
    [-170, -160, -159, -60, 39, 40, 239, 240, 250],
    [0, 0, 0.002506266, 0.250626566, 0.498746867, 0.501253133, 1, 1, 1],
  ],
  [
    'LINEAR_EXACT',
    { WindowCenter: [40], WindowWidth: [400], VOILUTFunction: 'LINEAR_EXACT' },
    [-170, -160, -159, -60, 39, 40, 239, 240, 250],
    [0, 0, 0.0025, 0.25, 0.4975, 0.5, 0.9975, 1, 1],
  ],
  [
    'LINEAR',
    { WindowCenter: [-600], WindowWidth: [1500], VOILUTFunction: 'LINEAR' },
    [-1400, -1350, -1349, -600, 149, 150],
    [0, 0, 0.000667111, 0.500333556, 1, 1],
  ],
  ['LINEAR, of two', { WindowCenter: [3], WindowWidth: [2] }, [1, 2, 2.25, 3, 4], [0, 0, 0.25, 1, 1]],
  ['LINEAR, a threshold', { WindowCenter: [50], WindowWidth: [1] }, [48, 49, 50, 51], [0, 0, 1, 1]],
  ['LINEAR, a threshold on a value', { WindowCenter: [50.5], WindowWidth: [1] }, [49, 50, 51, 52], [0, 0, 1, 1]],
  [
    'LINEAR_EXACT, narrower than 1',
    { WindowCenter: [2.25], WindowWidth: [0.5], VOILUTFunction: 'LINEAR_EXACT' },
    [1.9, 2, 2.125, 2.25, 2.5, 2.6],
    [0, 0, 0.25, 0.5, 1, 1],
  ],
];

describe('windows of DICOM files', () => {
  for (const [name, fields, values, shares] of pydicom)
    it(`show the greys of pydicom, ${name}`, async () => {
      const { windows } = await read(fields);
      const [{ from, to }] = windows!;
      for (const [i, value] of values.entries())
        expect(Math.min(1, Math.max(0, (value - from) / (to - from))), String(value)).to.be.closeTo(shares[i], 1e-8);
    });

  it('are all there, with well-known names in plain words, and numbers instead of others', async () => {
    const { windows, window, left } = await read(several);
    expect(windows).to.deep.equal([
      { name: 'mediastinum', from: -160, to: 239, width: 400, level: 40 },
      { name: 'lung', from: -1350, to: 149, width: 1500, level: -600 },
      { name: 'bone', from: -700, to: 1299, width: 2000, level: 300 },
      { name: 'Window 4', from: 40, to: 119, width: 80, level: 80 },
    ]);
    expect(window).to.deep.equal([-160, 239]);
    expect(left).to.equal(undefined);
  });

  it('have names of which each is in the messages', async () => {
    const words = ['ABDOMEN', 'Bone Window', 'CT BRAIN', 'THORAX', 'HEAD', 'LIVER', 'WINDOW LUNG', 'MEDIASTINAL'];
    words.push('NECK', 'PELVIS', 'SOFT_TISSUE', 'C-SPINE', 'ANGIO', 'NORMAL', 'HARDER', 'SOFTER');
    const { windows } = await read({
      WindowCenter: words.map((_, i) => i),
      WindowWidth: words.map(() => 10),
      WindowCenterWidthExplanation: words.join('\\'),
    });
    expect(windows!.map(({ name }) => name)).to.deep.equal(Object.keys(english.windowNames));
  });

  it('are those of the frame in an enhanced file', async () => {
    const { windows } = await read({
      SharedFunctionalGroupsSequence: [
        { FrameVOILUTSequence: [{ WindowCenter: [10], WindowWidth: [20], WindowCenterWidthExplanation: 'BRAIN' }] },
      ],
    });
    expect(windows).to.deep.equal([{ name: 'brain', from: 0, to: 19, width: 20, level: 10 }]);
  });

  it('with a curve are a straight line, and a table is its span; both are said', async () => {
    const sigmoid = await read({ ...several, VOILUTFunction: 'SIGMOID' });
    expect(sigmoid.windows![0]).to.include({ from: -160, to: 240 });
    expect(sigmoid.left).to.deep.equal(['windows with a curve from black to white (SIGMOID): a straight line is used']);
    const greys = Uint16Array.from([0, 0, 0, 100, 900, 4000, 4095, 4095, 4095, 4095]);
    const table = { LUTExplanation: 'BONE', LUTData: new Uint8Array(greys.buffer) };
    const said = ['tables from values to greys (VOI LUT): a straight line over the same values is used'];
    const tabled = await read({ VOILUTSequence: [{ LUTDescriptor: [10, 2 ** 16 - 100, 16], ...table }] });
    // Grey 0 up to the value -98, grey 4095 from -94 on.
    expect(tabled.windows).to.deep.equal([{ name: 'bone', from: -98, to: -94, width: 4, level: -96 }]);
    expect(tabled.left).to.deep.equal(said);
    const both = await read({ ...several, VOILUTSequence: [{ LUTDescriptor: [2, 5, 16], LUTExplanation: 'x' }] });
    expect(both.windows!.map(({ name, from, to }) => [name, from, to]).slice(3)).to.deep.equal([
      ['Window 4', 40, 119],
      ['Window 5', 5, 6],
    ]);
    expect(both.left).to.deep.equal(said);
  });

  it('leave out what is no window, and stop at sixteen', async () => {
    const bad = await read({ WindowCenter: '1\\x\\3\\4\\5', WindowWidth: '0\\5\\-3\\1e999' });
    expect([bad.window, bad.windows]).to.satisfy(([, windows]: unknown[]) => windows === undefined);
    const empty = await read({ VOILUTSequence: [{}, { LUTDescriptor: [1, 7, 16] }] });
    expect(empty.windows).to.equal(undefined);
    const many = Array.from({ length: 5000 }, (_, i) => i);
    const { windows, left } = await read({ WindowCenter: many, WindowWidth: many.map(() => 10) });
    expect(windows!.length).to.equal(16);
    expect(left).to.deep.equal(['4,984 windows after the first 16']);
  });

  it('are found by name and by number, and a pane reads their ends as they are', async () => {
    const volume = await read(several);
    expect(findWindow('Lung', volume)).to.deep.equal([-1350, 149]);
    expect(findWindow(' 4 ', volume)).to.deep.equal([40, 119]);
    expect(findWindow([1, 2], volume)).to.deep.equal([1, 2]);
    expect(() => findWindow('liver', volume)).to.throw(
      /expected two numbers, like "-150 250", or a window of the file: 1 or mediastinum, 2 or lung, 3 or bone, 4 or Window 4/,
    );
    expect(() => findWindow('lung', {})).to.throw(/this file has none/);
    expect(grayRange(grayLevels([-1350, 149], 'linear', volume))).to.deep.equal([-1350, 149]);
    expect(grayRange(grayLevels([-1350, 150], 'linear', volume))).to.deep.equal([-1350, 149]);
  });
});

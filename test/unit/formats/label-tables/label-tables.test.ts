import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import type { LabelTable } from '../../../../src/formats/label-tables/label-table.ts';
import { maxTableBytes, readLabelTable } from '../../../../src/formats/label-tables/read-label-table.ts';

const read = (text: string): LabelTable => readLabelTable(new TextEncoder().encode(text), 'names.txt');
const listOf = (table: LabelTable): unknown[] =>
  [...table.rows.values()].map(({ id, name, color, opacity, hidden }) => [
    id,
    name,
    color && color.map((c) => Math.round(c * 255)),
    opacity,
    hidden,
  ]);

describe('tables of labels', () => {
  it('of BIDS: columns in any order, n/a, colours of 3 and 6 digits', () => {
    // Columns and values as in the example of BIDS 1.10, "Common image-derived labels": tab-separated, with a header.
    const table = read(
      '﻿index\tname\tabbreviation\tcolor\tmapping\r\n1\tGray Matter\tGM\t#ff53bb\t1\r\n10\tn/a\tWM\t#2f8\t2\r\n\r\n-3\tOther\tn/a\tn/a\tn/a\r\n',
    );
    expect(table.format).to.equal('BIDS');
    expect(table.problems).to.deep.equal([]);
    expect(listOf(table)).to.deep.equal([
      [1, 'Gray Matter', [255, 83, 187], 1, false],
      [10, 'WM', [34, 255, 136], 1, false],
      [-3, 'Other', null, 1, false],
    ]);
    expect(listOf(read('color\tname\tindex\n#102030\tBone\t7'))).to.deep.equal([[7, 'Bone', [16, 32, 48], 1, false]]);
  });

  it('of FreeSurfer: A lets light through, and comments are left out', () => {
    // Rows of FreeSurferColorLUT.txt; A by CTABreadASCII: alpha = 255 - t.
    const table = read(
      '#$Id: FreeSurferColorLUT.txt\n\n#No. Label Name:                            R   G   B   A\n0   Unknown                                 0   0   0   0\n17  Left-Hippocampus                        220 216 20  0\n18  Left-Amygdala  103 255 255 51\n',
    );
    expect(table.format).to.equal('FreeSurfer');
    expect(listOf(table)).to.deep.equal([
      [0, 'Unknown', [0, 0, 0], 1, false],
      [17, 'Left-Hippocampus', [220, 216, 20], 1, false],
      [18, 'Left-Amygdala', [103, 255, 255], 0.8, false],
    ]);
    // Colour tables of 3D Slicer and MRtrix have 255 for opaque.
    expect(listOf(read('0 Background 0 0 0 0\n1 tissue 128 174 128 255\n2 bone 241 214 145 255'))).to.deep.equal([
      [0, 'Background', [0, 0, 0], 0, false],
      [1, 'tissue', [128, 174, 128], 1, false],
      [2, 'bone', [241, 214, 145], 1, false],
    ]);
    expect(listOf(read('5 Inner ear, left 1 2 3\n'))).to.deep.equal([[5, 'Inner ear, left', [1, 2, 3], 1, false]]);
  });

  it('of BIDS: cells in quotes, as pandas 3.1.1 writes names with tabs and quotes', () => {
    // pandas.DataFrame(...).to_csv(sep="\t", index=False)
    const table = read(
      'index\tname\tcolor\n1\t"He said ""x"""\t#ff0000\n2\t"a\tb"\t#00ff00\n3\tthe "x" area\t#0000ff\n4\t"open\t#010203\n',
    );
    expect(table.problems).to.deep.equal([]);
    expect(listOf(table)).to.deep.equal([
      [1, 'He said "x"', [255, 0, 0], 1, false],
      [2, 'a b', [0, 255, 0], 1, false],
      [3, 'the "x" area', [0, 0, 255], 1, false],
      [4, '"open', [1, 2, 3], 1, false],
    ]);
  });

  it('of 3D Slicer: A is opacity', () => {
    // Examples of its developer guide, "Colors", with other opacities.
    const text =
      '# Color table file /tmp/Segmentation-label_ColorTable.ctbl\n# 4 values\n0 Background 0 0 0 0\n1 artery 216 101 79 51\n2 bone 241 214 145 0\n';
    expect(listOf(read(text))).to.deep.equal([
      [0, 'Background', [0, 0, 0], 0, false],
      [1, 'artery', [216, 101, 79], 0.2, false],
      [2, 'bone', [241, 214, 145], 0, false],
    ]);
    expect(listOf(read('1 artery 216 101 79 51\n2 bone 241 214 145 255\n3 vein 1 2 3 255'))).to.deep.equal([
      [1, 'artery', [216, 101, 79], 0.2, false],
      [2, 'bone', [241, 214, 145], 1, false],
      [3, 'vein', [1, 2, 3], 1, false],
    ]);
    const table = read(
      'LabelValue,Name,Color_R,Color_G,Color_B,Color_A,Type_CodeMeaning\r\n1,left_kidney,185,102,83,255,Kidney\r\n10,,127,127,127,51,"Catheter, renal"\r\n5,mass,300,0,0,,\r\nx,y,1,2,3,4,\r\n',
    );
    expect(table.format).to.equal('3D Slicer');
    expect(listOf(table)).to.deep.equal([
      [1, 'left_kidney', [185, 102, 83], 1, false],
      [10, 'Catheter, renal', [127, 127, 127], 0.2, false],
      [5, 'mass', null, 1, false],
    ]);
    expect(table.problems.map((problem) => problem.slice(0, 6))).to.deep.equal(['line 4', 'line 5']);
    expect(listOf(read('LabelValue,Color_R,Color_G,Color_B\n3,1,2,3'))).to.deep.equal([[3, '', [1, 2, 3], 1, false]]);
  });

  it('of FreeSurfer: names with blanks may end in a number', () => {
    const named = [
      [1, 'Brodmann area 17', [222, 149, 10], 1, false],
      [2, 'V 2', [60, 46, 205], 1, false],
      [3, 'White matter', [1, 2, 3], 1, false],
    ];
    const more = [4, 5].map((id) => [id, 'a', [1, 2, 3], 1, false]);
    const rows = ['1 Brodmann area 17 222 149 10', '2 V 2 60 46 205', '3 White matter 1 2 3', '4 a 1 2 3', '5 a 1 2 3'];
    expect(listOf(read(rows.join('\n')))).to.deep.equal([...named, ...more]);
    const withAlpha = rows.map((row) => `${row} 0`);
    expect(listOf(read(withAlpha.join('\n')))).to.deep.equal([...named, ...more]);
    // All names end in a number: what would be alpha differs from row to row.
    expect(listOf(read(withAlpha.slice(0, 2).join('\n')))).to.deep.equal(named.slice(0, 2));
    // FreeSurfer's own tables with tissue types, a number after alpha.
    const withTypes = '0 Unknown 0 0 0 0 0\n2 Left-White 245 245 245 0 2\n4 Left-Ventricle 120 18 134 0 4';
    expect(listOf(read(withTypes))).to.deep.equal([
      [0, 'Unknown', [0, 0, 0], 1, false],
      [2, 'Left-White', [245, 245, 245], 1, false],
      [4, 'Left-Ventricle', [120, 18, 134], 1, false],
    ]);
  });

  it('of ITK-SNAP: A is 0 to 1, and VIS hides', () => {
    // As ITK-SNAP 3 and 4 write them: IDX R G B A VIS MSH LABEL.
    const table = read(
      '################################################\n# ITK-SnAP Label Description File\n    0     0    0    0        0  0  0    "Clear Label"\n    1   255    0    0        1  1  1    "Label 1"\n    2     0  255    0      0.5  0  1    "Left ""\n    3     0    0  255       .25  0  1    "Right, hidden"\n',
    );
    expect(table.format).to.equal('ITK-SNAP');
    expect(listOf(table)).to.deep.equal([
      [0, 'Clear Label', [0, 0, 0], 0, true],
      [1, 'Label 1', [255, 0, 0], 1, false],
      [3, 'Right, hidden', [0, 0, 255], 0.25, true],
    ]);
    expect(table.problems).to.have.length(1);
    expect(table.problems[0]).to.match(/^line 5 got "2 0 255 0 0.5/);
  });

  it('of NiiVue: lists in JSON, with ids or without', () => {
    // NiiVue's label colormaps: R, G, B, A, I, labels; makeLabelLut counts from 0 without I, and is opaque without A.
    const table = read(
      '{"R": [0, 255], "G": [0, 128], "B": [0, 64], "A": [0, 51], "I": [0, 1000], "labels": ["air", "bone"]}',
    );
    expect(table.format).to.equal('NiiVue');
    expect(listOf(table)).to.deep.equal([
      [0, 'air', [0, 0, 0], 0, false],
      [1000, 'bone', [255, 128, 64], 0.2, false],
    ]);
    expect(listOf(read('{"labels": ["air", "bone"]}'))).to.deep.equal([
      [0, 'air', null, 1, false],
      [1, 'bone', null, 1, false],
    ]);
  });

  it('report bad rows with their line, and keep the others; of doubled ids the first holds', () => {
    const table = read(
      'index\tname\tcolor\n1\tone\t#ff0000\n1.5\thalf\t#00ff00\n2\ttwo\torange-ish\n1\tagain\t#0000ff\nx\ty\tz\n',
    );
    expect(listOf(table)).to.deep.equal([
      [1, 'one', [255, 0, 0], 1, false],
      [2, 'two', null, 1, false],
    ]);
    expect(table.problems.map((problem) => problem.slice(0, 7))).to.deep.equal([
      'line 3 ',
      'line 4 ',
      'line 5:',
      'line 6 ',
    ]);
    expect(table.problems[2]).to.contain('the first one holds');
    const broken = read('1 a 1 2 3 0\n1 b 256 2 3 0\nnonsense\n');
    expect([...broken.rows.keys()]).to.deep.equal([1]);
    expect(broken.problems.map((problem) => problem.slice(0, 6))).to.deep.equal(['line 2', 'line 3']);
  });

  it('are distinguished from other files, and refused in words', () => {
    const refusals: [string | Uint8Array, string, RegExp][] = [
      ['<!doctype html>', 'format/unknown', /BIDS .* FreeSurfer .* ITK-SNAP .* NiiVue/],
      ['', 'format/unknown', /no kind that is known/],
      ['{"R": [', 'format/corrupt', /no JSON/],
      ['index\tname\nx\ty\n', 'format/corrupt', /no label that can be read.*line 2/],
      ['{"R": "red"}', 'format/corrupt', /R got/],
      [new Uint8Array(maxTableBytes + 1), 'format/too-large', /4,194,304/],
    ];
    for (const [text, code, message] of refusals) {
      const thrown = ((): unknown => {
        try {
          return typeof text === 'string' ? read(text) : readLabelTable(text, 'names.txt');
        } catch (error) {
          return error;
        }
      })();
      expect(thrown).to.be.instanceOf(VolumeViewError);
      expect((thrown as VolumeViewError).code).to.equal(code);
      expect((thrown as VolumeViewError).message).to.match(message);
    }
  });

  it('keep names to one short line, and the problems of a hostile file few', () => {
    const [row] = read(`index\tname\n1\t<img src=x onerror=alert(1)> ${'x'.repeat(5000)}\n`).rows.values();
    expect(row.name).to.have.length(200);
    const long = read(`1 a 1 2 3 0\n${'spoiled line\n'.repeat(10_000)}`);
    expect(long.problems).to.have.length(21);
    expect(long.problems[20]).to.contain('9980 more');
    expect(read('1 a‮\u0007b 1 2 3 0').rows.get(1)!.name).to.equal('a‮ b');
  });

  it('of any damage are read as far as they go, or refused', () => {
    const tables = [
      'index\tname\tcolor\n1\tone\t#ff0000\n2\ttwo\t#00ff00\n',
      '17 Left-Hippocampus 220 216 20 0\n18 Left-Amygdala 103 255 255 0\n',
      '1 255 0 0 1 1 1 "Label 1"\n2 0 255 0 0.5 0 1 "Label 2"\n',
      '{"R": [0, 255], "G": [0, 1], "B": [0, 2], "I": [0, 5], "labels": ["a", "b"]}',
    ];
    let seed = 15;
    const random = (below: number): number => (seed = (seed * 1103515245 + 12345) % 2 ** 31) % below;
    let [kept, refused] = [0, 0];
    for (let run = 0; run < 2000; run++) {
      const bytes = new TextEncoder().encode(tables[run % 4]);
      for (let change = random(5); change >= 0; change--) bytes[random(bytes.length)] = random(256);
      try {
        for (const { id, name, color, opacity } of readLabelTable(
          bytes.subarray(0, 1 + random(bytes.length)),
          'x',
        ).rows.values()) {
          expect(
            Number.isSafeInteger(id) &&
              typeof name === 'string' &&
              opacity >= 0 &&
              opacity <= 1 &&
              (color?.every((c) => c >= 0 && c <= 1) ?? true),
          ).to.equal(true);
        }
        kept++;
      } catch (error) {
        expect(error).to.be.instanceOf(VolumeViewError);
        refused++;
      }
    }
    expect(Math.min(kept, refused)).to.be.greaterThan(100);
  });
});

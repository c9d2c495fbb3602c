// <volume-measure>: what attributes say, in which units it is told, which lines show it, and the crosshair of panes in 3D.
import { expect } from '@esm-bundle/chai';
import { listMeasure, writeMeasure } from '../../../components/volume-measure/volume-measure-rows.ts';
import { crosshairLines } from '../../../src/viewer/attachments/crosshair-in-view.ts';
import { linesOf, textPlace } from '../../../src/viewer/tools/measure-lines.ts';
import {
  fromDrawn,
  measure,
  readMeasurePoints,
  readMeasureType,
  toDrawn,
} from '../../../src/viewer/tools/measuring.ts';
import type { MeasureResult } from '../../../src/viewer/tools/measuring.ts';
import { cartesianGrid } from '../../../src/volume/grid.ts';
import { length, scaleAndTranslate, subtract } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { english as companions } from '../../../src/messages/english-companions.ts';
import { english as handles } from '../../../src/messages/english-handles.ts';
import { english } from '../../../src/messages/english-measure.ts';
import { english as readout } from '../../../src/messages/english-readout.ts';
import { Language } from '../../../src/messages/language.ts';
import { radarVolume } from '../../helpers/synthetic-radar.ts';

const messages = { ...companions, ...readout, ...handles, ...english };
const locale = { language: new Language('en', messages), messages };

const plain: MeasureResult = {
  type: 'distance',
  points: [],
  lengthUnit: 'mm',
  value: 123.456,
  uncertainty: 0.789,
  lengths: [],
  statistics: null,
  unit: '',
};
const written = (known: Partial<MeasureResult>): string => writeMeasure({ ...plain, ...known }, locale);

describe('the attributes of a measure', () => {
  it('are points in threes, or an error that says how many', () => {
    expect(readMeasureType(null)).to.equal('distance');
    expect(readMeasureType(' Sphere ')).to.equal('sphere');
    expect(readMeasurePoints(' 1 2 3, -4 5e1 .5 ', 'distance')).to.deep.equal([
      [1, 2, 3],
      [-4, 50, 0.5],
    ]);
    expect(readMeasurePoints('', 'box')).to.equal(null);
    for (const [text, type] of [
      ['1 2 3', 'distance'],
      ['1 2 3 4 5', 'box'],
      ['1 2 3, 4 5 6', 'angle'],
      ['1 2 3, 4 5 x', 'sphere'],
      ['1 2 3, 4 5 NaN', 'sphere'],
      ['1 2 3, 4 5 1e300', 'sphere'],
    ] as const) {
      expect(() => readMeasurePoints(text, type), text).to.throw(
        `points of <volume-measure type="${type}"> got "${text}"; expected ${type === 'angle' ? 3 : 2} places`,
      );
    }
    expect(() => readMeasureType('length')).to.throw(
      'type of <volume-measure> got "length"; expected distance, angle, box, sphere.',
    );
  });
});

describe('what was measured, in words', () => {
  it('has as many digits as are known, and the unit of the file', () => {
    expect(written({})).to.equal('123.46 ± 0.79 mm');
    expect(written({ uncertainty: 12.3 })).to.equal('123 ± 12 mm');
    expect(written({ lengthUnit: '' })).to.equal('123.46 ± 0.79');
    expect(written({ lengthUnit: 'm', value: 45678, uncertainty: 321 })).to.equal('45.68 ± 0.32 km');
    expect(written({ type: 'angle', value: 43.21, uncertainty: 1.5 })).to.equal('43.2° ± 1.5°');
    expect(written({ type: 'box', value: 123_456, uncertainty: 7_890 })).to.equal('123.5 ± 7.9 cm³');
    expect(written({ type: 'box', value: 123, uncertainty: 7.89 })).to.equal('123.0 ± 7.9 mm³');
    expect(written({ type: 'sphere', value: 2.5e12, uncertainty: 3e11, lengthUnit: 'm' })).to.equal('2500 ± 300 km³');
  });

  it('has the unit that suits its size', () => {
    expect(written({ value: 0.012, uncertainty: 0.0002 })).to.equal('12.00 ± 0.20 µm');
    expect(written({ value: 0.25, uncertainty: 0.0003 })).to.equal('250.00 ± 0.30 µm');
    expect(written({ value: 0.7, uncertainty: 0.3 }), 'the thickness of a slice').to.equal('0.70 ± 0.30 mm');
    expect(written({ value: 1, uncertainty: 0.001 })).to.equal('1.0000 ± 0.0010 mm');
    expect(written({ value: 0.0004, uncertainty: 0.00001 })).to.equal('400 ± 10 nm');
    expect(written({ value: 0, uncertainty: 0.0002 }), 'no length').to.equal('0 ± 200 nm');
    expect(written({ type: 'sphere', value: 4.19e-6, uncertainty: 2.3e-7 })).to.equal('4190 ± 230 µm³');
    expect(written({ type: 'sphere', value: 4.19e-15, uncertainty: 2.3e-16 })).to.equal('4190 ± 230 nm³');
    expect(written({ type: 'sphere', value: 0.0042, uncertainty: 0.0002 })).to.equal('0.00420 ± 0.00020 mm³');
    const box = { ...plain, type: 'box', value: 6e-6, uncertainty: 1e-6, lengths: [0.03, 0.02, 0.01] } as const;
    expect(listMeasure(box, false, locale)[0].text).to.equal('30 × 20 × 10 µm');
  });

  it('says what is inside, what the surface cuts, and what has no data', () => {
    const statistics = {
      count: 900,
      withoutData: 7,
      mean: 12.3456,
      deviation: 3.21,
      standardError: 0.107,
      least: -5,
      largest: 30,
      cut: 100,
    };
    const box: MeasureResult = {
      ...plain,
      type: 'box',
      lengths: [10, 20.5, 30],
      value: 6150,
      uncertainty: 50,
      unit: 'HU',
      statistics,
    };
    expect(listMeasure(box, false, locale).map(({ name, text }) => `${name}: ${text}`)).to.deep.equal([
      'Size: 10 × 20.5 × 30 mm',
      'Volume: 6.150 ± 0.050 cm³',
      'Mean: 12.35 HU (standard error 0.11)',
      'Standard deviation: 3.21 HU',
      'Minimum to maximum: −5 to 30 HU',
      'Voxels: 900, 100 of them at the edge; 7 without data left out',
    ]);
    const none = {
      count: 0,
      withoutData: 0,
      mean: null,
      deviation: null,
      standardError: null,
      least: null,
      largest: null,
      cut: 0,
    };
    expect(listMeasure({ ...box, statistics: none }, true, locale).at(-1)).to.deep.equal({
      name: 'Gates',
      text: 'none inside',
    });
    expect(listMeasure({ ...box, statistics: null }, false, locale).at(-1)!.text).to.equal('adding up …');
  });

  it('of a radar is in metres, and heights are not exaggerated', () => {
    const volume = radarVolume(
      { sweeps: [{ elevation: 1, gates: 40, gateLength: 500, firstGate: 250 }] },
      { verticalExaggeration: 5 },
    );
    const points: readonly Vector3[] = [
      [0, 0, 0],
      [3000, 0, 4000],
    ];
    expect(measure(volume, 'distance', points)).to.include({ value: 5000, lengthUnit: 'm' });
    expect(toDrawn(points[1], volume)).to.deep.equal([3000, 0, 20_000]);
    expect(fromDrawn([3000, 0, 20_000], volume)).to.deep.equal(points[1]);
  });
});

describe('the lines of a measure', () => {
  it('are twelve edges of a box, circles of a sphere, and the arc of an angle', () => {
    const box = linesOf('box', [
      [0, 0, 0],
      [1, 2, 3],
    ]);
    const edges = box.flatMap((line) => line.slice(1).map((to, i) => length(subtract(to, line[i]))));
    edges.sort((a, b) => a - b);
    expect(edges).to.deep.equal([1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3]);
    const [x, y, z] = linesOf('sphere', [
      [5, 5, 5],
      [5, 5, 7],
    ]);
    for (const point of [...x, ...y, ...z]) expect(length(subtract(point, [5, 5, 5]))).to.be.closeTo(2, 1e-12);
    const [, arc] = linesOf('angle', [
      [4, 0, 0],
      [0, 0, 0],
      [0, 8, 0],
    ]);
    expect(arc[0]).to.deep.equal([1, 0, 0]);
    arc.at(-1)!.forEach((part, axis) => expect(part).to.be.closeTo([0, 1, 0][axis], 1e-12));
    expect(linesOf('angle', [[4, 0, 0]])).to.deep.equal([]);
    expect(
      textPlace('distance', [
        [0, 0, 0],
        [2, 4, 6],
      ]),
    ).to.deep.equal([1, 2, 3]);
  });
});

describe('the crosshair of panes in the picture', () => {
  it('goes from side to side of the volume through the place, and is not there outside of it', () => {
    const grid = cartesianGrid([10, 20, 30], scaleAndTranslate([1, 1, 2], [0.5, 0.5, 1]));
    expect(crosshairLines(grid, [3, 4, 5])).to.deep.equal([
      [
        [0, 4, 5],
        [10, 4, 5],
      ],
      [
        [3, 0, 5],
        [3, 20, 5],
      ],
      [
        [3, 4, 0],
        [3, 4, 60],
      ],
    ]);
    expect(crosshairLines(grid, [3, 21, 5])).to.deep.equal([]);
  });
});

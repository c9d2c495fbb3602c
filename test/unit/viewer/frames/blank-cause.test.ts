// Why nothing is to be seen of a volume: told from what is known of its picture.
import { expect } from '@esm-bundle/chai';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { estimateError } from '../../../../src/quality/error-estimate.ts';
import { findBlankCause } from '../../../../src/viewer/frames/blank-cause.ts';
import type { BlankFacts } from '../../../../src/viewer/frames/blank-cause.ts';
import type { ViewLabels } from '../../../../src/viewer/model/view-labels.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const volume = syntheticVolume({ dimensions: [8, 8, 8], field: (x) => 10 + 90 * x, kind: 'float32' });
const polar = { ...volume, grid: { kind: 'polar' } as unknown as BlankFacts['volume']['grid'] };

/** Facts of a volume of which all could be seen, but for what a case says. */
function factsOf(text: string, more: Partial<BlankFacts> = {}): BlankFacts {
  const optics = { transferFunction: parseTransferFunction(text, [0, 100]), opacityFactor: 1, surfaces: null };
  return {
    volume,
    optics,
    cuts: { region: null, slices: [], cuts: [] },
    labels: null,
    inSight: true,
    isMoved: false,
    alpha: 0,
    ...more,
  };
}
const seen = '0 #000 0, 100 #fff 50%';
const hidden = (count: number): ViewLabels => ({
  shown: {
    map: { dimensions: [8, 8, 8], numbers: new Uint8Array(512), ids: [0, 1] },
    styles: Array.from({ length: 2 }, (_, i) => ({ color: [1, 1, 1], opacityFactor: i < count ? 0 : 1 })),
  },
  nameOf: () => null,
});

describe('the cause of a picture that shows nothing', () => {
  const [low, high] = volume.range;

  for (const [name, facts, expected] of [
    ['all values below what shows', factsOf('500 #000 0, 600 #fff 1'), { cause: 'values', low, high }],
    [
      'all values between two that show',
      factsOf('-2 #fff 1, -1 #fff 0, 200 #fff 0, 300 #fff 1'),
      { cause: 'values', low, high },
    ],
    ['a single value that shows is not that', factsOf('54 #fff 0, 55 #fff 1, 56 #fff 0'), { cause: 'faint' }],
    ['no opacity', factsOf('0 #000 0, 100 #fff 0'), { cause: 'transparent' }],
    [
      'no values',
      factsOf(seen, { volume: { ...volume, histogram: { ...volume.histogram, counts: new Uint32Array(256) } } }),
      { cause: 'noData' },
    ],
    [
      'no echoes',
      factsOf(seen, { volume: { ...polar, histogram: { ...volume.histogram, counts: new Uint32Array(256) } } }),
      { cause: 'noEchoes' },
    ],
    ['weak echoes', factsOf('500 #000 0, 600 #fff 1', { volume: polar }), { cause: 'weakEchoes', value: 500 }],
    [
      'strong echoes that a scale leaves out',
      factsOf('-5 #fff 1, -1 #fff 0', { volume: polar }),
      { cause: 'values', low, high },
    ],
    ['all labels hidden', factsOf(seen, { labels: hidden(2), inSight: null }), { cause: 'labels' }],
    ['some labels hidden, and nothing else known', factsOf(seen, { labels: hidden(1) }), { cause: 'faint' }],
    [
      'a volume of labels that all are hidden',
      factsOf('0 #000 0, 2 #fff 0', { labels: { shown: null, nameOf: () => null } }),
      { cause: 'labels' },
    ],
    ['no cell shows', factsOf(seen, { inSight: null }), { cause: 'values', low, high }],
    ['out of sight', factsOf(seen, { inSight: false }), { cause: 'sight' }],
    ['out of sight of a person who went there', factsOf(seen, { inSight: false, isMoved: true }), null],
    ['cut away', factsOf(seen, { cuts: { region: volume.grid, slices: [], cuts: [] } }), { cause: 'cut' }],
    [
      'a part that is too faint',
      factsOf(seen, { cuts: { region: volume.grid, slices: [], cuts: [] }, alpha: 1 / 255 }),
      { cause: 'faint' },
    ],
    ['too faint', factsOf(seen, { alpha: 1 / 255 }), { cause: 'faint' }],
    ['too faint, from wherever', factsOf(seen, { alpha: 1 / 255, isMoved: true }), { cause: 'faint' }],
    ['beside it, by hand', factsOf(seen, { isMoved: true }), null],
    ['meant to be transparent', factsOf(seen, { optics: { ...factsOf(seen).optics, opacityFactor: 0 } }), null],
  ] as const) {
    it(name, () => expect(findBlankCause(facts)).to.deep.equal(expected));
  }
});

describe('rays that show nothing', () => {
  const estimate = (alpha: number): number => {
    const picture = Float32Array.from({ length: 400 }, (_, i) => (i % 4 === 3 ? alpha : alpha / 2));
    return estimateError({ shown: picture, middle: picture, fine: picture, isEven: true }).covered;
  };

  it('do not count as ones that met something: up to 2 of 255', () => {
    expect([0, 1e-9, 1 / 255, 2 / 255, 3 / 255, 1].map(estimate)).to.deep.equal([0, 0, 0, 0, 100, 100]);
  });
});

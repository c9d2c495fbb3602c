// What is stated as the largest error counts what styles alone may change.
import { expect } from '@esm-bundle/chai';
import { contributionOf } from '../../../../src/optics/cells/empty-space-distance.ts';
import { findDetail } from '../../../../src/optics/cells/cell-detail.ts';
import type { SeenVolume } from '../../../../src/optics/cells/cell-detail.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { findSeenCells } from '../../../../src/optics/cells/seen-cells.ts';
import { rangeLight, rangeStyles } from '../../../../src/optics/cells/style-detail.ts';
import type { StyleChain, VolumeStyle } from '../../../../src/optics/transfer/volume-styles.ts';
import { boundMissed } from '../../../../src/quality/largest-error.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const speck = (x: number, y: number, z: number): number =>
  Math.max(Math.abs(x - 0.48), Math.abs(y - 0.48), Math.abs(z - 0.48)) < 0.02 ? 1 : 0.1;

function see(
  field: (x: number, y: number, z: number) => number,
  text: string,
  replacement: (appearance: Parameters<typeof rangeLight>[0]) => SeenVolume['style'],
): SeenVolume {
  const volume = syntheticVolume({ dimensions: [24, 24, 24], field });
  const transferFunction = parseTransferFunction(text, [0, 1]);
  const style = replacement({ volume, transferFunction, referenceLength: 1 });
  return {
    volume,
    transferFunction,
    cells: findSeenCells(volume.macrocells, [contributionOf(transferFunction)], volume),
    opticalScale: 1,
    style,
  };
}

const chain = (...styles: readonly VolumeStyle[]): readonly StyleChain[] => [{ weight: 1, styles }];
const gradient = (...stops: readonly (readonly [number, number])[]): readonly StyleChain[] =>
  chain({ kind: 'gradient', stops });
const oneColor = '0 #fff 60%, 1 #fff 60%';
/** Of a voxel's tent of that opacity. */
const tent = 1 - 0.4 ** 2;

describe('the bound of what styles alone may show', () => {
  const boundOf = (chains: readonly StyleChain[], field = speck, text = oneColor, samples = 1): number =>
    boundMissed(
      see(field, text, (appearance) => rangeStyles(chains, appearance)),
      samples,
    );

  it('is what shows where `gradient-opacity` makes it show, among gradients that there may be', () => {
    expect(
      boundMissed(
        see(speck, oneColor, () => undefined),
        1,
      ),
      'without a style',
    ).to.equal(0);
    expect(boundOf(gradient([0.2, 0], [0.3, 1], [0.4, 0]))).to.be.closeTo(tent, 0.005);
    expect(
      boundOf(gradient([0.2, 0], [0.3, 1], [0.4, 0]), speck, oneColor, 4),
      'less between more samples',
    ).to.be.below(0.6 * tent);
    expect(boundOf(gradient([0.2, 0], [0.3, 0.5], [0.4, 0]))).to.be.closeTo(1 - 0.4, 0.005);
    expect(boundOf(gradient([5, 0], [6, 1])), 'steeper than there is').to.equal(0);
    expect(boundOf(gradient([0.2, 0.7])), 'the same everywhere').to.be.below(1e-9);
    expect(
      boundOf(gradient([0.2, 0], [0.3, 1], [0.4, 0]), () => 0.5),
      'one value',
    ).to.equal(0);
  });

  it('is less where a style hides most of it', () => {
    const text = '0 #fff 0, 1 #fff 60%';
    const plain = boundMissed(
      see(speck, text, () => undefined),
      1,
    );
    expect(boundOf(gradient([0, 0.02], [5, 0.02], [6, 1]), speck, text)).to.be.within(0.01 * plain, 0.1 * plain);
  });

  it('counts silhouettes, boundaries, colours and light', () => {
    expect(boundOf(chain({ kind: 'silhouette', retained: 0.1, boundary: 0.9, sharpness: 4 }))).to.be.within(
      0.9 * tent,
      tent,
    );
    expect(boundOf(chain({ kind: 'boundary', retained: 0, boundary: 1, power: 1 }))).to.be.within(0.3, 1);
    expect(boundOf(chain({ kind: 'edge', color: [0, 0, 0], threshold: 0.5 }))).to.be.above(0.9 * tent);
    expect(boundMissed(see(speck, oneColor, rangeLight), 1)).to.be.above(0.8 * tent);
    const faint = (x: number, y: number, z: number): number => (speck(x, y, z) > 0.5 ? 0.11 : 0.1);
    expect(boundMissed(see(faint, oneColor, rangeLight), 1), 'what is all but flat').to.be.below(0.05);
  });

  it('takes no more steps', () => {
    const plain = findDetail(
      see(speck, oneColor, () => undefined),
      2 / 255,
    );
    expect(findDetail(see(speck, oneColor, rangeLight), 2 / 255)).to.deep.equal(plain);
  });
});

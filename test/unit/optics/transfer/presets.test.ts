// What each preset is for, as numbers: values that it leaves out, and values that it shows. A new preset gets a row here.
import { expect } from '@esm-bundle/chai';
import { writtenPresets } from '../../../../src/optics/transfer/preset-names.ts';
import { readTransferFunction } from '../../../../src/optics/transfer/presets.ts';
import { evaluate } from '../../../../src/optics/transfer/transfer-function.ts';

interface Purpose {
  /** What presets and percentages span; a CT's and a radar's own values need none. */
  readonly window?: readonly [number, number];
  /** Values that are clear. */
  readonly clear: readonly number[];
  /** Values that show, from faint to opaque. */
  readonly seen: readonly number[];
}

/** CT in HU: air -1000, lung -850, fat -100, water 0, muscle 50, spongy bone 250, compact bone 1000. */
const purposes: Readonly<Record<(typeof writtenPresets)[number], Purpose>> = {
  gray: { window: [0, 100], clear: [0], seen: [20, 50, 100] },
  'ct-bone': { clear: [-1000, -100, 50, 140], seen: [250, 1000] },
  'ct-soft-tissue': { clear: [-1000, -850], seen: [-100, 50, 115] },
  'ct-angio': { clear: [-100, 50, 150], seen: [210, 280, 350] },
  'ct-lung': { clear: [-1000], seen: [-850, -700, -500] },
  'radar-dbz': { clear: [-10, 0, 3], seen: [10, 35, 55, 75] },
  'radar-velocity': { window: [-30, 30], clear: [], seen: [0, 15, 30] },
  diverging: { window: [-10, 10], clear: [0], seen: [3, 6, 10] },
};

describe('the presets', () => {
  for (const name of writtenPresets) {
    it(`${name} leaves out and shows what it is for`, async () => {
      const { window = [0, 1], clear, seen } = purposes[name];
      const stops = await readTransferFunction(name, window);
      const opacities = seen.map((value) => evaluate(stops, value)[3]);
      for (const value of clear) expect(evaluate(stops, value)[3], `opacity at ${value}`).to.equal(0);
      expect(Math.min(...opacities), 'the smallest opacity of what is seen').to.be.above(0);
      const falls = opacities.findIndex((opacity, i) => opacity < opacities[i - 1]);
      expect(falls, `no opacity falls in ${opacities.join(', ')}`).to.equal(-1);
    });
  }

  it('of a CT and of reflectivity do not depend on the window', async () => {
    for (const name of writtenPresets.filter((one) => /^ct-|dbz$/.test(one))) {
      expect(await readTransferFunction(name, [0, 1]), name).to.deep.equal(
        await readTransferFunction(name, [-500, 3000]),
      );
    }
  });
});

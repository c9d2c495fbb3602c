import { expect } from '@esm-bundle/chai';
import { buildDefaultPreset, defaultPreset } from '../../../../src/optics/transfer/default-preset.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { presetNames } from '../../../../src/optics/transfer/preset-names.ts';
import { resolveTransferFunction } from '../../../../src/optics/transfer/resolve-transfer-function.ts';

describe('the default preset', () => {
  const text =
    '0% #1c0a0a 0, 14% #33100c 2.5%, 32% #6e3426 5%, 50% #b57758 7%, 68% #e8bd92 9%, 86% #fff0d8 14%, 100% white 18%';

  it('is to the last bit what an author would write', async () => {
    for (const window of [
      [0, 1],
      [-150.25, 250.7],
      [1e-3, 7e8],
    ] as const) {
      const parsed = parseTransferFunction(text, window);
      expect(buildDefaultPreset(window)).to.deep.equal(parsed);
      expect(await resolveTransferFunction(` ${defaultPreset.toUpperCase()} `, window)).to.deep.equal(parsed);
    }
  });

  it('has numbers in windows as wide as they go', () => {
    for (const [low, high] of [
      [-1e38, 1e38],
      [-3.4e38, 3.4e38],
      [-1e300, 1e300],
      [0, 1e300],
    ] as const) {
      const values = buildDefaultPreset([low, high]).map(({ value }) => value);
      expect(values.every(Number.isFinite), `${low} to ${high}`).to.equal(true);
      expect([values[0], values.at(-1)]).to.deep.equal([low, high]);
      expect((values[3] - low) / (high - low)).to.be.closeTo(0.5, 1e-12);
      expect(values.every((value, i) => i === 0 || value > values[i - 1])).to.equal(true);
    }
  });

  it('is one of the presets, each of which has stops', async () => {
    expect(presetNames).to.include(defaultPreset);
    for (const name of presetNames)
      expect((await resolveTransferFunction(name, [0, 100])).length, `stops of ${name}`).to.be.at.least(2);
  });
});

import { expect } from '@esm-bundle/chai';
import { buildDefaultPreset, defaultPreset } from '../../src/optics/default-preset.ts';
import { parseTransferFunction } from '../../src/optics/parse-transfer-function.ts';
import { presetNames } from '../../src/optics/preset-names.ts';
import { resolveTransferFunction } from '../../src/optics/resolve-transfer-function.ts';

describe('the default preset', () => {
  const text = '0% #1c0a0a 0, 14% #33100c 2.5%, 32% #6e3426 5%, 50% #b57758 7%, 68% #e8bd92 9%, 86% #fff0d8 14%, 100% white 18%';

  it('is to the last bit what an author would write', async () => {
    for (const window of [[0, 1], [-150.25, 250.7], [1e-3, 7e8]] as const) {
      const parsed = parseTransferFunction(text, window);
      expect(buildDefaultPreset(window)).to.deep.equal(parsed);
      expect(await resolveTransferFunction(` ${defaultPreset.toUpperCase()} `, window)).to.deep.equal(parsed);
    }
  });

  it('is one of the presets, each of which has stops', async () => {
    expect(presetNames).to.include(defaultPreset);
    for (const name of presetNames) expect((await resolveTransferFunction(name, [0, 100])).length, name).to.be.above(4);
  });
});

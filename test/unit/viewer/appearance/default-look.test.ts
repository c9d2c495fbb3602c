import { expect } from '@esm-bundle/chai';
import { withDefaultLook } from '../../../../src/viewer/appearance/default-look.ts';
import type { ScanModel } from '../../../../src/viewer/model/scan-model.ts';
import { plainAppearance } from '../../../../src/viewer/model/plain-appearance.ts';
import type { AppearanceSettings } from '../../../../src/viewer/model/settings.ts';
import { evenAzimuths, radarVolume } from '../../../helpers/synthetic-radar.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const scan: ScanModel = syntheticVolume({ dimensions: [8, 8, 8], kind: 'uint8', field: (x) => x });
const sweeps = [{ elevation: 1, azimuths: evenAzimuths(36), gates: 20, gateLength: 1000 }];

const look = (
  more: Partial<ScanModel>,
  said: Partial<AppearanceSettings> = {},
): readonly [shading: string | null, factor: number | null] => {
  const { shading, opacityFactor } = withDefaultLook({ ...plainAppearance, ...said }, { ...scan, ...more });
  return [shading, opacityFactor];
};

describe('the look of a volume whose page asks for none', () => {
  it('is lit where the values are a scan of matter', () => {
    expect(look({})).to.deep.equal(['lit', 6]);
    expect(look({ unit: 'HU', transferFunction: 'ct-bone' })).to.deep.equal(['lit', 3]);
  });

  it('is not lit where people read values from colours', () => {
    const plain = [null, null];
    expect(look({ transferFunction: 'diverging' }), 'statistics').to.deep.equal(plain);
    expect(look({ unit: 'mm/h' }), 'a unit').to.deep.equal(plain);
    expect(look({ isDiscrete: true }), 'labels').to.deep.equal(plain);
    expect(look(radarVolume({ sweeps })), 'a radar scan').to.deep.equal(plain);
  });

  it('is what an attribute of the page says, whichever that is', () => {
    const given: Partial<AppearanceSettings>[] = [
      { named: 'flat' },
      { transferFunction: 'gray' },
      { opacityFactor: 2 },
      { projection: 'max' },
      { shading: 'unlit' },
      { surfaces: '0.5' },
      { gradientOpacity: '0 0, 1 1' },
      { transferFunction2d: 'box 0 1 0 1 red' },
    ];
    for (const said of given) {
      const settings = { ...plainAppearance, ...said };
      expect(withDefaultLook(settings, scan), JSON.stringify(said)).to.equal(settings);
    }
  });

  it('stays lit when a person changes the window', () => {
    expect(look({}, { window: [0, 0.5], referenceLength: 3, lightFactor: 2 })).to.deep.equal(['lit', 6]);
  });
});

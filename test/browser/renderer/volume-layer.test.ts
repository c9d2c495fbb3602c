import { expect } from '@esm-bundle/chai';
import { plainOptics } from '../../helpers/picture.ts';
import { createQuietLayer } from '../../helpers/quiet-layer.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

describe('the appearance of a layer', () => {
  const volume = syntheticVolume({ dimensions: [4, 4, 4], kind: 'float32', field: (x) => x });
  const brighter = { ...plainOptics, lightFactor: 2 };

  it('is set at once where nothing has to be loaded', async () => {
    const layer = createQuietLayer();
    layer.set(volume);
    await layer.setAppearance({ optics: plainOptics });
    void layer.setAppearance({ optics: brighter, style: null });
    expect(layer.optics).to.equal(brighter);
  });

  it('shows a style that is loaded and its optics in the same picture', async () => {
    const layer = createQuietLayer();
    await layer.setAppearance({ optics: plainOptics });
    const loading = layer.setAppearance({ optics: brighter, style: { projection: 'max' } });
    expect([layer.optics, !layer.cutsSteps]).to.deep.equal([plainOptics, false]);
    await loading;
    expect([layer.optics, !layer.cutsSteps]).to.deep.equal([brighter, true]);
  });

  it('keeps what a later call does not give, also while it loads', async () => {
    const layer = createQuietLayer();
    await Promise.all([
      layer.setAppearance({ style: { projection: 'max' } }),
      layer.setAppearance({ optics: plainOptics }),
      layer.setAppearance({ optics: brighter }),
    ]);
    expect([layer.optics, !layer.cutsSteps]).to.deep.equal([brighter, true]);
    await Promise.all([layer.setAppearance({ style: { projection: 'min' } }), layer.setAppearance({ style: null })]);
    expect(layer.cutsSteps).to.equal(true);
  });
});

import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../src/optics/camera.ts';
import { renderReference } from '../../src/optics/reference.ts';
import type { TransferFunction } from '../../src/optics/transfer-function.ts';
import { longestDiagonal } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';

const ramp: TransferFunction = [
  { value: 0.2, color: [0, 0, 0.2], opacity: 0 },
  { value: 0.45, color: [0.9, 0.3, 0.1], opacity: 0.05 },
  { value: 0.7, color: [1, 1, 0.8], opacity: 0.4 },
];

describe('a scene', () => {
  it('draws what the reference draws', async () => {
    const volume: Volume = syntheticVolume({ dimensions: [24, 20, 16] });
    const container = document.createElement('div');
    document.body.append(container);
    const t0 = performance.now();
    const scene = await VolumeScene.create(container, container, () => {});
    const t1 = performance.now();
    scene.resize(64, 48);
    scene.setVolume(volume);
    const optics = { transferFunction: ramp, referenceLength: 1, opacityFactor: 1, lightFactor: 1 };
    scene.setOptics(optics);
    scene.setCamera(orbitCamera({ theta: 0.6, phi: 1.2, radius: 70 }, [0, 0, 0], 0.6));
    const stepLength = longestDiagonal(volume) / 60;
    try { scene.draw(stepLength); } catch (e) { console.log(String((e as Error).cause)); throw e; }
    const t2 = performance.now();
    const got = scene.readPixels();
    const reference = renderReference({ grid: volume, ...volume, ...optics, stepLength }, scene.getRays()!, 64, 48);
    let worst = 0;
    let sum = 0;
    for (let i = 0; i < got.length; i++) {
      const difference = Math.abs(got[i] - reference[i] * 255);
      worst = Math.max(worst, difference);
      sum += difference ** 2;
    }
    console.log('worst', worst, 'rmse', Math.sqrt(sum / got.length), 'max', Math.max(...reference), t1 - t0, t2 - t1);
    expect(worst).to.be.below(2);
    scene.dispose();
    container.remove();
  });
});

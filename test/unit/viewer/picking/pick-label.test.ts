// What a pick says of a volume's channels: values of the file, the same as a slice writes.
import { expect } from '@esm-bundle/chai';
import { nearestSampler } from '../../../../src/panes/sample-at.ts';
import { layersAt } from '../../../../src/viewer/picking/pick-label.ts';
import type { Channel } from '../../../../src/volume/channels.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

const dimensions: Vector3 = [5, 4, 3];
const samples = Float32Array.from({ length: 60 }, (_, i) => (i * 37) % 61);
const channel = (more: Partial<Channel> = {}): Channel => ({
  number: 1,
  name: 'DNA',
  color: [0, 0, 1],
  window: [0, 60],
  samples,
  slope: 2,
  intercept: -10,
  ...more,
});
const volumeOf = (...list: Channel[]) => ({
  ...syntheticVolume({ dimensions }),
  channels: { list, infos: list, colors: new Uint8Array(240), full: 255 },
});

describe('the channels of a picked place', () => {
  it('have the value of the nearest voxel, as a slice through the place has it', () => {
    const random = randomNumbers(7);
    const other = samples.map((value) => 3 * value);
    const volume = volumeOf(channel(), channel({ number: 3, name: '', samples: other, slope: 1, intercept: 0 }));
    for (let n = 0; n < 200; n++) {
      const place = [random(), random(), random()] as const;
      const [x, y, z] = place.map((p, axis) => p * dimensions[axis] - 0.5);
      const inSlice = (of: typeof samples): number => nearestSampler({ samples: of, dimensions })(x, y, z);
      expect(layersAt(null, place, volume)).to.deep.equal({
        layers: [
          { name: 'DNA', value: 2 * inSlice(samples) - 10, unit: '', channel: 1 },
          { name: '', value: inSlice(other), unit: '', channel: 3 },
        ],
      });
    }
  });

  it('have no value where no voxel around has data, and none are there without channels', () => {
    const volume = volumeOf(channel({ samples: samples.map(() => NaN) }));
    expect(layersAt(null, [0.5, 0.5, 0.5], volume)).to.deep.equal({
      layers: [{ name: 'DNA', value: null, unit: '', channel: 1 }],
    });
    expect(layersAt(null, [0.5, 0.5, 0.5], syntheticVolume({ dimensions }))).to.deep.equal({});
  });
});

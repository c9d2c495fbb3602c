import { expect } from '@esm-bundle/chai';
import { chooseReduction } from '../../../../src/volume/reduce.ts';
import { deviceLimits } from '../../../../src/renderer/device/device.ts';
import type { Device } from '../../../../src/renderer/device/device.ts';

const desktop: Device = {
  webgl2: true,
  maxTextureSize: 16384,
  max3dTextureSize: 2048,
  floatLinear: true,
  twoByteLinear: true,
  quadPoints: true,
};
const handheld: Device = {
  webgl2: false,
  maxTextureSize: 4096,
  max3dTextureSize: 0,
  floatLinear: false,
  twoByteLinear: false,
  quadPoints: true,
};
const gibibyte = 2 ** 30;

/** As in a browser that tells how much memory the device has, in GiB, or does not. */
function withMemory<T>(gigabytes: number | undefined, use: () => T): T {
  Object.defineProperty(navigator, 'deviceMemory', { value: gigabytes, configurable: true });
  try {
    return use();
  } finally {
    Reflect.deleteProperty(navigator, 'deviceMemory');
  }
}

describe('what a volume may not exceed', () => {
  it('is what the textures hold, in 3D or as one image', () => {
    expect(deviceLimits(desktop)).to.include({ maxVoxelsPerAxis: 2048, maxAtlasSize: null });
    expect(deviceLimits(handheld)).to.include({ maxVoxelsPerAxis: 4096, maxAtlasSize: 4096 });
  });

  it('is a share of the memory, as far as a browser says', () => {
    for (const [memory, bytes] of [
      [undefined, gibibyte],
      [32, gibibyte],
      [8, gibibyte],
      [4, gibibyte / 2],
      [0.5, gibibyte / 16],
    ] as const) {
      expect(
        withMemory(memory, () => deviceLimits(desktop).maxBytes),
        `${memory} GiB`,
      ).to.equal(bytes);
    }
  });

  it('is what the GPU turned out to hold', () => {
    expect(withMemory(undefined, () => deviceLimits(desktop, 1e8).maxBytes)).to.equal(1e8);
  });

  it('lets 512 x 512 x 512 voxels of 16 bits through', () => {
    const block = {
      dimensions: [512, 512, 512] as const,
      samples: { BYTES_PER_ELEMENT: 2 } as Uint16Array<ArrayBuffer>,
      indexToWorld: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] as const,
    };
    expect(
      chooseReduction(
        block,
        withMemory(8, () => deviceLimits(desktop)),
      ),
    ).to.deep.equal([1, 1, 1]);
    // As tiles of one image they take 16,384 x 8,192 texels, or are made to fit into 4,096 x 4,096: a quarter along two axes at least.
    expect(
      chooseReduction(
        block,
        withMemory(8, () => deviceLimits({ ...handheld, maxTextureSize: 16384 })),
      ),
    ).to.deep.equal([1, 1, 1]);
    const factors = chooseReduction(
      block,
      withMemory(8, () => deviceLimits(handheld)),
    );
    expect(factors.reduce((product, f) => product * f, 1)).to.equal(8);
  });
});

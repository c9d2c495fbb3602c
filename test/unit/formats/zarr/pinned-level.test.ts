// Which level of a pyramid is read as a whole, and which ones come in bricks over it.
import { expect } from '@esm-bundle/chai';
import type { DecodedCartesianVolume, DecodeSettings } from '../../../../src/formats/base/decoded-volume.ts';
import type { DeviceLimits } from '../../../../src/volume/reduce.ts';
import { roomyLimits } from '../../../helpers/decode.ts';
import { pyramidFiles } from '../../../helpers/zarr-bytes.ts';
import type { PyramidCase } from '../../../helpers/zarr-bytes.ts';
import { readStore } from '../../../helpers/zarr-tree.ts';

/** 40 x 24 x 32 voxels of 2 bytes: 61,440, 7,680 and 960 bytes. */
const made: PyramidCase = { shape: [32, 24, 40], levels: 3, type: 'uint16' };

const read = (
  settings: DecodeSettings,
  { pyramid = made, limits = {} }: { pyramid?: PyramidCase; limits?: Partial<DeviceLimits> } = {},
): Promise<DecodedCartesianVolume> =>
  readStore(pyramidFiles(pyramid), settings, { limits: { ...roomyLimits, ...limits } });

const wanted = { finer: true, maxGpuBytes: 60_000 };

describe('a pyramid of which the GPU may not hold the finest level', () => {
  it('has a coarser level as a whole, in the numbers of its bricks, and says which finer ones there are', async () => {
    const { grid, samples, slope, intercept, levels, reduced } = await read(wanted);
    expect(grid.dimensions).to.deep.equal([20, 12, 16]);
    expect(samples).to.be.instanceOf(Uint16Array);
    expect([slope, intercept]).to.deep.equal([1, 0]);
    expect(levels!.map(({ dimensions, factors, bricks }) => ({ dimensions, factors, bricks }))).to.deep.equal([
      { dimensions: [40, 24, 32], factors: [1, 1, 1], bricks: [2, 1, 1] },
    ]);
    expect(reduced, 'nothing is left out').to.equal(undefined);
    const whole = await read({}, { limits: { maxBytes: 60_000 } });
    expect(whole.grid.dimensions).to.deep.equal(grid.dimensions);
    expect([...samples]).to.deep.equal([...whole.samples].map((n) => Math.round(whole.slope * n + whole.intercept)));
  });

  it('has two of them where the coarsest level alone is small enough', async () => {
    const { grid, levels } = await read({ ...wanted, maxGpuBytes: 8000 });
    expect(grid.dimensions).to.deep.equal([10, 6, 8]);
    expect(levels!.map(({ factors }) => factors)).to.deep.equal([
      [1, 1, 1],
      [2, 2, 2],
    ]);
  });

  it('is asked for in bricks where the device can not hold the finest level either', async () => {
    const long = { ...made, shape: [8, 8, 600] };
    const { levels, grid } = await read(
      { ...wanted, maxGpuBytes: 2 ** 28 },
      { limits: { maxVoxelsPerAxis: 576 }, pyramid: long },
    );
    expect(levels!.length).to.equal(1);
    expect(grid.dimensions[0]).to.equal(300);
  });

  it('comes in bricks by itself where the device can not hold the finest level', async () => {
    const { grid, levels, reduced } = await read({ finer: true }, { limits: { maxBytes: 40_000 } });
    expect([grid.dimensions, levels!.length, reduced]).to.deep.equal([[20, 12, 16], 1, undefined]);
  });

  it('leaves out levels whose table the device can not hold', async () => {
    const long = { ...made, shape: [1, 1, 20_000], levels: 7 };
    const bricksOf = async (maxGpuBytes: number, maxVoxelsPerAxis: number): Promise<number[]> => {
      const { levels } = await read({ ...wanted, maxGpuBytes }, { limits: { maxVoxelsPerAxis }, pyramid: long });
      return levels!.map(({ bricks }) => bricks[0]);
    };
    expect(await bricksOf(20_000, 576), 'too long').to.deep.equal([313, 157, 79, 40, 20]);
    expect(await bricksOf(4000, 576), 'more than half of the bytes').to.deep.equal([79, 40, 20]);
  });

  for (const [name, settings, more] of [
    ['it fits', { maxGpuBytes: 70_000 }, {}],
    ['nobody asks for bricks', { finer: false }, {}],
    ['the device holds it, and its author does not say what bricks may take', { maxGpuBytes: undefined }, {}],
    ['its author chooses a region', { region: [-1, -1, -1, 1, 1, 1] }, {}],
    ['its author says how large the level may be', { maxBytes: 50_000 }, {}],
    ['its author places its voxels', { spacing: [1, 1, 1] }, {}],
    ['parts of it are hidden', { clean: 'auto' }, {}],
    ['3D textures are missing', {}, { limits: { maxAtlasSize: 4096 } }],
    ['it has several channels', {}, { pyramid: { ...made, axes: 'czyx', shape: [2, 32, 24, 40] } }],
    ['it has several times', {}, { pyramid: { ...made, axes: 'tzyx', shape: [2, 32, 24, 40] } }],
    ['it has one level', {}, { pyramid: { ...made, levels: 1 } }],
  ] as const)
    it(`is read as before where ${name}`, async () => {
      const volume = await read({ ...wanted, ...(settings as DecodeSettings) }, more);
      expect(volume.levels).to.equal(undefined);
    });
});

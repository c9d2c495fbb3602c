// Channels that lie in one chunk, and windows that all times share.
import { expect } from '@esm-bundle/chai';
import type { DecodedCartesianVolume } from '../../../../src/formats/base/decoded-volume.ts';
import { finishVolume } from '../../../../src/formats/finish-volume.ts';
import { colorSliceStops, sliceStops } from '../../../../src/volume/slice-stops.ts';
import { roomyLimits } from '../../../helpers/decode.ts';
import { pyramidFiles } from '../../../helpers/zarr-bytes.ts';
import type { PyramidCase } from '../../../helpers/zarr-bytes.ts';
import { memoryTree, readStore } from '../../../helpers/zarr-tree.ts';

const valuesOfChannels = ({ channels }: DecodedCartesianVolume): readonly (readonly [number, readonly number[]])[] =>
  channels!.list.map(({ number, samples, slope, intercept }) => [
    number,
    Array.from(samples, (sample) => slope * sample + intercept),
  ]);

describe('channels of one chunk', () => {
  const shape = [5, 6, 7, 8];
  const apart: PyramidCase = { axes: 'czyx', shape, chunk: [1, 4, 4, 4] };
  const together: PyramidCase = { axes: 'czyx', shape, chunk: [3, 4, 4, 4] };
  const shards: PyramidCase = { ...together, version: 3, shard: [6, 8, 8, 8] };

  for (const [name, made] of Object.entries({ together, shards }))
    for (const channels of [undefined, '5,1,2', '4'])
      it(`are those of chunks of their own: ${name}, ${channels ?? 'all'}`, async () => {
        const expected = valuesOfChannels(await readStore(memoryTree(pyramidFiles(apart), false, { channels })));
        const read = valuesOfChannels(await readStore(memoryTree(pyramidFiles(made), false, { channels })));
        expect(read).to.deep.equal(expected);
      });

  it('come by one request', async () => {
    const tree = memoryTree(pyramidFiles(together));
    const loaded: number[] = [];
    await readStore(tree, {}, { onProgress: (done, total) => void (total > 0 && loaded.push(done / total)) });
    const chunks = tree.asked.filter((path) => /^0\/\d/.test(path));
    expect(chunks).to.have.length(2 * 2 * 2 * 2);
    expect(new Set(chunks).size).to.equal(chunks.length);
    expect(loaded.every((share, i) => share >= (loaded[i - 1] ?? 0) && share <= 1)).to.equal(true);
    expect(loaded.at(-1)).to.equal(1);
  });
});

describe('times without a window', () => {
  /** Each time is twice as bright as the one before it. */
  const brighter: PyramidCase = {
    axes: 'tzyx',
    shape: [4, 8, 8, 8],
    levels: 2,
    valueAt: ({ x, y, t }) => (10 + 100 * Math.sin(x + 2 * y) ** 2) * 2 ** t,
  };

  it('have one window, whichever is shown first', async () => {
    const windows = await Promise.all(
      [0, 1, 3].map(async (index) => (await readStore(pyramidFiles(brighter), { scan: { index } })).window),
    );
    expect(windows[0]).to.deep.equal(windows[1]);
    expect(windows[0]).to.deep.equal(windows[2]);
    const [low, high] = windows[0]!;
    expect(low).to.be.within(0, 440);
    expect(high).to.be.within(220, 880);
  });

  it('have one for each channel, and the windows of the file where it has some', async () => {
    const channels = { ...brighter, axes: 'tczyx', shape: [4, 3, 8, 8, 8] };
    const valueAt: PyramidCase['valueAt'] = (place) => brighter.valueAt!(place) + 1000 * place.c;
    const omero = { channels: [{}, { window: { start: 5, end: 77 } }, {}] };
    const files = pyramidFiles({ ...channels, valueAt, attributes: { omero } });
    const [first, last] = await Promise.all(
      [0, 3].map(async (index) =>
        (await readStore(files, { scan: { index } })).channels!.list.map(({ window }) => window),
      ),
    );
    expect(first).to.deep.equal(last);
    expect(first[1]).to.deep.equal([5, 77]);
    expect(first[2][0]).to.be.within(2000, 2880);
  });

  it('of a large level are looked at in one chunk in its middle', async () => {
    const large: PyramidCase = { axes: 'tzyx', shape: [2, 72, 72, 72], chunk: [1, 24, 24, 24], type: 'uint8' };
    const valueAt: PyramidCase['valueAt'] = ({ x, t }) => (x % 32) * (t + 1);
    const tree = memoryTree(pyramidFiles({ ...large, valueAt }));
    await readStore(tree, { scan: { index: 0 } });
    const asked = tree.asked.filter((path) => path.startsWith('0/1/'));
    expect(asked).to.deep.equal(['0/1/1/1/1']);
  });

  it('of which one is opened alone has the window of its values', async () => {
    const { window } = await readStore(pyramidFiles(brighter));
    expect(window).to.equal(undefined);
  });
});

describe('channels of one slice', () => {
  const spots: PyramidCase = {
    axes: 'cyx',
    shape: [2, 60, 50],
    levels: 1,
    // A dim background, and spots that are a hundredth of the picture, in each channel elsewhere.
    valueAt: ({ x, y, c }) => 100 + ((x * 7 + y * 3) % 11) + (x % 10 === 2 * c && y % 10 === 3 ? 3000 : 0),
  };

  it('are a picture: opaque, its colours added on black', async () => {
    const omero = { channels: [{ color: 'FF0000' }, { color: '00FF00' }] };
    const volume = await finishVolume(await readStore(pyramidFiles({ ...spots, attributes: { omero } })), roomyLimits);
    expect(volume).to.deep.include({ transferFunction: colorSliceStops, window: [0, 2] });
    const { colors, full, list } = volume.channels!;
    expect(full).to.equal(255);
    for (const { window } of list) {
      expect(window[0]).to.be.within(100, 102);
      expect(window[1]).to.be.within(3100, 3110);
    }
    const at = (x: number, y: number): number[] => [...colors.subarray(4 * (50 * y + x), 4 * (50 * y + x) + 4)];
    expect(at(0, 3)[0]).to.be.greaterThan(250);
    expect(at(2, 3)[1]).to.be.greaterThan(250);
    expect(Math.max(...at(1, 1).slice(0, 3))).to.be.lessThan(3);
    expect(at(1, 1)[3]).to.equal(255);
  });

  it('have one window at all times', async () => {
    const valueAt: PyramidCase['valueAt'] = (place) => spots.valueAt!(place) * 2 ** place.t;
    const files = pyramidFiles({ ...spots, axes: 'tcyx', shape: [3, 2, 60, 50], chunk: [1, 2, 60, 50], valueAt });
    const [first, last] = await Promise.all(
      [0, 2].map(async (index) =>
        (await readStore(files, { scan: { index } })).channels!.list.map(({ window }) => window),
      ),
    );
    expect(first).to.deep.equal(last);
    expect(first[0][1]).to.be.within(6000, 6300);
  });

  it('that are empty have no light, also in a volume', async () => {
    for (const [axes, shape] of [
      ['cyx', [2, 60, 50]],
      ['czyx', [2, 4, 60, 50]],
    ] as const) {
      const valueAt: PyramidCase['valueAt'] = ({ x, c }) => (c === 0 ? x : 0);
      const { channels } = await readStore(pyramidFiles({ axes, shape, valueAt }));
      const [{ color }, empty] = channels!.list;
      expect(empty.window[0]).to.equal(0);
      const brightest = 4 * 49;
      const light = Array.from(channels!.colors.subarray(brightest, brightest + 3), (one) => one / channels!.full);
      for (const [c, one] of light.entries()) expect(one).to.be.closeTo(color[c], 0.01);
    }
  });

  it('of 8 bits are grays of a screen, alone and at all times', async () => {
    const gray: PyramidCase = { ...spots, axes: 'tyx', shape: [3, 60, 50], type: 'uint8' };
    const valueAt: PyramidCase['valueAt'] = ({ x, y, t }) => ((x * 7 + y * 13) % 71) * (t + 1);
    const files = pyramidFiles({ ...gray, valueAt });
    for (const index of [0, 2]) {
      const volume = await finishVolume(await readStore(files, { scan: { index } }), roomyLimits);
      expect(volume).to.deep.include({ transferFunction: sliceStops, window: [0, 255] });
    }
  });
});

describe('a coarse level of one slice', () => {
  it('is no picture that stands for a volume', async () => {
    const thin: PyramidCase = { axes: 'zyx', shape: [2, 16, 16], levels: 2 };
    const tree = memoryTree(pyramidFiles(thin));
    const volume = await readStore(tree);
    expect(volume.grid.dimensions).to.deep.equal([16, 16, 2]);
    expect(tree.parts).to.have.length(0);
    const flat = memoryTree(pyramidFiles({ ...thin, shape: [1, 16, 16] }));
    expect((await readStore(flat)).grid.dimensions).to.deep.equal([16, 16, 1]);
    expect(flat.parts).to.have.length(1);
  });
});

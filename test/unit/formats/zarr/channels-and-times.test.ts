// Channels that lie in one chunk, and windows that all times share.
import { expect } from '@esm-bundle/chai';
import type { DecodedCartesianVolume } from '../../../../src/formats/base/decoded-volume.ts';
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

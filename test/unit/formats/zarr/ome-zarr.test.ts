import { expect } from '@esm-bundle/chai';
import { corners } from '../../../../src/volume/grid.ts';
import { transformPoint } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { finishVolume } from '../../../../src/formats/finish-volume.ts';
import { expectError, roomyLimits, valuesOf } from '../../../helpers/decode.ts';
import { jsonBytes, pyramidFiles, writeArray } from '../../../helpers/zarr-bytes.ts';
import type { PyramidCase } from '../../../helpers/zarr-bytes.ts';
import { memoryTree, readStore } from '../../../helpers/zarr-tree.ts';

const cube: PyramidCase = { shape: [16, 12, 20], levels: 3 };

/** Limits of a device that holds so many bytes. */
const bytes = (maxBytes: number): { limits: typeof roomyLimits } => ({ limits: { ...roomyLimits, maxBytes } });

/** The value of each voxel is that of its place. The world of a file without directions has x and y reversed. */
async function expectPlane(
  { channel, ...pyramid }: PyramidCase & { readonly channel?: string },
  ...options: Parameters<typeof readStore> extends [unknown, ...infer R] ? R : never
): Promise<Vector3> {
  const volume = await readStore(memoryTree(pyramidFiles(pyramid), false, { channel }), ...options);
  const { dimensions, indexToWorld } = volume.grid;
  const [nx, ny, nz] = dimensions;
  for (let k = 0; k < nz; k++)
    for (let j = 0; j < ny; j++)
      for (let i = 0; i < nx; i++) {
        const [x, y, z] = transformPoint(indexToWorld, [i, j, k]);
        const value = volume.slope * volume.samples[(k * ny + j) * nx + i] + volume.intercept;
        expect(value).to.be.closeTo(1000 - 8e3 * x - 64e3 * y + 512e3 * z, 0.5, `${i} ${j} ${k}`);
      }
  return dimensions;
}

describe('an OME-Zarr', () => {
  for (const version of [2, 3] as const) {
    it(`of Zarr ${version} has its values where its transforms say`, async () => {
      const placed = { ...cube, version, scale: [2, 0.5, 1], translation: [10, -4, 6] };
      expect(await expectPlane({ ...placed, type: 'float32' })).to.deep.equal([20, 12, 16]);
      const volume = await readStore(pyramidFiles(placed));
      expect(volume.format).to.equal(version === 2 ? 'OME-Zarr 0.4' : 'OME-Zarr 0.5');
      expect(volume.reduced).to.equal(undefined);
    });

    for (const [limit, dimensions] of [
      [8000, [20, 12, 16]],
      [7679, [10, 6, 8]],
      [900, [5, 3, 4]],
    ] as const)
      it(`of Zarr ${version}: a device of ${limit} bytes gets ${dimensions.join(' x ')} voxels, at the same place`, async () => {
        // Values of a plane are the same at the same place in all levels.
        expect(await expectPlane({ ...cube, version }, {}, bytes(limit))).to.deep.equal(dimensions);
        const volume = await finishVolume(
          await readStore(pyramidFiles({ ...cube, version }), {}, bytes(limit)),
          roomyLimits,
        );
        expect(volume.reduced).to.deep.equal(limit === 8000 ? undefined : { from: [20, 12, 16], to: dimensions });
      });
  }

  it('of which less is wanted, as max-bytes says, has the finest level of that size, of the region too', async () => {
    const all = await readStore(pyramidFiles(cube), { maxBytes: 7679 });
    expect([all.grid.dimensions, all.reduced]).to.deep.equal([[10, 6, 8], { from: [20, 12, 16], to: [10, 6, 8] }]);
    const region = [-9, -9, 0, -2, -2, 7].map((one) => one / 1000);
    const part = await readStore(pyramidFiles(cube), { maxBytes: 7679, region });
    expect([part.reduced, part.grid.spacing]).to.deep.equal([undefined, [0.001, 0.001, 0.001]]);
    const channels = await readStore(pyramidFiles({ ...cube, axes: 'czyx', shape: [2, 16, 12, 20] }), {
      maxBytes: 5 * 20 * 12 * 16 - 1,
    });
    expect(channels.grid.dimensions).to.deep.equal([10, 6, 8]);
  });

  it('has all levels between the same outer faces', async () => {
    const faces = await Promise.all(
      [1e6, 7000, 900].map(async (limit) => corners((await readStore(pyramidFiles(cube), {}, bytes(limit))).grid)),
    );
    for (const one of faces)
      for (const [i, corner] of one.entries())
        for (const [axis, place] of corner.entries()) expect(place).to.be.closeTo(faces[0][i][axis], 1e-12);
  });

  it('too large for the device even in its coarsest level is made smaller', async () => {
    const volume = await finishVolume(await readStore(pyramidFiles(cube), {}, bytes(50)), {
      ...roomyLimits,
      maxBytes: 50,
    });
    expect(volume.reduced!.from).to.deep.equal([20, 12, 16]);
    expect(volume.samples.byteLength).to.be.at.most(50);
  });

  it('shows its coarsest level first, at the place of the whole', async () => {
    const tree = memoryTree(pyramidFiles(cube));
    const volume = await readStore(tree);
    expect(tree.parts).to.have.length(1);
    expect(tree.parts[0].grid.dimensions).to.deep.equal([5, 3, 4]);
    expect(tree.grids[0]).to.deep.equal(volume.grid);
    expect(tree.asked.findIndex((path) => path.startsWith('2/0'))).to.be.below(
      tree.asked.findIndex((path) => path.startsWith('0/0')),
    );
  });

  it('asks for eight chunks at a time at most, the middle first', async () => {
    const tree = memoryTree(pyramidFiles({ shape: [24, 24, 24] }), true);
    await readStore(tree);
    expect(tree.most).to.equal(8);
    const chunks = tree.asked.filter((path) => /^0\/\d/.test(path)).map((path) => path.split('/').slice(1).map(Number));
    expect(chunks).to.have.length(216);
    const away = chunks.map((place) => Math.max(...place.map((n) => Math.abs(n - 2.5))));
    expect(Math.max(...away.slice(0, 8))).to.equal(0.5);
    expect(away.at(-1)).to.equal(2.5);
  });

  it('stops with its signal, and nothing is asked for afterwards', async () => {
    const stop = new AbortController();
    const tree = memoryTree(pyramidFiles({ shape: [24, 24, 24] }), true);
    const coming = readStore(
      tree,
      {},
      {
        signal: stop.signal,
        onProgress: (loaded) => {
          if (loaded > 0) stop.abort(new DOMException('over', 'AbortError'));
        },
      },
    );
    const failure: unknown = await coming.catch((cause: unknown) => cause);
    expect((failure as Error).name).to.equal('AbortError');
    const { length } = tree.asked;
    await new Promise((resolve) => setTimeout(resolve, 20));
    expect(tree.asked.length).to.equal(length);
    expect(length).to.be.below(30);
  });

  for (const axes of ['zyx', 'xyz', 'yzx', 'czyx', 'tczyx', 'xtyzc']) {
    it(`with the axes ${axes} is laid out as with others`, async () => {
      const lengths = { x: 7, y: 5, z: 3, t: 2, c: 3 };
      const shape = Array.from(axes, (name) => lengths[name as 'x']);
      expect(await expectPlane({ shape, axes, chunk: shape.map((n) => Math.min(n, 2)), channel: '1' })).to.deep.equal([
        7, 5, 3,
      ]);
    });
  }

  it('in two dimensions is one slice, as thick as its pixels are wide', async () => {
    const volume = await readStore(pyramidFiles({ shape: [6, 8], axes: 'yx', scale: [0.5, 0.25] }));
    expect(volume.grid.dimensions).to.deep.equal([8, 6, 1]);
    expect(volume.grid.spacing).to.deep.equal([0.00025, 0.0005, 0.00025]);
  });

  it('in shards is read by parts of them', async () => {
    const tree = memoryTree(pyramidFiles({ version: 3, shape: [10, 9, 11], chunk: [2, 3, 4], shard: [4, 6, 8] }));
    const volume = await readStore(tree);
    const plain = await readStore(pyramidFiles({ version: 3, shape: [10, 9, 11], chunk: [2, 3, 4] }));
    expect(volume.samples).to.deep.equal(plain.samples);
    // Each of 3 x 2 x 2 shards once for its index.
    expect(new Set(tree.asked.filter((path) => path.startsWith('0/c/')))).to.have.length(12);
  });

  it('may have numbers that JSON has not, as zarr-python 3.1.6 writes attributes and zarr-python 2 fill values', async () => {
    const files = pyramidFiles({ ...cube, levels: 1, isMissing: () => true });
    const write = (path: string, change: (text: string) => string): unknown =>
      files.set(path, new TextEncoder().encode(change(new TextDecoder().decode(files.get(path)))));
    write('.zattrs', (text) => `{"a": NaN, "b": [Infinity,\n -Infinity, NaN], ${text.slice(1)}`);
    write('0/.zarray', (text) => text.replace('<u2', '<f4').replace('"fill_value":0', '"fill_value": NaN'));
    const { samples } = await readStore(files);
    expect([samples.length, samples.every(Number.isNaN)]).to.deep.equal([16 * 12 * 20, true]);
  });

  it('without some chunks has the fill value there', async () => {
    const volume = await readStore(pyramidFiles({ shape: [4, 4, 8], isMissing: ([, , x]) => x === 1 }));
    const values = Array.from(volume.samples, (one) => volume.slope * one + volume.intercept);
    for (const [i, value] of values.entries()) expect(value > 0, String(i)).to.equal(i % 8 < 4);
  });

  it('counts micrometres as thousandths of the mm of the world, and other units by their own', async () => {
    for (const [unit, mm] of [
      ['micrometer', 1e-3],
      ['nanometer', 1e-6],
      ['millimeter', 1],
      ['micrometre', 1e-3],
    ] as const) {
      const { grid } = await readStore(pyramidFiles({ ...cube, unit, scale: [3, 2, 1] }));
      const { spacing } = grid;
      expect(spacing.map((one) => Number((one / mm).toPrecision(12)))).to.deep.equal([1, 2, 3]);
    }
    const without = await readStore(pyramidFiles({ ...cube, unit: null }));
    expect(without.format).to.equal('Zarr (OME 0.4)');
    expect(without.grid.spacing).to.deep.equal([1, 1, 1]);
  });

  it('applies the transforms of the whole after those of a level', async () => {
    const multiscale = {
      coordinateTransformations: [
        { type: 'scale', scale: [1, 10, 100] },
        { type: 'translation', translation: [0, 1, 2] },
      ],
    };
    const { grid } = await readStore(
      pyramidFiles({ ...cube, unit: 'millimeter', scale: [2, 3, 4], translation: [5, 6, 7], levels: 1, multiscale }),
    );
    expect(transformPoint(grid.indexToWorld, [0, 0, 0])).to.deep.equal([-702, -61, 5]);
    expect(grid.spacing).to.deep.equal([400, 30, 2]);
  });

  it('with the directions of a patient lies as they say', async () => {
    const axes = [
      {
        name: 'z',
        type: 'space',
        unit: 'millimeter',
        orientation: { type: 'anatomical', value: 'superior-to-inferior' },
      },
      {
        name: 'y',
        type: 'space',
        unit: 'millimeter',
        orientation: { type: 'anatomical', value: 'posterior-to-anterior' },
      },
      { name: 'x', type: 'space', unit: 'millimeter', orientation: { type: 'anatomical', value: 'right-to-left' } },
    ];
    const volume = await readStore(pyramidFiles({ ...cube, levels: 1, scale: [3, 2, 1], multiscale: { axes } }));
    expect(volume.anatomical).to.equal(true);
    expect(transformPoint(volume.grid.indexToWorld, [1, 1, 1])).to.deep.equal([-1, 2, -3]);
    expect((await readStore(pyramidFiles(cube))).anatomical).to.equal(undefined);
  });

  describe('of several channels', () => {
    const omero = {
      channels: [
        { label: 'DAPI\n', color: '0000FF', active: true, window: { start: 5, end: 50, min: 0, max: 99 } },
        { label: 'off', color: 'FF0000', active: false, window: { start: 0, end: 1 } },
        { color: '00FF80', window: { start: 20_000, end: 40_000, min: 0, max: 65_535 } },
      ],
    };
    const shape = [3, 4, 4, 4];
    const valueAt = ({ x, c }: { x: number; c: number }): number => [10 * (x + 1), 0, 20_000 + 5000 * x][c];
    const files = pyramidFiles({ axes: 'czyx', shape, valueAt, attributes: { omero } });

    it('shows those that the file has switched on, each in its colour and window', async () => {
      const volume = await readStore(files);
      expect(volume.channels!.list.map((one) => ({ ...one, samples: 0 }))).to.deep.equal([
        { number: 1, name: 'DAPI', color: [0, 0, 1], window: [5, 50], slope: 1, intercept: 0, samples: 0 },
        { number: 3, name: '', color: [0, 1, 128 / 255], window: [20_000, 40_000], slope: 1, intercept: 0, samples: 0 },
      ]);
      for (let x = 0; x < 4; x++) {
        const [first, second] = [(10 * (x + 1) - 5) / 45, x / 4];
        expect(volume.channels!.list[1].samples[x], 'the values of the file').to.equal(20_000 + 5000 * x);
        const expected = [0, second, (128 / 255) * second + first, first + second];
        const light = Array.from(volume.channels!.colors.subarray(4 * x, 4 * x + 4), (one) => volume.slope * one);
        for (const [c, one] of expected.entries()) expect(light[c]).to.be.closeTo(one, volume.slope / 2 + 1e-9);
        expect(volume.samples[x]).to.equal(volume.channels!.colors[4 * x + 3]);
      }
      expect(volume.window).to.deep.equal([0, 2]);
      expect(volume.left).to.deep.equal([
        '1 of 3 channels: "#channels=1,2" after the address shows the first and the second',
      ]);
    });

    it('shows those of the address, or one as values with its window', async () => {
      const chosen = await readStore(memoryTree(files, false, { channels: '3, 2' }));
      expect(chosen.channels!.list.map(({ number }) => number)).to.deep.equal([3, 2]);
      const one = await readStore(memoryTree(files, false, { channel: '3' }));
      expect([one.channels, one.window]).to.deep.equal([undefined, [20_000, 40_000]]);
      expect(one.samples[1]).to.equal(25_000);
      expect(one.left!.join()).to.contain('2 of 3 channels').and.contain('#channel=2');
      for (const [choice, message] of [
        [{ channel: '4' }, 'src got "#channel=4"; expected the number of a channel, from 1 to 3.'],
        [
          { channels: '1,<b>' },
          'src got "#channels=1,<b>"; expected numbers of channels with commas, from 1 to 3, 8 at most.',
        ],
      ] as const) {
        const error = await expectError(readStore(memoryTree(files, false, choice)));
        expect([error.code, error.message]).to.deep.equal(['attribute/invalid', message]);
      }
    });

    it('without words of how they look has windows from its values, as bright in the coarse level', async () => {
      const tree = memoryTree(pyramidFiles({ axes: 'czyx', shape: [2, 16, 16, 16], levels: 2 }));
      const volume = await readStore(tree);
      const windows = volume.channels!.list.map(({ window }) => window);
      expect(tree.parts[0].channels!.list.map(({ window }) => window)).to.deep.equal(windows);
      for (const [c, [low, high]] of windows.entries()) {
        expect(low).to.be.within(1000 + 10_000 * c, 10_000 + 10_000 * c);
        expect(high).to.be.within(low, 10_700 + 10_000 * c);
      }
      expect(new Set(volume.channels!.list.map(({ color }) => String(color))).size).to.equal(2);
    });

    it('takes a coarser level where the device has no room for all of them, and less of the coarsest', async () => {
      const deep = pyramidFiles({ axes: 'czyx', shape: [2, 16, 16, 16], levels: 2 });
      for (const [limit, n] of [
        [5 * 16 ** 3, 16],
        [5 * 16 ** 3 - 1, 8],
        [5 * 4 ** 3, 4],
      ]) {
        const volume = await finishVolume(await readStore(deep, {}, bytes(limit)), roomyLimits);
        expect(volume.grid.dimensions).to.deep.equal([n, n, n]);
        expect(volume.channels!.colors.length).to.equal(4 * n ** 3);
        expect(volume.channels!.list.map(({ samples: { length } }) => length)).to.deep.equal([n ** 3, n ** 3]);
        expect(volume.reduced?.to).to.deep.equal(n === 16 ? undefined : [n, n, n]);
      }
    });

    it('that are more than eight shows eight, and thousands cost no more', async () => {
      const many = Array.from({ length: 3000 }, () => ({ active: true, color: 'ff0000' }));
      const tree = memoryTree(
        pyramidFiles({
          axes: 'czyx',
          shape: [3000, 1, 2, 2],
          type: 'uint8',
          attributes: { omero: { channels: many } },
        }),
      );
      const volume = await readStore(tree);
      expect(volume.channels!.list.map(({ number }) => number)).to.deep.equal([1, 2, 3, 4, 5, 6, 7, 8]);
      expect(volume.left!.join()).to.contain('2992 of 3000 channels');
      expect(tree.asked.length).to.be.below(20);
    });

    for (const [name, odd] of Object.entries({
      'of a text': 'javascript:alert(1)',
      'that are no list': { channels: 7 },
      'of odd types': { channels: [null, { color: 5, label: {}, window: { start: 'a', end: NaN }, active: 'no' }] },
      'of a window that ends first': { channels: [{ window: { start: 9, end: 1 } }, { window: [1, 2] }] },
      'of a colour that is none': { channels: [{ color: 'javascript:' }, { color: 'red;background:url(//x)' }] },
      'of endless numbers': { channels: [{ window: { start: -1e308, end: 1e308 } }, { color: '000000' }] },
    }))
      it(`is shown with usual colours and windows where the file has words ${name}`, async () => {
        const made = pyramidFiles({ axes: 'czyx', shape: [2, 4, 4, 4], attributes: { omero: odd } });
        const volume = await finishVolume(await readStore(made), roomyLimits);
        expect(volume.channels!.list.map(({ name: label }) => label)).to.deep.equal(['', '']);
        for (const { color, window } of volume.channels!.list) {
          expect(color.every((part) => part >= 0 && part <= 1) && Math.max(...color) > 0).to.equal(true);
          expect(window[1]).to.be.above(window[0]);
        }
        expect(volume.range[1]).to.be.above(0.5);
      });

    it('has names of 60 characters at most, in one line', async () => {
      const channels = [{ label: `<img src=x onerror=alert(1)>\u2028${'x'.repeat(1e5)}` }, {}];
      const volume = await readStore(
        pyramidFiles({ axes: 'czyx', shape: [2, 4, 4, 4], attributes: { omero: { channels } } }),
      );
      const [{ name }] = volume.channels!.list;
      expect(name).to.have.length(60);
      expect(name).to.match(/^<img src=x onerror=alert\(1\)> x+$/);
    });
  });

  it('of several times becomes scans, with the times of its unit', async () => {
    const files = pyramidFiles({
      axes: 'tzyx',
      shape: [3, 4, 4, 4],
      timeUnit: 'millisecond',
      scale: [250, 1, 1, 1],
      translation: [500, 0, 0, 0],
    });
    let times: readonly unknown[] = [];
    const load = { onScans: (known: readonly unknown[]) => void (times = known) };
    const third = await readStore(files, { scan: { index: 2 } }, load);
    expect(times).to.deep.equal(['0.5 s', '0.75 s', '1 s']);
    expect(third.format).to.equal('OME-Zarr 0.4, volume 3 of 3');
    expect(third.left).to.equal(undefined);
    const at = await readStore(files, { scan: { time: '0.8 s' } }, load);
    expect(at.format).to.contain('volume 2 of 3');
    const first = await readStore(files);
    expect(first.left).to.deep.equal(['volumes 2 to 3 of the file']);
    const value = ({ samples, slope, intercept }: typeof first): number => slope * samples[0] + intercept;
    expect(value(third) - value(first)).to.equal(200);
  });

  it('reads of a region only the chunks of it, of the finest level that fits', async () => {
    const files = pyramidFiles({ shape: [32, 32, 32], levels: 3, unit: 'millimeter', type: 'float32' });
    const tree = memoryTree(files);
    // x from 8 to 15 of the file, which are -15 to -8 in the world.
    const region = [-15, -15, 8, -8, -8, 15];
    const volume = await readStore(tree, { region }, bytes(4 * 11 ** 3));
    expect(volume.grid.dimensions).to.deep.equal([8, 8, 8]);
    expect(transformPoint(volume.grid.indexToWorld, [0, 0, 0])).to.deep.equal([-8, -8, 8]);
    expect(volume.samples[0]).to.equal(1000 + 8 * 8 + 64 * 8 + 512 * 8);
    expect(tree.asked.filter((path) => /^0\/\d/.test(path))).to.have.length(8);
    expect(volume.reduced).to.equal(undefined);
    const all = await readStore(files, {}, bytes(4 * 11 ** 3));
    expect(all.grid.dimensions).to.deep.equal([8, 8, 8]);
    expect(all.reduced).to.deep.equal({ from: [32, 32, 32], to: [8, 8, 8] });
  });

  it('of labels has their colours and names, and is not averaged', async () => {
    const label = {
      version: '0.4',
      colors: [
        { 'label-value': 1, rgba: [255, 0, 51, 255] },
        { 'label-value': 4, rgba: [0, 255, 0, 255] },
      ],
      properties: [
        { 'label-value': 4, name: 'nucleus\n4' },
        { 'label-value': 7, class: 'wall' },
      ],
    };
    const files = pyramidFiles({
      shape: [4, 4, 4],
      attributes: { 'image-label': label },
      valueAt: ({ x }) => (x > 1 ? 4 : 1),
    });
    const volume = await finishVolume(await readStore(files), roomyLimits);
    expect(volume.isDiscrete).to.equal(true);
    expect(volume.named).to.deep.equal([
      { id: 1, name: '', color: [1, 0, 0.2] },
      { id: 4, name: 'nucleus 4', color: [0, 1, 0] },
      { id: 7, name: 'wall', color: null },
    ]);
    expect(
      valuesOf(volume)
        .slice(0, 4)
        .map((one) => volume.ids?.[one] ?? one),
    ).to.deep.equal([1, 1, 4, 4]);
  });

  it('of Bio-Formats is its first image, or the one of series', async () => {
    const files = new Map([
      ['.zattrs', jsonBytes({ 'bioformats2raw.layout': 3 })],
      ['.zgroup', jsonBytes({ zarr_format: 2 })],
    ]);
    for (const [number, length] of [
      [0, 4],
      [1, 6],
    ] as const)
      for (const [path, content] of pyramidFiles({ shape: [length, 4, 4] })) files.set(`${number}/${path}`, content);
    expect((await readStore(files)).grid.dimensions).to.deep.equal([4, 4, 4]);
    expect((await readStore(files, { series: 2 })).grid.dimensions).to.deep.equal([4, 4, 6]);
    const error = await expectError(readStore(files, { series: 3 }));
    expect(error.message).to.contain('no image 3');
  });

  it('of old versions, without axes and places, is read as t, c, z, y, x', async () => {
    const files = pyramidFiles({ axes: 'tczyx', shape: [1, 1, 4, 6, 8], levels: 2 });
    files.set('.zattrs', jsonBytes({ multiscales: [{ version: '0.2', datasets: [{ path: '0' }, { path: '1' }] }] }));
    const tree = memoryTree(files);
    const volume = await readStore(tree);
    expect(volume.grid.dimensions).to.deep.equal([8, 6, 4]);
    const [part] = tree.parts;
    const [fine, coarse] = [volume, part].map(({ grid }) => corners(grid));
    expect(coarse).to.deep.equal(fine);
  });
});

describe('an array that no image lists', () => {
  it('is a volume of its last three axes', async () => {
    const files = new Map<string, Uint8Array<ArrayBuffer>>();
    writeArray(files, '', {
      shape: [3, 4, 5],
      chunk: [2, 3, 2],
      version: 3,
      valueAt: ([z, y, x]) => 100 * z + 10 * y + x,
    });
    const volume = await readStore(files);
    expect(volume.format).to.equal('Zarr');
    expect(Array.from(volume.samples).slice(0, 7)).to.deep.equal([0, 1, 2, 3, 4, 10, 11]);
  });
});

describe('a store that lies, or lacks something, is refused in words:', () => {
  /** Metadata of level 1 of a pyramid of Zarr 2 that say something else. */
  const withArray = (metadata: Readonly<Record<string, unknown>>, level = 1): Map<string, Uint8Array<ArrayBuffer>> => {
    const files = pyramidFiles(cube);
    const path = `${level}/.zarray`;
    const own = JSON.parse(new TextDecoder().decode(files.get(path))) as object;
    return files.set(path, jsonBytes({ ...own, ...metadata }));
  };
  const ome = (attributes: unknown): Map<string, Uint8Array<ArrayBuffer>> =>
    pyramidFiles(cube).set('.zattrs', jsonBytes(attributes));
  const cases: Readonly<Record<string, readonly [Map<string, Uint8Array<ArrayBuffer>>, string, RegExp]>> = {
    'a level of another size': [
      withArray({ shape: [16, 12, 20] }),
      'format/corrupt',
      /level 1 .* lies from .* its shape or its scale is wrong/,
    ],
    'a shape of 0': [withArray({ shape: [0, 6, 10] }), 'format/corrupt', /level 1 .* shape 0 x 6 x 10/],
    'more axes in a level': [
      withArray({ shape: [1, 8, 6, 10], chunks: [1, 4, 4, 4] }),
      'format/corrupt',
      /level 1 .* 4 axes/,
    ],
    'chunks of other axes': [withArray({ chunks: [4, 4] }), 'format/corrupt', /level 1 .* chunks of 2 axes/],
    'chunks of 0': [withArray({ chunks: [4, 0, 4] }, 0), 'format/corrupt', /chunks 4 x 0 x 4/],
    'huge chunks': [withArray({ chunks: [4000, 4000, 4000] }, 0), 'format/unsupported', /at most 256 MiB each/],
    'chunks of other lengths than they say': [
      withArray({ chunks: [4, 4, 2] }, 0),
      'format/corrupt',
      /a chunk of the Zarr has 128 bytes where 64 belong/,
    ],
    'another type in a level': [withArray({ dtype: '<f4' }), 'format/corrupt', /level 1 .* float32; expected uint16/],
    'an unknown type': [withArray({ dtype: '<U8' }, 0), 'format/unsupported', /type "<U8"/],
    'an unknown packing': [
      withArray({ compressor: { id: 'zfpy' } }, 0),
      'format/unsupported',
      /"zfpy"; expected blosc, zstd/,
    ],
    filters: [withArray({ filters: [{ id: 'delta' }] }, 0), 'format/unsupported', /filters/],
    'no array of a level': [
      ome({ multiscales: [{ datasets: [{ path: '7' }] }] }),
      'format/corrupt',
      /level 0 .* is not there/,
    ],
    'a path out of the folder': [
      ome({ multiscales: [{ datasets: [{ path: '../7' }] }] }),
      'format/corrupt',
      /without a path below/,
    ],
    'no levels': [ome({ multiscales: [{ datasets: [] }] }), 'format/corrupt', /lists 0 levels/],
    'a plate': [ome({ plate: {} }), 'format/unsupported', /plate or a well.*plate\.zarr/],
    'a list of labels': [ome({ labels: ['cells'] }), 'format/unsupported', /image\.zarr\/labels\/cells/],
    'no JSON': [
      pyramidFiles(cube).set('.zattrs', new TextEncoder().encode('{"a": nan}')),
      'format/corrupt',
      /\(\.zattrs\) are no JSON$/,
    ],
    'no Zarr': [new Map(), 'format/unsupported', /is no Zarr: it has neither zarr\.json nor \.zgroup/],
    'a transform of another kind': [
      ome({
        multiscales: [
          { axes: ['z', 'y', 'x'], datasets: [{ path: '0', coordinateTransformations: [{ type: 'affine' }] }] },
        ],
      }),
      'format/unsupported',
      /"affine"/,
    ],
    'a scale of 0': [
      ome({
        multiscales: [
          {
            axes: ['z', 'y', 'x'],
            datasets: [{ path: '0', coordinateTransformations: [{ type: 'scale', scale: [1, 0, 1] }] }],
          },
        ],
      }),
      'format/corrupt',
      /scale 0/,
    ],
  };
  for (const [name, [files, code, words]] of Object.entries(cases))
    it(name, async () => {
      const error = await expectError(readStore(files));
      expect(error.message).to.match(words);
      expect(error.code).to.equal(code);
    });

  it('a volume of 2^60 voxels in no chunk', async () => {
    const files = new Map<string, Uint8Array<ArrayBuffer>>();
    const shape = [2 ** 20, 2 ** 20, 2 ** 20];
    writeArray(files, '', {
      shape: [1, 1, 1],
      chunk: [1, 1, 1],
      valueAt: () => 0,
      metadata: { shape, chunks: [256, 256, 256] },
    });
    const error = await expectError(readStore(files));
    expect([error.code, error.message]).to.have.property('0', 'format/too-large');
    expect(error.message).to.contain('too many chunks');
  });

  it('damaged shards', async () => {
    for (const [damage, words] of [
      [(shard: Uint8Array) => void (shard[shard.length - 6] ^= 1), /wrong checksum/],
      [(shard: Uint8Array) => shard.fill(0, 0, 1), null],
    ] as const) {
      const files = pyramidFiles({ version: 3, shape: [4, 4, 4], chunk: [2, 2, 2], shard: [4, 4, 4] });
      damage(files.get('0/c/0/0/0')!);
      const coming = readStore(files);
      if (words) expect((await expectError(coming)).message).to.match(words);
      else await coming;
    }
    const files = pyramidFiles({ version: 3, shape: [4, 4, 4], chunk: [2, 2, 2], shard: [4, 4, 4] });
    files.set('0/c/0/0/0', files.get('0/c/0/0/0')!.slice(0, 20));
    expect((await expectError(readStore(files))).message).to.contain('where its index of 132 belongs');
  });
});

// An OME-Zarr on servers, in archives and in folders, as the worker opens them.
import { expect } from '@esm-bundle/chai';
import { crc32 } from '../../../src/formats/codecs/crc32.ts';
import { isZarr } from '../../../src/sources/is-zarr.ts';
import { decodeRequest } from '../../../src/worker/decode-request.ts';
import type { RequestEnvironment } from '../../../src/worker/decode-request.ts';
import type { LoadRequest } from '../../../src/formats/base/load-request.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { expectError, roomyLimits } from '../../helpers/decode.ts';
import { zipBytes } from '../../helpers/zip-bytes.ts';
import { pyramidFiles } from '../../helpers/zarr-bytes.ts';
import type { ZarrFiles } from '../../helpers/zarr-bytes.ts';
import { readStore } from '../../helpers/zarr-tree.ts';
import { startZarr } from '../../helpers/zarr-server.ts';
import type { ZarrFaults, ZarrServer } from '../../helpers/zarr-server.ts';

// Node 20 has none.
if (!('navigator' in globalThis)) Object.assign(globalThis, { navigator: { onLine: true } });

const load = (
  request: Partial<LoadRequest> & { url: string },
  environment: Partial<RequestEnvironment> = {},
): Promise<Volume> =>
  decodeRequest(
    { limits: roomyLimits, ...request },
    { pageOrigin: 'https://page.example', onProgress: () => undefined, ...environment },
  );

async function withServer<T>(
  files: ZarrFiles,
  faults: ZarrFaults,
  run: (server: ZarrServer) => Promise<T>,
  name?: string,
): Promise<T> {
  const server = await startZarr(files, faults, name);
  try {
    return await run(server);
  } finally {
    await server.close();
  }
}

const pyramid = { shape: [12, 10, 14], levels: 2 } as const;
const sharded = { ...pyramid, version: 3, chunk: [3, 5, 7], shard: [6, 10, 14] } as const;
const expected = (await readStore(pyramidFiles(pyramid))).samples;
const zipOf = (files: ZarrFiles, folder = ''): Uint8Array<ArrayBuffer> =>
  zipBytes([...files].map(([path, packed]) => ({ path: folder + path, packed, crc: crc32(packed) })));

describe('an OME-Zarr on a server', () => {
  it('is known by its address', () => {
    for (const [address, is] of [
      ['https://a.b/x.ome.zarr', true],
      ['https://a.b/x.zarr/', true],
      ['https://a.b/x.zarr/labels/cells', true],
      ['https://a.b/x.zarr?sig=1', true],
      ['https://a.b/x.ozx', true],
      ['https://a.b/x.zarr#channel=2', true],
      ['https://a.b/x.nii', false],
      ['https://a.b/x.zarr.json', false],
      ['https://a.b/zarr', false],
    ] as const)
      expect(isZarr(address), address).to.equal(is);
  });

  for (const [name, files] of [
    ['of Zarr 2', pyramidFiles(pyramid)],
    ['of Zarr 3', pyramidFiles({ ...pyramid, version: 3 })],
    ['of Zarr 3 in shards', pyramidFiles(sharded)],
  ] as const)
    for (const ranges of [true, false])
      for (const isOwn of [true, false])
        it(`${name} is read from a server ${ranges ? 'that sends parts' : 'that sends no parts'} of ${isOwn ? 'the' : 'another'} origin`, async () => {
          await withServer(files, { ranges }, async ({ url, origin, most }) => {
            const volume = await load({ url: `${url}/` }, isOwn ? { pageOrigin: origin } : {});
            expect(volume.samples).to.deep.equal(expected);
            expect(volume.source).to.equal(undefined);
            expect(most()).to.be.at.most(8);
          });
        });

  it('in shards is fetched in parts: a region needs few bytes', async () => {
    const files = pyramidFiles({ ...sharded, shape: [24, 40, 56], unit: 'millimeter', levels: 1 });
    const whole = [...files.values()].reduce((sum, { length }) => sum + length, 0);
    await withServer(files, {}, async ({ url, sent }) => {
      const volume = await load({ url, settings: { region: [-3, -3, 0, 0, 0, 2] } });
      expect(volume.grid.kind === 'cartesian' && volume.grid.dimensions).to.deep.equal([4, 4, 3]);
      expect(sent()).to.be.below(whole / 20);
    });
  });

  it('in shards asks once for the neighbours in a shard, and not for what lies far between them', async () => {
    const files = pyramidFiles({ ...sharded, levels: 1 });
    const shards = [...files.keys()].filter((path) => path.startsWith('0/c/'));
    await withServer(files, {}, async ({ url, asked }) => {
      expect((await load({ url })).samples).to.deep.equal(expected);
      const ofShards = asked.filter((one) => one.includes('0/c/') && one.startsWith('GET'));
      expect(ofShards.length, 'an index and one part').to.equal(2 * shards.length);
    });
    // Of a large shard the middle is left out: 2 x 1 x 1 chunks of 4 x 64 x 64 floats, with others between them.
    const large = pyramidFiles({
      version: 3,
      type: 'float32',
      shape: [8, 64, 192],
      chunk: [4, 64, 64],
      shard: [8, 64, 192],
      unit: 'millimeter',
    });
    await withServer(large, {}, async ({ url, asked, sent }) => {
      const { grid } = await load({ url, settings: { region: [-3, -63, 0, 0, 0, 7] } });
      expect(grid.kind === 'cartesian' && grid.dimensions).to.deep.equal([4, 64, 8]);
      expect(asked.filter((one) => one.startsWith('GET 0/c/'))).to.have.length(3);
      expect(sent()).to.be.below(2.1 * 4 * 64 * 64 * 4);
    });
  });

  it('with a query after its address has it on all of its files', async () => {
    await withServer(pyramidFiles(pyramid), {}, async ({ url }) => {
      expect((await load({ url: `${url}?sig=1` })).samples).to.deep.equal(expected);
    });
  });

  it('is read where one request of five fails', async function () {
    this.timeout(20_000);
    await withServer(pyramidFiles(sharded), { failEvery: 5 }, async ({ url, asked }) => {
      const volume = await load({ url });
      expect(volume.samples).to.deep.equal(expected);
      expect(new Set(asked).size).to.be.below(asked.length);
    });
  });

  it('without CORS, without a Zarr, or behind a login is refused in words', async () => {
    await withServer(new Map(), {}, async ({ url }) => {
      const error = await expectError(load({ url }));
      expect([error.code, error.message]).to.deep.equal([
        'format/unsupported',
        'the folder is no Zarr: it has neither zarr.json nor .zgroup; check the address, and that the server sends files whose names begin with a dot',
      ]);
    });
    await withServer(new Map(), { missingStatus: 403 }, async ({ url }) => {
      const error = await expectError(load({ url }));
      expect(error.code).to.equal('source/not-found');
      expect(error.message).to.contain('zarr.json got HTTP status 403');
    });
  });

  it('asks for nothing any more when it is given up', async () => {
    const stop = new AbortController();
    await withServer(pyramidFiles({ shape: [40, 40, 40] }), { slowMs: 5 }, async ({ url, asked, running }) => {
      let before = 0;
      const onProgress = ({ loaded }: { readonly loaded: number }): void => {
        if (loaded === 0 || stop.signal.aborted) return;
        before = asked.length;
        stop.abort();
      };
      const coming = load({ url }, { signal: stop.signal, onProgress });
      expect(((await coming.catch((cause: unknown) => cause)) as Error).name).to.equal('AbortError');
      await new Promise((resolve) => setTimeout(resolve, 100));
      expect(running()).to.equal(0);
      // What was on its way may have come.
      expect(asked.length).to.be.at.most(before + 8);
    });
  });
});

describe('an OME-Zarr in an archive or a folder', () => {
  for (const name of ['brain.ozx', 'brain.zarr.zip', 'brain.zip'])
    for (const folder of ['', 'a folder/brain.ome.zarr/'])
      it(`${name}, ${folder ? 'in a folder of it' : 'at its top'}, is read`, async () => {
        const files = new Map([['', zipOf(pyramidFiles(sharded), folder)]]);
        await withServer(
          files,
          {},
          async ({ url }) => {
            const volume = await load({ url });
            expect(volume.samples).to.deep.equal(expected);
            expect(volume.format, 'the image, not an array of it').to.equal('OME-Zarr 0.5');
            expect(volume.source).to.deep.equal({ kind: 'archive', count: pyramidFiles(sharded).size });
          },
          name,
        );
      });

  it('.ozx is read by parts of it', async () => {
    // The list at its end takes 66 kB.
    const zip = zipOf(
      pyramidFiles({ ...sharded, shape: [24, 60, 98], type: 'float32', unit: 'millimeter', levels: 1 }),
    );
    await withServer(
      new Map([['', zip]]),
      {},
      async ({ url, sent }) => {
        await load({ url, settings: { region: [-3, -3, 0, 0, 0, 2] } });
        expect(sent()).to.be.below(zip.length / 5);
      },
      'brain.ozx',
    );
  });

  it('.ozx needs one request for each of its files, and three for their list', async () => {
    const files = pyramidFiles(pyramid);
    await withServer(
      new Map([['', zipOf(files)]]),
      {},
      async ({ url, asked }) => {
        expect((await load({ url })).samples).to.deep.equal(expected);
        expect(asked.length).to.be.at.most(files.size + 3);
      },
      'brain.ozx',
    );
  });

  it('.zarr.zip is read by parts of it, and as a whole from a server that hides how long it is', async () => {
    const zip = zipOf(
      pyramidFiles({ ...sharded, shape: [24, 60, 98], type: 'float32', unit: 'millimeter', levels: 1 }),
    );
    for (const hidesSizes of [false, true])
      await withServer(
        new Map([['', zip]]),
        { hidesSizes, ranges: !hidesSizes },
        async ({ url, sent, asked }) => {
          await load({ url, settings: { region: [-3, -3, 0, 0, 0, 2] } });
          expect(sent()).to.be[hidesSizes ? 'equal' : 'below'](hidesSizes ? zip.length : zip.length / 5);
          if (hidesSizes) expect(asked).to.deep.equal(['HEAD ', 'GET ']);
        },
        'brain.zarr.zip',
      );
  });

  it('of chosen files is read, and no message has their names', async () => {
    const base = 'https://local-1.invalid/';
    const asFiles = (all: ZarrFiles): File[] =>
      [...all].map(([path, bytes]) =>
        Object.defineProperty(new File([bytes], path.split('/').at(-1)!), 'webkitRelativePath', {
          value: `Jane Doe/brain.ome.zarr/${path}`,
        }),
      );
    const volume = await load({ url: base, local: { base, files: asFiles(pyramidFiles(pyramid)) } });
    expect(volume.samples).to.deep.equal(expected);
    expect(volume.format).to.equal('OME-Zarr 0.4');
    expect(volume.source).to.deep.equal({ kind: 'files', count: pyramidFiles(pyramid).size });
    const damaged = pyramidFiles(pyramid);
    damaged.set('0/1/1/1', new Uint8Array(3));
    const error = await expectError(load({ url: base, local: { base, files: asFiles(damaged) } }));
    expect(error.message).to.equal('a chunk of the Zarr has 3 bytes where 128 belong');
    const zip = zipOf(pyramidFiles(pyramid), 'Jane Doe/');
    expect((await load({ url: base, local: { base, files: [new File([zip], 'Jane.zip')] } })).samples).to.deep.equal(
      expected,
    );
  });

  it('without a Zarr is refused where its name promises one', async () => {
    await withServer(
      new Map([['', zipOf(new Map([['a.txt', new Uint8Array(3)]]))]]),
      {},
      async ({ url }) => expect((await expectError(load({ url }))).message).to.contain('brain.ozx holds no Zarr'),
      'brain.ozx',
    );
  });
});

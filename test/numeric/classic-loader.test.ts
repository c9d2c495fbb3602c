// What begins the classic script, with parts and a server of the test's own.
import { expect } from '@esm-bundle/chai';

type Factory = (
  need: (part: number) => Record<string, unknown>,
  load: (part: number) => Promise<unknown>,
  own: Record<string, unknown>,
) => void;
interface Loader {
  load(part: number): Promise<Record<string, unknown>>;
  need(part: number): Record<string, unknown>;
  modules: Record<number, Record<string, unknown>>;
}

const text = await (await fetch('/scripts/classic/loader.js')).text();
const asModule = new Blob(
  [`export const createLoader = (VERSION, PART_NEEDS) => {${text}\nreturn { need, load, modules };}`],
  { type: 'text/javascript' },
);
const { createLoader } = (await import(URL.createObjectURL(asModule))) as {
  createLoader(version: string, needs: Record<number, number[]>): Loader;
};

let copies = 0;

/** A loader with an entry, whose scripts do what the test says; without anything they could not be loaded. */
function withServer(
  scripts: Record<string, (() => void) | undefined>,
  needs: Record<number, number[]> = {},
): { loader: Loader; asked: string[]; define: (part: number, factory: Factory) => void } {
  const version = `test${copies++}`;
  const asked: string[] = [];
  const loader = createLoader(version, needs);
  loader.modules[0] = {
    scriptUrl: 'https://example.test/dist/volume-view.iife.js',
    async injectScript(url: string) {
      asked.push(url.replace(`-${version}`, ''));
      const run = scripts[asked.at(-1)!.replace(/^.*\//, '')];
      if (!run) throw new Error(`${url} could not be loaded`);
      run();
    },
  };
  const parts = (globalThis as unknown as { volumeViewParts: Record<string, Factory> }).volumeViewParts;
  return { loader, asked, define: (part, factory) => void (parts[`${part}-${version}`] = factory) };
}

const codeOf = (loading: Promise<unknown>): Promise<string> =>
  loading.then(
    () => 'loaded',
    (error: Error) => error.message,
  );

describe('parts of the classic script', () => {
  it('come once, with what they need, from beside the script', async () => {
    const { loader, asked, define } = withServer(
      {
        '1.js': () => define(1, (need, _, own) => (own.sum = (need(2).two as number) + 1)),
        '2.js': () => define(2, (_need, _load, own) => (own.two = 2)),
      },
      { 1: [2] },
    );
    const [first, second] = await Promise.all([loader.load(1), loader.load(1)]);
    expect([first.sum, second, await loader.load(1)]).to.deep.equal([3, first, first]);
    expect(asked).to.have.members(['https://example.test/dist/classic/1.js', 'https://example.test/dist/classic/2.js']);
  });

  it('are asked for again where they were missing', async () => {
    const scripts: Parameters<typeof withServer>[0] = {};
    const { loader, define } = withServer(scripts);
    expect(await codeOf(loader.load(1))).to.match(/classic\/1-test\d+\.js could not be loaded/);
    scripts['1.js'] = () => define(1, (_need, _load, own) => (own.one = 1));
    expect((await loader.load(1)).one).to.equal(1);
  });

  it('are asked for again where the server answered with another file', async () => {
    const scripts: Parameters<typeof withServer>[0] = { '1.js': () => {} };
    const { loader, asked, define } = withServer(scripts);
    for (let times = 0; times < 2; times++)
      expect(await codeOf(loader.load(1))).to.match(/^part 1-test\d+ is another file$/);
    scripts['1.js'] = () => define(1, (_need, _load, own) => (own.one = 1));
    expect((await loader.load(1)).one).to.equal(1);
    expect(asked).to.have.lengthOf(3);
  });
});

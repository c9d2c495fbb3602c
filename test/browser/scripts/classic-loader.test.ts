// What begins the classic script, with parts and a server of the test's own.
import { expect } from '@esm-bundle/chai';

type Part = Record<string, unknown>;
type Factory = (require: (name: string) => Part, exports: Part) => void;
interface Loader {
  require(name: string): Part | Promise<Part>;
  modules: Record<number, Part>;
}

const text = await (await fetch('/scripts/classic/loader.js')).text();
const asModule = new Blob(
  [`export const createLoader = (VERSION, PART_NEEDS) => {${text}\nreturn { require, modules };}`],
  { type: 'text/javascript' },
);
const { createLoader } = (await import(URL.createObjectURL(asModule))) as {
  createLoader(version: string, needs: string): Loader;
};

/** Of ten parts. */
const noNeeds = ','.repeat(9);

let copies = 0;

/** A loader with an entry, whose scripts do what the test says; without anything they could not be loaded. */
function withServer(
  scripts: Record<string, (() => void) | undefined>,
  needs = noNeeds,
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

/** What a bundler writes for import('../../numeric/NUMBER'). */
const load = async (loader: Loader, part: number): Promise<Part> => loader.require(`./${part}`);

const codeOf = (loading: Promise<unknown>): Promise<string> =>
  loading.then(
    () => 'loaded',
    (error: Error) => error.message,
  );

describe('parts of the classic script', () => {
  it('come once, with what they need, from the folder of the script', async () => {
    const { loader, asked, define } = withServer(
      {
        '1.js': () => define(1, (require, exports) => (exports.sum = (require('./2').two as number) + 1)),
        '2.js': () => define(2, (require, exports) => (exports.two = (require('./3').three as number) - 1)),
        '3.js': () => define(3, (_, exports) => (exports.three = 3)),
      },
      ',c,d,,,',
    );
    const [first, second] = await Promise.all([load(loader, 1), load(loader, 1)]);
    expect([first.sum, second, loader.require('./1')]).to.deep.equal([3, first, first]);
    expect(asked).to.have.members([1, 2, 3].map((part) => `https://example.test/dist/classic/${part}.js`));
  });

  it('come with those of which the build writes the gaps', async () => {
    const empty = (part: number, define: (part: number, factory: Factory) => void) => (): void =>
      define(part, () => {});
    const all = [1, 2, 30, 700];
    const scripts: Parameters<typeof withServer>[0] = {};
    const { loader, asked, define } = withServer(scripts, `,cBcZu${','.repeat(700)}`);
    for (const part of all) scripts[`${part}.js`] = empty(part, define);
    await load(loader, 1);
    expect(asked).to.have.members(all.map((part) => `https://example.test/dist/classic/${part}.js`));
  });

  it('are asked for again where they were missing', async () => {
    const scripts: Parameters<typeof withServer>[0] = {};
    const { loader, define } = withServer(scripts);
    expect(await codeOf(load(loader, 1))).to.match(/classic\/1-test\d+\.js could not be loaded/);
    scripts['1.js'] = () => define(1, (_, exports) => (exports.one = 1));
    expect((await load(loader, 1)).one).to.equal(1);
  });

  it('are asked for again where the server answered with another file', async () => {
    const scripts: Parameters<typeof withServer>[0] = { '1.js': () => {} };
    const { loader, asked, define } = withServer(scripts);
    for (let times = 0; times < 2; times++)
      expect(await codeOf(load(loader, 1))).to.match(/^part 1-test\d+ is another file$/);
    scripts['1.js'] = () => define(1, (_, exports) => (exports.one = 1));
    expect((await load(loader, 1)).one).to.equal(1);
    expect(asked).to.have.lengthOf(3);
  });

  it('wait for what they need where their own script came first', async () => {
    const { loader, asked, define } = withServer(
      { '2.js': () => define(2, (_, exports) => (exports.two = 2)) },
      ',c,,',
    );
    define(1, (require, exports) => (exports.sum = (require('./2').two as number) + 1));
    expect((await load(loader, 1)).sum).to.equal(3);
    expect(asked).to.deep.equal(['https://example.test/dist/classic/2.js']);
  });
});

// Many chosen files go to the worker in groups, between which the page does other work.
import { expect } from '@esm-bundle/chai';
import { loadVolume } from '../../../src/worker/load.ts';
import { endSpare } from '../../../src/worker/spare-worker.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { ctSlice, dicomBytes } from '../../helpers/dicom-bytes.ts';
import { roomyLimits } from '../../helpers/decode.ts';

const base = 'https://local-7.invalid/';

const load = (files: readonly unknown[], signal = new AbortController().signal): Promise<Volume> =>
  loadVolume({ url: base, local: { base, files }, limits: roomyLimits }, { signal, onProgress: () => undefined });

const slices = (count: number): File[] =>
  Array.from({ length: count }, (_, k) => new File([dicomBytes(ctSlice(2 * k))], `${k + 1}.dcm`));

/** How many files each message has, to a worker or a port. */
async function watchMessages(run: () => Promise<unknown>): Promise<number[]> {
  const sent: number[] = [];
  const count = (message: unknown): void => {
    let files = 0;
    JSON.stringify(message, (_key, value: unknown) => (value instanceof File ? void files++ : value));
    if (files > 0) sent.push(files);
  };
  const originals = [Worker.prototype, MessagePort.prototype].map((prototype) => {
    const original = Reflect.get(prototype, 'postMessage') as (...args: unknown[]) => void;
    Reflect.set(prototype, 'postMessage', function (this: unknown, ...args: unknown[]) {
      count(args[0]);
      original.apply(this, args);
    });
    return () => Reflect.set(prototype, 'postMessage', original);
  });
  try {
    await run();
  } finally {
    for (const restore of originals) restore();
  }
  return sent;
}

describe('many chosen files', () => {
  beforeEach(() => endSpare());

  it('are sent in groups of 16, and are one volume', async () => {
    let volume: Volume | undefined;
    const sent = await watchMessages(async () => (volume = await load(slices(70))));
    expect(sent).to.deep.equal([16, 16, 16, 16, 6]);
    expect(volume?.grid).to.have.nested.property('dimensions[2]', 70);
  });

  it('are sent at once where they are few', async () => {
    expect(await watchMessages(() => load(slices(40)))).to.deep.equal([40]);
  });

  it('are checked, also those that can not be sent', async () => {
    const error = await load([...slices(60), () => undefined]).catch((cause: unknown) => cause);
    expect(error).to.have.property('code', 'attribute/invalid');
    expect(error).to.have.property('message').that.contains('no file at place 61');
  });

  it('are not sent any more once the load is given up', async () => {
    const controller = new AbortController();
    const sent = await watchMessages(async () => {
      const loading = load(slices(600), controller.signal).catch((error: unknown) => error);
      setTimeout(() => controller.abort(new Error('given up')));
      expect(await loading).to.have.property('message', 'given up');
      await new Promise((resolve) => setTimeout(resolve, 300));
    });
    expect(sent.reduce((sum, count) => sum + count, 0)).to.be.below(600);
  });
});

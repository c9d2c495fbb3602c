import { expect } from '@esm-bundle/chai';
import { later } from '../../../src/core/later.ts';

const page = globalThis as { scheduler?: unknown };

describe('a pause', () => {
  const own = Object.getOwnPropertyDescriptor(globalThis, 'scheduler');
  const replace = (scheduler: unknown): void =>
    void Object.defineProperty(globalThis, 'scheduler', { value: scheduler, configurable: true });
  afterEach(() => {
    if (own) Object.defineProperty(globalThis, 'scheduler', own);
    else delete page.scheduler;
  });

  it('is a task where the browser has tasks: these do not wait for 4 ms', async () => {
    const asked: number[] = [];
    replace({
      postTask: async (work: () => void, { delay }: { delay: number }) => {
        asked.push(delay);
        work();
      },
    });
    await later();
    expect(asked).to.deep.equal([1]);
  });

  it('is a timer in an older browser', async () => {
    replace(undefined);
    let others = 0;
    setTimeout(() => others++, 0);
    await later();
    expect(others, 'work that was waiting').to.equal(1);
  });
});

import { expect } from '@esm-bundle/chai';
import '../../../src/index.ts';
import { measureTrade } from '../../../demos/trade/measure-trade.ts';

describe('what the page of error against time measures', () => {
  it('is one picture by each method: with finer steps all but the paper’s come close to the same limit', async () => {
    const container = document.createElement('div');
    document.body.append(container);
    const shares: number[] = [];
    const lines = await measureTrade(container, new AbortController().signal, (share) => shares.push(share), {
      size: 64,
      errors: [8, 1],
      turns: 1,
      steps: [20, 400],
    });
    expect(lines.map(({ color }) => color)).to.deep.equal(['--printed', '--plain', '--keep', '--free']);
    for (const { name, points } of lines) {
      expect(points, name).to.have.length(2);
      for (const [ms] of points) expect(ms, name).to.be.above(0);
    }
    const [printed, plain, keep, free] = lines.map(({ points }) => points.map(([, error]) => error));
    expect(Math.min(...printed), 'the paper’s colours are of 8 bits').to.be.above(2);
    expect(Math.max(...plain)).to.be.above(5);
    expect(Math.min(...plain)).to.be.below(1);
    // With `max-error` 1 and 8, in the order of their times.
    expect(Math.min(...keep)).to.be.below(1.5);
    expect(Math.max(...keep)).to.be.below(4);
    expect(Math.max(...free)).to.be.below(12);
    expect(shares.at(-1)).to.equal(1);
    expect(container.getAttribute('aria-label')).to.contain('volume-view, detail="free": ');
    expect(document.querySelector('volume-view'), 'the measured view is gone').to.equal(null);
    container.remove();
  });

  it('ends where the reader stops it', async () => {
    const container = document.createElement('div');
    const aborter = new AbortController();
    const running = measureTrade(container, aborter.signal, () => aborter.abort(new Error('stopped')), {
      size: 16,
      errors: [8],
      turns: 1,
      steps: [20],
    });
    expect(await running.catch((cause: unknown) => (cause as Error).message)).to.equal('stopped');
    expect(container.childElementCount).to.equal(0);
  });
});

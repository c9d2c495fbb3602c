import { expect } from '@esm-bundle/chai';
import { findFewest, listCounts, remember } from '../../bench/find-steps.ts';

const counts = listCounts(4000);

describe("the benchmark's search for the smallest number of steps", () => {
  it('finds what a test of all of them finds, where errors fall', async () => {
    for (const target of [0.1, 1, 4]) {
      for (const factor of [3, 100, 350]) {
        const errorOf = (steps: number): number => factor / steps;
        const expected = counts.find((steps) => errorOf(steps) <= target);
        const found = await findFewest(counts, target, errorOf);
        expect(found?.steps ?? null, `${factor} / steps to ${target}`).to.equal(expected ?? null);
        if (found) expect(found.error).to.equal(errorOf(found.steps));
      }
    }
  });

  it('takes no single good number of steps that is luck', async () => {
    const lucky = counts[24];
    const found = await findFewest(counts, 1, (steps) => (steps === lucky ? 0 : 200 / steps));
    expect(found!.steps).to.equal(counts.find((steps) => steps >= 200));
  });

  it('says where no number of steps is enough', async () => {
    expect(await findFewest(counts, 1, () => 1.5)).to.equal(null);
  });

  it('measures few of many, and each once', async () => {
    const asked: number[] = [];
    await findFewest(
      counts,
      1,
      remember(async (steps) => {
        asked.push(steps);
        return 700 / steps;
      }),
    );
    expect(new Set(asked).size).to.equal(asked.length);
    expect(asked.length).to.be.below(counts.length / 4);
  });

  it('goes up in steps of about a tenth', () => {
    for (let i = 12; i < counts.length; i++) expect(counts[i] / counts[i - 1]).to.be.within(1.05, 1.16);
  });
});

import { expect } from '@esm-bundle/chai';
import { ContextPool } from '../../../../src/viewer/scenes/context-pool.ts';
import type { Need, ContextHolder } from '../../../../src/viewer/scenes/context-pool.ts';

/** An element's part, without an element: a test sets what it needs. */
class Holder implements ContextHolder {
  inSight = true;
  asked = false;
  mayHold = true;
  need: Need = 'picture';
  busy = false;
  holds = false;

  constructor(
    readonly name: string,
    changes: Partial<Omit<Holder, 'name'>> = {},
  ) {
    Object.assign(this, changes);
  }

  enter(): void {
    expect(this.holds, `${this.name} has no context yet`).to.equal(false);
    this.holds = true;
  }

  leave(): void {
    expect(this.holds, `${this.name} has a context`).to.equal(true);
    expect(this.busy, `${this.name} can leave`).to.equal(false);
    this.holds = false;
  }
}

/** Fill a pool with elements named a, b, c ... */
function fillPool(
  max: number,
  holders: readonly Partial<Omit<Holder, 'name'>>[],
): { pool: ContextPool; all: Holder[] } {
  const pool = new ContextPool(max);
  const all = holders.map((changes, i) => new Holder('abcdefgh'[i], changes));
  for (const holder of all) pool.add(holder);
  return { pool, all };
}

/** Who has a context, once all is decided. */
async function namesOf(all: readonly Holder[]): Promise<string> {
  await Promise.resolve();
  return all
    .filter((holder) => holder.holds)
    .map(({ name }) => name)
    .join('');
}

/** All that hold a context have drawn, and need it no more. */
function draw(pool: ContextPool, all: readonly Holder[]): void {
  for (const holder of all) {
    if (!holder.holds) continue;
    holder.need = 'ready';
    pool.drew(holder);
  }
}

describe('the contexts of a page', () => {
  it('are never more than there are, and all come to draw, each once', async () => {
    const { pool, all } = fillPool(
      2,
      Array.from({ length: 5 }, () => ({})),
    );
    expect(await namesOf(all)).to.equal('ab');
    draw(pool, all);
    expect(await namesOf(all)).to.equal('cd');
    draw(pool, all);
    const last = await namesOf(all);
    expect(last).to.have.lengthOf(2);
    expect(last).to.contain('e');
    draw(pool, all);
    expect(await namesOf(all), 'nobody in sight leaves for one whose picture is right').to.equal(last);
  });

  it('go to a hand first, then to what is in sight', async () => {
    const { pool, all } = fillPool(1, [{ inSight: false }, {}, { need: 'hand' }, { need: 'ready' }]);
    expect(await namesOf(all)).to.equal('c');
    draw(pool, all);
    expect(await namesOf(all)).to.equal('b');
    draw(pool, all);
    expect(await namesOf(all), 'not for one out of sight').to.equal('b');
  });

  it('of those that need them no more, the one goes first that drew longest ago', async () => {
    const { pool, all } = fillPool(3, [{}, {}, {}]);
    expect(await namesOf(all)).to.equal('abc');
    draw(pool, all);
    pool.drew(all[0]);
    const late = new Holder('z');
    pool.add(late);
    expect(await namesOf([...all, late])).to.equal('acz');
  });

  it('are left at once by what went far away, unless it can not leave', async () => {
    const { pool, all } = fillPool(2, [{}, {}]);
    expect(await namesOf(all)).to.equal('ab');
    for (const holder of all) Object.assign(holder, { inSight: false, mayHold: false, need: 'none' });
    all[1].busy = true;
    pool.review();
    expect(await namesOf(all)).to.equal('b');
    all[1].busy = false;
    pool.drew(all[1]);
    expect(await namesOf(all)).to.equal('');
  });

  it('free ones are for whoever is in sight, and those out of sight make room', async () => {
    const { pool, all } = fillPool(2, [{ inSight: false }, { inSight: false }]);
    expect(await namesOf(all)).to.equal('ab');
    for (const holder of all) holder.need = 'none';
    const seen = new Holder('s', { need: 'ready' });
    pool.add(seen);
    expect(await namesOf([...all, seen])).to.equal('bs');
  });

  it('one more there is for what a script asks for out of sight', async () => {
    const { pool, all } = fillPool(2, [{}, {}, ...Array.from({ length: 2 }, () => ({ inSight: false, asked: true }))]);
    expect(await namesOf(all)).to.equal('abc');
    Object.assign(all[2], { asked: false, mayHold: false, need: 'none' });
    pool.drew(all[2]);
    expect(await namesOf(all)).to.equal('abd');
    all[3].asked = false;
    pool.review();
    expect(await namesOf(all), 'it may go on while it draws').to.equal('abd');
    all[3].need = 'none';
    pool.drew(all[3]);
    expect(await namesOf(all), 'near, and done').to.equal('ab');
  });

  it('go round where nothing ever comes to rest', async () => {
    const { pool, all } = fillPool(1, [{}, {}, {}]);
    const now = performance.now;
    let time = now.call(performance);
    performance.now = () => time;
    try {
      const seen: string[] = [];
      for (let frame = 0; frame < 7; frame++) {
        seen.push(await namesOf(all));
        time += 1000;
        pool.drew(all.find((holder) => holder.holds)!);
      }
      expect(seen.join(' ')).to.equal('a a b b c c a');
    } finally {
      performance.now = now;
    }
  });

  it('that a hand is on are not taken, however long it stays', async () => {
    const { pool, all } = fillPool(1, [{ need: 'hand' }, {}]);
    const now = performance.now;
    try {
      expect(await namesOf(all)).to.equal('a');
      performance.now = () => now.call(performance) + 60_000;
      pool.drew(all[0]);
      expect(await namesOf(all)).to.equal('a');
      all[0].need = 'ready';
      pool.drew(all[0]);
      expect(await namesOf(all)).to.equal('b');
    } finally {
      performance.now = now;
    }
  });
});

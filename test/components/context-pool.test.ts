import { expect } from '@esm-bundle/chai';
import { ContextPool } from '../../src/viewer/context-pool.ts';
import type { Need, ContextHolder } from '../../src/viewer/context-pool.ts';

/** An element's part, without an element: a test sets what it needs. */
class Guest implements ContextHolder {
  inSight = true;
  asked = false;
  mayHold = true;
  need: Need = 'picture';
  busy = false;
  holds = false;

  constructor(readonly name: string, changes: Partial<Omit<Guest, 'name'>> = {}) {
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

/** Fill a pool with guests named a, b, c ... */
function house(most: number, guests: readonly Partial<Omit<Guest, 'name'>>[]): { pool: ContextPool; all: Guest[] } {
  const pool = new ContextPool(most);
  const all = guests.map((changes, i) => new Guest('abcdefgh'[i], changes));
  for (const guest of all) pool.add(guest);
  return { pool, all };
}

/** Who has a context, once all is decided. */
async function holders(all: readonly Guest[]): Promise<string> {
  await Promise.resolve();
  return all.filter((guest) => guest.holds).map(({ name }) => name).join('');
}

/** All that hold a context have drawn, and need it no more. */
function draw(pool: ContextPool, all: readonly Guest[]): void {
  for (const guest of all) {
    if (!guest.holds) continue;
    guest.need = 'ready';
    pool.drew(guest);
  }
}

describe('the context pool', () => {
  it('are never more than there are, and all come to draw, each once', async () => {
    const { pool, all } = house(2, Array.from({ length: 5 }, () => ({})));
    expect(await holders(all)).to.equal('ab');
    draw(pool, all);
    expect(await holders(all)).to.equal('cd');
    draw(pool, all);
    const last = await holders(all);
    expect(last).to.have.lengthOf(2);
    expect(last).to.contain('e');
    draw(pool, all);
    expect(await holders(all), 'nobody in sight leaves for one whose picture is right').to.equal(last);
  });

  it('go to a hand first, then to what is in sight', async () => {
    const { pool, all } = house(1, [{ inSight: false }, {}, { need: 'hand' }, { need: 'ready' }]);
    expect(await holders(all)).to.equal('c');
    draw(pool, all);
    expect(await holders(all)).to.equal('b');
    draw(pool, all);
    expect(await holders(all), 'not for one out of sight').to.equal('b');
  });

  it('of those that need them no more, the one goes first that drew longest ago', async () => {
    const { pool, all } = house(3, [{}, {}, {}]);
    expect(await holders(all)).to.equal('abc');
    draw(pool, all);
    pool.drew(all[0]);
    const late = new Guest('z');
    pool.add(late);
    expect(await holders([...all, late])).to.equal('acz');
  });

  it('are left at once by what went far away, unless it can not leave', async () => {
    const { pool, all } = house(2, [{}, {}]);
    expect(await holders(all)).to.equal('ab');
    for (const guest of all) Object.assign(guest, { inSight: false, mayHold: false, need: 'none' });
    all[1].busy = true;
    pool.review();
    expect(await holders(all)).to.equal('b');
    all[1].busy = false;
    pool.drew(all[1]);
    expect(await holders(all)).to.equal('');
  });

  it('free ones are for whoever is in sight, and those out of sight make room', async () => {
    const { pool, all } = house(2, [{ inSight: false }, { inSight: false }]);
    expect(await holders(all)).to.equal('ab');
    for (const guest of all) guest.need = 'none';
    const seen = new Guest('s', { need: 'ready' });
    pool.add(seen);
    expect(await holders([...all, seen])).to.equal('bs');
  });

  it('one more there is for what a script asks for out of sight', async () => {
    const { pool, all } = house(2, [{}, {}, ...Array.from({ length: 2 }, () => ({ inSight: false, asked: true }))]);
    expect(await holders(all)).to.equal('abc');
    Object.assign(all[2], { asked: false, mayHold: false, need: 'none' });
    pool.drew(all[2]);
    expect(await holders(all)).to.equal('abd');
    all[3].asked = false;
    pool.review();
    expect(await holders(all), 'it may go on while it draws').to.equal('abd');
    all[3].need = 'none';
    pool.drew(all[3]);
    expect(await holders(all), 'near, and done').to.equal('ab');
  });

  it('go round where nothing ever comes to rest', async () => {
    const { pool, all } = house(1, [{}, {}, {}]);
    const now = performance.now;
    let time = now.call(performance);
    performance.now = () => time;
    try {
      const seen: string[] = [];
      for (let frame = 0; frame < 7; frame++) {
        seen.push(await holders(all));
        time += 1000;
        pool.drew(all.find((guest) => guest.holds)!);
      }
      expect(seen.join(' ')).to.equal('a a b b c c a');
    } finally {
      performance.now = now;
    }
  });

  it('that a hand is on are not taken, however long it stays', async () => {
    const { pool, all } = house(1, [{ need: 'hand' }, {}]);
    const now = performance.now;
    try {
      expect(await holders(all)).to.equal('a');
      performance.now = () => now.call(performance) + 60_000;
      pool.drew(all[0]);
      expect(await holders(all)).to.equal('a');
      all[0].need = 'ready';
      pool.drew(all[0]);
      expect(await holders(all)).to.equal('b');
    } finally {
      performance.now = now;
    }
  });
});

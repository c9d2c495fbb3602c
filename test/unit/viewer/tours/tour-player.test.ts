import { expect } from '@esm-bundle/chai';
import { readDwell } from '../../../../src/viewer/tours/tour-attributes.ts';
import { TourPlayer } from '../../../../src/viewer/tours/tour-player.ts';
import { errorOf } from '../../../helpers/error-of.ts';
import { FakeTimers } from '../../../helpers/fake-timers.ts';

describe('a tour that plays', () => {
  /** A player that has shown its first step for no time yet, and how often it went on. */
  const withPlayer = (act: (player: TourPlayer, timers: FakeTimers, count: () => number) => void): Promise<void> =>
    new FakeTimers().run((timers) => {
      let count = 0;
      const player: TourPlayer = new TourPlayer(() => {
        count++;
        player.stay(2000); // Another step opens, with a time of its own.
      });
      player.stay(2000);
      act(player, timers, () => count);
      player.pause();
      expect(timers.count, 'timers that are left').to.equal(0);
    });

  it('opens the next step after the time of each, until it is paused', () =>
    withPlayer((player, timers, count) => {
      timers.pass(9000);
      expect([count(), player.paused]).to.deep.equal([0, true]);
      player.play();
      expect(player.paused).to.equal(false);
      timers.pass(1999);
      expect(count()).to.equal(0);
      timers.pass(1);
      expect(count()).to.equal(1);
      timers.pass(2000);
      expect(count()).to.equal(2);
      player.pause();
      timers.pass(9000);
      expect([count(), player.paused]).to.deep.equal([2, true]);
    }));

  it('waits while anything holds it, and then for the whole time of the step', () =>
    withPlayer((player, timers, count) => {
      player.play();
      timers.pass(1900);
      player.hold('pointer', true);
      player.hold('focus', true);
      timers.pass(9000);
      player.hold('pointer', false);
      timers.pass(9000);
      expect([count(), player.paused]).to.deep.equal([0, false]);
      player.hold('focus', false);
      timers.pass(1000);
      player.hold('focus', false); // Nothing new.
      timers.pass(999);
      expect(count()).to.equal(0);
      timers.pass(1);
      expect(count()).to.equal(1);
      player.hold('pointer', true);
      player.pause();
      player.play();
      timers.pass(9000);
      expect(count()).to.equal(1);
      player.hold('pointer', false);
    }));

  it('counts from the last time that somebody used the view, and from the opening of a step', () =>
    withPlayer((player, timers, count) => {
      player.play();
      for (let turns = 0; turns < 5; turns++) {
        timers.pass(1500);
        player.restart();
      }
      expect(count()).to.equal(0);
      player.stay(5000); // A person has chosen a step.
      timers.pass(4999);
      expect(count()).to.equal(0);
      timers.pass(1);
      expect(count()).to.equal(1);
    }));
});

describe('the time of a step', () => {
  it('is read in seconds', () => {
    expect(readDwell(null, 'dwell')).to.equal(null);
    expect(readDwell(' 2.5 ', 'dwell')).to.equal(2500);
    expect(readDwell('3600', 'dwell')).to.equal(3_600_000);
  });

  it('is refused where nobody could read the text, or a number of milliseconds is meant', () => {
    for (const text of ['0', '0.5', '-1', '8000', 'long', '', 'Infinity', '1e9', '__proto__']) {
      const { code, message } = errorOf(() => readDwell(text, 'dwell of <volume-tour>'));
      expect(code).to.equal('attribute/invalid');
      expect(message).to.equal(`dwell of <volume-tour> got "${text}"; expected seconds, 1 to 3600.`);
    }
  });
});

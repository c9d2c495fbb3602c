// The line under a picture that is made finer: when it is there, and when not. What draws is played here, so that times are known.
import { expect } from '@esm-bundle/chai';
import { followRefining } from '../../../../src/viewer/view/refining.ts';
import type { RefinedView } from '../../../../src/viewer/view/refining-sign.ts';
import type { VolumePresenter } from '../../../../src/viewer/view/volume-presenter.ts';
import { fakeOf } from '../../../helpers/fake.ts';

const wait = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));

/** An element in which pictures are drawn. */
function makeView(): {
  view: RefinedView;
  presenter: Pick<VolumePresenter, 'viewer'>;
  state: {
    converged: boolean;
    paused: boolean;
    moving: boolean;
    animating: boolean;
    canDraw: boolean;
    unfinished: boolean;
    coarse: boolean;
    gathered: number | null;
  };
} {
  const element = document.body.appendChild(document.createElement('div'));
  element.attachShadow({ mode: 'open' });
  const state = {
    converged: false,
    paused: true,
    moving: false,
    animating: false,
    canDraw: true,
    unfinished: true,
    coarse: false,
    gathered: null as number | null,
  };
  const viewer = {
    wantsPicture: true,
    get volume() {
      return { coarse: state.coarse || undefined };
    },
    get canDraw() {
      return state.canDraw;
    },
    get moving() {
      return state.moving;
    },
    get animating() {
      return state.animating;
    },
    loop: {
      get unfinished() {
        return state.unfinished;
      },
    },
    pictures: {
      get gathered() {
        return state.gathered;
      },
    },
  };
  Object.defineProperties(element, {
    renderStats: { get: () => ({ converged: state.converged }) },
    paused: { get: () => state.paused },
  });
  return {
    view: element as unknown as RefinedView,
    presenter: fakeOf<VolumePresenter>('VolumePresenter', { viewer }),
    state,
  };
}

const signOf = ({ shadowRoot }: RefinedView): HTMLElement | null => shadowRoot!.querySelector('.refining');

describe('the sign that a picture is refined', () => {
  it('comes after a second, follows how much is drawn, says nothing to who listens, and goes with the final picture', async () => {
    const { view, presenter, state } = makeView();
    followRefining(view, presenter);
    await wait(700);
    followRefining(view, presenter); // Another coarse picture.
    expect(signOf(view), 'too early').to.equal(null);
    await wait(700);
    const sign = signOf(view)!;
    expect(sign.getAttribute('aria-hidden')).to.equal('true');
    expect(sign.getAttribute('part')).to.equal('refining');
    expect(getComputedStyle(sign).position, 'nothing moves for it').to.equal('absolute');
    const line = sign.firstElementChild as HTMLElement;
    expect(line.className, 'nobody knows how far it is').to.equal('unknown');
    state.gathered = 0.4;
    for (let i = 0; i < 100 && Math.abs(line.offsetWidth / sign.offsetWidth - 0.4) > 0.01; i++) await wait(50); // It glides, as fast as the page draws.
    expect(line.className).to.equal('');
    expect(line.offsetWidth / sign.offsetWidth).to.be.closeTo(0.4, 0.01);
    view.dispatchEvent(new CustomEvent('render'));
    expect(signOf(view), 'another coarse picture').to.equal(sign);
    state.converged = true;
    view.dispatchEvent(new CustomEvent('render'));
    expect(signOf(view), 'a screenshot of the final picture is without it').to.equal(null);
    view.remove();
  });

  it('goes when no picture follows', async () => {
    const { view, presenter, state } = makeView();
    followRefining(view, presenter);
    await wait(1150);
    expect(signOf(view)).not.to.equal(null);
    state.unfinished = false;
    await wait(200);
    expect(signOf(view)).to.equal(null);
    view.remove();
  });

  it('does not come where the final picture does within a second, and begins to count again with the next change', async () => {
    const { view, presenter, state } = makeView();
    followRefining(view, presenter);
    await wait(600);
    state.converged = true;
    followRefining(view, presenter);
    await wait(100);
    state.converged = false;
    followRefining(view, presenter);
    await wait(600);
    expect(signOf(view)).to.equal(null);
    state.converged = true;
    followRefining(view, presenter);
    await wait(600);
    expect(signOf(view)).to.equal(null);
    view.remove();
  });

  for (const [name, value] of [
    ['moving', true],
    ['animating', true],
    ['paused', false],
    ['canDraw', false],
    ['unfinished', false],
    ['coarse', true],
  ] as const) {
    it(`does not come, and goes, where ${name} is ${value}`, async () => {
      const { view, presenter, state } = makeView();
      Object.assign(state, { [name]: value });
      followRefining(view, presenter);
      await wait(1150);
      expect(signOf(view)).to.equal(null);
      Object.assign(state, { [name]: !value });
      followRefining(view, presenter);
      await wait(1150);
      expect(signOf(view), 'without that').not.to.equal(null);
      Object.assign(state, { [name]: value });
      await wait(200);
      expect(signOf(view)).to.equal(null);
      view.remove();
    });
  }
});

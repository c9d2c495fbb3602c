import { expect } from '@esm-bundle/chai';
import { CustomStates } from '../../../../components/internal/custom-states.ts';

class TestState extends HTMLElement {
  readonly states = new CustomStates<'loading' | 'error'>(this);
}
customElements.define('test-state', TestState);

describe('custom states', () => {
  it('are seen by CSS, several at once, without an attribute', () => {
    const element = new TestState();
    element.states.set('loading', true);
    element.states.set('error', true);
    expect(element.matches(':state(loading):state(error)')).to.equal(true);
    element.states.set('loading', false);
    element.states.set('loading', false);
    expect([element.matches(':state(loading)'), element.matches(':state(error)')]).to.deep.equal([false, true]);
    expect(element.attributes.length).to.equal(0);
  });

  for (const [what, states] of [
    ['none', undefined],
    [
      'those of the first draft',
      new (class extends Set<string> {
        override add(name: string): this {
          if (!name.startsWith('--')) throw new DOMException('no dashes', 'SyntaxError');
          return super.add(name);
        }
      })(),
    ],
  ] as const) {
    it(`are attributes where the browser has ${what}`, () => {
      class Old extends TestState {
        override attachInternals(): ElementInternals {
          return { states } as unknown as ElementInternals;
        }
      }
      customElements.define(`test-state-${states ? 'draft' : 'none'}`, Old);
      const element = new Old();
      element.states.set('loading', true);
      expect(element.matches('[data-state-loading]')).to.equal(true);
      element.states.set('loading', false);
      expect(element.attributes.length).to.equal(0);
    });
  }
});

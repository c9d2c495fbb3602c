import { expect } from '@esm-bundle/chai';
import { noticeStyles } from '../../../../components/internal/view-notices-styles.ts';
import { styles as controlStyles } from '../../../../components/volume-view/view-controls-styles.ts';
import { styles as noteStyles } from '../../../../components/volume-note/volume-note-styles.ts';
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

  for (const [what, text, state, property] of [
    ['notes in the page', noteStyles.cssText, 'linked', 'display'],
    ['notes that are pointed at', noteStyles.cssText, 'active', 'background'],
    ['controls above an error', controlStyles.cssText, 'error', 'inset-block'],
    ['notices above an error', noticeStyles, 'error', 'inset-block-start'],
  ] as const)
    it(`styles of ${what} find the attribute in a browser that does not know :state()`, () => {
      const sheet = new CSSStyleSheet();
      // To this browser the name says as little as `:state()` to an older one.
      sheet.replaceSync(text.replaceAll(':state(', ':unknown('));
      const rules = [...sheet.cssRules].filter(
        (rule): rule is CSSStyleRule =>
          rule instanceof CSSStyleRule && rule.selectorText.includes(`[data-state-${state}]`),
      );
      expect(rules.some(({ style }) => style.getPropertyValue(property) !== '')).to.equal(true);
      expect(text.match(/:state\(/g)!.length).to.equal(text.match(/\[data-state-/g)!.length);
    });
});

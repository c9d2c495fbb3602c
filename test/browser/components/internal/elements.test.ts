// The one table of elements: each line loads what defines that element, and every tag of the package has a line.
import { expect } from '@esm-bundle/chai';
import { elements } from '../../../../components/internal/elements.ts';

describe('the table of elements', () => {
  for (const [name, load] of Object.entries(elements)) {
    it(`has what defines <${name}>`, async () => {
      const classes = Object.values((await load()) as Record<string, unknown>);
      expect(classes).to.include(customElements.get(name));
    });
  }

  it('takes a new element by one line', async () => {
    const table: Record<string, () => Promise<unknown>> = {
      ...elements,
      'volume-toy': async () => customElements.define('volume-toy', class extends HTMLElement {}),
    };
    await table['volume-toy']();
    expect(customElements.get('volume-toy')).to.be.a('function');
  });
});

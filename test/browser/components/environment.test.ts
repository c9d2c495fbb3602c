import { expect } from '@esm-bundle/chai';

// Fails first, and plainly, on a machine whose browser cannot draw, where every other test would fail obscurely.
describe('the browser of the unit tests', () => {
  for (const name of ['webgl', 'webgl2']) {
    it(`gives a ${name} context`, () => {
      expect(document.createElement('canvas').getContext(name)).to.not.equal(null);
    });
  }
});

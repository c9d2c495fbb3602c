// Companions inside shadow roots: their code is fetched, and they find the volume, wherever the two are.
import { expect } from '@esm-bundle/chai';
import '../../../components/volume-view/define.ts';
import type { VolumeLegend } from '../../../components/volume-legend/volume-legend.ts';
import { english } from '../../../src/messages/english-companions.ts';

/** Put HTML into an element's new shadow root. */
function attach(host: Element, html: string, mode: ShadowRootMode = 'open'): ShadowRoot {
  const root = host.attachShadow({ mode });
  root.innerHTML = html;
  return root;
}

function addHost(place: Node = document.body): HTMLElement {
  return place.appendChild(document.createElement('div'));
}

/** What a companion says once nothing is under way. */
async function textOf(element: Element | null): Promise<string> {
  await customElements.whenDefined(element!.localName);
  await new Promise((resolve) => setTimeout(resolve)); // Observers call back before it.
  await (element as VolumeLegend).updateComplete;
  return element!.shadowRoot!.querySelector('.hint')!.textContent;
}

const { noVolume } = english; // It has found a view, which has nothing to show.

afterEach(() => document.body.replaceChildren());

// A name is defined once for all tests of a page: each of these has a companion of its own.
describe('the code of a companion is fetched', () => {
  it('in a shadow root that comes with its host', async () => {
    const host = document.createElement('div');
    const root = attach(host, '<volume-view></volume-view><volume-legend></volume-legend>');
    document.body.append(host);
    expect(await textOf(root.querySelector('volume-legend'))).to.equal(noVolume);
  });

  it('in a shadow root that is attached later, once a view is in it', async () => {
    const root = attach(addHost(), '<volume-view></volume-view><section><volume-timeline></volume-timeline></section>');
    expect(await textOf(root.querySelector('volume-timeline'))).to.equal(noVolume);
  });

  it('in the shadow root that an element has once it is defined, in a shadow root', async () => {
    const outer = attach(addHost(), '<volume-view></volume-view><later-host></later-host>');
    await new Promise((resolve) => setTimeout(resolve));
    let inner: ShadowRoot | null = null;
    customElements.define(
      'later-host',
      class extends HTMLElement {
        constructor() {
          super();
          inner = attach(this, '<volume-transfer-function></volume-transfer-function>');
        }
      },
    );
    expect(await textOf(inner!.firstElementChild)).to.equal(noVolume);
    expect(outer.querySelector('later-host')!.shadowRoot).to.equal(inner);
  });

  it('in the shadow root of an element of the page whose name begins as ours do', async () => {
    customElements.define('volume-knob', class extends HTMLElement {});
    const knob = document.createElement('volume-knob');
    const root = attach(knob, '<volume-label-list></volume-label-list>');
    document.body.append(knob);
    await customElements.whenDefined('volume-label-list');
    expect(root.firstElementChild!.shadowRoot).not.to.equal(null);
  });

  it('in a closed shadow root with a view', async () => {
    attach(addHost(), '<volume-view></volume-view><volume-slice></volume-slice>', 'closed');
    await customElements.whenDefined('volume-slice');
  });
});

describe('a companion finds the view', () => {
  const legendIn = (root: ParentNode): Element | null => root.querySelector('volume-legend');
  const nobody = (id: string | null = null): string => english.noView(id);

  it('in its own root before one around it, and in one around it before one below', async () => {
    document.body.innerHTML = '<volume-view id="a"></volume-view>';
    const root = attach(addHost(), '<volume-legend for="a"></volume-legend><p id="a"></p>');
    expect(await textOf(legendIn(root)), 'the nearest element of this id is none').to.equal(nobody('a'));
    root.querySelector('p')!.remove();
    expect(await textOf(legendIn(root))).to.equal(noVolume);
  });

  for (const name of ['', 'for="v"']) {
    it(`in a shadow root below it ${name}, as long as it is there`, async () => {
      const host = addHost();
      attach(addHost(attach(host, '')), '<volume-view id="v"></volume-view>');
      document.body.insertAdjacentHTML('beforeend', `<volume-legend ${name}></volume-legend>`);
      expect(await textOf(legendIn(document))).to.equal(noVolume);
      host.remove();
      expect(await textOf(legendIn(document))).to.equal(nobody(name ? 'v' : null));
      document.body.append(host);
      expect(await textOf(legendIn(document))).to.equal(noVolume);
    });

    it(`in the shadow root of a sibling ${name}, which comes later`, async () => {
      const root = attach(addHost(), `<volume-legend ${name}></volume-legend>`);
      expect(await textOf(legendIn(root))).to.equal(nobody(name ? 'v' : null));
      attach(addHost(), '<volume-view id="v"></volume-view>');
      expect(await textOf(legendIn(root))).to.equal(noVolume);
    });
  }

  it('when it is given its id', async () => {
    const root = attach(addHost(), '<volume-view></volume-view>');
    document.body.insertAdjacentHTML('beforeend', '<volume-legend for="named"></volume-legend>');
    expect(await textOf(legendIn(document))).to.equal(nobody('named'));
    root.querySelector('volume-view')!.id = 'named';
    expect(await textOf(legendIn(document))).to.equal(noVolume);
  });

  it('is not found in a closed root from outside', async () => {
    attach(addHost(), '<volume-view></volume-view>', 'closed');
    document.body.insertAdjacentHTML('beforeend', '<volume-legend></volume-legend>');
    expect(await textOf(legendIn(document))).to.equal(nobody());
  });
});

// A second language, registered by the page: the elements speak it where `lang` names it.
import { expect } from '@esm-bundle/chai';
import '../../../components/volume-legend/define.ts';
import '../../../components/volume-slice-view/define.ts';
import '../../../components/volume-timeline/define.ts';
import '../../../components/volume-transfer-function/define.ts';
import type { VolumeLegend } from '../../../components/volume-legend/volume-legend.ts';
import type { VolumeTimeline } from '../../../components/volume-timeline/volume-timeline.ts';
import { english } from '../../../src/messages/english-companions.ts';
import { registerTranslation } from '../../../src/messages/locale-controller.ts';

registerTranslation('nl', {
  noView: (id) => (id === null ? 'Hier is geen <volume-view>.' : `Hier is geen <volume-view id="${id}">.`),
  play: 'Afspelen',
  previousScan: 'Vorige scan',
  slice: {
    axial: 'Axiale doorsnede',
    coronal: 'Coronale doorsnede',
    sagittal: 'Sagittale doorsnede',
    oblique: 'Schuine doorsnede',
  },
});

const textOf = (element: Element | null): string => element!.shadowRoot!.textContent.replace(/\s+/g, ' ').trim();
const labelsOf = (element: Element): (string | null)[] =>
  [...element.shadowRoot!.querySelectorAll('button')].map((button) => button.getAttribute('aria-label'));

/** Put HTML in the page; returns what holds it. */
async function show(html: string): Promise<HTMLElement> {
  const place = document.createElement('div');
  place.innerHTML = html;
  document.body.append(place);
  await settle(place);
  return place;
}

async function settle(place: Element): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve)); // Observers call back before it.
  await Promise.all([...place.querySelectorAll('*')].map((element) => (element as VolumeLegend).updateComplete));
}

describe('a second language', () => {
  afterEach(() => document.body.replaceChildren());

  it('is spoken where the nearest lang names it, with English for what it lacks', async () => {
    const place = await show(
      '<section lang="nl-BE"><volume-timeline></volume-timeline></section><volume-timeline lang="en"></volume-timeline>',
    );
    const [dutch, englishOne] = place.querySelectorAll<VolumeTimeline>('volume-timeline');
    expect(labelsOf(dutch)).to.deep.equal(['Vorige scan', 'Afspelen', english.nextScan]);
    expect(labelsOf(englishOne)).to.deep.equal([english.previousScan, english.play, english.nextScan]);
    expect(textOf(dutch)).to.equal('Hier is geen <volume-view>.');
    expect(dutch.shadowRoot!.querySelector('[role=group]')!.getAttribute('aria-label')).to.equal(english.time);
  });

  it('is spoken by slices too', async () => {
    const place = await show('<section lang="nl"><volume-slice-view></volume-slice-view></section>');
    const { shadowRoot } = place.querySelector('volume-slice-view')!;
    expect(shadowRoot!.querySelector('[part=picture]')!.getAttribute('aria-label')).to.equal('Axiale doorsnede');
    expect(shadowRoot!.querySelector('[part=hint]')!.textContent).to.equal('Hier is geen <volume-view>.');
    expect(shadowRoot!.querySelector('#keys')!.textContent).to.contain('Page up');
  });

  it('comes and goes with lang, also on an element far around', async () => {
    const place = await show('<section><p><volume-legend for="nobody"></volume-legend></p></section>');
    const legend = place.querySelector('volume-legend');
    const section = place.querySelector('section')!;
    expect(textOf(legend)).to.equal(english.noView('nobody'));
    section.lang = 'nl';
    await settle(place);
    expect(textOf(legend)).to.equal('Hier is geen <volume-view id="nobody">.');
    section.lang = 'en';
    await settle(place);
    expect(textOf(legend)).to.equal(english.noView('nobody'));
  });

  it('is found across shadow roots; what is no language is passed over', async () => {
    const place = await show('<section lang="nl"><div lang="no such language!"></div></section>');
    const root = place.querySelector('div')!.attachShadow({ mode: 'open' });
    root.append(document.createElement('volume-transfer-function'));
    await settle(root.host);
    await (root.firstElementChild as VolumeLegend).updateComplete;
    expect(textOf(root.firstElementChild)).to.equal('Hier is geen <volume-view>.');
  });

  it('may come late', async () => {
    const place = await show('<volume-legend lang="fi"></volume-legend>');
    expect(textOf(place.firstElementChild)).to.equal(english.noView(null));
    registerTranslation('fi', { noView: () => 'Ei tilavuutta täällä.' });
    await settle(place);
    expect(textOf(place.firstElementChild)).to.equal('Ei tilavuutta täällä.');
  });
});

describe('a language of the package', () => {
  afterEach(() => document.body.replaceChildren());

  /** Its file has come. */
  const until = async (holds: () => boolean): Promise<void> => {
    for (const end = Date.now() + 20_000; !holds() && Date.now() < end;)
      await new Promise((resolve) => setTimeout(resolve, 20));
  };

  it('comes by itself where lang names it, and goes with it', async () => {
    const place = await show('<section lang="fr-CA"><volume-legend for="nobody"></volume-legend></section>');
    const legend = place.querySelector('volume-legend');
    await until(() => textOf(legend).startsWith('Il n’y a pas'));
    expect(textOf(legend)).to.equal('Il n’y a pas de <volume-view id="nobody"> dans cette page.');
    place.querySelector('section')!.lang = 'en-GB';
    await settle(place);
    expect(textOf(legend)).to.equal(english.noView('nobody'));
    place.querySelector('section')!.lang = 'sv';
    await settle(place);
    expect(textOf(legend), 'a language that is not there').to.equal(english.noView('nobody'));
  });

  it('gives way to what the page registers, word by word', async () => {
    registerTranslation('es', { noView: () => 'Nada aquí.' });
    const place = await show('<section lang="es"><volume-timeline></volume-timeline></section>');
    const timeline = place.querySelector('volume-timeline')!;
    await until(() => labelsOf(timeline).includes('Reproducir'));
    expect(textOf(timeline)).to.equal('Nada aquí.');
    expect(labelsOf(timeline)).to.deep.equal(['Barrido anterior', 'Reproducir', 'Barrido siguiente']);
  });
});

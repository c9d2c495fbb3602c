// <volume-view> itself: its states for CSS, and its words in the language of the page.
import { expect } from '@esm-bundle/chai';
import { render } from 'lit';
import { renderError } from '../../../../components/volume-view/volume-view-parts.ts';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { VolumeView } from '../../../../components/volume-view/define.ts';
import { english } from '../../../../src/messages/english-view.ts';
import { registerTranslation } from '../../../../src/messages/locale-controller.ts';

registerTranslation('nl', {
  cameraKeys: 'Pijltjes draaien het.',
  volumePicture: 'Beeld van een volume',
  errors: {
    ...english.errors,
    attribute: 'Een instelling is onleesbaar.',
    'source/not-found': 'Het bestand ontbreekt.',
  },
});

let view: VolumeView;

beforeEach(() => {
  view = new VolumeView();
  document.body.append(view);
});

afterEach(() => document.body.replaceChildren());

const inside = (selector: string): Element => view.shadowRoot!.querySelector(selector)!;
const hasState = (name: string): boolean => view.matches(`:state(${name})`);
const eventOf = (type: string): Promise<Event> =>
  new Promise((resolve) => view.addEventListener(type, resolve, { once: true }));

describe('the states of <volume-view>', () => {
  it('are loading while a file comes, and error where it does not', async () => {
    expect([hasState('loading'), hasState('error')]).to.deep.equal([false, false]);
    const failed = eventOf('error');
    view.loading = 'eager';
    view.src = '/nowhere.nii';
    await view.updateComplete;
    await view.updateComplete;
    expect([hasState('loading'), hasState('error')]).to.deep.equal([true, false]);
    await failed;
    await view.updateComplete;
    expect([hasState('loading'), hasState('error')]).to.deep.equal([false, true]);
    view.src = null;
    await view.updateComplete;
    await view.updateComplete;
    expect(hasState('error')).to.equal(false);
  });

  it('are playing from play() to pause()', async () => {
    view.loading = 'eager';
    view.src = '/nowhere.nii /nowhere-else.nii';
    await view.updateComplete;
    view.play().catch(() => {}); // It is paused before there is anything.
    await view.updateComplete;
    expect(hasState('playing')).to.equal(true);
    view.pause();
    await view.updateComplete;
    expect(hasState('playing')).to.equal(false);
  });
});

describe('the words of <volume-view>', () => {
  it('are those of the nearest lang, and follow it', async () => {
    await view.updateComplete;
    expect([inside('.picture').ariaLabel, inside('#keys').textContent]).to.deep.equal([
      english.volumePicture,
      english.cameraKeys,
    ]);
    document.body.lang = 'nl';
    await new Promise((resolve) => setTimeout(resolve)); // Observers call back before it.
    await view.updateComplete;
    expect([inside('.picture').ariaLabel, inside('#keys').textContent]).to.deep.equal([
      'Beeld van een volume',
      'Pijltjes draaien het.',
    ]);
    document.body.lang = '';
  });

  it("say what went wrong to a reader, and in English to the page's author", async () => {
    view.lang = 'nl';
    const failed = eventOf('error');
    view.setAttribute('steps', 'lots');
    await failed;
    await view.updateComplete;
    const [headline, message] = view.shadowRoot!.querySelectorAll('.error p');
    expect(headline.textContent).to.equal('Een instelling is onleesbaar.');
    expect(message.getAttribute('lang')).to.equal('en');
    expect(message.textContent).to.match(/^steps got "lots"; expected auto, or a number from 1 to \d+\.$/);
  });

  it('of addresses say the folder and the name', () => {
    const shown = {
      'https://a.example/b/scan.nii.gz?token=x/y#z/q got 404': 'b/scan.nii.gz got 404',
      'not from https://a.example/lib/x3dom.js. Put it there': 'not from lib/x3dom.js. Put it there',
      'the file of "https://a.example/b/c.nii": x': 'the file of "b/c.nii": x',
      'file:///home/me/a.nii can not be read from https://a.example; expected':
        'me/a.nii can not be read from https://a.example; expected',
      'src got "a/b.nii"; expected a URL': 'src got "a/b.nii"; expected a URL',
    };
    for (const [message, expected] of Object.entries(shown)) {
      const place = document.createElement('div');
      render(
        renderError(new VolumeViewError('source/not-found', message), english, () => {}),
        place,
      );
      expect(place.querySelectorAll('p')[1].textContent).to.equal(expected);
    }
  });
});

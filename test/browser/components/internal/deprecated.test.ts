// Old names of attributes go on working, with one line on the console each.
import { expect } from '@esm-bundle/chai';
import { oldAttributes } from '../../../../components/internal/deprecated.ts';
import { VolumeViewAttributes } from '../../../../components/volume-view/volume-view-attributes.ts';

class OldView extends VolumeViewAttributes {}
customElements.define('old-view', OldView);

/** What the console is told while something is done. */
function listen(act: () => void): string[] {
  const lines: string[] = [];
  const { warn } = console;
  console.warn = (...words: unknown[]) => void lines.push(words.join(' '));
  act();
  console.warn = warn;
  return lines;
}

function create(html: string): OldView {
  const place = document.createElement('div');
  document.body.append(place);
  place.innerHTML = `<old-view ${html}></old-view>`;
  return place.firstElementChild as OldView;
}

const cases: Record<
  string,
  { text: string; property: keyof OldView; value: unknown; present: string; text2: string | null }
> = {
  window: { text: '0 80', property: 'valueWindow', value: [0, 80], present: 'value-window', text2: '5 9' },
  play: { text: '', property: 'autoplay', value: true, present: 'autoplay', text2: null },
  'camera-controls': { text: ' Off ', property: 'interaction', value: 'none', present: 'interaction', text2: 'auto' },
};

describe('an old attribute', () => {
  afterEach(() => document.body.replaceChildren());

  it('is in this test', () => expect(oldAttributes).to.have.members(Object.keys(cases)));

  for (const [old, { text, property, value, present, text2 }] of Object.entries(cases)) {
    it(`${old} is read, and reported once; ${present} wins`, async () => {
      let views: OldView[] = [];
      const lines = listen(() => {
        views = [create(`${old}="${text}"`), create(`${old}="${text}"`)];
        views[1].setAttribute(old, `${text} `);
      });
      expect(lines).to.have.length(1);
      expect(lines[0]).to.match(
        new RegExp(`^<volume-view>: the attribute ${old} is an old name; write ${present}.*\\.$`),
      );
      const [view] = views;
      expect(view[property]).to.deep.equal(value);
      await view.updateComplete;
      if (text2 === null) return; // A flag says the same under either name.
      view.setAttribute(present, text2);
      expect(view[property]).to.not.deep.equal(value);
      view.removeAttribute(present);
      expect(view[property]).to.deep.equal(value);
    });

    it(`${old} is an update of ${property}, and goes when that is set`, async () => {
      const view = create('');
      await view.updateComplete;
      let changed: PropertyKey[] = [];
      Object.assign(view, { updated: (changes: Map<PropertyKey, unknown>) => (changed = [...changes.keys()]) });
      view.setAttribute(old, text);
      await view.updateComplete;
      expect(changed).to.deep.equal([property]);
      Object.assign(view, { [property]: null });
      expect([view.hasAttribute(old), view.hasAttribute(present), view[property] || null]).to.deep.equal([
        false,
        false,
        null,
      ]);
    });
  }

  it('camera-controls says nothing where it is not off', () => {
    expect(create('camera-controls').interaction).to.equal(null);
    expect(create('camera-controls="on"').interaction).to.equal(null);
  });
});

// What can happen to an element of a page. Each step is given the walk: its dice, the page's places, and an element.
const data = '/test/e2e/pages/data';
export const good = `${data}/field.nii.gz`;

/** An element as every check of the walk has it. */
export const plain = {
  src: good,
  'transfer-function': '0.15 #003 0, 0.4 #c63 4%, 0.8 #ffc 0.3',
  'reference-length': '1',
  'camera-orbit': '35deg 65deg 90',
  'camera-target': '0 0 0',
  'field-of-view': '32deg',
  steps: '40',
};

const valid = {
  src: [`${data}/ball.nii`, `${data}/field.nii`, `${data}/field.json`, `${data}/field.nii ${data}/ball.nii`],
  'camera-orbit': ['10deg 20deg 120%', 'auto auto auto', '1e300deg 0deg 50%'],
  steps: ['auto', '10', '90'],
  projection: ['max', 'average', ''],
  'opacity-factor': ['0', '2.5'],
  region: ['-5 -5 -5 5 5 5', ''],
  'play-speed': ['1e-7', '1e9', '3'],
  interaction: ['none', 'auto'],
  loading: ['eager', 'lazy'],
  autoplay: [''],
  'max-error': ['4'],
};
const invalid = {
  src: ['data:,garbage', 'data:application/octet-stream;base64,AAAA', 'data:application/json,{}', ''],
  'camera-orbit': ['left', '1e999deg 0deg 1', '1 2'],
  'transfer-function': ['0.1 whit', 'no-preset', '0,0,0,0'],
  steps: ['-3', 'many'],
  region: ['1', 'NaN NaN NaN 1 1 1'],
  'play-speed': ['0', '-1', 'NaN'],
  projection: ['sideways'],
  'field-of-view': ['0deg', '1e-320deg', 'wide'],
  time: ['-1', 'yesterday'],
};

const shape =
  '<transform translation="2 0 0"><shape><appearance><material diffusecolor="1 0 0"></material></appearance><box size="5 5 40"></box></shape></transform>';
const clock = '<timesensor cycleinterval="1" loop="true"></timesensor>';
const viewpoint = '<viewpoint position="0 0 90" fieldofview="0.6"></viewpoint>';

function setOne(values, { pick, element }) {
  const name = pick(Object.keys(values));
  element.setAttribute(name, pick(values[name]));
}

export const steps = {
  'a good source': ({ element, pick }) => (element.src = pick([good, ...valid.src])),
  'a broken source': ({ element, pick }) => (element.src = pick(invalid.src)),
  'a source that stalls': ({ element, counts, count }) => {
    counts.deaf = 1;
    element.src = `${good}?stalled=${count}`;
  },
  'a worker is killed': ({ counts, pick }) => pick([...counts.busy])?.terminate(),
  'a valid attribute': (walk) => setOne(valid, walk),
  'an attribute that is wrong': (walk) => setOne(invalid, walk),
  'an attribute is gone': ({ element, pick }) => element.removeAttribute(pick(Object.keys(plain))),
  removed: ({ element }) => element.remove(),
  'removed and put back': ({ element, places }) => (element.remove(), places.body.append(element)),
  moved: ({ element, places }) => places.body.prepend(element),
  'into a frame': ({ element, places }) => places.frame().append(element),
  'the frame is removed': ({ places }) => places.dropFrame(),
  'into a dialog': ({ element, places, pick }) => {
    places.dialog.append(element);
    places.dialog.close();
    if (pick([true, false])) places.dialog.showModal();
  },
  'into details': ({ element, places, pick }) => {
    places.details.append(element);
    places.details.open = pick([true, false]);
  },
  'into a shadow root': ({ element, places }) => places.shadow.append(element),
  hidden: ({ element, pick }) => (element.hidden = pick([true, false])),
  'of no size': ({ element, pick }) => (element.style.width = pick(['0', '', '33px'])),
  'its context is lost': ({ element }) => {
    const canvas = element.shadowRoot?.querySelector('x3d canvas');
    const gl = canvas && (canvas.getContext('webgl2') ?? canvas.getContext('webgl'));
    gl?.getExtension('WEBGL_lose_context')?.loseContext();
  },
  'other pixels': ({ pick, element }) => {
    const ratio = pick([1, 1.5, 2]);
    Object.defineProperty(window, 'devicePixelRatio', { configurable: true, get: () => ratio });
    element.style.height = pick(['44px', '']);
  },
  'the page is put away and comes back': () => {
    for (const type of ['pagehide', 'pageshow'])
      window.dispatchEvent(new PageTransitionEvent(type, { persisted: true }));
  },
  'a picture is asked for': ({ element, ask }) => ask(element.toBlob({ width: 20 })),
  'it is waited for': ({ element, ask }) => ask(element.whenRendered()),
  'it is drawn': ({ element, ask }) => ask(element.redraw()),
  'it plays': ({ element, ask }) => ask(element.play()),
  'it pauses': ({ element }) => element.pause(),
  'the next scan': ({ element }) => element.next(),
  'a shape comes': ({ element, pick }) => element.insertAdjacentHTML('beforeend', pick([shape, clock, viewpoint])),
  'a shape goes': ({ element }) => element.lastElementChild?.remove(),
  'a shape moves': ({ element, pick }) =>
    element.querySelector('transform')?.setAttribute('translation', pick(['4 0 0', '0 4 0'])),
  keys: ({ element, pick }) =>
    element.shadowRoot
      ?.querySelector('.picture')
      ?.dispatchEvent(new KeyboardEvent('keydown', { key: pick(['ArrowLeft', '+', '-', 'Home']) })),
};

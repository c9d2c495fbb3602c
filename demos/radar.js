// The controls set attributes of <volume-view> and of its slices; the companions follow the volume by themselves.
const find = (selector) => document.querySelector(selector);
const view = find('volume-view');
const legend = find('volume-legend');
const moments = find('#moments .buttons');
const storm = {
  src: { DBZH: 'data/storm-radar.json', VRADH: 'data/storm-radar-velocity.json' },
  words: { DBZH: 'Reflectivity', VRADH: 'Radial velocity' },
};

/** The region of the supercell on its way: metres east, north and above the antenna. */
const supercell = '-60000 -100000 0 25000 -25000 16000';

/** The synthetic storm's echoes fill only a part of what is scanned. */
const stormView = { cameraTarget: view.cameraTarget, cameraOrbit: view.cameraOrbit };
const wholeView = { cameraTarget: null, cameraOrbit: '200deg 62deg 80%' };

/** blob: URLs of the files that are open. */
let opened = [];

/** Each moment has its own defaults; edits for another moment do not suit it. */
function forgetLook() {
  Object.assign(view, { transferFunction: null, lightFactor: null, window: null });
  showVolume();
}

function showVolume() {
  view.opacityFactor = find('#volume').checked ? null : '0';
}

function showMoment(moment) {
  forgetLook();
  if (opened.length > 0) view.moment = moment;
  else view.src = storm.src[moment];
  legend.label = opened.length > 0 ? moment : storm.words[moment];
}

/** Radio buttons for the moments that there are. */
function listMoments(list, chosen) {
  const known = [...moments.querySelectorAll('input')].map(({ value }) => value);
  if (known.join() !== list.join()) {
    moments.replaceChildren(
      ...list.map((moment) => {
        const label = Object.assign(document.createElement('label'), { className: 'choice' });
        const input = Object.assign(document.createElement('input'), { type: 'radio', name: 'moment', value: moment });
        const words = Object.assign(document.createElement('span'), {
          textContent: opened.length > 0 ? moment : storm.words[moment],
        });
        label.append(input, words);
        return label;
      }),
    );
  }
  for (const input of moments.querySelectorAll('input')) input.checked = input.value === chosen;
}

function forgetFiles() {
  for (const url of opened) URL.revokeObjectURL(url.replace(/#.*/, ''));
  opened = [];
}

/** Several files are scans of one radar, in the order of their names. */
function openFiles(files) {
  if (files.length === 0) return;
  forgetFiles();
  const sorted = [...files];
  sorted.sort((a, b) => a.name.localeCompare(b.name, 'en', { numeric: true }));
  // Messages name a blob: URL by its fragment.
  opened = sorted.map((file) => `${URL.createObjectURL(file)}#${encodeURIComponent(file.name)}`);
  forgetLook();
  find('#region').checked = false;
  find('#zoomed').hidden = true;
  view.pause();
  Object.assign(view, {
    ...wholeView,
    region: null,
    rings: find('#rings').checked ? '' : 'none',
    time: null,
    moment: null,
    src: opened.join(' '),
    alt: `Radar scan, ${sorted[0].name}`,
  });
  legend.label = null;
  find('#back').hidden = false;
  find('#what').textContent = sorted.map(({ name }) => name).join(', ');
}

function closeFiles() {
  forgetFiles();
  find('#file').value = '';
  find('#back').hidden = true;
  find('#zoomed').hidden = false;
  find('#what').textContent = '';
  view.pause();
  Object.assign(view, {
    ...stormView,
    moment: null,
    time: null,
    rings: find('#rings').checked ? '50' : 'none',
    alt: 'Thunderstorms on radar, synthetic',
  });
  listMoments(['DBZH', 'VRADH'], 'DBZH');
  showMoment('DBZH');
}

view.addEventListener('load', ({ detail }) => {
  if (opened.length === 0) return;
  if (detail.moments) listMoments([...detail.moments], detail.moment);
  legend.label = detail.moment ?? null;
  const place = [detail.site?.name, detail.time?.replace('T', ' ').replace('Z', ' UTC')].filter(Boolean).join(', ');
  find('#what').textContent = [`${detail.format}${place ? `: ${place}` : ''}.`, detail.partial]
    .filter(Boolean)
    .join(' ');
});

moments.addEventListener('change', ({ target }) => {
  if (opened.length === 0) view.time = view.scan?.time ?? null; // The other quantity of the same scan.
  showMoment(target.value);
});
find('#file').addEventListener('change', ({ target }) => openFiles([...target.files]));
find('#back').addEventListener('click', closeFiles);
find('#volume').addEventListener('change', showVolume);
find('#rings').addEventListener(
  'change',
  ({ target }) => (view.rings = target.checked ? (opened.length > 0 ? '' : '50') : 'none'),
);
find('#region').addEventListener('change', ({ target: { checked } }) => {
  Object.assign(view, {
    region: checked ? supercell : null,
    ...(checked ? { ...wholeView, cameraOrbit: '200deg 62deg 105%' } : stormView),
  });
});

const exaggeration = find('#exaggeration');
const sayTimes = () => (find('#times').textContent = `${exaggeration.value} times as large`);
exaggeration.addEventListener('input', sayTimes);
exaggeration.addEventListener('change', () => (view.verticalExaggeration = exaggeration.value));
sayTimes();

const units = {
  elevation: (value) => `${value.toFixed(1)}°`,
  height: (value) => `${(value / 1000).toFixed(2)} km`,
  azimuth: (value) => `${value}°`,
};
for (const input of document.querySelectorAll('[data-of]')) {
  const slice = find(`volume-slice[type=${input.dataset.of}]`);
  const box = find(`[data-slice=${input.dataset.of}]`);
  const say = () => {
    const text = units[input.name](Number(input.value));
    input.nextElementSibling.textContent = text;
    input.setAttribute('aria-valuetext', text);
  };
  input.addEventListener('input', () => {
    slice.setAttribute(input.name, input.value);
    say();
  });
  box.addEventListener('change', () => {
    slice.hidden = !box.checked;
    input.disabled = !box.checked;
  });
  input.disabled = !box.checked;
  say();
}

// The section's two points are written in kilometres; the attributes are in metres.
const section = find('volume-slice[type=section]');
const sectionBox = find('[data-slice=section]');
const points = [...document.querySelectorAll('[data-end]')];
const showSection = () => {
  for (const end of ['from', 'to']) {
    section.setAttribute(
      end,
      points
        .filter(({ dataset }) => dataset.end === end)
        .map(({ valueAsNumber }) => valueAsNumber * 1000)
        .join(' '),
    );
  }
};
const enableSection = () => {
  section.hidden = !sectionBox.checked;
  for (const input of points) input.disabled = !sectionBox.checked;
};
for (const input of points)
  input.addEventListener('change', () => input.checkValidity() && input.value !== '' && showSection());
sectionBox.addEventListener('change', enableSection);
enableSection();

addEventListener('dragover', (event) => {
  event.preventDefault();
  document.body.classList.add('dropping');
});
addEventListener('dragleave', ({ relatedTarget }) => {
  if (!relatedTarget) document.body.classList.remove('dropping');
});
addEventListener('drop', (event) => {
  event.preventDefault();
  document.body.classList.remove('dropping');
  openFiles([...event.dataTransfer.files]);
});

listMoments(['DBZH', 'VRADH'], 'DBZH');
legend.label = storm.words.DBZH;

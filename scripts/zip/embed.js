// embed.html?src=scan.nii.gz&alt=Brain&controls: a page with one volume, for an <iframe>. Attributes come from its address, but only those
// in this list, as the address may be written by anybody.
(() => {
  const attributes = [
    'src',
    'stack',
    'mosaic',
    'slices',
    'spacing',
    'coordinates',
    'elevations',
    'range',
    'azimuth',
    'moment',
    'color-moment',
    'beam-model',
    'max-bytes',
    'series',
    'vertical-exaggeration',
    'clean',
    'time',
    'autoplay',
    'play-speed',
    'look',
    'transfer-function',
    'projection',
    'shading',
    'surface-values',
    'gradient-opacity',
    'transfer-function-2d',
    'value-window',
    'reference-length',
    'opacity-factor',
    'light-factor',
    'steps',
    'max-error',
    'detail',
    'target-fps',
    'region',
    'cutout',
    'rings',
    'camera-orbit',
    'camera-target',
    'field-of-view',
    'min-camera-orbit',
    'max-camera-orbit',
    'interpolation-decay',
    'auto-rotate',
    'auto-rotate-delay',
    'rotation-per-second',
    'orientation-marker',
    'interaction',
    'controls',
    'controlslist',
    'self-check',
    'alt',
    'loading',
  ];
  /** Companions below the picture, where their names are in the address. */
  const companions = { legend: 'volume-legend', timeline: 'volume-timeline' };

  const given = new URLSearchParams(location.search);
  const main = document.querySelector('main');
  const add = (name) => main.appendChild(document.createElement(name));
  if (!given.get('src')) {
    add('h1').textContent = 'No volume';
    add('p').textContent = 'This page shows a volume; its address has to name one: embed.html?src=scan.nii.gz';
    return;
  }
  const view = document.createElement('volume-view');
  for (const name of attributes) if (given.has(name)) view.setAttribute(name, given.get(name));
  main.append(view);
  // Authors of the iframe may expect addresses relative to the page around it; but they are relative to this page.
  view.addEventListener('error', ({ detail }) => {
    const src = given.get('src').trim();
    if (detail?.code !== 'source/not-found' || /^(\w+:|\/)/.test(src) || main.querySelector('.hint')) return;
    const hint = add('p');
    hint.className = 'hint';
    hint.textContent = `Addresses count from the folder of this page, ${new URL('.', location.href).pathname}. If the file is in the folder above it, write src=${src
      .split(/\s+/)
      .map((one) => `../${one}`)
      .join('%20')}`;
  });
  document.title = given.get('alt') || document.title;
  if (given.has('lang')) document.documentElement.lang = given.get('lang').slice(0, 35);
  for (const [name, element] of Object.entries(companions)) if (given.has(name)) add(element);
})();

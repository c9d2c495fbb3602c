// What the element gets for each projection, and what is to be seen then.
const looks = {
  all: {
    attributes: { 'transfer-function': 'ct-soft-tissue' },
    words: 'Without the attribute: all that lies on a ray shines, and hides what is behind it.',
  },
  max: {
    attributes: { projection: 'max', 'transfer-function': 'gray', 'value-window': '0 700' },
    words: 'The densest of each ray: bones, in front and behind. So radiologists look at vessels with contrast medium.',
  },
  min: {
    attributes: {
      projection: 'min',
      'transfer-function': 'gray',
      'value-window': '-1000 100',
      region: '-174 -15 -174 174 25 174',
    },
    words: 'The thinnest of each ray, in a slab of 4 cm: lungs, windpipe, and where it forks.',
  },
  average: {
    attributes: { projection: 'average', 'transfer-function': 'gray', 'value-window': '-700 -100' },
    words: 'The mean of each ray: much like an X-ray, with the air in the stomach as a dark disc.',
  },
};

const view = document.querySelector('#torso');
const names = new Set(Object.values(looks).flatMap(({ attributes }) => Object.keys(attributes)));

function show({ attributes, words }) {
  for (const name of names) {
    if (attributes[name] === undefined) view.removeAttribute(name);
    else view.setAttribute(name, attributes[name]);
  }
  document.querySelector('#words').textContent = words;
  document.querySelector('#markup').textContent = Object.entries(attributes)
    .map(([name, value]) => `${name}="${value}"`)
    .join('\n');
}

document.querySelector('fieldset').addEventListener('change', ({ target }) => show(looks[target.value]));
show(looks[document.querySelector('fieldset :checked').value]);

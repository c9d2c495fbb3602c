// What is seen, and what an author writes for it.
const torso = { src: 'data/ct-phantom.json', 'camera-orbit': '25deg 80deg 105%' };
const brain = { src: 'data/mni152-t1.nii.gz' };
const looks = {
  bones: { ...torso, 'surface-values': '-300 #d9a98c 25%, 250 #f3e6cc' },
  tissue: { ...torso, 'surface-values': '250 #f3e6cc', 'transfer-function': 'ct-soft-tissue' },
  brain: { ...brain, 'surface-values': '38% #e2b9a6', 'camera-orbit': '65deg 75deg 82%' },
  white: { ...brain, 'surface-values': '35% #d8a48f 30%, 72% #fff4e0', 'camera-orbit': '120deg 65deg 90%' },
  storm: {
    src: 'data/storm-synthetic.json',
    'surface-values': '20 #3fa7ff 25%, 35 #ffd23f 40%, 50 #ff3b30',
    'camera-orbit': '30deg 55deg 85%',
  },
};

const view = document.querySelector('#seen');

function show(name) {
  const look = looks[name];
  for (const attribute of ['src', 'transfer-function', 'surface-values', 'camera-orbit']) {
    if (attribute in look) view.setAttribute(attribute, look[attribute]);
    else view.removeAttribute(attribute);
  }
  const written = ['transfer-function', 'surface-values']
    .filter((attribute) => attribute in look)
    .map((attribute) => `\n             ${attribute}="${look[attribute]}"`);
  document.querySelector('#code').textContent =
    `<volume-view src="${look.src.replace('data/', '')}"${written.join('')}></volume-view>`;
}

document.querySelector('fieldset').addEventListener('change', ({ target }) => show(target.value));
show(document.querySelector('fieldset :checked').value);

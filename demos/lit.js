// What is seen, lit and unlit, and one camera for both.
const looks = {
  head: {
    src: 'data/colin27-t1.nii.gz',
    'transfer-function': '38 #5a3028 0, 52 #c08068 75%, 80 #e3b8a0 90%, 120 #fff2e6 95%',
    cutout: '-120 -20 10 0 120 120',
    'camera-orbit': '35deg 66deg 92%',
  },
  brain: {
    src: 'data/mni152-t1.nii.gz',
    'transfer-function': '0% #d8a48f 0, 33% #d8a48f 0, 40% #e2b9a6 60%, 100% #f4e4d8 90%',
    'camera-orbit': '65deg 75deg 82%',
  },
  bones: {
    src: 'data/ct-phantom.json',
    'transfer-function': '150 #d9b88a 0, 250 #e6cfa5 50%, 700 #fff6e5 90%',
    'camera-orbit': '25deg 80deg 105%',
  },
  vessels: { src: 'data/ct-phantom.json', 'transfer-function': 'ct-angio', 'camera-orbit': '25deg 80deg 95%' },
};

const views = ['#lit', '#unlit'].map((selector) => document.querySelector(selector));

function show(name) {
  for (const view of views) {
    view.toggleAttribute('cutout', false);
    for (const [attribute, value] of Object.entries(looks[name])) view.setAttribute(attribute, value);
  }
}

for (const [i, view] of views.entries()) {
  view.addEventListener('camera-change', ({ detail: { orbit } }) => {
    views[1 - i].cameraOrbit = `${orbit.theta}rad ${orbit.phi}rad ${orbit.radius}`;
  });
}

document.querySelector('fieldset').addEventListener('change', ({ target }) => show(target.value));
show(document.querySelector('fieldset :checked').value);

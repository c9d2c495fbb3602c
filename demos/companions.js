// The radio buttons change attributes; editor and legend follow the volume by themselves.
const view = document.querySelector('volume-view');
const editor = document.querySelector('volume-transfer-function');
const legend = document.querySelector('volume-legend');

// By value and gradient each volume begins with some boxes; by value alone there are none.
function startPlane() {
  const { dataset } = document.querySelector('[name="volume"]:checked');
  view.transferFunction2d = editor.mode === '2d' ? dataset.plane : null;
}

for (const input of document.querySelectorAll('[name="volume"]')) {
  input.addEventListener('change', () => {
    legend.label = input.dataset.label;
    Object.assign(view, { src: input.value, alt: input.nextSibling.textContent });
    // Each begins with what suits it.
    Object.assign(view, { transferFunction: null, opacityFactor: null, lightFactor: null });
    startPlane();
  });
}
for (const input of document.querySelectorAll('[name="mode"]')) {
  input.addEventListener('change', () => {
    editor.mode = input.value;
    startPlane();
  });
}
// A browser that goes back to this page leaves the buttons as they were.
for (const input of document.querySelectorAll('input:checked')) input.dispatchEvent(new Event('change'));

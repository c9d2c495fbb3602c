// The radio buttons change attributes; editor and legend follow the volume by themselves.
const view = document.querySelector('volume-view');
const editor = document.querySelector('volume-transfer-function');
const legend = document.querySelector('volume-legend');

for (const input of document.querySelectorAll('[name="volume"]')) {
  input.addEventListener('change', () => {
    legend.label = input.dataset.label;
    Object.assign(view, { src: input.value, alt: input.nextSibling.textContent });
    // Each begins with what suits it.
    Object.assign(view, { transferFunction: null, opacityFactor: null, lightFactor: null });
  });
}
for (const input of document.querySelectorAll('[name="mode"]')) {
  input.addEventListener('change', () => (editor.mode = input.value));
}
// A browser that goes back to this page leaves the buttons as they were.
for (const input of document.querySelectorAll('input:checked')) input.dispatchEvent(new Event('change'));

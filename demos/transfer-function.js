// The field's text becomes the attribute; a mistake is named beside the field, and by the element itself.
const view = document.querySelector('volume-view');
const field = document.querySelector('textarea');
const message = document.querySelector('.message');
const volumes = document.querySelector('select');

function say(text, isBad) {
  message.textContent = text;
  message.classList.toggle('bad', isBad);
  field.setAttribute('aria-invalid', String(isBad));
}

async function apply() {
  const text = field.value;
  view.transferFunction = text;
  try {
    await view.whenRendered();
    if (text === field.value) say(`${text.split(/,(?![^(]*\))/).length} stops, applied.`, false);
  } catch (error) {
    if (text === field.value) say(`${error.message} (${error.code})`, true);
  }
}

function choose() {
  const option = volumes.selectedOptions[0];
  for (const button of document.querySelectorAll('[data-for]')) button.hidden = button.dataset.for !== option.value;
  view.alt = option.textContent;
  view.src = option.value;
  document.querySelector('[data-for]:not([hidden])').click();
}

for (const button of document.querySelectorAll('[data-for]')) {
  button.addEventListener('click', () => {
    field.value = button.dataset.stops
      .split(/,(?![^(]*\))/)
      .map((stop) => stop.trim())
      .join(',\n');
    void apply();
  });
}
document
  .querySelector('#boundaries')
  .addEventListener('change', ({ target }) => (view.gradientOpacity = target.checked ? target.value : null));
field.addEventListener('input', () => void apply());
volumes.addEventListener('change', choose);
choose();

// Shows those channels whose boxes are checked; one at least.
const view = document.querySelector('#cells');
const boxes = [...document.querySelectorAll('#channels input')];
const [file] = view.getAttribute('src').split('#');

document.querySelector('#channels').addEventListener('change', ({ target }) => {
  if (!boxes.some(({ checked }) => checked)) target.checked = true;
  const asked = boxes
    .filter(({ checked }) => checked)
    .map(({ value }) => value)
    .join();
  view.setAttribute('src', `${file}#channels=${asked}`);
  document.querySelector('#asked').textContent = asked;
});

// Taking the elements out of the page gives their WebGL contexts back; putting them in again shows the same pictures.
const home = document.querySelector('.many');
const views = [...home.querySelectorAll('figure')];
const button = document.querySelector('#take-out');
const message = document.querySelector('.message');

button.addEventListener('click', () => {
  const isIn = home.childElementCount > 0;
  if (isIn) home.replaceChildren();
  else home.append(...views);
  button.textContent = isIn ? 'Put them back' : 'Take them out';
  message.textContent = isIn ? 'Eight elements are out of the page and hold no WebGL context.' : 'Eight elements are back.';
});

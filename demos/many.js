// Removing the elements from the page releases their WebGL contexts; putting them back shows the same pictures.
const home = document.querySelector('.many');
const views = [...home.querySelectorAll('figure')];
const button = document.querySelector('#take-out');
const message = document.querySelector('.message');

button.addEventListener('click', () => {
  const isIn = home.childElementCount > 0;
  if (isIn) home.replaceChildren();
  else home.append(...views);
  button.textContent = isIn ? 'Put them back' : 'Remove them';
  message.textContent = isIn
    ? 'The eight elements are not in the page now and hold no WebGL context.'
    : 'The eight elements are back.';
});

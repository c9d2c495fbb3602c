// Each group of radio buttons sets the transfer function of the element beside it.
for (const group of document.querySelectorAll('.beside')) {
  const view = group.querySelector('volume-view');
  const markup = group.querySelector('code');
  group.addEventListener('change', ({ target }) => {
    view.transferFunction = target.value;
    markup.textContent = `transfer-function="${target.value}"`;
  });
}

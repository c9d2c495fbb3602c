// What the demo pages share: the element itself, and a button that copies each block marked `copyable`.
import '../src/index.ts';

for (const block of document.querySelectorAll('.copyable')) {
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = 'Copy';
  button.addEventListener('click', () => {
    navigator.clipboard.writeText(block.querySelector('pre').textContent.trim()).then(
      () => say('Copied'),
      () => say('Select it to copy'),
    );
  });
  const say = (text) => {
    button.textContent = text;
    setTimeout(() => (button.textContent = 'Copy'), 2000);
  };
  block.append(button);
}

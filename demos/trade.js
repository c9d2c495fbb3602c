// The number of steps along the longest ray, and what the element says about each frame.
const view = document.querySelector('volume-view');
const cells = document.querySelectorAll('[data-stat]');
const rows = document.querySelector('#measured');
const number = new Intl.NumberFormat('en', { maximumFractionDigits: 2 });

const words = {
  steps: (stats) => number.format(stats.steps),
  stepLength: (stats) => `${number.format(stats.stepLength)} mm`,
  rays: (stats) => (stats.rays === 1 ? 'one per pixel' : `${Math.round(100 * stats.rays)} % of the pixels, about`),
  samples: (stats) => `${number.format(stats.samples / 1e6)} million`,
  frameMs: (stats) => `${number.format(stats.frameMs)} ms`,
  size: (stats) => `${stats.width} × ${stats.height} pixels`,
  error: ({ error }) => (error ? `${number.format(error.rms)} / 255` : '–'),
  converged: (stats) => (stats.converged ? 'yes' : 'no'),
};

view.addEventListener('render', ({ detail }) => {
  for (const cell of cells) cell.textContent = words[cell.dataset.stat](detail);
});

const buttons = document.querySelectorAll('[data-steps]');
for (const button of buttons) {
  button.addEventListener('click', () => {
    for (const other of buttons) other.setAttribute('aria-pressed', String(other === button));
    view.steps = button.dataset.steps;
  });
}

document.querySelector('#measure').addEventListener('click', ({ currentTarget }) => void measure(currentTarget));

/** Five forced frames for each number of steps; the median counts. */
async function measure(button) {
  button.disabled = true;
  const before = view.steps;
  rows.replaceChildren();
  try {
    for (const { dataset } of buttons) {
      view.steps = dataset.steps;
      await view.whenRendered();
      const frames = [];
      for (let i = 0; i < 5; i++) frames.push(await view.redraw());
      const times = frames.map((frame) => frame.frameMs).toSorted((a, b) => a - b);
      const row = document.createElement('tr');
      for (const text of [
        `${frames[0].steps}${dataset.steps === 'auto' ? ' (auto)' : ''}`,
        `${number.format(times[2])} ms`,
        number.format(1000 / times[2]),
      ]) {
        row.append(Object.assign(document.createElement('td'), { textContent: text }));
      }
      rows.append(row);
    }
  } finally {
    view.steps = before;
    button.disabled = false;
  }
}

document.querySelector('#check').addEventListener('click', ({ currentTarget }) => void check(currentTarget));

/** Say how far the graphics processor is from the main one. */
async function check(button) {
  button.disabled = true;
  try {
    const result = await view.checkPicture();
    document.querySelector('#checked').textContent = result
      ? tell(result)
      : 'This device can not draw what is needed to check it.';
  } finally {
    button.disabled = false;
  }
}

function tell({ rays, off, max, agrees }) {
  const difference = `the largest difference of ${rays} rays is ${number.format(max)} of 255`;
  return agrees ? `It is: ${difference}.` : `It is not: ${off} are off, ${difference}.`;
}

// The transfer function of the paper, tf.png: 255 texels of colour and opacity, written as the stops of ours.
import { decode } from 'fast-png';

const folder = '/shared-data/medical/aorta_mosaic';
const view = document.querySelector('volume-view');
const absent = document.querySelector('#absent');

/** Opacity of a texel of opacity 1, per reference length. */
const share = 0.12;

/** Stops `value colour opacity` from one row of RGBA; texel i stands for the values around i + 0.5. */
function writeStops({ data, width }) {
  return Array.from({ length: width }, (_, i) => {
    const [r, g, b, a] = data.subarray(i * 4, i * 4 + 4);
    const value = (((i + 0.5) * 255) / width).toFixed(2);
    return `${value} rgb(${r} ${g} ${b}) ${((a / 255) * share).toFixed(5)}`;
  }).join(', ');
}

async function start() {
  const response = await fetch(`${folder}/tf.png`);
  if (!response.ok) {
    absent.hidden = false;
    document.querySelector('#present').hidden = true;
    return;
  }
  const stops = writeStops(decode(await response.arrayBuffer()));
  view.transferFunction = stops;
  view.src = `${folder}/aorta4096.png`;
  document.querySelector('#stops').textContent = `${stops.split(', ').slice(60, 66).join(',\n')},\n…`;
  for (const input of document.querySelectorAll('[name="function"]')) {
    input.addEventListener('change', () => (view.transferFunction = input.value === 'paper' ? stops : null));
  }
}

void start();

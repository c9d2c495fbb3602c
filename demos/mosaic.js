// Two elements, one camera: whichever is turned takes the other along. And a check that they show the same.
const views = [...document.querySelectorAll('volume-view')];

for (const view of views) {
  view.addEventListener('camera-change', ({ detail: { orbit } }) => {
    for (const other of views) {
      if (other !== view) other.cameraOrbit = `${orbit.theta}rad ${orbit.phi}rad ${orbit.radius}`;
    }
  });
}

/** The element's picture on black, as pixels. */
async function readPicture(view) {
  const bitmap = await createImageBitmap(await view.toBlob({ width: 400, height: 300 }));
  const canvas = new OffscreenCanvas(400, 300).getContext('2d');
  canvas.fillRect(0, 0, 400, 300);
  canvas.drawImage(bitmap, 0, 0);
  return canvas.getImageData(0, 0, 400, 300).data;
}

const result = document.querySelector('#result');
document.querySelector('#compare').addEventListener('click', () => void compare());

async function compare() {
  result.textContent = 'Comparing …';
  try {
    const [a, b] = await Promise.all(views.map(readPicture));
    let largest = 0;
    for (let i = 0; i < a.length; i++) largest = Math.max(largest, Math.abs(a[i] - b[i]));
    result.textContent = `400 × 300 pixels compared. Largest difference in any channel: ${largest} of 255.`;
  } catch (error) {
    result.textContent = error.message;
  }
}

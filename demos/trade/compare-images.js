// How far two pictures of the same size are apart.

/**
 * Root mean square and largest difference, in 1/255, over the pixels where one of the two shows something, and the difference as a picture.
 * @param {ImageData} picture
 * @param {ImageData} exact
 * @param {readonly number[]} background - red, green, blue, 0..255
 * @param {number} amplification - of the difference that is shown
 */
export function compareImages(picture, exact, background, amplification) {
  const difference = new ImageData(exact.width, exact.height);
  let sum = 0;
  let max = 0;
  let shown = 0;
  for (let at = 0; at < exact.data.length; at += 4) {
    difference.data[at + 3] = 255;
    const isEmpty = background.every(
      (channel, i) => picture.data[at + i] === channel && exact.data[at + i] === channel,
    );
    if (isEmpty) continue;
    shown++;
    for (let i = 0; i < 3; i++) {
      const apart = Math.abs(picture.data[at + i] - exact.data[at + i]);
      difference.data[at + i] = amplification * apart; // Clamped to 255.
      sum += apart ** 2;
      max = Math.max(max, apart);
    }
  }
  return { rms: shown ? Math.sqrt(sum / (3 * shown)) : 0, max, difference };
}

/** The pixels of an element's picture, before an opaque background. @param {*} view @param {readonly number[]} background */
export async function readPicture(view, background) {
  const bitmap = await createImageBitmap(await view.toBlob());
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('The browser gives no canvas to read the picture from.');
  context.fillStyle = `rgb(${background.join(' ')})`;
  context.fillRect(0, 0, bitmap.width, bitmap.height);
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

/**
 * Runs in a page: paints pictures with their names, side by side.
 * @param {{ cells: readonly { picture: string, name: string }[], columns: number, cell: [number, number] }} sheet
 */
export async function paintSheet({ cells, columns, cell: [w, h] }) {
  const caption = 22;
  const rows = Math.ceil(cells.length / columns);
  const canvas = Object.assign(document.createElement('canvas'), {
    width: columns * (w + 6) - 6,
    height: rows * (h + caption),
  });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.fillStyle = '#fff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.font = '13px system-ui, sans-serif';
  context.fillStyle = '#222';
  for (const [i, { picture, name }] of cells.entries()) {
    if (picture === '') continue; // This place stays empty.
    const image = new Image();
    image.src = `data:image/png;base64,${picture}`;
    await image.decode();
    const [x, y] = [(i % columns) * (w + 6), Math.floor(i / columns) * (h + caption)];
    context.drawImage(image, x, y, w, h);
    context.fillText(name, x + 4, y + h + 15);
  }
  return canvas.toDataURL('image/webp', 0.85);
}

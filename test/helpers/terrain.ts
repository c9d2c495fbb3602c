import { noHeight } from '../../src/formats/terrain/hgt.ts';

/** An SRTM tile with 3 arc seconds. @param height - metres at degrees north and east of the tile's south-west corner; null for no data */
export function hgtBytes(height: (north: number, east: number) => number | null, side = 1201): Uint8Array<ArrayBuffer> {
  const view = new DataView(new ArrayBuffer(2 * side * side));
  for (let row = 0; row < side; row++) {
    for (let column = 0; column < side; column++)
      view.setInt16(
        2 * (row * side + column),
        Math.round(height(1 - row / (side - 1), column / (side - 1)) ?? noHeight),
      );
  }
  return new Uint8Array(view.buffer);
}

import type { VolumeScene } from '../../src/x3d/scene.ts';

/** Draw a picture off-screen, a number of rows at a time, with the view of the last picture. It is not shown yet. */
export function drawInPieces(
  scene: VolumeScene,
  stepLength: number,
  size: { readonly width: number; readonly height: number },
  rows = 10,
): void {
  for (const pass of scene.startGathering({ stepLength }, size)) {
    for (let firstRow = 0; firstRow < pass.height; firstRow += rows) {
      scene.gather({ stepLength }, { pass, firstRow, rows: Math.min(rows, pass.height - firstRow) }, size);
    }
  }
}

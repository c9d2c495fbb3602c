import { svg } from 'lit';
import { writeColor } from '../../src/optics/transfer/write-transfer-function.ts';
import type { PaintPoint } from '../../src/editor/paint-curve.ts';

/** Stops of an SVG gradient: the colours as they appear on an opaque background. */
export function renderGradientStops(points: readonly PaintPoint[]): unknown {
  return points.map(
    ({ share, color }) => svg`<stop offset=${share.toFixed(5)} stop-color=${writeColor(color)}></stop>`,
  );
}

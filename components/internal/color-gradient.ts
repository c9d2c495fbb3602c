import { svg } from 'lit';
import { writeColor } from '../../src/optics/transfer/write-transfer-function.ts';
import type { PaintPoint } from '../../src/editor/paint-curve.ts';

/** Stops of an SVG gradient: colours as they are on an opaque ground. */
export function renderGradientStops(points: readonly PaintPoint[]): unknown {
  return points.map(({ share, color }) => svg`<stop offset=${share.toFixed(5)} stop-color=${writeColor(color)}></stop>`);
}

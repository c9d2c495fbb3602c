// In the browser: a renderer that is compared, and what it is to show.
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** A renderer with a scene, see peers/README.md. */
export interface Peer {
  readonly gl: WebGL2RenderingContext;
  readonly isFixed?: boolean;
  readonly parallel?: { readonly target: Vector3; readonly halfHeight: number };
  setSize(pixels: number): void;
  draw(stepLength: number): void;
  dispose(): void;
  /** Ours: the picture at rest for this `max-error` and `detail` is drawn until the size is set, whatever step length is asked for. */
  choose?(maxError: number, isFree: boolean): Promise<ChosenPicture>;
}

/** How our picture at rest is drawn. */
export interface ChosenPicture {
  readonly steps: number;
  readonly substeps: number;
  /** Share of the pixels that get rays. */
  readonly rays: number;
}

/** What all renderers are to show. */
export interface Shown {
  readonly volume: Volume;
  readonly transferFunction: TransferFunction;
  readonly isLit: boolean;
  /** The same without its small things, and where these are in the world. */
  readonly things?: { readonly bare: Volume; readonly places: readonly Vector3[] };
}

/** RGBA over black, bottom row first. The context's own buffer is read in the task that drew it. */
export function drawPicture({ gl, draw }: Peer, stepLength: number, size: number): Uint8Array {
  draw(stepLength);
  const pixels = new Uint8Array(size * size * 4);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

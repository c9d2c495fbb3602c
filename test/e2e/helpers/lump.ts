// A volume as large as a test wants it, made in the page, and what the page notes while it is loaded.
import type { Page } from '@playwright/test';
import { withElement } from './harness.ts';
import type { Picture } from './pictures.ts';

/** What the pages note of the GPU's work, in the page. */
export interface Watch {
  gpuBytes(): { samples: number; textures: number; all: number };
  /** Called with the context after each piece of an upload. */
  onPiece(gl: WebGL2RenderingContext, pieces: number): void;
  /** Pieces so far. */
  pieces: number;
}

/** Run before the page: counts pieces of uploads to 3D textures. */
export function watchPieces(): void {
  const watch = window as unknown as Watch;
  watch.pieces = 0;
  const original = WebGL2RenderingContext.prototype.texSubImage3D as (...args: unknown[]) => void;
  Object.defineProperty(WebGL2RenderingContext.prototype, 'texSubImage3D', {
    value(this: WebGL2RenderingContext, ...args: unknown[]) {
      original.apply(this, args);
      watch.onPiece?.(this, ++watch.pieces);
    },
  });
}

/**
 * Give the page's element a NIfTI file that is made there: a lumpy ellipsoid, brighter inside.
 * @param edge - voxels along each axis
 * @param bits - 8 or 16 of each
 */
export async function loadLump(page: Page, edge: number, bits: 8 | 16): Promise<void> {
  await withElement(
    page,
    (element, [n, b]) => {
      const header = new DataView(new ArrayBuffer(352));
      header.setInt32(0, 348, true);
      [3, n, n, n, 1, 1, 1, 1].forEach((length, i) => header.setInt16(40 + 2 * i, length, true));
      header.setInt16(70, b === 16 ? 512 : 2, true);
      header.setInt16(72, b, true);
      [1, 1, 1, 1].forEach((spacing, i) => header.setFloat32(76 + 4 * i, spacing * (100 / n), true));
      header.setFloat32(108, 352, true);
      [0x6e, 0x2b, 0x31, 0].forEach((byte, i) => header.setUint8(344 + i, byte));
      const samples = b === 16 ? new Uint16Array(n ** 3) : new Uint8Array(n ** 3);
      const [base, gain] = b === 16 ? [20000, 40000] : [80, 150];
      const squares = Float32Array.from({ length: n }, (_, i) => ((2 * i + 1) / n - 1) ** 2);
      for (let k = 0, at = 0; k < n; k++) {
        for (let j = 0; j < n; j++) {
          const rest = 1 - squares[k] - 1.6 * squares[j] + 0.1 * Math.sin((40 * j) / n) * Math.sin((50 * k) / n);
          for (let i = 0; i < n; i++, at++) {
            const depth = rest - 2 * squares[i];
            if (depth > 0) samples[at] = base + gain * depth;
          }
        }
      }
      element.setAttribute('src', URL.createObjectURL(new Blob([header, samples])));
    },
    { argument: [edge, bits] as const },
  );
}

/** 36 MB: above the size from which there is a coarse picture first, and uploaded in more than 30 pieces. */
export const largeEdge = 330;

export const plain =
  '<volume-view transfer-function="30% #024 0, 45% #c63 5%, 90% #ffc 60%" camera-orbit="35deg 65deg 100%" steps="120"></volume-view>';

/** Mean of the alpha channel, 0 to 255: whether anything is seen. */
export function meanAlpha({ data }: Picture): number {
  return data.reduce((sum, x, i) => (i % 4 === 3 ? sum + x : sum), 0) / (data.length / 4);
}

import type { GridFrame } from '../../volume/grid.ts';
import type { Volume } from '../../volume/volume.ts';
import type { Scene, Size } from './scene.ts';

/** A view that has been drawn. */
export interface DrawnView {
  readonly scene: Scene;
  readonly grid: GridFrame;
  /** It may say what a lossy form of it changed; without it, nothing is known of that. */
  readonly volume?: Volume;
  /** Pixels across and down of the picture in full. */
  readonly size: Size;
  /** Whether the view is still needed. */
  readonly goesOn: () => boolean;
}

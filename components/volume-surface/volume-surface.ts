import { readSurface } from '../../src/viewer/attachments/surface-attributes.ts';
import type { WantedSurface } from '../../src/viewer/attachments/surface-attributes.ts';
import type { Surface } from '../../src/volume/surface.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { flag, number } from '../internal/property-kinds.ts';
import { property } from '../internal/reflecting-element.ts';
import { SurfaceElement } from '../internal/surface-element.ts';

/** What a `<volume-surface>` has loaded. */
export interface VolumeSurfaceInfo {
  /** What the file is, for people. */
  readonly format: string;
  readonly triangles: number;
  /** Corners of the box around all of it, world units (mm). */
  readonly bounds: readonly [low: Vector3, high: Vector3];
}

/**
 * A surface from a file in the picture of the `<volume-view>` around it: a cortex, a bone, a mould. The volume before it veils it, and it
 * hides what is behind it.
 *
 * With `hidden` it is not shown.
 *
 * `<volume-surface src="white.surf.gii" color="#e8d9c0"></volume-surface>`
 *
 * @tag volume-surface
 * @fires {CustomEvent<VolumeSurfaceInfo>} load - another surface is in the picture
 * @fires {CustomEvent<ProgressDetail>} progress - bytes came in
 * @fires {CustomEvent<ErrorDetail>} error - something failed; the last good surface stays
 */
export class VolumeSurface extends SurfaceElement {
  /** A file with triangles: STL, OBJ, PLY, GIfTI or glTF, or one of these packed with gzip. */
  @property() src!: string | null;

  /** A CSS colour. By default the colours of the file where it has some, else a warm white. */
  @property() color!: string | null;

  /**
   * Only 1: a translucent surface is refused, as it could not be drawn rightly within a volume.
   * @default 1
   */
  @property({ kind: number }) opacity!: number | null;

  /** Which way the file's axes run: `ras`, to the right, front and head, or `lps`, to the left, back and head. By default what the file says, else `ras`. */
  @property() space!: string | null;

  /** Whether what cuts the volume cuts the surface too: `region`, `cutout` of the view, and `<volume-clip>`. By default these lay it bare. */
  @property({ kind: flag, attribute: 'cut-with-volume' }) cutWithVolume!: boolean;

  /** The surface in the picture; null before it is there. */
  get info(): VolumeSurfaceInfo | null {
    return this.surface && this.describe(this.surface);
  }

  protected override readWanted(read: (name: string) => string | null): WantedSurface {
    return readSurface(read);
  }

  protected override describe({ format, triangles, low, high }: Surface): VolumeSurfaceInfo {
    return { format, triangles, bounds: [low, high] };
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-surface': VolumeSurface;
  }
}

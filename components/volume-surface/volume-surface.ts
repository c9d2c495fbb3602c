import { readSurface } from '../../src/viewer/attachments/surface-attributes.ts';
import type { WantedSurface } from '../../src/viewer/attachments/surface-attributes.ts';
import type { Surface } from '../../src/volume/surface.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { flag, number } from '../internal/property-kinds.ts';
import { property } from '../internal/reflecting-element.ts';
import { SurfaceElement } from '../internal/surface-element.ts';

/** The description of a loaded `<volume-surface>`. */
export interface VolumeSurfaceInfo {
  /** The format of the file, as a name for people. */
  readonly format: string;
  readonly triangles: number;
  /** Corners of the box around the whole surface, world units (mm). */
  readonly bounds: readonly [low: Vector3, high: Vector3];
}

/**
 * A surface from a file in the picture of the `<volume-view>` around it: a cortex, a bone, a mould. The volume in front of it covers it
 * partly, and it hides the volume behind it.
 *
 * With `hidden` it is not shown.
 *
 * `<volume-surface src="white.surf.gii" color="#e8d9c0"></volume-surface>`
 *
 * @tag volume-surface
 * @fires {CustomEvent<VolumeSurfaceInfo>} load - another surface is in the picture
 * @fires {CustomEvent<ProgressDetail>} progress - bytes have arrived
 * @fires {CustomEvent<ErrorDetail>} error - something failed; the last good surface stays
 */
export class VolumeSurface extends SurfaceElement {
  /** A file with triangles: STL, OBJ, PLY, VTK (legacy), GIfTI, FreeSurfer or glTF, or one of these packed with gzip. */
  @property() src!: string | null;

  /** A CSS colour. By default the colours of the file where it has some, else a warm white. */
  @property() color!: string | null;

  /**
   * Only 1 is allowed: a translucent surface is refused, as it could not be drawn correctly within a volume.
   * @default 1
   */
  @property({ kind: number }) opacity!: number | null;

  /**
   * Directions of the axes of the file: `ras`, to the right, front and head, or `lps`, to the left, back and head. By default those in the
   * file, else `ras`.
   */
  @property() space!: string | null;

  /**
   * Whether the cuts of the volume cut the surface too: `region` and `cutout` of the view, and `<volume-clip>`. By default these expose the
   * surface.
   */
  @property({ kind: flag, attribute: 'cut-with-volume' }) cutWithVolume!: boolean;

  /** The surface in the picture; null before it is loaded. */
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

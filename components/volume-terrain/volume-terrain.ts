import { readTerrain } from '../../src/viewer/attachments/surface-attributes.ts';
import type { WantedSurface } from '../../src/viewer/attachments/surface-attributes.ts';
import type { Surface } from '../../src/volume/surface.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { flag, number, pair } from '../internal/property-kinds.ts';
import { property } from '../internal/reflecting-element.ts';
import { SurfaceElement } from '../internal/surface-element.ts';

/** The description of a loaded `<volume-terrain>`. */
export interface VolumeTerrainInfo {
  readonly triangles: number;
  /** The largest difference between the heights in the files and the drawn heights, metres. */
  readonly error: number;
  /** Root mean square of these differences, metres. */
  readonly meanError: number;
  /** Height of the lowest and of the highest place that is shown, metres above the sea. */
  readonly heights: readonly [lowest: number, highest: number];
  /** Share, 0 to 1, of the samples within the range of the radar and the area of the files that have no heights and stay open. */
  readonly voids: number;
}

/**
 * The ground under a weather radar, in the picture of the `<volume-view>` around it: as far as the range of the radar, with the same
 * exaggeration of heights. Beams meet the ground where they do in reality.
 *
 * With `hidden` it is not shown.
 *
 * `<volume-terrain src="N46E007.hgt N46E008.hgt"></volume-terrain>`
 *
 * @tag volume-terrain
 * @fires {CustomEvent<VolumeTerrainInfo>} load - another terrain is in the picture
 * @fires {CustomEvent<ProgressDetail>} progress - bytes have arrived
 * @fires {CustomEvent<ErrorDetail>} error - something failed; the last good terrain stays
 */
export class VolumeTerrain extends SurfaceElement {
  /**
   * Files with heights in the format of SRTM, `.hgt` or `.hgt.gz`: one file, or several, separated by blanks. Their names give their
   * positions.
   */
  @property() src!: string | null;

  /** For one file whose name does not give its position: whole degrees north and east of its south-west corner, `46 7`. */
  @property({ kind: pair }) corner!: readonly [south: number, west: number] | null;

  /** A CSS colour. By default muted colours by height. */
  @property() color!: string | null;

  /**
   * Only 1 is allowed: translucent terrain is refused, as it could not be drawn correctly within a volume.
   * @default 1
   */
  @property({ kind: number }) opacity!: number | null;

  /**
   * Whether the cuts of the volume cut the ground too: `region` and `cutout` of the view, and `<volume-clip>`. By default these leave it
   * whole.
   */
  @property({ kind: flag, attribute: 'cut-with-volume' }) cutWithVolume!: boolean;

  /** The terrain in the picture; null before it is loaded. */
  get info(): VolumeTerrainInfo | null {
    return this.surface && this.describe(this.surface);
  }

  protected override readWanted(read: (name: string) => string | null, volume: Volume | null): WantedSurface {
    return readTerrain(read, volume);
  }

  protected override describe({ triangles, terrain }: Surface): VolumeTerrainInfo {
    return { triangles, ...terrain! };
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-terrain': VolumeTerrain;
  }
}

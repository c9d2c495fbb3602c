import { readTerrain } from '../../src/viewer/attachments/surface-attributes.ts';
import type { WantedSurface } from '../../src/viewer/attachments/surface-attributes.ts';
import type { Surface } from '../../src/volume/surface.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { flag, number, pair } from '../internal/property-kinds.ts';
import { property } from '../internal/reflecting-element.ts';
import { SurfaceElement } from '../internal/surface-element.ts';

/** What a `<volume-terrain>` has loaded. */
export interface VolumeTerrainInfo {
  readonly triangles: number;
  /** The largest difference between the heights of the files and what is shown, metres. */
  readonly error: number;
  /** Its root mean square, metres. */
  readonly meanError: number;
  /** Lowest and highest place that is shown, metres above the sea. */
  readonly heights: readonly [lowest: number, highest: number];
  /** Share, 0 to 1, of the samples within the radar's reach and the files' area that have no heights and are left open. */
  readonly voids: number;
}

/**
 * The ground under a weather radar, in the picture of the `<volume-view>` around it: as far as the radar reaches, at its exaggeration of
 * heights. Beams meet it where they do outside.
 *
 * With `hidden` it is not shown.
 *
 * `<volume-terrain src="N46E007.hgt N46E008.hgt"></volume-terrain>`
 *
 * @tag volume-terrain
 * @fires {CustomEvent<VolumeTerrainInfo>} load - another terrain is in the picture
 * @fires {CustomEvent<ProgressDetail>} progress - bytes came in
 * @fires {CustomEvent<ErrorDetail>} error - something failed; the last good terrain stays
 */
export class VolumeTerrain extends SurfaceElement {
  /** Heights as SRTM has them, `.hgt` or `.hgt.gz`: one file, or several, separated by blanks. Their names say where they are. */
  @property() src!: string | null;

  /** Of one file whose name does not say it: whole degrees north and east of its south-west corner, `46 7`. */
  @property({ kind: pair }) corner!: readonly [south: number, west: number] | null;

  /** A CSS colour. By default quiet colours by height. */
  @property() color!: string | null;

  /**
   * Only 1: translucent terrain is refused, as it could not be drawn rightly within a volume.
   * @default 1
   */
  @property({ kind: number }) opacity!: number | null;

  /** Whether what cuts the volume cuts the ground too: `region`, `cutout` of the view, and `<volume-clip>`. By default these leave it whole. */
  @property({ kind: flag, attribute: 'cut-with-volume' }) cutWithVolume!: boolean;

  /** The terrain in the picture; null before it is there. */
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

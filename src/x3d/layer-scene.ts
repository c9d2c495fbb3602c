import type { ShownOverlay } from '../optics/attachments/overlay.ts';
import type { RayStyle } from '../optics/rays/ray-style.ts';
import type { Optics, RayCut } from '../renderer/ray/ray-module.ts';
import type { ProjectedRays } from '../optics/rays/ray-style.ts';
import type { SeenVolume, Substeps, VolumeLayer } from '../renderer/layers/volume-layer.ts';
import type { RayTwins } from '../renderer/ray/ray-twin.ts';
import type { Slice } from '../radar/slices.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { ShownLabels } from '../volume/labels.ts';

/** The settings and queries of a scene that concern its layer. */
export abstract class LayerScene {
  /** What is drawn; only one at present. */
  abstract readonly layers: readonly [VolumeLayer];

  setOptics(optics: Optics): Promise<void> {
    return this.layers[0].setOptics(optics);
  }

  setStyle(style: RayStyle | null): Promise<void> {
    return this.layers[0].setStyle(style);
  }

  setLabels(labels: ShownLabels | null): Promise<void> {
    return this.layers[0].setAttached((attached) => attached.setLabels(labels));
  }

  setOverlay(overlay: ShownOverlay | null): Promise<void> {
    return this.layers[0].setAttached((attached) => attached.setOverlay(overlay));
  }

  /** Shows only one part of the volume, see volume/region.ts; null for all of it. */
  setRegion(region: GridFrame | null): void {
    this.layers[0].region = region;
  }

  /** Sets slices of a radar scan, at most `maxSlices`, and other things that cut rays. */
  setSlices(slices: readonly Slice[], cuts: readonly RayCut[] = []): void {
    this.layers[0].slices = slices;
    this.layers[0].cuts = cuts;
  }

  setSubsteps(substeps: Substeps): void {
    this.layers[0].substeps = substeps;
  }

  /** See `Scene`. */
  twins(looks?: boolean): RayTwins | null {
    return this.layers[0].twins(false, looks);
  }

  detail(): Uint8Array | null {
    return this.layers[0].detail();
  }

  get cutsSteps(): boolean {
    return this.layers[0].cutsSteps;
  }

  get walksVoxels(): boolean {
    return this.layers[0].walksVoxels;
  }

  get projection(): ProjectedRays | null {
    return this.layers[0].projection;
  }

  whatIsSeen(): SeenVolume | null {
    return this.layers[0].whatIsSeen();
  }
}

import type { ShownOverlay } from '../optics/attachments/overlay.ts';
import type { Appearance } from '../renderer/ray/ray-module.ts';
import type { ProjectedRays } from '../optics/rays/ray-style.ts';
import type { SeenVolume, Substeps, VolumeLayer } from '../renderer/layers/volume-layer.ts';
import type { RayTwins } from '../renderer/ray/ray-twin.ts';
import type { ShownLabels } from '../volume/labels.ts';

/** The settings and queries of a scene that concern its layer. */
export abstract class LayerScene {
  /** What is drawn; only one at present. */
  abstract readonly layers: readonly [VolumeLayer];

  setAppearance(appearance: Partial<Appearance>): Promise<void> {
    return this.layers[0].setAppearance(appearance);
  }

  setLabels(labels: ShownLabels | null): Promise<void> {
    return this.layers[0].setAttached((attached) => attached.setLabels(labels));
  }

  setOverlay(overlay: ShownOverlay | null): Promise<void> {
    return this.layers[0].setAttached((attached) => attached.setOverlay(overlay));
  }

  /** See `Scene`. */
  twins(looks?: boolean): RayTwins | null {
    return this.layers[0].twins(false, looks);
  }

  detail(substeps?: Substeps): Uint8Array | null {
    return this.layers[0].detail(substeps);
  }

  get cutsSteps(): boolean {
    return this.layers[0].cutsSteps;
  }

  get walksVoxels(): boolean {
    return this.layers[0].walksVoxels;
  }

  projection(substeps: Substeps): ProjectedRays | null {
    return this.layers[0].projection(substeps);
  }

  whatIsSeen(): SeenVolume | null {
    return this.layers[0].whatIsSeen();
  }
}

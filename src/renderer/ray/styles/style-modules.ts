import type { SeenVolume } from '../../../optics/cells/cell-detail.ts';
import type { Contribution } from '../../../optics/cells/empty-space-distance.ts';
import type { SceneLights } from '../../../optics/transfer/lights.ts';
import type { StyledAppearance } from '../../../optics/cells/style-detail.ts';
import type { VolumeData } from '../../../volume/volume.ts';
import type { Device, Gl } from '../../device/device.ts';
import type { FieldTaps } from '../modules/field-taps.ts';
import type { Optics, RayModule } from '../ray-module.ts';
import type { RayPlan } from '../ray-plan.ts';

/** See `SeenVolume`. */
type MoreSeen = Pick<SeenVolume, 'more' | 'functions' | 'hasSurfaces' | 'jumps' | 'found' | 'style'>;

/** The modules of a style. */
export interface StyleModules {
  /** Whether rays project values, independent of the length over which the values occur. */
  readonly projects: boolean;
  /** Load what a volume needs in this style, before it is set. */
  readonly prepare?: (volume: Pick<VolumeData, 'grid'>) => Promise<void>;
  /** The style's modules for a ray of the layer's volume. @param others - the other modules of the ray */
  modules(others: readonly RayModule[]): readonly RayModule[];
  /** Which values show where, given the contributions of the other modules. */
  contributions?(all: readonly RayModule[], optics: Optics): readonly Contribution[];
  /** What is seen in addition to what the transfer function shows. @param more - what labels add */
  seen?(more: MoreSeen | undefined, appearance: StyledAppearance): MoreSeen | undefined;
  dispose(): void;
}

/** The members of a layer that a style reads; it reads some of them again for each picture. */
export interface StyledLayer {
  readonly gl: Gl;
  readonly device: Device;
  readonly providers: { readonly polarTaps?: () => Promise<FieldTaps> };
  readonly volume: VolumeData | null;
  readonly plan: Pick<RayPlan, 'substeps' | 'cuts' | 'region'>;
  readonly lights: () => SceneLights | null;
}

import type { SeenVolume } from '../../../optics/cells/cell-detail.ts';
import type { Contribution } from '../../../optics/cells/empty-space-distance.ts';
import type { SceneLights } from '../../../optics/transfer/lights.ts';
import type { Substeps } from '../../../optics/cells/substeps.ts';
import type { StyledLook } from '../../../optics/cells/style-detail.ts';
import type { Volume } from '../../../volume/volume.ts';
import type { Device, Gl } from '../../device/device.ts';
import type { FieldTaps } from '../modules/lit.ts';
import type { Optics, RayCut, RayModule } from '../ray-module.ts';

/** See `SeenVolume`. */
type MoreSeen = Pick<SeenVolume, 'more' | 'functions' | 'hasSurfaces' | 'jumps' | 'found' | 'style'>;

/** The modules of a style. */
export interface StyleModules {
  /** Whether rays show values, whatever the length over which there are some. */
  readonly projects: boolean;
  /** Of a ray of the layer's volume. @param others - the modules that it has beside these */
  modules(others: readonly RayModule[]): readonly RayModule[];
  /** Which values show where, given what the other modules say. */
  contributions?(all: readonly RayModule[], optics: Optics): readonly Contribution[];
  /** What is seen beside what the transfer function shows. @param more - by labels */
  seen?(more: MoreSeen | undefined, look: StyledLook): MoreSeen | undefined;
  dispose(): void;
}

/** What of a layer a style reads: some of it for each picture. */
export interface StyledLayer {
  readonly gl: Gl;
  readonly device: Device;
  readonly providers: { readonly polarTaps?: () => Promise<FieldTaps> };
  readonly volume: Volume | null;
  readonly substeps: Substeps;
  readonly cuts: readonly RayCut[];
  readonly region: unknown;
  readonly lights: () => SceneLights | null;
}

// How rays are drawn where it is not by emission and absorption alone: loaded with the first picture of the kind.
import { headlightAlone } from '../../optics/lights.ts';
import type { SceneLights } from '../../optics/lights.ts';
import type { ProjectionKind, RayStyle } from '../../optics/ray-style.ts';
import type { StyleChain } from '../../optics/volume-styles.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import type { Device, Gl } from '../device.ts';
import type { FieldTaps } from './modules/lit.ts';
import type { RayCut, RayModule } from './ray-module.ts';

/** The modules of a style. */
export interface StyleModules {
  /** Whether rays show values, whatever the length over which there are some. */
  readonly projects: boolean;
  /** Of a ray of the layer's volume. @param others - the modules that it has beside these */
  modules(others: readonly RayModule[]): readonly RayModule[];
  dispose(): void;
}

/** What of a layer a style reads: some of it for each picture. */
export interface StyledLayer {
  readonly gl: Gl;
  readonly device: Device;
  readonly providers: { readonly polarTaps?: () => Promise<FieldTaps> };
  readonly volume: Volume | null;
  readonly cuts: readonly RayCut[];
  readonly lights: () => SceneLights | null;
}

export async function createStyle(style: RayStyle, layer: StyledLayer): Promise<StyleModules> {
  if (style.projection) return createProjected(style.projection, layer);
  const parts: Promise<StyleModules>[] = [];
  // What styles a volume lights it too: normals are found once.
  if (style.styles) parts.push(createStyled(style.styles, style, layer));
  else if (style.lit) parts.push(createLight(layer));
  return join(await Promise.all(parts));
}

async function createProjected(kind: ProjectionKind, { gl, device }: StyledLayer): Promise<StyleModules> {
  const { createProjection } = await import('./modules/projection.ts');
  const projection = createProjection(kind, gl, device);
  return { projects: true, modules: () => [projection], dispose: () => projection.dispose!() };
}

/** Parts that leave emission and absorption as they are, in the order in which their modules act. */
function join(parts: readonly StyleModules[]): StyleModules {
  return {
    projects: false,
    modules: (others) => parts.flatMap((part) => part.modules(others)),
    dispose: () => parts.forEach((part) => part.dispose()),
  };
}

/** Volumes of labels have no values between which something could face anywhere. */
async function createLight(layer: StyledLayer): Promise<StyleModules> {
  const { cartesianTapsOf, createLit, pointsModule } = await import('./modules/lit.ts');
  const { cutsOf, hasCuts } = await import('./modules/lit-cuts.ts');
  const polarTaps: FieldTaps | null = (await layer.providers.polarTaps?.()) ?? null;
  return {
    projects: false,
    modules: () => {
      const volume = layer.volume!;
      const taps = isPolar(volume) ? polarTaps : cartesianTapsOf;
      if (volume.isDiscrete || !taps) return [];
      const lights = layer.lights() ?? headlightAlone;
      const cuts = cutsOf(layer.cuts);
      return [pointsModule, createLit({ taps, lights: lights.lights.length > 0, cuts: hasCuts(cuts) }, { lights, cuts })];
    },
    dispose: () => {},
  };
}

async function createStyled(chains: readonly StyleChain[], { lit }: RayStyle, layer: StyledLayer): Promise<StyleModules> {
  const [{ cartesianTapsOf, pointsModule }, { cutsOf, hasCuts }, { hasRoom, StyledRays }] = await Promise.all([import('./modules/lit.ts'), import('./modules/lit-cuts.ts'), import('./modules/styled.ts')]);
  const polarTaps: FieldTaps | null = (await layer.providers.polarTaps?.()) ?? null;
  const rays = new StyledRays(layer.gl, lit ? withLight(chains) : chains);
  return {
    projects: false,
    modules: (others) => {
      const volume = layer.volume!;
      const taps = isPolar(volume) ? polarTaps : cartesianTapsOf;
      if (volume.isDiscrete || !taps || !hasRoom(others, layer.device)) return [];
      const lights = layer.lights() ?? headlightAlone;
      const cuts = cutsOf(layer.cuts);
      return [pointsModule, rays.module({ taps, lights: lights.lights.length > 0, cuts: hasCuts(cuts) }, { lights, cuts })];
    },
    dispose: () => rays.dispose(),
  };
}

/** A view that is lit is lit last, where no style of its own lights it. */
function withLight(chains: readonly StyleChain[]): readonly StyleChain[] {
  const isLit = chains.some(({ styles }) => styles.some(({ kind }) => kind === 'shaded'));
  return isLit ? chains : chains.map(({ weight, styles }) => ({ weight, styles: [...styles, { kind: 'shaded', material: null }] }));
}

// Rays that show more than emission and absorption, or something else. The first such picture loads this file.
import type { ProjectionKind, RayStyle } from '../../../optics/rays/ray-style.ts';
import { isCut } from '../../../optics/cells/substeps.ts';
import { isPolar } from '../../../volume/volume.ts';
import type { StyledLayer, StyleModules } from './style-modules.ts';

export type { StyledLayer, StyleModules } from './style-modules.ts';

export async function createStyle(style: RayStyle, layer: StyledLayer): Promise<StyleModules> {
  if (style.projection) return createProjected(style.projection, style.intensityThreshold, layer);
  const parts: Promise<StyleModules>[] = [];
  // Rendering styles also light the volume, so that normals are computed once.
  if (style.styles && !style.clear) {
    const { styles: chains, lit } = style;
    parts.push(import('./styled-rays.ts').then(({ createStyled }) => createStyled(chains, Boolean(lit), layer)));
  } else if (style.lit && !style.clear) {
    parts.push(
      style.lit === 'ambient-occlusion'
        ? import('./occlusion.ts').then(({ createOccludedLight }) => createOccludedLight(layer))
        : import('./light.ts').then(({ createLight }) => createLight(layer)),
    );
  }
  if (style.patches && !style.clear)
    parts.push(import('./patches.ts').then(({ createPatched }) => createPatched(style.patches!, layer)));
  if (style.surfaces)
    parts.push(import('./iso-surfaces.ts').then(({ createIsoSurfaces }) => createIsoSurfaces(style, layer)));
  return join(await Promise.all(parts));
}

async function createProjected(
  kind: ProjectionKind,
  threshold: number | undefined,
  layer: StyledLayer,
): Promise<StyleModules> {
  const { createProjection } = await import('../modules/projection.ts');
  const { stepped, exact } = createProjection({ kind, threshold }, layer.gl, layer.device);
  return {
    projects: true,
    modules: () => [projectsExactly(layer) ? exact : stepped],
    dispose: () => stepped.dispose!(),
  };
}

/** A radar's gates are not voxels, and pictures in motion have to take few steps: both project by steps. */
function projectsExactly({ volume, plan: { substeps } }: StyledLayer): boolean {
  return volume !== null && !isPolar(volume) && isCut(substeps);
}

/** Join styles that keep emission and absorption, in the order in which their modules act. A module that several styles need is there once. */
function join(parts: readonly StyleModules[]): StyleModules {
  // Surfaces come last, and show at any gradient, so their contributions replace the others.
  const last = parts.filter((part) => part.contributions).at(-1);
  return {
    projects: false,
    prepare: async (volume) => {
      await Promise.all(parts.map(async (part) => part.prepare?.(volume)));
    },
    modules: (others) => [...new Set(parts.flatMap((part) => part.modules(others)))],
    contributions: last?.contributions,
    seen: (more, appearance) => parts.reduce((known, part) => part.seen?.(known, appearance) ?? known, more),
    dispose: () => parts.forEach((part) => part.dispose()),
  };
}

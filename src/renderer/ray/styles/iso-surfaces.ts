// Surfaces at constant values (isosurfaces). The first of them loads this file.
import type { Contribution } from '../../../optics/cells/empty-space-distance.ts';
import type { RayStyle } from '../../../optics/rays/ray-style.ts';
import { contributionOfSurfaces, depthOfSurfaces, surfaceFlat } from '../../../optics/surfaces/surfaces.ts';
import { isPolar } from '../../../volume/volume.ts';
import { lightLayer } from './layer-light.ts';
import type { LayerLight } from './layer-light.ts';
import { pointsModule } from '../modules/points.ts';
import { createSurfaces } from '../modules/surfaces.ts';
import type { StyledLayer, StyleModules } from './style-modules.ts';

/** Volumes of labels have no values between their labels, and therefore no surfaces. */
export async function createIsoSurfaces(
  { surfaces = [], plain, clear, surfaceStyles }: RayStyle,
  layer: StyledLayer,
): Promise<StyleModules> {
  const layerLight = plain ? null : lightLayer(layer);
  const lightOf = (): ReturnType<LayerLight> => layerLight?.() ?? null;
  const made = createSurfaces(layer.gl, layer.device);
  const styling = surfaceStyles && (await import('../modules/styled.ts'));
  const styles = styling && new styling.StyledRays(layer.gl, [{ weight: 1, styles: surfaceStyles }], surfaceFlat);
  const showing = new WeakMap<Contribution, Contribution>();
  const own = contributionOfSurfaces(surfaces);
  const depth = depthOfSurfaces(surfaces);
  const has = (): boolean => !layer.volume!.isDiscrete;
  const widen = (shows: Contribution): Contribution => {
    if (clear) return own;
    const wide = showing.get(shows) ?? ((low, high, cell) => shows(low, high, cell) || own(low, high, cell));
    showing.set(shows, wide);
    return wide;
  };
  return {
    projects: false,
    prepare: layerLight?.prepare,
    modules: (others) => {
      if (!has()) return [];
      const light = styling && !styling.hasRoom(others, layer.device) ? null : lightOf();
      const options = {
        isOne: surfaces.length === 1,
        fog: !clear,
        kinks: !isPolar(layer.volume!),
        light: light && light.options,
        styling: light && styling ? styling.stylingText(light.options) : undefined,
      };
      return [pointsModule, made.of(surfaces, options, light && { surroundings: light.surroundings, styles })];
    },
    // Parts that labels hide stay hidden; the other contributions are about emission and absorption, so surfaces extend them.
    contributions: (all, optics) =>
      all.flatMap((module) => {
        const shows = module.contributes?.(optics);
        return !shows || !has() || module.name === 'labels' ? (shows ?? []) : widen(shows);
      }),
    seen: (more) =>
      has()
        ? { ...(clear ? { more: () => 0 } : more), hasSurfaces: true, jumps: [...(more?.jumps ?? []), depth] }
        : more,
    dispose: () => {
      made.dispose();
      styles?.dispose();
    },
  };
}

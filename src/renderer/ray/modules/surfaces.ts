import finishColor from '../../../../shaders/chunks/gather/finish-color.glsl?raw';
import emptySpace from '../../../../shaders/chunks/walk/empty-space.glsl?raw';
import gatheredPieces from '../../../../shaders/chunks/gather/gathered-pieces.glsl?raw';
import surfaceValuesChunk from '../../../../shaders/chunks/gather/surface-values.glsl?raw';
import crossings from '../../../../shaders/chunks/gather/surface-crossings.glsl?raw';
import surfacesChunk from '../../../../shaders/chunks/gather/surfaces.glsl?raw';
import type { IsoSurface } from '../../../optics/rays/ray-style.ts';
import { grazingProbes, kinkedSubsteps, surfaceRefinements } from '../../../optics/surfaces/surface-crossings.ts';
import { maxSurfaces } from '../../../optics/transfer/surface-limits.ts';
import { maxSubsteps } from '../../../optics/transfer/substep-limits.ts';
import { brightenSurfaces, surfaceFlat } from '../../../optics/surfaces/surfaces.ts';
import type { Device, Gl } from '../../device/device.ts';
import { joinInputs } from '../../device/inputs.ts';
import type { ProgramInputs, Uniforms } from '../../device/inputs.ts';
import { EdgeRays } from '../../passes/edge-rays.ts';
import type { RayFrame, RayModule, RayText, RayTwin } from '../ray-module.ts';
import { compositeText, createComposite } from './composite.ts';
import { litScene, perFlat, shadedTwin, shadingText, shadingUniforms } from './lit.ts';
import { shadingTwins } from './field-taps.ts';
import type { StyledRays, StylesTwin } from './styled.ts';
import { kinkProbes, surfaceValues } from './surface-values.ts';
import type { LitOptions, LitSurroundings } from './lit.ts';

/** A difference of values for places where it is not known: larger than between any two values, smaller than to an unused surface slot. */
const farthest = '1e35';

/** The options of the module's text. */
export interface SurfaceOptions {
  /** There is only one surface: the search for it costs less than for several. */
  readonly isOne: boolean;
  /** Whether the volume emits and absorbs between surfaces. */
  readonly fog: boolean;
  /** Whether values have kinks at the planes of voxel centres, as on a cartesian grid. */
  readonly kinks: boolean;
  /** null for surfaces that are not lit: they show their own colours. */
  readonly light: LitOptions | null;
  /** For surfaces in X3D's rendering styles, which also light them: the result of `stylingText`. */
  readonly styling?: Pick<RayText, 'defines' | 'chunks' | 'samplers'>;
}

/** The data that light and styles need. */
export interface SurfaceShading {
  readonly surroundings: LitSurroundings;
  readonly styles?: StyledRays;
}

export function surfacesText({ isOne, fog, kinks, light, styling }: SurfaceOptions): RayText {
  const count = isOne ? 1 : maxSurfaces;
  const shading = light && (styling ?? { ...shadingText(light), samplers: [] });
  return {
    name: 'surfaces',
    stage: 'gather',
    defines: {
      ...compositeText.defines,
      ...shading?.defines,
      LOOKS: 1,
      SURFACE_COUNT: count,
      FARTHEST: farthest,
      SURFACE_FOG: Number(fog),
      SURFACES_LIT: Number(light !== null && !styling),
      SURFACES_STYLED: Number(light !== null && styling !== undefined),
      KINKS: Number(kinks),
      // MAX_PIECES: crossings of each surface up, down, and the one after that; and the ends of these three parts.
      SURFACE_REFINEMENTS: surfaceRefinements,
      GRAZING_PROBES: grazingProbes,
      KINK_PROBES: kinks ? kinkProbes : 0,
      GRAZING_SUBSTEPS: `${kinks ? kinkedSubsteps : maxSubsteps}.0`,
      MAX_PIECES: 3 * count + 3,
    },
    chunks: [
      ...(shading?.chunks ?? []),
      surfaceValuesChunk,
      crossings,
      gatheredPieces,
      surfacesChunk,
      emptySpace,
      finishColor,
    ],
    samplers: [...compositeText.samplers, ...(shading?.samplers ?? [])],
  };
}

/** Emission and absorption, with surfaces in it. Its modules for one volume differ only by their texts. */
export function createSurfaces(
  gl: Gl,
  device: Device,
): {
  of(surfaces: readonly IsoSurface[], options: SurfaceOptions, shading: SurfaceShading | null): RayModule<'gather'>;
  dispose(): void;
} {
  const composite = createComposite(gl, device);
  let edges: EdgeRays | null = null;
  return {
    of: (surfaces, options, shading) => ({
      ...surfacesText(options),
      stage: 'gather',
      sparesRays: true,
      // Surfaces are found wherever the samples are, even if rays only graze them.
      order: Infinity,
      twin: surfacesTwin(surfaces, options, shadingOf(options, shading)),
      edges: () => (edges ??= new EdgeRays(gl)),
      inputs: (frame) =>
        joinInputs(
          joinInputs(composite.inputs(frame), { uniforms: surfaceUniforms(surfaces, frame), units: [] }),
          shadingInputs(frame, options, shading),
        ),
    }),
    dispose: () => {
      composite.dispose!();
      edges?.dispose();
    },
  };
}

/** The data that light surfaces in float64. */
interface TwinShading extends Pick<SurfaceShading, 'surroundings'> {
  readonly light: LitOptions;
  readonly styles?: StylesTwin;
}

/** Halvings that find a place to the precision of floats. If only places matter, few rays are cast, so the time does not matter. */
const placeRefinements = 40;

function shadingOf({ light, styling }: SurfaceOptions, shading: SurfaceShading | null): TwinShading | null {
  if (!light || !shading) return null;
  const { surroundings, styles } = shading;
  return { light, surroundings, ...(styling && { styles: styles?.stylesTwin(light, surroundings) }) };
}

function surfacesTwin(surfaces: readonly IsoSurface[], { fog }: SurfaceOptions, shading: TwinShading | null): RayTwin {
  const parts: RayTwin['parts'] = (frame) => {
    const {
      optics,
      volume: { grid },
      placesOnly,
    } = frame;
    const { surfaceGather, brightenSurfaces, lightAt, towardsEye } = shadingTwins.code;
    const stylesOf = shading?.styles?.(frame);
    const scene = shading && !stylesOf && !placesOnly ? litScene(frame, shading.light, shading.surroundings) : null;
    return {
      gather: surfaceGather({
        surfaces: brightenSurfaces(surfaces, optics.lightFactor),
        isClear: !fog,
        light: scene && lightAt({ ...scene, flat: surfaceFlat * scene.flat }),
        toEye: (ray) => towardsEye(grid, ray),
        stylesOf,
        ...(placesOnly && { refinements: placeRefinements }),
      }),
    };
  };
  return shading ? shadedTwin(shading.light, parts) : { load: shadingTwins.load, parts };
}

function shadingInputs(
  frame: RayFrame,
  { light, styling }: SurfaceOptions,
  shading: SurfaceShading | null,
): ProgramInputs {
  if (!light || !shading) return { uniforms: {}, units: [] };
  if (styling) return shading.styles!.inputs(frame, light, shading.surroundings);
  return {
    uniforms: {
      ...shadingUniforms(frame, light.taps, shading.surroundings),
      uPerFlatSurface: perFlat(frame) / surfaceFlat,
    },
    units: [],
  };
}

function surfaceUniforms(surfaces: readonly IsoSurface[], frame: RayFrame): Uniforms {
  const shown = brightenSurfaces(surfaces, frame.optics.lightFactor);
  const slots = Array.from({ length: maxSurfaces }, (_, i) => shown[i] ?? { color: [0, 0, 0], opacity: 0 });
  return {
    uSurfaceValues: surfaceValues(
      shown.map(({ value }) => value),
      frame,
    ),
    uSurfaceColors: slots.flatMap(({ color, opacity }) => [...color, opacity]),
  };
}

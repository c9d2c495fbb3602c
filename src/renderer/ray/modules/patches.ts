import patchesChunk from '../../../../shaders/chunks/classify/patches.glsl?raw';
import { lightPatches, perWorldUnit } from '../../../optics/rays/patch-classify.ts';
import {
  densityOf,
  gaussianFloor,
  gaussianReach,
  gaussianScale,
  maxPatches,
  shortWay,
} from '../../../optics/transfer/patches.ts';
import type { Patch } from '../../../optics/transfer/patches.ts';
import type { Gl } from '../../device/device.ts';
import { joinInputs } from '../../device/inputs.ts';
import type { Uniforms } from '../../device/inputs.ts';
import type { RayFrame, RayModule, RayText, RayTwin } from '../ray-module.ts';
import { shadedTwin, shadingText, shadingUniforms } from './lit.ts';
import { shadingTwins } from './field-taps.ts';
import type { LitOptions, LitSurroundings } from './lit.ts';
import { classifyText, classifyTwin, createClassify } from './transfer-function.ts';

/** The text is the same for all patches; the patches are in uniforms. */
export function patchesText(options: LitOptions): RayText {
  const { defines, chunks } = shadingText(options);
  return classifyText({
    name: 'patches',
    defines: {
      ...defines,
      GAUSSIAN_REACH: gaussianReach.toFixed(1),
      GAUSSIAN_FLOOR: gaussianFloor.toFixed(9),
      GAUSSIAN_SCALE: gaussianScale.toFixed(9),
      SHORT_WAY: shortWay.toFixed(2),
    },
    chunks: [...chunks, patchesChunk],
    samplers: [],
  });
}

/** All parts except the patches are those of the transfer function's twin. */
function patchesTwin(patches: readonly Patch[], options: LitOptions): RayTwin {
  const own = shadedTwin(options, (frame, before) => {
    const {
      volume,
      optics: { referenceLength, opacityFactor, lightFactor },
      rays,
    } = frame;
    const slopes = options.taps.slopes.code(volume);
    const scene = {
      ...slopes,
      field: slopes,
      grid: volume.finer?.finest ?? volume.grid,
      patches: lightPatches(patches, lightFactor),
      opticalScale: (rays.diameter / referenceLength) * opacityFactor,
    };
    return { classify: shadingTwins.code.patchClassify(classifyTwin.parts(frame, before).classify!, scene) };
  });
  return { load: (frame) => Promise.all([classifyTwin.load(frame), own.load(frame)]), parts: own.parts };
}

/** Patches in the plane of value and gradient give colour and opacity. The transfer function of the optics has to be their `outlinePatches`. */
export function createPatches(
  gl: Gl,
  patches: readonly Patch[],
): { of(options: LitOptions, scene: LitSurroundings): RayModule<'classify'>; dispose(): void } {
  const none = {
    name: '',
    defines: {},
    chunks: [],
    samplers: [],
    inputs: () => ({ uniforms: {}, units: [] }),
    dispose: () => {},
  };
  const made = createClassify(gl, none);
  return {
    of: (options, scene) => ({
      ...made,
      ...patchesText(options),
      stage: 'classify',
      twin: patchesTwin(patches, options),
      inputs: (frame) =>
        joinInputs(made.inputs(frame), {
          uniforms: { ...shadingUniforms(frame, options.taps, scene), ...patchUniforms(frame, patches) },
          units: [],
        }),
    }),
    dispose: () => made.dispose!(),
  };
}

/** Factors and places stay below this, so that the shader's products and their squares don't overflow. */
const farthest = 1e18;

/** A change of value that no data distinguish from 0: a share of the domain from voxel to voxel. */
const flattest = 1e-12;

/** Boxes come first. The unit of gradients is the smallest gradient of any patch, so that float32 loses no digits of small ones. */
function patchUniforms({ volume, domain: [low, high], optics }: RayFrame, patches: readonly Patch[]): Uniforms {
  const lit = lightPatches(patches, optics.lightFactor);
  const boxes = lit.filter(({ kind }) => kind === 'box');
  const all = [...boxes, ...lit.filter(({ kind }) => kind !== 'box')];
  const width = high - low;
  const perDomain = perWorldUnit(volume.finer?.finest ?? volume.grid) * width;
  const steepest = Math.max(
    flattest * perDomain,
    Math.min(...all.map((patch) => (patch.kind === 'box' ? patch.gradients[1] : patch.gradient + patch.widths[1]))),
  );
  const share = (value: number): number => (value - low) / width;
  const places = all.map((patch) =>
    (patch.kind === 'box'
      ? [share(patch.values[0]), patch.gradients[0] / steepest, share(patch.values[1]), patch.gradients[1] / steepest]
      : [share(patch.value), patch.gradient / steepest, width / patch.widths[0], steepest / patch.widths[1]]
    ).map((x) => Math.min(farthest, Math.max(-farthest, x))),
  );
  const looks = all.map((patch) => [...patch.color, densityOf(patch)]);
  const [placesA, placesB] = inHalves(places);
  const [looksA, looksB] = inHalves(looks);
  return {
    uPatchesA: placesA,
    uPatchesB: placesB,
    uPatchColorsA: looksA,
    uPatchColorsB: looksB,
    uPatchCounts: [boxes.length, all.length],
    uPatchSteepness: perDomain / steepest,
  };
}

/** Distribute the columns over two matrices. */
function inHalves(columns: readonly (readonly number[])[]): [number[], number[]] {
  const all = Array.from({ length: maxPatches }, (_, i) => columns[i] ?? [0, 0, 0, 0]);
  return [all.slice(0, maxPatches / 2).flat(), all.slice(maxPatches / 2).flat()];
}

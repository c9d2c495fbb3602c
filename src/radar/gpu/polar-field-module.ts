import decode from '../../../shaders/chunks/field/decode.glsl?raw';
import polarFolds from '../../../shaders/chunks/radar/polar-folds.glsl?raw';
import polarGates from '../../../shaders/chunks/radar/polar-gates.glsl?raw';
import volumePolar from '../../../shaders/chunks/radar/volume-polar.glsl?raw';
import { VolumeViewError } from '../../core/errors.ts';
import { highestElevation, lowestElevation } from '../polar-box.ts';
import type { PolarGrid } from '../../volume/polar-grid.ts';
import { isPolar } from '../../volume/volume.ts';
import type { VolumeData } from '../../volume/volume.ts';
import { isWebGl2 } from '../../renderer/device/device.ts';
import type { Device, Gl } from '../../renderer/device/device.ts';
import { allocatePlane, fillPlane } from '../../renderer/textures/fill-plane.ts';
import { prepareUpload, slowBytes, texelsOf } from '../../renderer/textures/fill-texture.ts';
import type { Upload } from '../../renderer/textures/fill-texture.ts';
import { layOutRadials, packRows } from '../polar-layout.ts';
import { widestGap } from '../sweep-elevations.ts';
import { buildPolarTable, hasRadialElevations, tableWidth } from '../polar-table.ts';
import type { PolarTable } from '../polar-table.ts';
import type { Uniforms } from '../../renderer/device/inputs.ts';
import { chooseFloatScale, prepareFloats } from '../../renderer/device/prepare-floats.ts';
import type { FieldModule, RayText } from '../../renderer/ray/ray-module.ts';
import { twinOf } from '../../renderer/ray/ray-twin.ts';
import { textureUnit } from '../../renderer/device/texture-unit.ts';
import { radarTwins } from './radar-twins.ts';

/** What the text of the module depends on. */
export interface PolarOptions {
  /** Whether 16-bit samples are stored in two 8-bit channels. */
  readonly twoBytes: boolean;
  /** Whether the radials of its sweeps have elevations of their own. */
  readonly radialElevations: boolean;
  /** Whether its values fold, as velocities do. */
  readonly folds: boolean;
  /** Whether radials crowd somewhere, see `PolarTable`. */
  readonly crowds: boolean;
}

export function polarText({ twoBytes, radialElevations, folds, crowds }: PolarOptions): RayText {
  return {
    name: 'polar',
    stage: 'field',
    defines: {
      TWO_BYTES: Number(twoBytes),
      RADIAL_ELEVATIONS: Number(radialElevations),
      CROWDS: Number(crowds),
      NO_DATA: 1,
      FOLDS: Number(folds),
    },
    chunks: [decode, polarGates, ...(folds ? [polarFolds] : []), volumePolar],
    samplers: ['uVolume', 'uPolarTable'],
  };
}

const twin = twinOf(radarTwins, ({ polarField }, { volume }) => (isPolar(volume) ? { field: polarField(volume) } : {}));

/** Floats below this stand for no data; for integers, values nearer to 0 than to 1 do. */
const noDataBelow = -3e38;

/**
 * Uploads a radar's gates at their own precision, and the table in which the shader finds them.
 * @throws {VolumeViewError} `format/too-large` if the textures do not fit the device
 */
export function* uploadPolarVolume(gl: Gl, volume: VolumeData, device: Device): Upload<FieldModule> {
  const { samples } = volume;
  if (!isPolar(volume)) throw new TypeError('uploadPolarVolume got a cartesian grid; expected a polar one');
  const polar = volume.grid;
  const layout = layOutRadials(polar, device.maxTextureSize);
  if (!layout) throw tooLarge(polar, device);
  const table = buildPolarTable(polar, layout, device.maxTextureSize);
  if (!table) throw tooLarge(polar, device);
  const radialElevations = hasRadialElevations(polar.sweeps);
  const float = samples instanceof Float32Array;
  const twoBytes = samples instanceof Uint16Array;
  const floatScale = float ? chooseFloatScale(volume) : 1;
  const storedScale = float ? floatScale : twoBytes ? 1 : 255;
  const texels = texelsOf(gl, samples);

  const [texture, tableTexture] = [gl.createTexture(), gl.createTexture()];
  let isWhole = false;
  try {
    gl.bindTexture(gl.TEXTURE_2D, texture);
    allocatePlane(gl, texels, layout);
    if (samples.byteLength > slowBytes) yield Infinity;
    if (gl.getError() === gl.OUT_OF_MEMORY) throw tooLarge(polar, device);
    yield* fillPlane(gl, texture, { texels, ...layout }, (first, count) => {
      const rows = packRows(samples, polar, layout, { first, count });
      return rows instanceof Float32Array ? prepareFloats(rows, floatScale) : rows;
    });
    uploadTable(gl, tableTexture, table);
    if (gl.getError() === gl.OUT_OF_MEMORY) throw tooLarge(polar, device);
    isWhole = true;
  } finally {
    if (!isWhole) for (const unfinished of [texture, tableTexture]) gl.deleteTexture(unfinished);
  }
  const shared = { type: gl.TEXTURE_2D, filter: gl.NEAREST };
  const uniforms: Uniforms = {
    ...gridUniforms(polar),
    ...tableUniforms(table),
    uBeamReach: [polar.beamWidth / 2, widestGap(polar.beamWidth)],
    uTurnsFrom: layout.from,
    uGateTexels: [layout.width, 1 / layout.width, 1 / layout.height],
    uNoDataBelow: float ? noDataBelow : 0.5 / storedScale,
    ...(polar.foldFrom === undefined ? {} : { uFoldFrom: polar.foldFrom / storedScale }),
  };
  const units = [
    textureUnit(gl, { ...shared, texture, samplerName: 'uVolume' }),
    textureUnit(gl, { ...shared, texture: tableTexture, samplerName: 'uPolarTable' }),
  ];
  return {
    ...polarText({ twoBytes, radialElevations, folds: polar.foldFrom !== undefined, crowds: table.crowds }),
    stage: 'field',
    sparesRays: true,
    order: 2,
    twin,
    storedScale,
    bytes: layout.width * layout.height * samples.BYTES_PER_ELEMENT + table.texels.byteLength,
    inputs: () => ({ uniforms, units }),
    dispose: () => [texture, tableTexture].forEach((one) => gl.deleteTexture(one)),
  };
}

function uploadTable(gl: Gl, texture: WebGLTexture, { texels, height }: PolarTable): void {
  gl.bindTexture(gl.TEXTURE_2D, texture);
  prepareUpload(gl);
  const format = isWebGl2(gl) ? gl.RGBA32F : gl.RGBA;
  gl.texImage2D(gl.TEXTURE_2D, 0, format, tableWidth, height, 0, gl.RGBA, gl.FLOAT, texels);
}

function gridUniforms(polar: PolarGrid): Uniforms {
  const { sweeps, box, earthRadius } = polar;
  const [lowest, highest] = [sweeps[0].elevation, sweeps.at(-1)!.elevation];
  return {
    uElevations: [lowestElevation(polar), lowest, highest, highestElevation(polar)],
    uPolarLow: box.low,
    uPolarSize: box.high.map((high, axis) => high - box.low[axis]),
    uCurvature: 1 / earthRadius,
  };
}

function tableUniforms(table: PolarTable): Uniforms {
  const { elevationBinsPerDegree, azimuthBinsPerDegree, azimuthBins, sweepsFrom, radialsFrom, azimuthsFrom, height } =
    table;
  return {
    uPolarBins: [elevationBinsPerDegree, azimuthBinsPerDegree, azimuthBins],
    uTableBegins: [sweepsFrom, radialsFrom, azimuthsFrom],
    uPolarTableRow: 1 / height,
  };
}

function tooLarge({ sweeps }: PolarGrid, device: Device): VolumeViewError {
  const radials = sweeps.reduce((sum, { azimuths }) => sum + azimuths.length, 0);
  const gates = Math.max(...sweeps.map((sweep) => sweep.gates));
  return new VolumeViewError(
    'format/too-large',
    `The radar volume has ${radials} radials of up to ${gates} gates; this device holds what fits one image of ${device.maxTextureSize} x ${device.maxTextureSize} pixels and its memory. Use a file with fewer sweeps.`,
  );
}

import { VolumeViewError } from '../errors.ts';
import { polarSampling } from '../shader/polar.ts';
import { allocateLike } from '../volume/mosaic.ts';
import { highestElevation, lowestElevation } from '../volume/polar-box.ts';
import type { PolarGrid } from '../volume/polar-grid.ts';
import type { Samples, Volume } from '../volume/volume.ts';
import { isWebGl2 } from './device.ts';
import type { Device, Gl } from './device.ts';
import { allocatePlane, fillPlane, prepareUpload } from './fill-texture.ts';
import type { Upload } from './fill-texture.ts';
import { buildPolarTable, repeatedRays, tableWidth } from './polar-table.ts';
import type { PolarTable } from './polar-table.ts';
import { chooseFloatScale, prepareFloats, textureUnit } from './textures.ts';
import type { VolumeTexture } from './textures.ts';
import type { Uniforms } from './uniforms.ts';

export { sliceUniforms, uploadStops } from './slice-textures.ts';

/** Floats below this are no data; for integers, what is nearer to 0 than to 1 is. */
const noDataBelow = -3e38;

/** Where rays lie in their texture: rows, in columns of `rows` of them. */
interface GateLayout {
  readonly rows: number;
  /** Texels of a row: gates of the longest ray. */
  readonly gates: number;
  readonly width: number;
  readonly height: number;
}

/**
 * Upload a radar's gates at their own precision, and the table by which the shader finds them.
 * @throws {VolumeViewError} `format/too-large` where the textures do not fit the device
 */
export function* uploadPolarVolume(gl: Gl, volume: Volume, device: Device): Upload<VolumeTexture> {
  const { samples } = volume;
  const polar = volume.polar!;
  const table = buildPolarTable(polar);
  const rayElevations = table.rayElevationsFrom !== null;
  const layout = layOutGates(polar, device.maxTextureSize);
  if (!layout || table.height > device.maxTextureSize) throw tooLarge(polar, device);
  const float = samples instanceof Float32Array;
  const twoBytes = samples instanceof Uint16Array;
  const floatScale = float ? chooseFloatScale(volume) : 1;
  const storedScale = float ? floatScale : twoBytes ? 65535 : 255;
  const packed = packGates(samples, polar, table, layout);

  const [texture, tableTexture] = [gl.createTexture(), gl.createTexture()];
  let isWhole = false;
  try {
    gl.bindTexture(gl.TEXTURE_2D, texture);
    allocatePlane(gl, packed, layout);
    if (gl.getError() === gl.OUT_OF_MEMORY) throw tooLarge(polar, device);
    yield* fillPlane(gl, texture, { like: packed, ...layout }, (first, count) => {
      const rows = packed.subarray(first * layout.width, (first + count) * layout.width);
      return rows instanceof Float32Array ? prepareFloats(rows, floatScale) : rows;
    });
    uploadTable(gl, tableTexture, table);
    if (gl.getError() === gl.OUT_OF_MEMORY) throw tooLarge(polar, device);
    isWhole = true;
  } finally {
    if (!isWhole) for (const unfinished of [texture, tableTexture]) gl.deleteTexture(unfinished);
  }
  const shared = { type: gl.TEXTURE_2D, filter: gl.NEAREST };
  return {
    unit: textureUnit(gl, { ...shared, texture, samplerName: 'uVolume' }),
    features: { webgl2: isWebGl2(gl), texture3d: false, polar: true, rayElevations, twoBytes, noData: true, filterInShader: true },
    storedScale,
    atlas: null,
    bytes: packed.byteLength + table.texels.byteLength,
    polar: {
      sampling: polarSampling,
      unit: textureUnit(gl, { ...shared, texture: tableTexture, samplerName: 'uPolarTable' }),
      uniforms: {
        ...gridUniforms(polar),
        ...tableUniforms(table),
        ...(rayElevations ? { uRayElevations: [table.rayElevationsFrom, polar.beamWidth / 2] } : {}),
        uGateTexels: [layout.rows, layout.gates, 1 / layout.width, 1 / layout.height],
        uNoDataBelow: float ? noDataBelow : 0.5 / storedScale,
        uFoldFrom: polar.foldFrom === undefined ? -noDataBelow : polar.foldFrom / storedScale,
      },
    },
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
  const { elevationBinsPerDegree, azimuthBinsPerDegree, sweepsFrom, azimuthsFrom, azimuthBins, height } = table;
  return {
    uPolarBins: [elevationBinsPerDegree, azimuthBinsPerDegree, sweepsFrom, azimuthsFrom],
    uAzimuthBins: azimuthBins,
    uPolarTableRow: 1 / height,
  };
}

/** @returns null where the device has no texture for so many */
function layOutGates({ sweeps }: PolarGrid, maxSize: number): GateLayout | null {
  const gates = Math.max(...sweeps.map((sweep) => sweep.gates));
  const rays = sweeps.reduce((sum, { azimuths }) => sum + azimuths.length + repeatedRays, 0);
  const columns = Math.ceil(rays / maxSize);
  const rows = Math.ceil(rays / columns);
  const layout = { rows, gates, width: columns * gates, height: rows };
  return layout.width <= maxSize ? layout : null;
}

function packGates(samples: Samples, { sweeps }: PolarGrid, { firstRows }: PolarTable, layout: GateLayout): Samples {
  const packed = allocateLike(samples, layout.width * layout.height);
  sweeps.forEach(({ azimuths, gates, offset }, i) => {
    const rays = azimuths.length;
    for (let ray = 0; ray < rays + repeatedRays; ray++) {
      const from = offset + (ray % rays) * gates;
      const row = firstRows[i] + ray;
      const column = Math.floor(row / layout.rows);
      packed.set(samples.subarray(from, from + gates), (row - column * layout.rows) * layout.width + column * layout.gates);
    }
  });
  return packed;
}

function tooLarge({ sweeps }: PolarGrid, device: Device): VolumeViewError {
  const rays = sweeps.reduce((sum, { azimuths }) => sum + azimuths.length, 0);
  const gates = Math.max(...sweeps.map((sweep) => sweep.gates));
  return new VolumeViewError(
    'format/too-large',
    `The radar volume has ${rays} rays of up to ${gates} gates; this device holds what fits one image of ${device.maxTextureSize} x ${device.maxTextureSize} pixels and its memory. Use a file with fewer sweeps.`,
  );
}

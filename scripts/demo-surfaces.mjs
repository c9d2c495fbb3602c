// Makes surfaces for the demos: the white matter of the demo head as GIfTI, and the heights of a fictional island as tiles of SRTM.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateSync, gunzipSync, gzipSync } from 'node:zlib';
import { makeNoise, smooth } from './demo-storm.mjs';

/** Number of voxels that become one along each axis, and the value (0 to 255) at which white matter begins. */
const [step, level] = [3, 172];

/** Smoothing rounds: each one goes inwards and then a little more outwards, so that the surface does not shrink (Taubin, SIGGRAPH 1995). */
const [rounds, inwards, outwards] = [10, 0.5, -0.53];

/**
 * The white matter of the head as a closed surface. It is for pictures only, not for measurements.
 * @param {string} folder - of the demos' data
 */
export function writeWhiteMatter(folder) {
  const { samples, dimensions, origin } = readHead(gunzipSync(readFileSync(join(folder, 'mni152-t1.nii.gz'))));
  [1, dimensions[0], dimensions[0] * dimensions[1]].forEach((stride) => blur(samples, stride));
  const inside = keepLargest(
    samples.map((value) => Number(value > level)),
    dimensions,
  );
  const { places, triangles } = wrap(samples, inside, dimensions);
  relax(places, triangles);
  const points = Float32Array.from(places, (x, i) => Math.round((origin[i % 3] + step * x) * 20) / 20);
  const array = (
    /** @type {string} */ intent,
    /** @type {string} */ type,
    /** @type {Float32Array | Int32Array} */ numbers,
  ) => `<DataArray Intent="NIFTI_INTENT_${intent}" DataType="NIFTI_TYPE_${type}" ArrayIndexingOrder="RowMajorOrder" Dimensionality="2" Dim0="${numbers.length / 3}" Dim1="3" Encoding="GZipBase64Binary" Endian="LittleEndian" ExternalFileName="" ExternalFileOffset="0">
${intent === 'POINTSET' ? '<CoordinateSystemTransformMatrix><DataSpace>NIFTI_XFORM_MNI_152</DataSpace><TransformedSpace>NIFTI_XFORM_MNI_152</TransformedSpace><MatrixData>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</MatrixData></CoordinateSystemTransformMatrix>\n' : ''}<Data>${deflateSync(new Uint8Array(numbers.buffer), { level: 9 }).toString('base64')}</Data>
</DataArray>
`;
  const text = `<?xml version="1.0" encoding="UTF-8"?>
<GIFTI Version="1.0" NumberOfDataArrays="2">
${array('POINTSET', 'FLOAT32', points)}${array('TRIANGLE', 'INT32', Int32Array.from(triangles))}</GIFTI>
`;
  writeFileSync(join(folder, 'mni152-white.surf.gii'), text);
  console.log(`mni152-white.surf.gii: ${triangles.length / 3} triangles, ${text.length} bytes`);
}

/** Means of blocks of voxels. @param {Buffer} file */
function readHead(file) {
  const whole = [0, 1, 2].map((axis) => file.readInt16LE(42 + 2 * axis));
  const data = file.subarray(file.readFloatLE(108));
  const dimensions = whole.map((length) => Math.floor(length / step));
  const samples = new Float64Array(dimensions[0] * dimensions[1] * dimensions[2]);
  for (let at = 0, k = 0; k < dimensions[2]; k++) {
    for (let j = 0; j < dimensions[1]; j++) {
      for (let i = 0; i < dimensions[0]; i++, at++) {
        for (let n = 0; n < step ** 3; n++)
          samples[at] +=
            data[
              step * i +
                (n % step) +
                whole[0] *
                  (step * j + (Math.floor(n / step) % step) + whole[1] * (step * k + Math.floor(n / step ** 2)))
            ] /
            step ** 3;
      }
    }
  }
  const origin = [0, 1, 2].map((axis) => file.readFloatLE(280 + 16 * axis + 12) + (step - 1) / 2);
  return { samples, dimensions, origin };
}

/** Weighted means of each sample and its two neighbours, by 1, 2 and 1. @param {Float64Array} samples @param {number} stride */
function blur(samples, stride) {
  const before = samples.slice();
  for (let i = stride; i < samples.length - stride; i++)
    samples[i] = (before[i - stride] + 2 * before[i] + before[i + stride]) / 4;
}

/** The largest connected piece. @param {ArrayLike<number>} inside @param {number[]} dimensions */
function keepLargest(inside, [nx, ny, nz]) {
  const names = new Int32Array(inside.length);
  /** @type {number[]} */
  const sizes = [0];
  for (let seed = 0; seed < inside.length; seed++) {
    if (!inside[seed] || names[seed]) continue;
    const name = sizes.length;
    const open = [seed];
    names[seed] = name;
    sizes.push(0);
    for (let at = open.pop(); at !== undefined; at = open.pop()) {
      sizes[name]++;
      const [i, j, k] = [at % nx, Math.floor(at / nx) % ny, Math.floor(at / nx / ny)];
      for (const [next, fits] of /** @type {const} */ ([
        [at - 1, i > 0],
        [at + 1, i < nx - 1],
        [at - nx, j > 0],
        [at + nx, j < ny - 1],
        [at - nx * ny, k > 0],
        [at + nx * ny, k < nz - 1],
      ])) {
        if (!fits || !inside[next] || names[next]) continue;
        names[next] = name;
        open.push(next);
      }
    }
  }
  const largest = sizes.indexOf(Math.max(...sizes));
  return names.map((name) => Number(name === largest));
}

/**
 * A vertex in each cell that the surface runs through, at the mean of the points where it crosses the edges of the cell, and a square for
 * each edge between inside and outside (surface nets: Gibson, MICCAI 1998).
 * @param {Float64Array} samples @param {Int32Array} inside @param {number[]} dimensions
 */
function wrap(samples, inside, [nx, ny, nz]) {
  const strides = [1, nx, nx * ny];
  const names = new Int32Array(inside.length).fill(-1);
  /** @type {number[][]} */
  const [places, triangles] = [[], []];
  for (let k = 0; k < nz - 1; k++)
    for (let j = 0; j < ny - 1; j++)
      for (let i = 0; i < nx - 1; i++) {
        const at = i + nx * j + nx * ny * k;
        const sum = [0, 0, 0];
        let crossings = 0;
        for (let axis = 0; axis < 3; axis++)
          for (let side = 0; side < 4; side++) {
            const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            const from = at + (side & 1) * strides[u] + (side >> 1) * strides[v];
            const to = from + strides[axis];
            if (inside[from] === inside[to]) continue;
            const share = Math.min(0.95, Math.max(0.05, (level - samples[from]) / (samples[to] - samples[from] || 1)));
            sum[axis] += share;
            sum[u] += side & 1;
            sum[v] += side >> 1;
            crossings++;
          }
        if (crossings === 0) continue;
        names[at] = places.length / 3;
        places.push(i + sum[0] / crossings, j + sum[1] / crossings, k + sum[2] / crossings);
      }
  for (let k = 1; k < nz - 1; k++)
    for (let j = 1; j < ny - 1; j++)
      for (let i = 1; i < nx - 1; i++) {
        const at = i + nx * j + nx * ny * k;
        for (let axis = 0; axis < 3; axis++) {
          if (inside[at] === inside[at + strides[axis]]) continue;
          const [u, v] = [strides[(axis + 1) % 3], strides[(axis + 2) % 3]];
          const around = [names[at - u - v], names[at - v], names[at], names[at - u]];
          const [a, b, c, d] = [0, 1, 2, 3].map((i) => around[inside[at] ? i : 3 - i]);
          triangles.push(a, b, c, a, c, d);
        }
      }
  return { places, triangles };
}

/** @param {number[]} places @param {number[]} triangles */
function relax(places, triangles) {
  for (let round = 0; round < 2 * rounds; round++) {
    const [sums, counts] = [new Float64Array(places.length), new Uint16Array(places.length / 3)];
    for (let i = 0; i < triangles.length; i += 3)
      for (let corner = 0; corner < 3; corner++) {
        const [own, next] = [triangles[i + corner], triangles[i + ((corner + 1) % 3)]];
        for (let axis = 0; axis < 3; axis++) sums[3 * own + axis] += places[3 * next + axis];
        counts[own]++;
      }
    for (let i = 0; i < places.length; i++)
      places[i] += (round % 2 ? outwards : inwards) * (sums[i] / counts[Math.floor(i / 3)] - places[i]);
  }
}

/** Number of samples along the side of a tile, one every 3 seconds of arc. */
const side = 1201;

/** Metres to which heights are rounded, so that the files are small. */
const rounding = 10;

/** Four tiles around the point where the equator meets the prime meridian; in reality there is only sea. @param {string} folder */
export function writeIsland(folder) {
  mkdirSync(join(folder, 'island'), { recursive: true });
  const noises = [1, 2, 3, 4].map((seed) => makeNoise(20 + seed));
  for (const [south, west] of [
    [0, 0],
    [0, -1],
    [-1, 0],
    [-1, -1],
  ]) {
    const tile = Buffer.alloc(2 * side * side);
    for (let row = 0; row < side; row++) {
      for (let column = 0; column < side; column++) {
        const height = islandHeight(
          (west + column / (side - 1)) * 111.2,
          (south + 1 - row / (side - 1)) * 111.2,
          noises,
        );
        tile.writeInt16BE(rounding * Math.round(height / rounding), 2 * (row * side + column));
      }
    }
    const packed = gzipSync(tile, { level: 9 });
    packed[9] = 255; // The byte for the operating system is set, so that all systems write the same bytes.
    const name = `${south < 0 ? 'S01' : 'N00'}${west < 0 ? 'W001' : 'E000'}.hgt.gz`;
    writeFileSync(join(folder, 'island', name), packed);
    console.log(`island/${name}: ${packed.length} bytes`);
  }
}

/**
 * Metres above the sea: ranges from the south-west to the north-east, ridges on them, hills, and valleys where they meet.
 * @param {number} x - km east @param {number} y - km north @param {((x: number, y: number, z: number) => number)[]} noises
 */
function islandHeight(x, y, [coast, ranges, ridges, hills]) {
  const shore = 92 + 24 * coast(x / 45, y / 45, 0) + 9 * coast(x / 13, y / 13, 7);
  const land = smooth(Math.hypot(x, y * 1.15), shore, shore - 38);
  if (land <= 0) return 0;
  const along = Math.exp(-((((x - y) / Math.SQRT2 + 14) / 46) ** 2));
  const ridge = (/** @type {number} */ size, /** @type {number} */ z) =>
    (1 - Math.abs(ridges(x / size, y / size, z))) ** 2;
  const mountains =
    (0.65 + 0.35 * ranges(x / 40, y / 40, 3)) * (1500 * ridge(26, 0) + 900 * ridge(11, 5) + 350 * ridge(4.5, 9));
  return land * (40 + 90 * (1 + hills(x / 9, y / 9, 0)) + along * mountains);
}

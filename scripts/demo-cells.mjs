// Makes a synthetic image of cells as a light microscope would take it, in three channels, for the demo of microscopy: DNA, microtubules and mitochondria of
// cells on glass, one of which is dividing. It is an OME-Zarr 0.5 in one file. No data of any cell.
import { writeFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { zipSync } from 'fflate';

/** @typedef {readonly [number, number, number]} Place - x, y and z, micrometres */

/** Voxels along x, y and z, and their edges in micrometres. */
const dimensions = /** @type {const} */ ([192, 192, 40]);
const spacing = /** @type {const} */ ([0.25, 0.25, 0.35]);

/** Voxels of a chunk along z, y and x. */
const chunk = [40, 96, 96];

/** What a camera gives where there is no light, and where there is most, of 255. */
const [dark, bright] = [6, 250];

/** Random numbers from 0 to 1, the same in every run. @param {number} seed */
function randomNumbers(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) | 0;
    return (state >>> 8) / 2 ** 24;
  };
}

/** Light that is added spot by spot. A microscope blurs more along z. */
class Light {
  values = new Float32Array(dimensions[0] * dimensions[1] * dimensions[2]);

  /**
   * A spot of light.
   * @param {Place} place @param {number} radius - micrometres @param {number} strength
   */
  spot([x, y, z], radius, strength) {
    const [sx, sy, sz] = [radius, radius, Math.max(1.8 * radius, 0.5)];
    const span = [sx, sy, sz].map((sigma, axis) => (2.6 * sigma) / spacing[axis]);
    const at = [x / spacing[0], y / spacing[1], z / spacing[2]];
    const [from, to] = [-1, 1].map((side) =>
      at.map((one, axis) => Math.min(dimensions[axis] - 1, Math.max(0, Math.round(one + side * span[axis])))),
    );
    for (let k = from[2]; k <= to[2]; k++)
      for (let j = from[1]; j <= to[1]; j++)
        for (let i = from[0]; i <= to[0]; i++) {
          const away =
            (((i - at[0]) * spacing[0]) / sx) ** 2 +
            (((j - at[1]) * spacing[1]) / sy) ** 2 +
            (((k - at[2]) * spacing[2]) / sz) ** 2;
          this.values[i + dimensions[0] * (j + dimensions[1] * k)] += strength * Math.exp(-0.5 * away);
        }
  }

  /**
   * A line of spots.
   * @param {readonly Place[]} path @param {number} radius @param {(share: number) => number} strength - by the share of the way
   */
  line(path, radius, strength) {
    for (let i = 0; i + 1 < path.length; i++) {
      const [from, to] = [path[i], path[i + 1]];
      const count = Math.max(1, Math.ceil(Math.hypot(...from.map((one, a) => to[a] - one)) / (0.8 * radius)));
      for (let step = 0; step < count; step++) {
        const place = /** @type {Place} */ (
          /** @type {unknown} */ (from.map((one, a) => one + ((to[a] - one) * step) / count))
        );
        this.spot(place, radius, strength((i + step / count) / (path.length - 1)));
      }
    }
  }
}

/**
 * Cells on the glass: the middle, the long axis, the half-lengths along it and across, and the height of the middle.
 * @type {readonly { x: number, y: number, turn: number, long: number, short: number, seed: number }[]}
 */
const resting = [
  { x: 11.5, y: 14, turn: 0.5, long: 12.5, short: 8.6, seed: 3 },
  { x: 37, y: 11.5, turn: 2.5, long: 12, short: 8.2, seed: 11 },
  { x: 10.5, y: 35.5, turn: 2.2, long: 12.6, short: 8.4, seed: 23 },
  { x: 36.5, y: 37, turn: 0.75, long: 12.8, short: 8.8, seed: 31 },
];

/** The cell that divides: round, and higher than the others. */
const dividing = { x: 24, y: 24.5, z: 6.6, turn: 0.9, radius: 7.2, seed: 47 };

/** The height of a cell above the glass at a share of its way to the edge, 0..1. @param {number} share */
const heightAt = (share) => 1 + 5.6 * Math.max(0, 1 - share ** 1.5) ** 1.2;

/** From the axes of a cell to the image. @param {{ x: number, y: number, turn: number }} cell @param {number} u @param {number} v */
const toImage = ({ x, y, turn }, u, v) => [
  x + u * Math.cos(turn) - v * Math.sin(turn),
  y + u * Math.sin(turn) + v * Math.cos(turn),
];

/** @typedef {{ dna: Light, tubes: Light, mitochondria: Light }} Lights */

/** @param {Lights} lights @param {typeof resting[number]} cell */
function paintResting({ dna, tubes, mitochondria }, cell) {
  const random = randomNumbers(cell.seed);
  const around = (/** @type {number} */ reach) => reach * (2 * random() - 1);
  /** @type {(u: number, v: number, height: number) => Place} */
  const place = (u, v, height) => {
    const share = Math.hypot(u / cell.long, v / cell.short);
    const [x, y] = toImage(cell, u, v);
    return [x, y, 1.2 + height * (heightAt(share) - 0.6)];
  };
  // The nucleus: an ellipsoid of spots, denser under its skin and in some knots; two nucleoli are dark.
  const nucleus = { long: 5.4, short: 4.1, high: 2.1, z: 3.6 };
  const knots = Array.from({ length: 22 }, () => {
    const [a, b, r] = [around(Math.PI), around(1), 0.9 * random() ** 0.4];
    return [r * Math.cos(a) * Math.sqrt(1 - b * b), r * Math.sin(a) * Math.sqrt(1 - b * b), r * b];
  });
  const dents = [
    [0.35, 0.2, 0.1],
    [-0.4, -0.25, 0],
  ];
  for (let i = 0; i < 5200; i++) {
    const p = [around(1), around(1), around(1)];
    const r = Math.hypot(...p);
    if (r > 1) continue;
    const near = (/** @type {number[]} */ of) => Math.hypot(...p.map((one, a) => one - of[a]));
    const dent = Math.min(...dents.map(near));
    const knot = Math.min(...knots.map(near));
    const strength =
      (0.3 + 0.45 * r ** 8 + 1.5 * Math.exp(-((knot / 0.13) ** 2))) * (1 - Math.exp(-((dent / 0.2) ** 4)));
    const [x, y] = toImage(cell, nucleus.long * p[0], nucleus.short * p[1]);
    dna.spot([x, y, nucleus.z + nucleus.high * p[2]], 0.4, strength);
  }
  /** Whether a place is in the nucleus. @param {number} u @param {number} v @param {number} z */
  const inNucleus = (u, v, z) => (u / 5.6) ** 2 + (v / 4.3) ** 2 + ((z - nucleus.z) / 2.3) ** 2 < 1;
  // Microtubules run from a centre beside the nucleus to the edge, in bends.
  const centre = [around(1) > 0 ? 5.9 : -5.9, around(1.5)];
  for (let i = 0; i < 110; i++) {
    const angle = 2 * Math.PI * (i / 110) + around(0.05);
    let [u, v] = centre;
    let [heading, bend] = [angle, around(0.06)];
    const [path, layer] = [/** @type {Place[]} */ ([]), random()];
    for (let step = 0; step < 60; step++) {
      const share = Math.hypot(u / cell.long, v / cell.short);
      if (share > 0.97) break;
      const at = place(u, v, 0.1 + 0.85 * layer);
      if (!inNucleus(u, v, at[2])) path.push(at);
      else path.push([at[0], at[1], layer > 0.4 ? nucleus.z + 2.6 : nucleus.z - 2.4]);
      bend = 0.85 * bend + around(0.07);
      // Near the edge they turn along it.
      heading += bend + 0.18 * Math.max(0, share - 0.75) * Math.sign(Math.sin(heading - Math.atan2(v, u)) || 1);
      u += 0.45 * Math.cos(heading);
      v += 0.45 * Math.sin(heading);
    }
    if (path.length > 6) tubes.line(path, 0.16, (way) => 1 - 0.45 * way);
  }
  for (let i = 0; i < 40; i++) tubes.spot(place(centre[0] + around(0.4), centre[1] + around(0.4), 0.5), 0.3, 0.5);
  // Mitochondria: worms around the nucleus, fewer far from it.
  for (let i = 0; i < 90; i++) {
    const angle = around(Math.PI);
    const from = 1.12 + 0.75 * random() ** 1.6;
    let [u, v] = [5.4 * from * Math.cos(angle), 4.1 * from * Math.sin(angle)];
    let heading = angle + (random() < 0.7 ? Math.PI / 2 : 0) + around(0.6);
    let bend = around(0.1);
    const [path, layer, length] = [/** @type {Place[]} */ ([]), 0.15 + 0.7 * random(), 5 + 14 * random()];
    for (let step = 0; step < length; step++) {
      if (Math.hypot(u / cell.long, v / cell.short) > 0.88) break;
      const at = place(u, v, layer);
      if (inNucleus(u, v, at[2])) break;
      path.push(at);
      bend = 0.8 * bend + around(0.18);
      heading += bend;
      u += 0.3 * Math.cos(heading);
      v += 0.3 * Math.sin(heading);
    }
    if (path.length > 2) mitochondria.line(path, 0.25, () => 0.8 + 0.4 * random());
  }
}

/** @param {Lights} lights */
function paintDividing({ dna, tubes, mitochondria }) {
  const random = randomNumbers(dividing.seed);
  const around = (/** @type {number} */ reach) => reach * (2 * random() - 1);
  /** Along the spindle, across it, and up. @type {(u: number, v: number, w: number) => Place} */
  const place = (u, v, w) => {
    const [x, y] = toImage(dividing, u, v);
    return [x, y, dividing.z + w];
  };
  // Chromosomes: short rods, side by side in a plane between the poles.
  for (let i = 0; i < 46; i++) {
    const [angle, r] = [around(Math.PI), 4 * Math.sqrt(random())];
    const middle = [around(0.35), r * Math.cos(angle), 0.9 * r * Math.sin(angle)];
    const lean = [around(0.5), around(0.8), around(0.8)];
    const rod = [-1, -0.5, 0, 0.5, 1].map((t) =>
      place(middle[0] + t * lean[0], middle[1] + t * lean[1], middle[2] + t * lean[2]),
    );
    dna.line(rod, 0.36, () => 1.5);
  }
  // The spindle: from both poles to the chromosomes, and stars of short ones outwards.
  for (const side of [-1, 1])
    for (let i = 0; i < 64; i++) {
      const angle = around(Math.PI);
      const r = 3.6 * Math.sqrt(random());
      const inner = Array.from({ length: 9 }, (_, step) => {
        const t = step / 8;
        const wide = r * Math.sin((t * Math.PI) / 2) ** 0.9;
        return place(side * 4.3 * (1 - 0.93 * t), wide * Math.cos(angle), 0.9 * wide * Math.sin(angle));
      });
      tubes.line(inner, 0.17, (t) => 0.95 - 0.35 * t);
      if (i % 3) continue;
      const out = [0.5 + around(1), around(1.3), around(1.3)];
      const star = Array.from({ length: 5 }, (_, step) =>
        place(side * (4.3 + 0.45 * step * out[0]), 0.55 * step * out[1], 0.5 * step * out[2]),
      );
      tubes.line(star, 0.16, (t) => 0.7 - 0.5 * t);
    }
  // Mitochondria keep to the outside of the cell.
  for (let i = 0; i < 210; i++) {
    const b = around(0.95);
    const angle = around(Math.PI);
    const r = dividing.radius * (0.78 + 0.18 * random());
    const at = [r * Math.cos(angle) * Math.sqrt(1 - b * b), r * Math.sin(angle) * Math.sqrt(1 - b * b), 0.82 * r * b];
    if (Math.abs(at[0]) < 5.2 && Math.hypot(at[1], at[2]) < 4) continue;
    const lean = [around(0.5), around(0.5), around(0.3)];
    mitochondria.line(
      [-1, 0, 1].map((t) => place(at[0] + t * lean[0], at[1] + t * lean[1], at[2] + t * lean[2])),
      0.27,
      () => 0.9,
    );
  }
}

/** Numbers of 8 bits; what is brightest is a few voxels, which are cut. @param {Light} light @param {number} share - that is kept */
function expose({ values }, share) {
  const sorted = new Float32Array(values);
  sorted.sort();
  const most = sorted[Math.floor(share * (sorted.length - 1))];
  return Uint8Array.from(values, (value) => Math.round(dark + (bright - dark) * Math.min(1, value / most)));
}

/** Means of 2 x 2 x 2 voxels. @param {Uint8Array} all @param {readonly number[]} size */
function halve(all, [nx, ny, nz]) {
  const to = [nx / 2, ny / 2, nz / 2];
  const values = new Uint8Array(to[0] * to[1] * to[2]);
  for (let k = 0, at = 0; k < to[2]; k++)
    for (let j = 0; j < to[1]; j++)
      for (let i = 0; i < to[0]; i++, at++) {
        let sum = 0;
        for (let c = 0; c < 8; c++)
          sum += all[2 * i + (c & 1) + nx * (2 * j + ((c >> 1) & 1) + ny * (2 * k + (c >> 2)))];
        values[at] = Math.round(sum / 8);
      }
  return { values, size: to };
}

/** The same bytes on all systems. @param {Uint8Array} bytes */
function pack(bytes) {
  const packed = gzipSync(bytes, { level: 9 });
  packed[9] = 255;
  return new Uint8Array(packed);
}

/** @param {string} path - of the file, which ends with `.ozx` */
export function writeDemoCells(path) {
  const lights = { dna: new Light(), tubes: new Light(), mitochondria: new Light() };
  for (const cell of resting) paintResting(lights, cell);
  paintDividing(lights);
  const channels = [
    { label: 'DNA', color: '3D7BFF', values: expose(lights.dna, 0.9988), start: 16, end: 235 },
    { label: 'Microtubules', color: '2FE870', values: expose(lights.tubes, 0.9985), start: 20, end: 205 },
    { label: 'Mitochondria', color: 'FF4FC3', values: expose(lights.mitochondria, 0.9985), start: 22, end: 215 },
  ];
  /** @type {Record<string, Uint8Array>} */
  const files = {};
  const json = (/** @type {unknown} */ value) => new TextEncoder().encode(JSON.stringify(value));
  const levels = [0, 1];
  files['zarr.json'] = json({
    zarr_format: 3,
    node_type: 'group',
    attributes: {
      ome: {
        version: '0.5',
        multiscales: [
          {
            name: 'cells',
            axes: [
              { name: 'c', type: 'channel' },
              ...['z', 'y', 'x'].map((name) => ({ name, type: 'space', unit: 'micrometer' })),
            ],
            datasets: levels.map((level) => ({
              path: String(level),
              coordinateTransformations: [
                { type: 'scale', scale: [1, ...[2, 1, 0].map((axis) => 2 ** level * spacing[axis])] },
                // The middle of the first voxel is half of it away from the edge, at each level.
                { type: 'translation', translation: [0, ...[2, 1, 0].map((axis) => (2 ** level / 2) * spacing[axis])] },
              ],
            })),
          },
        ],
        omero: {
          channels: channels.map(({ label, color, start, end }) => ({
            label,
            color,
            active: true,
            window: { min: 0, max: 255, start, end },
          })),
        },
      },
    },
  });
  for (const [c, { values: all }] of channels.entries()) {
    /** @type {{ values: Uint8Array, size: number[] }} */
    let block = { values: all, size: [...dimensions] };
    for (const level of levels) {
      if (level > 0) block = halve(block.values, block.size);
      const [nx, ny, nz] = block.size;
      const lengths = chunk.map((n, axis) => Math.min(n, [nz, ny, nx][axis]));
      files[`${level}/zarr.json`] = json({
        zarr_format: 3,
        node_type: 'array',
        shape: [channels.length, nz, ny, nx],
        data_type: 'uint8',
        chunk_grid: { name: 'regular', configuration: { chunk_shape: [1, ...lengths] } },
        chunk_key_encoding: { name: 'default', configuration: { separator: '/' } },
        fill_value: 0,
        codecs: [{ name: 'bytes' }, { name: 'gzip', configuration: { level: 9 } }],
        dimension_names: ['c', 'z', 'y', 'x'],
        attributes: {},
      });
      for (let z = 0; z * lengths[0] < nz; z++)
        for (let y = 0; y * lengths[1] < ny; y++)
          for (let x = 0; x * lengths[2] < nx; x++) {
            const part = new Uint8Array(lengths[0] * lengths[1] * lengths[2]);
            for (let k = 0, at = 0; k < lengths[0]; k++)
              for (let j = 0; j < lengths[1]; j++, at += lengths[2]) {
                const from = x * lengths[2] + nx * (y * lengths[1] + j + ny * (z * lengths[0] + k));
                part.set(block.values.subarray(from, from + lengths[2]), at);
              }
            files[`${level}/c/${c}/${z}/${y}/${x}`] = pack(part);
          }
    }
  }
  const zip = zipSync(files, { level: 0, mtime: new Date(2000, 0, 1) });
  writeFileSync(path, zip);
  console.log(`${path}: ${dimensions.join(' x ')}, ${channels.length} channels, ${zip.length} bytes`);
}

// Makes a synthetic map of z values for the demo of layers, as in a study in which people moved the fingers of their right hand: no data of
// any person. It is in the space of the head that it belongs to, on a coarser grid of its own, and follows the grey matter of that head.
import { writeFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';

/** Edge of a voxel, mm. */
const spacing = 3;

/** The z value of one step of the integers in the file. */
const slope = 0.1;

/**
 * Approximate results of such a study: position in MNI space, mm; extent along x, y and z; z value in the middle.
 * @type {readonly { at: readonly [number, number, number], reach: readonly [number, number, number], z: number }[]}
 */
const places = [
  { at: [-37, -24, 57], reach: [11, 10, 11], z: 11 }, // Motor and sensory cortex of the hand, left.
  { at: [-47, -24, 46], reach: [9, 9, 9], z: 6 },
  { at: [-4, -7, 56], reach: [7, 10, 9], z: 7.5 }, // Supplementary motor area.
  { at: [-52, -24, 20], reach: [8, 8, 6], z: 5 }, // Secondary somatosensory cortex.
  { at: [52, -26, 24], reach: [8, 8, 6], z: 3.6 },
  { at: [-14, -20, 6], reach: [7, 7, 6], z: 4.6 }, // Thalamus.
  { at: [-26, 0, 2], reach: [6, 9, 6], z: 3.8 }, // Putamen.
  { at: [19, -52, -23], reach: [11, 9, 7], z: 8.5 }, // Cerebellum, right.
  { at: [38, -24, 57], reach: [11, 10, 11], z: -5.5 }, // The cortex of the other hand is at rest.
  { at: [0, -56, 28], reach: [9, 12, 12], z: -5.5 }, // So are the areas of day-dreaming.
  { at: [-46, -68, 34], reach: [10, 10, 10], z: -4.6 },
  { at: [48, -66, 34], reach: [10, 10, 10], z: -4.6 },
  { at: [0, 52, 2], reach: [10, 10, 14], z: -4.8 },
];

/** Random numbers from -1 to 1, the same in every run. @param {number} seed */
function randomNumbers(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) | 0;
    return state / 2 ** 31;
  };
}

/**
 * @param {string} path - of the file
 * @param {{ dimensions: readonly number[], origin: readonly number[], samples: import('../src/volume/samples.ts').Samples }} head - 1 mm along x, y and z
 */
export function writeDemoMotor(path, { dimensions: [nx, ny, nz], origin, samples }) {
  const size = [nx, ny, nz].map((n) => Math.floor(n / spacing));
  let largest = 0;
  for (const x of samples) largest = Math.max(largest, x);
  /**
   * Share of grey matter in a voxel, by its brightness, which is between that around the brain and that of white matter.
   * @param {number} bright
   */
  const grey = (bright) => Math.exp(-(((bright / largest - 0.62) / 0.16) ** 2));
  const waves = Array.from(
    { length: 24 },
    ((random) => () => ({ k: [random(), random(), random()].map((x) => 0.35 * x), phase: 3 * random() }))(
      randomNumbers(7),
    ),
  );
  const values = new Uint8Array(size[0] * size[1] * size[2]);
  for (let k = 0, at = 0; k < size[2]; k++)
    for (let j = 0; j < size[1]; j++)
      for (let i = 0; i < size[0]; i++, at++) {
        let [share, inside] = [0, 0];
        for (let dz = 0; dz < spacing; dz++)
          for (let dy = 0; dy < spacing; dy++)
            for (let dx = 0; dx < spacing; dx++) {
              const bright = samples[i * spacing + dx + nx * (j * spacing + dy + ny * (k * spacing + dz))];
              share += grey(bright) / spacing ** 3;
              inside += Number(bright > 0.1 * largest) / spacing ** 3;
            }
        const place = [i, j, k].map((n, axis) => origin[axis] + n * spacing + (spacing - 1) / 2);
        let z = 0;
        for (const { at: middle, reach, z: max } of places)
          z += max * Math.exp(-0.5 * middle.reduce((sum, x, axis) => sum + ((place[axis] - x) / reach[axis]) ** 2, 0));
        for (const { k: wave, phase } of waves)
          z +=
            (0.9 / Math.sqrt(waves.length)) *
            Math.cos(phase + wave.reduce((sum, x, axis) => sum + x * place[axis], 0)) *
            Math.SQRT2;
        values[at] = Math.round(128 + (inside > 0.5 ? z * (0.25 + 0.75 * Math.min(1, 1.3 * share)) : 0) / slope);
      }
  const file = Buffer.alloc(352 + values.length);
  file.writeInt32LE(348, 0);
  [3, ...size, 1, 1, 1, 1].forEach((n, i) => file.writeInt16LE(n, 40 + 2 * i));
  file.writeInt16LE(5, 68); // z values
  file.writeInt16LE(2, 70); // uint8
  file.writeInt16LE(8, 72);
  [1, spacing, spacing, spacing, 1, 1, 1, 1].forEach((n, i) => file.writeFloatLE(n, 76 + 4 * i));
  file.writeFloatLE(352, 108);
  file.writeFloatLE(slope, 112);
  file.writeFloatLE(-128 * slope, 116);
  file.writeUInt8(2, 123);
  file.write('synthetic z map, right hand moving, volume-view', 148, 79, 'latin1');
  file.writeInt16LE(4, 254);
  [0, 1, 2].forEach((axis) => {
    file.writeFloatLE(spacing, 280 + 16 * axis + 4 * axis);
    file.writeFloatLE(origin[axis] + (spacing - 1) / 2, 280 + 16 * axis + 12);
  });
  file.write('n+1\0', 344, 'latin1');
  Buffer.from(values).copy(file, 352);
  const packed = gzipSync(file, { level: 9 });
  packed[9] = 255; // The byte for the operating system is set, so that all systems write the same bytes.
  writeFileSync(path, packed);
  console.log(`${path.split('/').at(-1)}: ${size.join(' x ')}, ${packed.length} bytes`);
}

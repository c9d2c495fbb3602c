// Makes a synthetic thunderstorm on a cartesian grid, reflectivity in dBZ: two cells, their anvil, and rain behind them. World: x east, y
// north, z up, metres; the wind higher up blows to the north-east.
import { Painter, seededRandom } from './demo-painter.mjs';

export const noEcho = -32;

/** @returns {Painter} */
export function paintStorm() {
  const storm = new Painter([128, 128, 48], [1000, 1000, 400], [-63500, -63500, 200], noEcho);
  const billows = makeNoise(7);
  storm.all((index, x, y, z) => {
    const turbulence = billows(x / 9000, y / 9000, z / 3200) + 0.5 * billows(x / 4000, y / 4000, z / 1500);
    const [u, v] = [x + 2400 * turbulence, y + 2400 * billows(x / 6000, z / 2200, y / 6000)];
    const parts = [
      cell(u, v, z, { x: -14000, y: -8000, reach: 8500, top: 15000, peak: 62 }),
      cell(u, v, z, { x: 16000, y: -20000, reach: 6800, top: 13000, peak: 57 }),
      cell(u, v, z, { x: -30000, y: -22000, reach: 4600, top: 8500, peak: 46 }),
      anvil(u, v, z),
      rain(u, v, z),
    ];
    const dbz = Math.max(...parts) + 5 * turbulence;
    storm.values[index] = dbz < 4 ? noEcho : Math.round(dbz * 2) / 2;
  });
  return storm;
}

/**
 * A leaning column: strongest near the ground, weaker towards its top.
 * @param {number} x @param {number} y @param {number} z
 * @param {{ x: number, y: number, reach: number, top: number, peak: number }} shape - peak: dBZ
 */
function cell(x, y, z, { x: cx, y: cy, reach, top, peak }) {
  const lean = 0.45 * z;
  const away = Math.hypot(x - cx - lean, y - cy - 0.35 * lean) / (reach * (1 + 0.35 * smooth(z, 0.6 * top, top)));
  const core = peak - 26 * away ** 1.6;
  const aloft = 34 * smooth(z, 0.45 * top, top * 1.02) ** 1.5;
  const vault =
    z < 3000 ? 8 * (1 - z / 3000) * Math.exp(-(((x - cx - 5200) / 3500) ** 2) - ((y - cy + 3000) / 3500) ** 2) : 0;
  return core - aloft - vault - (z > top ? (z - top) / 60 : 0);
}

/** The ice that spreads downwind from the tops of the cells. @param {number} x @param {number} y @param {number} z */
function anvil(x, y, z) {
  const [along, across] = [(x + 8000) * 0.8 + (y + 8000) * 0.6, -(x + 8000) * 0.6 + (y + 8000) * 0.8];
  const middle = 11600 + 0.012 * along;
  const thick = 1900 * (1 - 0.45 * smooth(along, 0, 60000));
  const width = 14000 + 0.3 * Math.max(0, along);
  const edge = ((along - 14000) / 40000) ** 4 + (across / width) ** 2;
  return 27 - 20 * edge - 14 * ((z - middle) / thick) ** 2;
}

/** Steady rain behind the cells, strongest where the snow melts, at 4 km. @param {number} x @param {number} y @param {number} z */
function rain(x, y, z) {
  const edge = ((x + 26000) / 30000) ** 2 + ((y - 14000) / 25000) ** 2;
  const melting = 8 * Math.exp(-(((z - 4000) / 450) ** 2));
  return 30 - 22 * edge ** 1.5 + melting - (z > 4200 ? (z - 4200) / 260 : 0);
}

/** 0 below `low`, 1 above `high`, smooth between. @param {number} value @param {number} low @param {number} high */
export function smooth(value, low, high) {
  const t = Math.min(1, Math.max(0, (value - low) / (high - low)));
  return t * t * (3 - 2 * t);
}

/** Smooth noise from -1 to 1 that repeats every 16. @param {number} seed */
export function makeNoise(seed) {
  const random = seededRandom(seed);
  const lattice = Float32Array.from({ length: 4096 }, () => random() * 2 - 1);
  const at = (/** @type {number} */ i, /** @type {number} */ j, /** @type {number} */ k) =>
    lattice[((k & 15) << 8) | ((j & 15) << 4) | (i & 15)];
  const mix = (/** @type {number} */ a, /** @type {number} */ b, /** @type {number} */ t) =>
    a + (b - a) * t * t * (3 - 2 * t);
  return (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) => {
    const [i, j, k] = [x, y, z].map(Math.floor);
    const [u, v, w] = [x - i, y - j, z - k];
    const layer = (/** @type {number} */ n) =>
      mix(mix(at(i, j, n), at(i + 1, j, n), u), mix(at(i, j + 1, n), at(i + 1, j + 1, n), u), v);
    return mix(layer(k), layer(k + 1), w);
  };
}

// Makes the synthetic weather of an afternoon: a supercell with hail, its anvil and a rotating updraft, two smaller cells, and a line of
// thunderstorms with steady rain behind it. Everything moves and changes with time. Units: metres east, north and up of the radar, and
// seconds after the first scan. The shapes are invented; sizes, heights and strengths are those in textbooks:
//   Houze, Cloud Dynamics (2nd ed. 2014), ch. 8 (convective clouds, supercells) and 9 (lines, bright band);
//   Doviak and Zrnic, Doppler Radar and Weather Observations (1993), ch. 8 and 9.
import { makeNoise, smooth } from './demo-storm.mjs';

/** Height of 0 °C: snow melts just below. */
const freezingLevel = 3900;

/**
 * A convective cell.
 * @typedef {object} Cell
 * @property {[number, number]} from - its position at the first scan
 * @property {[number, number]} motion - m/s
 * @property {number} reach - metres to the distance at which it is 20 dB weaker
 * @property {[number, number]} top - height of its top, at the first scan and 20 minutes later
 * @property {[number, number]} peak - dBZ, at the same two times
 */

/** @type {Cell} */
const supercell = { from: [-36_000, -58_000], motion: [13, 6], reach: 13_500, top: [15_000, 15_800], peak: [61, 63] };

/** @type {Cell[]} */
const cells = [
  supercell,
  { from: [38_000, -78_000], motion: [12, 7], reach: 9500, top: [7500, 12_500], peak: [46, 57] },
  { from: [66_000, 16_000], motion: [13, 5], reach: 10_500, top: [11_500, 7800], peak: [53, 40] },
  // Showers: some grow, some become weaker.
  ...[
    [95_000, -40_000],
    [18_000, -112_000],
    [110_000, 60_000],
    [-98_000, -66_000],
    [74_000, -104_000],
  ].map(
    (from, i) =>
      /** @type {Cell} */ ({
        from,
        motion: [12, 5],
        reach: 5500 + 700 * i,
        top: [6500 + 500 * i, 9000 - 600 * i],
        peak: [36 + 2 * i, 46 - 3 * i],
      }),
  ),
  // A line of thunderstorms.
  ...Array.from({ length: 9 }, (_, i) => lineCell(i)),
];

/** One cell of the line, from the south-west to the north-east. @param {number} i @returns {Cell} */
function lineCell(i) {
  return {
    from: [-50_000 + 9000 * i + 3000 * Math.sin(7 * i), 4000 + 12_500 * i + 3000 * Math.cos(5 * i)],
    motion: [15, 2],
    reach: 8800 + 1600 * Math.sin(3 * i),
    top: [12_000 + 1800 * Math.sin(2 * i), 12_000 + 1800 * Math.sin(2 * i + 1)],
    peak: [53 + 4 * Math.cos(4 * i), 53 + 4 * Math.cos(4 * i + 1.2)],
  };
}

const billows = makeNoise(11);
const eddies = makeNoise(12);

/**
 * The weather at one moment.
 * @param {number} time - seconds
 */
export function weatherAt(time) {
  const age = Math.min(1, Math.max(0, time / 1200));
  const now = cells.map(({ from, motion, reach, top, peak }) => ({
    x: from[0] + motion[0] * time,
    y: from[1] + motion[1] * time,
    reach,
    top: top[0] + (top[1] - top[0]) * age,
    peak: peak[0] + (peak[1] - peak[0]) * age,
  }));
  const [big] = now;
  const rainX = -66_000 + 14 * time;
  const rainY = 78_000 + 3 * time;

  return {
    /** Reflectivity factor, mm^6 m^-3. @param {number} x @param {number} y @param {number} z */
    reflectivity(x, y, z) {
      if (z > 17_000) return 0;
      const [along, across] = [x - 13 * time, y - 6 * time]; // The turbulence moves with the storms.
      const turbulence =
        billows(along / 7000, across / 7000, z / 3000) + 0.5 * eddies(along / 2600, across / 2600, z / 1300);
      const [u, v] = [x + 2400 * turbulence, y + 3600 * eddies(across / 6000, along / 6000, z / 2500)];
      let total = hook(u, v, z, big) + anvil(u, v, z, big) + steadyRain(u - rainX, v - rainY, z);
      for (const cell of now) total += convection(u, v, z, cell);
      return total * 10 ** (0.45 * turbulence);
    },
    /**
     * Wind, m/s to the east, to the north and up, without the fall speed of rain and hail.
     * @param {number} x
     * @param {number} y
     * @param {number} z
     */
    wind: (x, y, z) => wind(x, y, z, big),
  };
}

/** Speed at which rain, or snow above the freezing level, falls through the air, m/s. @param {number} z @param {number} reflectivity */
export function fallSpeed(z, reflectivity) {
  // Atlas, Srivastava and Sekhon 1973; air is thinner higher up (Foote and du Toit 1969).
  const speed = z > freezingLevel ? 1.2 : 2.6 * Math.max(1, reflectivity) ** 0.107;
  return speed * Math.exp((0.4 * z) / 10_000);
}

/** @typedef {{ x: number, y: number, reach: number, top: number, peak: number }} CellNow */

/**
 * A column that leans with the wind: strongest from the ground to its middle, weak at the top.
 * @param {number} x
 * @param {number} y
 * @param {number} z
 * @param {CellNow} cell
 */
function convection(x, y, z, { x: cx, y: cy, reach, top, peak }) {
  const [dx, dy] = [x - cx - 0.35 * z, y - cy - 0.15 * z];
  const spread = reach * (1 + 0.25 * smooth(z, 0.5 * top, top));
  if (Math.abs(dx) > 2 * spread || Math.abs(dy) > 2 * spread || z > top + 1500) return 0;
  const away = Math.hypot(dx, dy) / spread;
  // Hail grows above the freezing level; its core reaches down to the ground in strong cells.
  const hail = peak > 57 ? 5 * Math.exp(-((away / 0.3) ** 2)) * Math.exp(-(((z - 5200) / 3000) ** 2)) : 0;
  const dbz = peak - 20 * away ** 1.8 + hail - 40 * smooth(z, 0.4 * top, 1.1 * top) - (z > top ? (z - top) / 80 : 0);
  // The updraft of the strongest cell is so fast that drops have no time to grow in it: there is a vault below the core.
  const vault =
    peak > 57
      ? 24 *
        Math.exp(-(((dx - 0.55 * reach) / 3000) ** 2) - ((dy + 0.35 * reach) / 3000) ** 2) *
        (1 - smooth(z, 3500, 7000))
      : 0;
  return 10 ** ((dbz - vault) / 10);
}

/**
 * Rain that the rotating updraft pulls around itself, from the north by the west to the south, in the lowest kilometres.
 * @param {number} x
 * @param {number} y
 * @param {number} z
 * @param {CellNow} cell
 */
function hook(x, y, z, cell) {
  const [cx, cy] = vortexCentre(z, cell);
  const away = Math.hypot(x - cx, y - cy);
  if (away > 9000 || z > 5000) return 0;
  const angle = Math.atan2(x - cx, y - cy); // From north, clockwise.
  const turned = angle > 1 ? angle - 2 * Math.PI : angle;
  const arm = 4300 - 350 * turned;
  const fade = smooth(turned, -4.1, -2.8) * (1 - smooth(turned, 0, 0.9));
  const dbz = 47 - 10 * ((away - arm) / 1100) ** 2 - 24 * (1 - fade) - 24 * smooth(z, 2200, 4500);
  return 10 ** (dbz / 10);
}

/**
 * Ice that spreads downwind from the top of the supercell: to the east-north-east.
 * @param {number} x
 * @param {number} y
 * @param {number} z
 * @param {CellNow} cell
 */
function anvil(x, y, z, { x: cx, y: cy }) {
  if (z < 7500 || z > 14_500) return 0;
  const [dx, dy] = [x - cx - 4000, y - cy - 1500];
  const [along, across] = [dx * 0.93 + dy * 0.37, -dx * 0.37 + dy * 0.93];
  if (along < -25_000 || along > 110_000) return 0;
  const middle = 11_700 + 0.008 * along;
  const thick = 1700 * (1 - 0.5 * smooth(along, 0, 100_000));
  const width = 13_000 + 0.3 * Math.max(0, along);
  const dbz =
    29 -
    17 * smooth(along, 0, 105_000) -
    40 * smooth(-along, 8000, 25_000) -
    16 * (across / width) ** 2 -
    10 * ((z - middle) / thick) ** 2;
  return 10 ** (dbz / 10);
}

/** Steady rain behind the line, with the bright band where snow melts. @param {number} x @param {number} y @param {number} z */
function steadyRain(x, y, z) {
  const [along, across] = [0.76 * x + 0.65 * y, -0.65 * x + 0.76 * y];
  const edge = (along / 66_000) ** 2 + (across / 40_000) ** 2 + 0.35 * billows(x / 16_000, y / 16_000, 3);
  if (edge > 2.2) return 0;
  const melting = 8 * Math.exp(-(((z - freezingLevel + 250) / 260) ** 2));
  const snow = z > freezingLevel ? (4.2 * (z - freezingLevel)) / 1000 + 3 : 0;
  return 10 ** ((31 - 13 * Math.max(0, edge) ** 1.5 + melting - snow - 12 * smooth(z, 8500, 10_500)) / 10);
}

/** Heights and winds, metres and m/s: with height the wind turns to the right and becomes stronger, as supercells need. */
const profile = [
  [0, 1, 7],
  [1000, 6, 11],
  [3000, 13, 11],
  [6000, 20, 9],
  [10_000, 30, 11],
  [14_000, 33, 12],
  [20_000, 25, 8],
];

/** @param {number} x @param {number} y @param {number} z @param {CellNow} big @returns {[number, number, number]} */
function wind(x, y, z, big) {
  const above = Math.max(
    1,
    profile.findIndex(([height]) => height >= z),
  );
  const [[low, u0, v0], [high, u1, v1]] = [profile[above - 1], profile[above]];
  const share = Math.min(1, Math.max(0, (z - low) / (high - low)));
  const [vx, vy] = vortexCentre(z, big);
  const [dx, dy] = [x - vx, y - vy];
  const away = Math.max(1, Math.hypot(dx, dy));
  // A Rankine vortex of 3 km and 24 m/s, cyclonic, in the lower half of the storm; outflow at its top.
  const rotation =
    (24 * Math.min(away / 3000, 3000 / away) * smooth(z, -2000, 1500) * (1 - smooth(z, 6000, 9500))) / away;
  const outflow = (20 * Math.min(away / 7000, 7000 / away) * Math.exp(-(((z - 13_500) / 1600) ** 2))) / away;
  const updraft = 34 * Math.exp(-((away / 3800) ** 2)) * Math.sin(Math.PI * Math.min(1, z / big.top));
  const gusts = 1.5 * eddies(x / 3500, y / 3500, z / 1500);
  return [
    u0 + share * (u1 - u0) - rotation * dy + outflow * dx + gusts,
    v0 + share * (v1 - v0) + rotation * dx + outflow * dy + gusts,
    updraft,
  ];
}

/**
 * The centre of the supercell's rotation: at the south-east side of its rain, leaning with the cell.
 * @param {number} z
 * @param {CellNow} cell
 * @returns {[number, number]}
 */
function vortexCentre(z, { x, y, reach }) {
  return [x + 0.35 * z + 0.55 * reach, y + 0.15 * z - 0.35 * reach];
}

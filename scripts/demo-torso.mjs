// Makes a synthetic CT phantom: a torso in Hounsfield units, with the tissues that CT presets show: skin, fat, bones, lungs, vessels.
// World: x right, y anterior, z superior, mm. The anatomy is only approximate; do not learn it from here.
import { Painter, seededRandom } from './demo-painter.mjs';

/** @typedef {import('./demo-painter.mjs').Point} Point */

const HU = {
  air: -1000,
  lung: -860,
  fat: -100,
  muscle: 52,
  skin: 20,
  blood: 45,
  contrast: 330,
  liver: 112,
  kidney: 190,
  spleen: 125,
  cartilage: 120,
  marrow: 260,
  cortex: 760,
};

/** @returns {Painter} */
export function paintTorso() {
  const torso = new Painter([116, 88, 116], [3, 3, 3], [-172.5, -130.5, -172.5], HU.air);
  paintBody(torso);
  paintOrgans(torso);
  paintLungs(torso);
  paintHeart(torso);
  paintSpine(torso);
  paintRibs(torso);
  paintVessels(torso);
  addNoise(torso);
  return torso;
}

/** Half widths of the trunk at a height: hips, waist, chest, shoulders. @param {number} z */
function trunk(z) {
  const shoulder = Math.max(0, (z - 95) / 80);
  return {
    rx: 148 + 8 * Math.sin((z + 40) / 60) - 30 * shoulder ** 2,
    ry: 100 + 6 * Math.sin((z - 20) / 70) - 28 * shoulder ** 2,
  };
}

/** Distance to the surface of the trunk, minus `depth`. @param {number} depth @returns {import('./demo-painter.mjs').Distance} */
function trunkSurface(depth) {
  return (x, y, z) => {
    const { rx, ry } = trunk(z);
    const [a, b] = [x / (rx - depth), y / (ry - depth)];
    const k = (a ** 4 + 0.7 * a * a * b * b + b ** 4) ** 0.25 * 0.35 + 0.65 * Math.hypot(a, b);
    return (k - 1) * Math.min(rx, ry);
  };
}

/** @param {Painter} torso */
function paintBody(torso) {
  torso.fill(trunkSurface(0), HU.skin);
  torso.fill(trunkSurface(3), HU.fat);
  torso.fill(trunkSurface(15), HU.muscle);
}

/** @param {Painter} torso */
function paintOrgans(torso) {
  torso.ellipsoid([0, 18, -140], [112, 62, 72], -85); // The fat around the bowels.
  for (let n = 0; n < 14; n++) {
    const angle = n * 2.4;
    const reach = 22 + 5 * n;
    torso.ellipsoid(
      [reach * Math.cos(angle) * 1.05, 24 + 0.42 * reach * Math.sin(angle), -130 - 3 * n + 12 * Math.sin(n * 1.7)],
      [17, 14, 13],
      38,
    );
  }
  torso.ellipsoid([58, 4, -62], [78, 76, 58], HU.liver);
  torso.ellipsoid([-92, -34, -70], [30, 42, 44], HU.spleen);
  torso.ellipsoid([-46, 34, -72], [44, 36, 40], 30);
  torso.ellipsoid([-50, 50, -62], [26, 14, 20], HU.air); // The air in the stomach.
  for (const side of [-1, 1]) {
    torso.ellipsoid([side * 58, -46, -118], [25, 22, 46], HU.kidney);
    torso.ellipsoid([side * 46, -42, -118], [11, 12, 22], -60);
  }
}

/** @param {Painter} torso */
function paintLungs(torso) {
  for (const side of [-1, 1]) {
    const lung = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) => {
      const [a, b, c] = [(x - side * (66 - 16 * Math.max(0, (z - 30) / 118))) / 52, (y + 4) / 72, (z - 30) / 118];
      const shell = (Math.hypot(a, b, c) - 1) * 52;
      const dome = -(z + 62 - 62 * Math.max(0, 1 - ((x - side * 62) / 95) ** 2 - ((y - 5) / 105) ** 2)); // The diaphragm.
      return Math.max(shell, dome, 16 - side * x);
    };
    torso.fill(lung, HU.lung);
  }
}

/** @param {Painter} torso */
function paintHeart(torso) {
  torso.ellipsoid([-20, 26, 6], [50, 40, 52], HU.blood);
  torso.ellipsoid([-32, 20, 0], [24, 22, 32], 210);
  torso.ellipsoid([4, 32, 8], [22, 20, 30], 150);
  torso.ellipsoid([-8, 0, 34], [30, 20, 18], 190);
}

/** @param {Painter} torso */
function paintSpine(torso) {
  torso.tube(
    [
      [0, -50, -175],
      [0, -50, 175],
    ],
    [21, 16],
    85,
  ); // Discs and ligaments.
  for (let z = -162; z <= 175; z += 27) {
    const size = 1 - z / 900;
    const body =
      (/** @type {number} */ inset) => (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ at) =>
        Math.max(Math.hypot(x / 1.22, y + 50) - (18 - inset) * size, Math.abs(at - z) - (10.5 - inset));
    torso.fill(body(0), HU.cortex * 0.75, [
      [-25, -73, z - 12],
      [25, -28, z + 12],
    ]);
    torso.fill(body(3), HU.marrow, [
      [-25, -73, z - 12],
      [25, -28, z + 12],
    ]);
    for (const side of [-1, 1]) {
      torso.tube(
        [
          [side * 12, -64, z],
          [side * 13, -80, z - 2],
        ],
        [4.5, 4.5],
        HU.cortex * 0.8,
      );
      torso.tube(
        [
          [side * 13, -78, z - 2],
          [side * 38, -82, z + 1],
        ],
        [4.5, 3.5],
        HU.cortex * 0.7,
      );
      torso.tube(
        [
          [side * 13, -80, z - 2],
          [0, -88, z - 6],
        ],
        [4, 4],
        HU.cortex * 0.75,
      );
    }
    torso.tube(
      [
        [0, -86, z - 6],
        [0, -91, z - 18],
      ],
      [4, 3],
      HU.cortex * 0.7,
    );
  }
  torso.tube(
    [
      [0, -74, -175],
      [0, -74, 175],
    ],
    [7.5, 7.5],
    25,
  ); // The spinal canal.
}

/** @param {Painter} torso */
function paintRibs(torso) {
  for (let n = 0; n < 11; n++) {
    const top = 150 - 25 * n;
    const wide = 84 + 40 * Math.sin(Math.min(1.45, 0.25 + n * 0.22));
    const deep = 62 + 23 * Math.sin(Math.min(1.5, 0.4 + n * 0.25));
    const turn = n < 8 ? 2.62 : 2.62 - 0.36 * (n - 7);
    for (const side of [-1, 1]) {
      /** @type {Point[]} */
      const rib = [];
      for (let step = 0; step <= 16; step++) {
        const angle = 0.3 + ((turn - 0.3) * step) / 16;
        rib.push([side * wide * Math.sin(angle), -4 - deep * Math.cos(angle), top - 52 * (step / 16) ** 1.3]);
      }
      torso.tube(rib, [5.6, 5.2], HU.cortex);
      torso.tube(rib, [2.6, 2.2], HU.marrow + 60);
      if (n < 7) torso.tube([rib[16], [side * 15, 92 - n * 0.8, 98 - 17 * n]], [5, 4.5], HU.cartilage);
    }
  }
  torso.tube(
    [
      [0, 84, 106],
      [0, 93, 60],
      [0, 92, -12],
    ],
    [7, 6],
    HU.cortex * 0.7,
  );
  torso.ellipsoid([0, 86, 98], [24, 7, 20], HU.cortex * 0.7);
  torso.tube(
    [
      [0, 93, -12],
      [0, 90, -38],
    ],
    [5, 3],
    HU.cartilage,
  );
  for (const side of [-1, 1])
    torso.tube(
      [
        [side * 16, 80, 114],
        [side * 60, 66, 128],
        [side * 104, 24, 134],
      ],
      [6, 5.5],
      HU.cortex * 0.85,
    );
}

/** @param {Painter} torso */
function paintVessels(torso) {
  torso.tube(
    [
      [0, 0, 175],
      [2, -10, 100],
      [2, -14, 78],
    ],
    [9, 9],
    HU.air,
  ); // Windpipe and bronchi.
  for (const side of [-1, 1]) {
    torso.tube(
      [
        [2, -14, 78],
        [side * 34, -14, 52],
      ],
      [7, 5],
      HU.air,
    );
    branchInLung(
      torso,
      { from: [side * 22, -6, 46], direction: [side, -0.1, -0.15], radius: 6.5, length: 27, depth: 6 },
      seededRandom(11 + side),
    );
  }
  torso.tube(
    [
      [-14, 30, 28],
      [-12, 20, 56],
      [-24, -6, 52],
    ],
    [13, 9],
    210,
  ); // The pulmonary arteries.
  torso.tube(
    [
      [-6, 16, 24],
      [12, 24, 52],
      [12, 16, 76],
      [2, -6, 92],
      [-14, -28, 84],
      [-21, -32, 56],
      [-20, -28, 0],
      [-10, -22, -80],
      [-4, -20, -150],
    ],
    [14, 10],
    HU.contrast,
  );
  for (const [start, end] of /** @type {[Point, Point][]} */ ([
    [
      [10, 10, 84],
      [24, 14, 175],
    ],
    [
      [2, -2, 92],
      [-14, 10, 175],
    ],
    [
      [-8, -16, 92],
      [-30, -4, 175],
    ],
  ])) {
    torso.tube([start, [end[0] * 0.7, end[1], 130], end], [6.5, 4.5], HU.contrast - 10);
  }
  for (const side of [-1, 1]) {
    torso.tube(
      [
        [-6, -22, -112],
        [side * 26, -40, -112],
        [side * 46, -44, -116],
      ],
      [4.5, 3.2],
      HU.contrast - 20,
    );
    torso.tube(
      [
        [-4, -20, -148],
        [side * 24, -12, -175],
      ],
      [8, 7.5],
      HU.contrast - 10,
    );
  }
  torso.tube(
    [
      [-8, -18, -86],
      [10, 0, -84],
      [40, 4, -72],
    ],
    [4.8, 3],
    HU.contrast - 20,
  );
  torso.tube(
    [
      [-8, -18, -88],
      [-40, -14, -80],
      [-78, -30, -74],
    ],
    [4.2, 3],
    HU.contrast - 20,
  );
  torso.tube(
    [
      [-7, -16, -96],
      [2, 10, -122],
      [10, 20, -165],
    ],
    [4.2, 2.5],
    HU.contrast - 20,
  );
}

/**
 * A tree of vessels, as in a lung: each stem ends in three thinner ones.
 * @param {Painter} torso
 * @param {{ from: Point, direction: Point, radius: number, length: number, depth: number }} stem
 * @param {() => number} random
 */
function branchInLung(torso, stem, random) {
  const size = Math.hypot(...stem.direction);
  const to = /** @type {Point} */ (stem.from.map((v, axis) => v + (stem.direction[axis] / size) * stem.length));
  const isInside =
    Math.hypot((to[0] - Math.sign(to[0]) * 66) / 49, (to[1] + 4) / 68, (to[2] - 30) / 112) < 1 && Math.abs(to[0]) > 18;
  if (!isInside || to[2] < -40) return;
  torso.tube([stem.from, to], [stem.radius, stem.radius * 0.8], 40 + 110 * Math.min(1, stem.radius / 5));
  if (stem.depth === 0) return;
  for (let n = 0; n < 3; n++) {
    const spread = () => (random() - 0.5) * 2.1;
    const direction = /** @type {Point} */ (
      stem.direction.map((v, axis) => v / size + spread() * (axis === 2 ? 1.25 : 1))
    );
    branchInLung(
      torso,
      {
        from: to,
        direction,
        radius: Math.max(1.3, stem.radius * 0.7),
        length: stem.length * 0.86,
        depth: stem.depth - 1,
      },
      random,
    );
  }
}

/** Scanner noise of about 8 HU within the body, in steps of 16 HU: smaller steps would only make the file larger. @param {Painter} torso */
function addNoise(torso) {
  const random = seededRandom(2011);
  torso.all((index) => {
    const value = torso.values[index];
    if (value <= HU.air + 5) return;
    const noise = (random() + random() + random() + random() - 2) * 13;
    torso.values[index] = Math.max(HU.air, Math.round((value + noise) / 16) * 16);
  });
}

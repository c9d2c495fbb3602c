// Makes a synthetic beating heart, no person's: a left ventricle, round and thick, and a right one around its side, whose walls thicken while they contract.
// volume-view-prepare makes the video of it that the demo shows.

/** Voxels along each axis, and their edge in mm. */
const edge = 56;
const spacing = 2.2;

/** Frames of a beat, and seconds from one to the next. */
export const frames = 20;
export const step = 0.045;

/** How far the heart has contracted, 0 to 1: it takes a third of the beat, and lets go more slowly. @param {number} share - of the beat */
export const contractionAt = (share) =>
  share < 0.4 ? Math.sin((Math.PI * share) / 0.8) ** 2 : Math.cos((Math.PI * (share - 0.4)) / 1.2) ** 2;

/** 1 within a surface, 0 beyond it, with an edge of two voxels. @param {number} depth - mm below the surface */
const inside = (depth) => Math.min(1, Math.max(0, 0.5 + depth / (2 * spacing)));

/** A depth below an ellipsoid that is about in mm. @param {readonly number[]} at @param {readonly number[]} radii */
const depthIn = (at, radii) => (1 - Math.hypot(...at.map((x, axis) => x / radii[axis]))) * Math.min(...radii);

/** The brightness of a place, 0 to 255. @param {readonly number[]} place - mm from the middle of the left ventricle @param {number} contraction */
export function valueAt([x, y, z], contraction) {
  // Above the base there are no ventricles; the apex stays where it is, and the base moves down to it.
  const base = 34 - 10 * contraction;
  const below = inside(base - z);
  const radius = 29 - 3 * contraction;
  const cavity = 20 - 8 * contraction;
  const left = depthIn([x, y, z], [radius, radius, 52]);
  const blood = depthIn([x, y, z], [cavity, cavity, 43 - 6 * contraction]);
  const shift = [x - 20, y + 4, z - 6];
  const right = depthIn(shift, [33 - 5 * contraction, 30 - 2 * contraction, 44]);
  const rightBlood = depthIn(shift, [29 - 8 * contraction, 26 - 5 * contraction, 40 - 3 * contraction]);
  const muscle = Math.max(inside(left), inside(right));
  const filled = Math.max(inside(blood), Math.min(inside(rightBlood), 1 - inside(left)));
  return below * muscle * (95 + 130 * filled);
}

/** The file of all frames: NIfTI-1 of 8 bits. @returns {Buffer} */
export function paintHeart() {
  const header = Buffer.alloc(352);
  header.writeInt32LE(348, 0);
  for (const [i, value] of [4, edge, edge, edge, frames, 1, 1, 1].entries()) header.writeInt16LE(value, 40 + 2 * i);
  header.writeInt16LE(2, 70);
  header.writeInt16LE(8, 72);
  for (const [i, value] of [1, spacing, spacing, spacing, step, 1, 1, 1].entries())
    header.writeFloatLE(value, 76 + 4 * i);
  header.writeFloatLE(352, 108);
  header.writeFloatLE(1, 112);
  header[123] = 2 + 8; // Millimetres, and seconds.
  header.writeInt16LE(1, 254);
  const start = (-spacing * (edge - 1)) / 2;
  const rows = [
    [spacing, 0, 0, start],
    [0, spacing, 0, start],
    [0, 0, spacing, start],
  ];
  for (const [i, value] of rows.flat().entries()) header.writeFloatLE(value, 280 + 4 * i);
  header.write('n+1\0', 344, 'latin1');
  const data = Buffer.alloc(frames * edge ** 3);
  for (let frame = 0, at = 0; frame < frames; frame++) {
    const contraction = contractionAt(frame / frames);
    for (let k = 0; k < edge; k++)
      for (let j = 0; j < edge; j++)
        for (let i = 0; i < edge; i++) {
          const [x, y, z] = [i, j, k].map((n) => start + spacing * n);
          data[at++] = Math.round(valueAt([x + 10, y - 3, z + 4], contraction));
        }
  }
  return Buffer.concat([header, data]);
}

// `npm run map-data` writes src/radar/map-data.ts, the coasts and borders of the Earth, from world-atlas (Natural Earth, 1:50 million), so
// that the package does not depend on it. `--check` only checks whether the file is up to date.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from './shared-data.mjs';

/**
 * Degrees. Coordinates are integers in this unit. No line is farther than one unit from the line of Natural Earth: that is about a
 * kilometre, while Natural Earth itself is wrong by several.
 */
const unit = 0.01;

/** @typedef {[x: number, y: number]} Point */

const { arcs, transform, objects } = JSON.parse(
  readFileSync(join(projectRoot, 'node_modules/world-atlas/countries-50m.json'), 'utf8'),
);

/** Number of countries with an arc in their outline: a border has two. @type {Map<number, number>} */
const uses = new Map();
/** @param {any} indices - of arcs, nested; the complement of a number means that arc backwards */
const count = (indices) => {
  if (Array.isArray(indices)) indices.forEach(count);
  else uses.set(indices < 0 ? ~indices : indices, (uses.get(indices < 0 ? ~indices : indices) ?? 0) + 1);
};
objects.countries.geometries.forEach((/** @type {{ arcs?: unknown }} */ one) => count(one.arcs ?? []));

/** Longitude and latitude of an arc, degrees. @param {Point[]} deltas @returns {Point[]} */
function decode(deltas) {
  let [x, y] = [0, 0];
  return deltas.map(([dx, dy]) => [
    (x += dx) * transform.scale[0] + transform.translate[0],
    (y += dy) * transform.scale[1] + transform.translate[1],
  ]);
}

/** Distance of a point from a straight segment. @param {Point} p @param {Point} a @param {Point} b */
function distanceTo([px, py], [ax, ay], [bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const length = dx * dx + dy * dy;
  const t = length === 0 ? 0 : Math.min(1, Math.max(0, ((px - ax) * dx + (py - ay) * dy) / length));
  return Math.hypot(px - ax - t * dx, py - ay - t * dy);
}

/** Remove points that are nearer to the line than `unit`: D. Douglas and T. Peucker, 1973. @param {Point[]} line @returns {Point[]} */
function simplify(line) {
  if (line.length < 3) return line;
  const [first, last] = [line[0], line[line.length - 1]];
  let [farthest, at] = [0, 0];
  for (let i = 1; i < line.length - 1; i++) {
    const distance = distanceTo(line[i], first, last);
    if (distance > farthest) [farthest, at] = [distance, i];
  }
  if (farthest <= unit) return [first, last];
  return [...simplify(line.slice(0, at + 1)).slice(0, -1), ...simplify(line.slice(at))];
}

/** Write a number as in Google's "encoded polyline": 5 bits per character, zigzag. @param {number} value */
function write(value) {
  let rest = value < 0 ? ~(value << 1) : value << 1;
  let text = '';
  for (; rest >= 32; rest >>= 5) text += String.fromCharCode((32 | (rest & 31)) + 63);
  return text + String.fromCharCode(rest + 63);
}

/** @param {Point[]} line - degrees; the first point is relative to 0 0, each other one to the point before */
function encode(line) {
  let [x, y] = [0, 0];
  const moves = line.map(([longitude, latitude]) => {
    const [nextX, nextY] = [Math.round(longitude / unit), Math.round(latitude / unit)];
    const move = [nextX - x, nextY - y];
    [x, y] = [nextX, nextY];
    return move;
  });
  const kept = moves.filter(([dx, dy], i) => i === 0 || dx !== 0 || dy !== 0);
  return kept.length < 2 ? '' : kept.flat().map(write).join('');
}

/** @param {boolean} isBorder */
const listLines = (isBorder) => {
  const lines = arcs
    .filter((/** @type {Point[]} */ _, /** @type {number} */ i) => (uses.get(i) ?? 0) > 1 === isBorder)
    .map((/** @type {Point[]} */ arc) => encode(simplify(decode(arc))))
    .filter(Boolean);
  // Numbers contain no blank.
  return JSON.stringify(lines.join(' '));
};

const text = `// Written by scripts/make-map-data.mjs from world-atlas 2 (see CREDITS.md): change it there.

/** Degrees that a coordinate counts. */
export const mapUnit = ${unit};

/** Lines, with a blank between them: longitude and latitude of each point in "encoded polylines", 5 bits a character. Natural Earth, 1:50 million. */
export const coasts =
  ${listLines(false)};
export const borders =
  ${listLines(true)};
`;

const file = join(projectRoot, 'src/radar/map-data.ts');
if (!process.argv.includes('--check')) writeFileSync(file, text);
else if (readFileSync(file, 'utf8') !== text) {
  console.error('src/radar/map-data.ts is not what scripts/make-map-data.mjs writes: run npm run map-data');
  process.exitCode = 1;
}

// A stone by formula, as the chunks of an OME-Zarr: nothing is stored, each chunk is computed when it is asked for. Voxels of a level are about the means of the
// voxels below them, because each level has only those waves of the noise that are longer than its voxels.

/** Voxels of the finest level along x, y and z; each next level has half as many. */
let finest = [4096, 3072, 2560];
let levels = 7;
const voxelsOf = (level) => finest.map((n) => n / 2 ** level);

const chunkSide = 32;
/** Micrometres: the box around the stone is 8.2 mm wide. */
let voxel = 2;

/** The same stone with so many levels more, each with voxels of half the edge. */
function refine(more) {
  finest = finest.map((n) => n * 2 ** more);
  levels += more;
  voxel /= 2 ** more;
}

/** The whole numbers below 256 in a disorder that is always the same, twice. */
const disorder = new Uint8Array(512);
for (let n = 0; n < 256; n++) disorder[n] = n;
for (let n = 255, state = 1; n > 0; n--) {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  const other = state % (n + 1);
  const kept = disorder[n];
  disorder[n] = disorder[other];
  disorder[other] = kept;
}
disorder.copyWithin(256, 0, 256);

/** Smooth noise, -1..1, one wave a unit. */
function noise(x, y, z, seed) {
  const i = Math.floor(x);
  const j = Math.floor(y);
  const k = Math.floor(z);
  const u = x - i;
  const v = y - j;
  const w = z - k;
  const a = u * u * (3 - 2 * u);
  const b = v * v * (3 - 2 * v);
  const c = w * w * (3 - 2 * w);
  const near = disorder[(i + seed) & 255];
  const far = disorder[(i + 1 + seed) & 255];
  const front = k & 255;
  const back = (k + 1) & 255;
  const top = j & 255;
  const bottom = (j + 1) & 255;
  const rowOf = (down, deep) => {
    const left = disorder[disorder[near + down] + deep];
    return left + a * (disorder[disorder[far + down] + deep] - left);
  };
  const first = rowOf(top, front);
  const second = rowOf(top, back);
  const one = first + b * (rowOf(bottom, front) - first);
  const other = second + b * (rowOf(bottom, back) - second);
  return (one + c * (other - one)) / 127.5 - 1;
}

/**
 * Sums of waves: `first` of them in the box, twice as many each time, as long as they are longer than two voxels. `fall`: how high the next ones are, as a share.
 */
function makeWaves({ first, fall, seed }) {
  return (x, y, z, side) => {
    let sum = 0;
    for (let n = first, size = 1, turn = seed; n <= side / 2; n *= 2, size *= fall, turn += 17)
      sum += size * noise(x * n, y * n, z * n, turn);
    return sum;
  };
}

const bumps = makeWaves({ first: 3, fall: 0.5, seed: 1 });
const grains = makeWaves({ first: 16, fall: 0.9, seed: 90 });

/** No point of the surface is farther than twice this from that without waves. */
const relief = 0.11;

/** The value of a voxel, 0 (air) to 255. x, y, z: of its middle, as shares of the box's width; side: voxels along that. */
function valueAt(x, y, z, side) {
  const px = (x - 0.5) / 1.2;
  const py = (y - 0.375) / 0.9;
  const pz = (z - 0.3125) / 0.72;
  const height = 0.31 - Math.sqrt(px * px + py * py + pz * pz);
  if (height < -2 * relief) return 0;
  const depth = height + (height < 2 * relief ? relief * bumps(x, y, z, side) : 0);
  const share = 0.5 + depth * side;
  if (share <= 0) return 0;
  // Layers, bent by long waves, with grains of all sizes in them.
  const layers = Math.sin(38 * (z + 0.25 * x + 0.1 * noise(3 * x, 3 * y, 3 * z, 40)));
  const inside = 130 + 40 * layers + 30 * grains(x, y, z, side);
  return Math.min(1, share) * Math.min(255, Math.max(60, inside));
}

function makeChunk(level, at) {
  const [side] = voxelsOf(level);
  const chunk = new Uint8Array(chunkSide ** 3);
  let isEmpty = true;
  for (let k = 0, voxelAt = 0; k < chunkSide; k++)
    for (let j = 0; j < chunkSide; j++)
      for (let i = 0; i < chunkSide; i++, voxelAt++) {
        const value = valueAt(
          (at[0] * chunkSide + i + 0.5) / side,
          (at[1] * chunkSide + j + 0.5) / side,
          (at[2] * chunkSide + k + 0.5) / side,
          side,
        );
        if (value > 0) isEmpty = false;
        chunk[voxelAt] = value;
      }
  return isEmpty ? null : chunk;
}

function describeImage() {
  const axis = (name) => ({ name, type: 'space', unit: 'micrometer' });
  const datasets = Array.from({ length: levels }, (_, level) => {
    const edge = voxel * 2 ** level;
    const middle = (edge - voxel) / 2;
    return {
      path: String(level),
      coordinateTransformations: [
        { type: 'scale', scale: [edge, edge, edge] },
        { type: 'translation', translation: [middle, middle, middle] },
      ],
    };
  });
  return {
    zarr_format: 3,
    node_type: 'group',
    attributes: {
      ome: { version: '0.5', multiscales: [{ name: 'A stone', axes: ['z', 'y', 'x'].map(axis), datasets }] },
    },
  };
}

function describeLevel(level) {
  return {
    zarr_format: 3,
    node_type: 'array',
    shape: voxelsOf(level).toReversed(),
    data_type: 'uint8',
    chunk_grid: { name: 'regular', configuration: { chunk_shape: [chunkSide, chunkSide, chunkSide] } },
    chunk_key_encoding: { name: 'default', configuration: { separator: '/' } },
    fill_value: 0,
    codecs: [{ name: 'bytes' }],
    attributes: {},
  };
}

/** What a web server would have under a path; null for nothing. */
function answer(path) {
  if (path === 'zarr.json') return JSON.stringify(describeImage());
  const [, level, rest] = /^(\d)\/(.+)$/.exec(path) ?? [];
  if (rest === 'zarr.json') return JSON.stringify(describeLevel(Number(level)));
  const chunk = /^c\/(\d+)\/(\d+)\/(\d+)$/.exec(rest ?? '');
  return chunk && makeChunk(Number(level), [Number(chunk[3]), Number(chunk[2]), Number(chunk[1])]);
}

addEventListener('message', ({ data }) => {
  if (typeof data === 'number') refine(data);
  else postMessage(answer(data));
});

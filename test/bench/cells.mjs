// `npm run bench -- cells`: what the cells of a volume cost to find, compared with their ranges alone, by processor time. No browser: it runs
// in Node, whose V8 is that of Chromium. EDGE=128 makes a quick run.
import { cpus } from 'node:os';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { repeats } from './knobs.mjs';
import { median, printTable } from './table.mjs';

/** Voxels along each edge of a cube of 16 bits. */
const edge = Number(process.env.EDGE ?? 512);

const cellSize = 8;

/** @typedef {(x: number, y: number, z: number) => number} Field - at places of -1..1 */

/** Values of 0..65535, in the order of voxels. @type {Record<string, () => Field>} */
const volumes = {
  smooth: () => (x, y, z) => 30000 + 9000 * Math.sin(3 * x + 2 * y) + 9000 * Math.cos(4 * z - x),
  'a ball of noisy tissue in air': () => {
    const random = makeRandom();
    return (x, y, z) => (x * x + y * y + z * z < 0.6 ? 20000 + 4000 * random() : 0);
  },
  noise: () => {
    const random = makeRandom();
    return () => 65535 * random();
  },
};

/** 0..1, always the same ones. Source: Marsaglia 2003, xorshift of 32 bits */
function makeRandom() {
  let state = 1;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}

/** @param {Field} field */
function makeSamples(field) {
  const samples = new Uint16Array(edge ** 3);
  const places = Float64Array.from({ length: edge }, (_, i) => (2 * i + 1) / edge - 1);
  let at = 0;
  for (const z of places) for (const y of places) for (const x of places) samples[at++] = field(x, y, z);
  return samples;
}

/**
 * Ranges alone, as they were found before cells had a roughness: the first version of `buildMacrocells`, of which the aim of 1.5 is told.
 * @param {Uint16Array} samples
 */
function findRanges(samples) {
  const cells = Math.ceil(edge / cellSize);
  const low = new Uint16Array(cells ** 3).fill(65535);
  const high = new Uint16Array(cells ** 3);
  const around = Array.from({ length: edge }, (_, i) => cellsAround(i, cells));
  const row = { low: new Float32Array(cells), high: new Float32Array(cells) };
  for (let k = 0; k < edge; k++) {
    for (let j = 0; j < edge; j++) {
      const start = edge * (j + edge * k);
      findRowRanges(samples.subarray(start, start + edge), row);
      for (let z = around[k][0]; z <= around[k][1]; z++) {
        for (let y = around[j][0]; y <= around[j][1]; y++) {
          const cell = cells * (y + cells * z);
          for (let x = 0; x < cells; x++) {
            if (row.low[x] < low[cell + x]) low[cell + x] = row.low[x];
            if (row.high[x] > high[cell + x]) high[cell + x] = row.high[x];
          }
        }
      }
    }
  }
  return { low, high };
}

/**
 * @param {Uint16Array} values
 * @param {{ low: Float32Array, high: Float32Array }} row - of each cell, with the next voxel on both sides
 */
function findRowRanges(values, row) {
  for (let cell = 0; cell < row.low.length; cell++) {
    const end = Math.min(values.length, (cell + 1) * cellSize + 1);
    let low = Infinity;
    let high = -Infinity;
    for (let i = Math.max(0, cell * cellSize - 1); i < end; i++) {
      const value = values[i];
      if (value < low && value > -Infinity) low = value;
      if (value > high && value < Infinity) high = value;
    }
    row.low[cell] = low;
    row.high[cell] = high;
  }
}

/**
 * First and last cell along an axis to which a voxel belongs.
 * @param {number} index
 * @param {number} cells
 */
function cellsAround(index, cells) {
  const own = Math.floor(index / cellSize);
  const place = index % cellSize;
  return [place === 0 ? Math.max(0, own - 1) : own, place === cellSize - 1 ? Math.min(cells - 1, own + 1) : own];
}

/**
 * The shipped source, which Node can not read as it is.
 * @returns {Promise<typeof import('../../src/volume/macrocells.ts')>}
 */
async function loadMacrocells() {
  const result = await build({
    configFile: false,
    root: projectRoot,
    publicDir: false,
    logLevel: 'error',
    build: {
      write: false,
      lib: { entry: fileURLToPath(new URL('../../src/volume/macrocells.ts', import.meta.url)), formats: ['es'] },
    },
  });
  const [{ output }] = /** @type {import('vite').Rolldown.RolldownOutput[]} */ (result);
  return import(`data:text/javascript,${encodeURIComponent(output[0].code)}`);
}

/**
 * @template Result
 * @param {() => Result} work
 * @returns {{ milliseconds: number, result: Result }} processor time of this process
 */
function time(work) {
  const before = process.cpuUsage();
  const result = work();
  const { user, system } = process.cpuUsage(before);
  return { milliseconds: (user + system) / 1000, result };
}

export async function run() {
  const { buildMacrocells } = await loadMacrocells();
  console.log(
    `Node ${process.versions.node}, ${cpus()[0].model}, ${edge}^3 voxels of 16 bits, processor time, medians of ${repeats} in turns`,
  );
  const rows = [];
  for (const [volume, makeField] of Object.entries(volumes)) {
    const samples = makeSamples(makeField());
    const [alone, all] = [/** @type {number[]} */ ([]), /** @type {number[]} */ ([])];
    // The first turn of each is for the compiler.
    for (let turn = 0; turn <= repeats; turn++) {
      const ranges = time(() => findRanges(samples));
      const cells = time(() => buildMacrocells(samples, [edge, edge, edge], cellSize));
      if (
        String(ranges.result.low) !== String(cells.result.low) ||
        String(ranges.result.high) !== String(cells.result.high)
      )
        throw new Error(`cells of ${volume}: their ranges differ from ranges alone`);
      if (turn === 0) continue;
      alone.push(ranges.milliseconds);
      all.push(cells.milliseconds);
    }
    const notify = (/** @type {readonly number[]} */ times) =>
      `${Math.round(median(times))} ms (${Math.round(Math.min(...times))} to ${Math.round(Math.max(...times))})`;
    rows.push({
      volume,
      'ranges alone': notify(alone),
      'ranges and roughness': notify(all),
      'times as long': (median(all) / median(alone)).toFixed(2),
    });
  }
  printTable('Macrocells', rows);
}

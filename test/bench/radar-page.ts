// In the browser: a radar volume in its own geometry against the usual resampling to cartesian cells.
import { fieldProviders } from '../../components/internal/field-providers.ts';
import { loadVolume } from '../../src/worker/load.ts';
import { orbitCamera, framingDistance } from '../../src/optics/rays/camera.ts';
import { polarSampler } from '../../src/radar/interpolate-polar.ts';
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import { isPolar } from '../../src/volume/volume.ts';
import { cartesianGrid } from '../../src/volume/grid.ts';
import { summarize } from '../../src/volume/histogram.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { PolarVolume, Volume } from '../../src/volume/volume.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { changePlan, drawAt } from '../helpers/change-plan.ts';
import { median } from './table.mjs';
import { probe as probeRays } from '../helpers/probe.ts';
import '../helpers/provide-substeps.ts';

export interface Resampling {
  readonly name: string;
  /** Voxels, or sweeps, rays and gates. */
  readonly size: string;
  readonly megabytes: number;
  /** Against the native picture with 8 times the steps, RMS and 99th percentile, 1/255. */
  readonly rms: number;
  readonly p99: number;
  /** Median, GPU finished. */
  readonly ms: number;
}

/** World units of a step, the same for all: metres. */
const stepLengths = { shown: 1000, limit: 125 };

/** Cells that a page's memory holds as floats. */
const maxCells = 5e7;

const limits = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 31 };

function countCells(volume: PolarVolume, cell: number): number {
  const { box } = volume.grid;
  return box.high.reduce((product, high, axis) => (product * (high - box.low[axis])) / cell, 1);
}

/** What web viewers make of a scan: values at the centres of cartesian cells, interpolated; no data where there is none. */
function resample(volume: PolarVolume, cell: number): Volume {
  const { box } = volume.grid;
  const edges = box.high.map((high, axis) => high - box.low[axis]);
  const dimensions = edges.map((edge) => Math.max(2, Math.round(edge / cell))) as unknown as Vector3;
  const sampleAt = polarSampler(volume);
  const samples = new Float32Array(dimensions[0] * dimensions[1] * dimensions[2]);
  let at = 0;
  for (let k = 0; k < dimensions[2]; k++) {
    for (let j = 0; j < dimensions[1]; j++) {
      for (let i = 0; i < dimensions[0]; i++) {
        samples[at++] =
          volume.slope * sampleAt([(i + 0.5) / dimensions[0], (j + 0.5) / dimensions[1], (k + 0.5) / dimensions[2]]) +
          volume.intercept;
      }
    }
  }
  const m = volume.grid.indexToWorld;
  const factor = dimensions.map((n, axis) => volume.grid.dimensions[axis] / n);
  const origin = [0, 1, 2].map(
    (row) => m[row * 4 + 3] - [0, 1, 2].reduce((sum, c) => sum + m[row * 4 + c] * 0.5 * (1 - factor[c]), 0),
  );
  const indexToWorld = [0, 1, 2]
    .flatMap((row) => [...[0, 1, 2].map((c) => m[row * 4 + c] * factor[c]), origin[row]])
    .concat([0, 0, 0, 1]);
  return {
    ...volume,
    grid: cartesianGrid(dimensions, indexToWorld),
    samples,
    slope: 1,
    intercept: 0,
    macrocells: buildMacrocells(samples, dimensions),
    ...summarize(samples, 1, 0),
  };
}

/** @param cells - metres */
export async function compareResamplings(
  url: string,
  cells: readonly number[],
  size: number,
  repeats: number,
): Promise<Resampling[]> {
  const volume = await loadVolume(
    { url, settings: { verticalExaggeration: 5 }, limits },
    { signal: new AbortController().signal, onProgress: () => {} },
  );
  const transferFunction = await resolveTransferFunction('radar-dbz', [0, 1]);
  if (!isPolar(volume)) throw new TypeError(`${url} got a ${volume.grid.kind} grid; expected a radar's file`);
  const reach = volume.grid.box.high[0];
  const camera = orbitCamera({ theta: 0.5, phi: 1.1, radius: framingDistance(reach, 0.5, 1) }, [0, 0, 20_000], 0.5);
  const host = document.createElement('div');
  document.body.append(host);
  const scene = await VolumeScene.create(host, host, () => {}, fieldProviders);
  changePlan(scene, { picture: { width: size, height: size } });
  const show = async (shown: Volume): Promise<void> => {
    await scene.prepare(shown);
    scene.setVolume(shown);
    await scene.setAppearance({
      optics: { transferFunction, referenceLength: 4000, opacityFactor: 1, lightFactor: 1 },
    });
    changePlan(scene, { camera });
    drawAt(scene, stepLengths.shown);
    await scene.finished();
  };
  const probe = (stepLength: number): Float32Array =>
    probeRays(
      scene,
      [stepLength],
      { stride: 2, first: [0, 0], width: size / 2, height: size / 2 },
      { width: size, height: size },
    )![0];

  await show(volume);
  const limit = probe(stepLengths.limit);
  const candidates = [
    { name: 'native: sweeps, radials, gates', volume },
    ...cells
      .filter((cell) => countCells(volume, cell) <= maxCells)
      .map((cell) => ({ name: `cells of ${cell} m`, volume: resample(volume, cell) })),
  ];
  const rows: Resampling[] = [];
  for (const candidate of candidates) {
    await show(candidate.volume);
    const picture = probe(stepLengths.shown);
    const { rms, p99 } = compare(picture, limit);
    const times: number[] = [];
    for (let i = 0; i < repeats + 1; i++) {
      const began = performance.now();
      drawAt(scene, stepLengths.shown);
      await scene.finished();
      if (i > 0) times.push(performance.now() - began);
    }
    const { grid, samples }: Volume = candidate.volume;
    const gates =
      grid.kind === 'polar'
        ? `${grid.sweeps.length} x ${grid.sweeps[0].azimuths.length} x ${grid.sweeps[0].gates}`
        : grid.dimensions.join(' x ');
    rows.push({ name: candidate.name, size: gates, megabytes: samples.byteLength / 1e6, rms, p99, ms: median(times) });
  }
  scene.dispose();
  host.remove();
  return rows;
}

function compare(picture: Float32Array, limit: Float32Array): { rms: number; p99: number } {
  let sum = 0;
  const worst: number[] = [];
  for (let i = 0; i < picture.length; i += 4) {
    let max = 0;
    for (let c = i; c < i + 4; c++) {
      const off = (picture[c] - limit[c]) * 255;
      sum += off ** 2;
      max = Math.max(max, Math.abs(off));
    }
    worst.push(max);
  }
  worst.sort((a, b) => a - b);
  return { rms: Math.sqrt(sum / picture.length), p99: worst[Math.floor(worst.length * 0.99)] };
}

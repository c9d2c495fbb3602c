// What may be wrong in pictures of things that become opaque at once, where all pixels are probed. Only such pictures load it.
import { seekBetweenJumps } from '../../quality/between-jumps.ts';
import type { ErrorEstimate } from '../../quality/error-estimate.ts';
import type { Level, LevelCuts } from '../../quality/levels.ts';
import { autoSteps, stepLengthOf, voxelsAlong } from '../../quality/steps.ts';
import type { PixelLattice } from '../../optics/rays/rays.ts';
import { domainOf } from '../../optics/transfer/emission.ts';
import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import type { ProgramInputs } from '../../renderer/device/inputs.ts';
import type { DrawnView } from '../model/drawn-view.ts';
import type { ErrorProbe } from './measure-quality.ts';
import type { MeasuringTools } from './measuring-tools.ts';

/** What is measured. */
export interface JumpView {
  readonly view: DrawnView;
  readonly probe: ErrorProbe;
  readonly cuts: LevelCuts;
  readonly seen: SeenVolume;
}

/** References have so many times the steps of a level, see `ErrorProbe`. */
const finer = 4;

/** A float's relative error of rounding. */
const rounding = 2 ** -24;

/**
 * How far any pixel may be from the truth, 0..1. All pixels have been compared with finer ones. What these may miss is bounded by what may be missed
 * between the values at which matter becomes opaque, and by how pixels change if all values are a little larger or smaller: a ray that touches matter so
 * shortly that rounding decides shows it in one of the two pictures and not in the other.
 * @returns null if that is not known
 */
export async function boundAtJumps(
  { view, probe, cuts, seen }: JumpView,
  level: Level,
  estimate: ErrorEstimate,
  { aside, rangeEmission }: MeasuringTools,
): Promise<number | null> {
  const { scene, grid, goesOn } = view;
  const lattice = wholeOf(probe);
  if (!lattice || !isPlain(seen)) return null;
  const one = autoSteps(grid);
  const coarse = { ...level, steps: Math.max(level.steps, one) };
  const cut = cuts.reference(coarse);
  const samplesAVoxel = (finer * coarse.steps) / voxelsAlong(grid);
  const between = await aside(
    seekBetweenJumps(seen, samplesAVoxel, scene.detail(cut), { rangeEmission }),
    scene,
    goesOn,
  );
  if (!between) return null;
  const shift = smallestChange(seen, grid.dimensions);
  const pictures: Float32Array[] = [];
  for (const sign of [1, -1]) {
    const picture = scene.startProbe(
      {
        stepLength: stepLengthOf(grid, coarse.steps),
        substeps: cut,
        change: (inputs) => shiftValues(inputs, sign * shift),
      },
      lattice,
      view.size,
    )?.();
    if (!picture) return null;
    pictures.push(picture);
    await scene.finished();
    if (!goesOn()) return null;
  }
  const [larger, smaller] = pictures;
  const touched = larger.reduce((max, x, i) => Math.max(max, Math.abs(x - smaller[i])), 0);
  return Math.min(1, estimate.max / 255 + between.value + touched);
}

/** The pixels that are probed, where these are all in which something may be visible. */
function wholeOf({ lattices, rectangle }: ErrorProbe): PixelLattice | null {
  if (lattices?.length !== 1 || !rectangle) return null;
  const [lattice] = lattices;
  const isWhole = lattice.stride === 1 && lattice.width === rectangle.width && lattice.height === rectangle.height;
  return isWhole ? lattice : null;
}

/** Whether nothing but a transfer function decides what is seen, and values are cubics between planes of voxels. */
function isPlain({ volume, functions, more, hasSurfaces, jumps, style }: SeenVolume): boolean {
  const { channels, finer: bricks, hasNoData } = volume;
  return !channels && !bricks && !hasNoData && !functions && !more && !hasSurfaces && !jumps && !style;
}

/**
 * What floats may change of a value, as a share of the transfer function's domain: by rounding of the value, by that of its place, and by the length of
 * the shortest pieces of a ray, within which a value that turns may change.
 */
function smallestChange({ volume, transferFunction }: SeenVolume, dimensions: readonly number[]): number {
  const [low, high] = domainOf(transferFunction);
  const [min, max] = volume.range;
  const size = Math.max(
    Math.abs(min - volume.intercept),
    Math.abs(max - volume.intercept),
    Math.abs(low - volume.intercept),
  );
  const voxels = Math.max(...dimensions);
  return ((8 * size + (4 * voxels + 16) * (max - min)) * rounding) / (high - low) + 8 * rounding;
}

/** Make all values larger by a share of the transfer function's domain. */
function shiftValues({ uniforms, units }: ProgramInputs, shift: number): ProgramInputs {
  const [scale] = uniforms.uTableDomain as readonly number[];
  const from = (name: string): readonly number[] => {
    const [own, begin] = uniforms[name] as readonly number[];
    return [own, begin - shift / scale];
  };
  return {
    uniforms: { ...uniforms, uTableDomain: from('uTableDomain'), uColumnDomain: from('uColumnDomain') },
    units,
  };
}

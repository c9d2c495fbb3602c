// In the browser: what a picture at rest costs and what it shows, by `max-error` and `detail`.
import { voxelsAlong } from '../../src/quality/steps.ts';
import { finestSpacing } from '../../src/volume/grid.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { RenderStats } from '../../src/viewer/model/render-stats.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { measureThing, measureTrueError } from './compare-shown.ts';
import type { KeptThing } from './compare-shown.ts';
import { cameraOf, distanceFor, placeElement, takeAtRest } from './element-picture.ts';
import type { Sight } from './element-picture.ts';
import { findPixel } from './full-rays.ts';
import { loadHere, serveVolume, show, sightOf } from './small-page.ts';
import { smallScenes } from './small-scenes.ts';

/** A scene of the trade, as an element shows it. */
interface TradeScene {
  readonly volume: Volume;
  readonly src: string;
  /** Address of the same without its small things; null where none are known. */
  readonly bare: string | null;
  readonly places: readonly Vector3[];
  /** Around a place its thing is looked for, pixels. */
  readonly reach: number;
  readonly sight: Sight;
  readonly pixels: number;
  readonly attributes: Readonly<Record<string, string>>;
}

type Details = 'keep' | 'free';

/** One picture at rest. */
export interface TradeResult {
  readonly detail: Details;
  readonly maxError: number;
  readonly stats: RenderStats;
  /** From the element in the page to its picture at rest. */
  readonly ms: number;
  /** E, and the largest difference, from a picture with eight steps a voxel. */
  readonly e: number;
  readonly max: number;
  readonly things: readonly KeptThing[];
}

/** Steps a voxel of the truth. */
const trueSteps = 8;

const pixels = 320;

/** Scans of people and of weather, with about two pixels a voxel. */
const scans: Readonly<Record<string, readonly [file: string, attributes: Record<string, string>]>> = {
  'MRI of a brain, lit': ['mni152-t1', {}],
  'MRI of a brain, unlit': ['mni152-t1', { shading: 'unlit' }],
  'MRI of a head, lit': ['colin27-t1', {}],
  'CT phantom, bone, lit': ['ct-phantom', { 'transfer-function': 'ct-bone' }],
  'CT phantom, soft tissue, lit': ['ct-phantom', { 'transfer-function': 'ct-soft-tissue' }],
  'Storm, unlit': ['storm-synthetic', { 'transfer-function': 'radar-dbz', shading: 'unlit' }],
};

const small: readonly string[] = [
  'Specks of 1 voxel in a veil, large',
  'Specks of 1 voxel in a veil, small',
  'Plate of 1 voxel, almost from its edge',
  'Lesions of low contrast, radius 2',
  'Wires of 1 voxel',
  'Shells of about 1 voxel',
];

export function listTraded(): string[] {
  return [...Object.keys(scans), ...small];
}

async function makeScene(name: string): Promise<TradeScene> {
  if (name in scans) {
    const [file, attributes] = scans[name];
    const src = `/demos/data/${file}.nii.gz`;
    const volume = await loadHere(src);
    const sight = sightOf(volume, { pixels, pixelsPerVoxel: 1, theta: 30, phi: 75, ratio: 1 }, 0);
    const radius = distanceFor({
      pixels,
      pixelsPerVoxel: pixels / 1.2 / Math.max(...volume.grid.dimensions),
      voxel: finestSpacing(volume.grid),
    });
    return { volume, src, bare: null, places: [], reach: 0, pixels, sight: { ...sight, radius }, attributes };
  }
  const { view, transferFunction } = smallScenes.find((one) => one.name === name)!;
  const shown = await show(name);
  return {
    ...shown,
    bare: serveVolume(shown.bare!),
    reach: Math.max(1, shown.reach * view.pixelsPerVoxel),
    pixels: view.pixels,
    sight: sightOf(shown.volume, view, 0),
    attributes: { shading: 'unlit', ...(transferFunction ? { 'transfer-function': transferFunction } : {}) },
  };
}

/** @param name - of a scene @param notify - what is being done */
export async function measureTrade(
  name: string,
  { details, errors }: { readonly details: readonly Details[]; readonly errors: readonly number[] },
  notify: (what: string) => void,
): Promise<TradeResult[]> {
  const scene = await makeScene(name);
  const { volume, sight, pixels: size } = scene;
  const draw = async (
    src: string,
    attributes: Record<string, string>,
  ): Promise<{ data: Uint8Array; stats: RenderStats; ms: number }> => {
    const all = { 'value-window': volume.range.join(' '), ...scene.attributes, ...attributes };
    if (name in scans) delete (all as Record<string, string>)['value-window'];
    const element = placeElement({ src, sight, pixels: size, ratio: 1, attributes: all });
    const began = performance.now();
    const picture = await takeAtRest(element, size);
    const ms = performance.now() - began;
    element.remove();
    return { ...picture, ms };
  };
  const steps = String(Math.min(4096, trueSteps * voxelsAlong(volume.grid)));
  const drawTruth = async (src: string): Promise<Float32Array> =>
    Float32Array.from((await draw(src, { steps })).data, (x) => x / 255);
  notify(`${name}, all rays`);
  const full = await drawTruth(scene.src);
  const bare = scene.bare === null ? null : await drawTruth(scene.bare);
  const results: TradeResult[] = [];
  for (const detail of details) {
    for (const maxError of errors) {
      notify(`${name}, ${detail}, ${maxError}`);
      const { data, stats, ms } = await draw(scene.src, { detail, 'max-error': String(maxError) });
      const { e, max } = measureTrueError(data, full);
      const things = bare
        ? scene.places.flatMap((place) => {
            const around = findPixel(cameraOf(sight), place, size);
            const thing = measureThing({ shown: data, full, bare, size }, around, scene.reach);
            return thing && thing.contrast >= lostPerError * maxError ? [thing] : [];
          })
        : [];
      results.push({ detail, maxError, stats, ms, e, max, things });
    }
  }
  return results;
}

/** Things count that stand out by this many times `max-error`. */
const lostPerError = 8;

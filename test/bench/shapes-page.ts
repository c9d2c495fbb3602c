// In the browser: frames with shapes among a volume against those without.
import { fieldProviders } from '../../components/internal/field-providers.ts';
import { loadVolume } from '../../src/worker/load.ts';
import type { Cutout, HalfSpace } from '../../src/optics/rays/clip-intervals.ts';
import type { PlaneSlice } from '../../src/optics/attachments/plane-slices.ts';
import { framingDistance, orbitCamera } from '../../src/optics/rays/camera.ts';
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import { stepLengthOf } from '../../src/quality/steps.ts';
import { buildRings, planRings } from '../../src/radar/range-rings.ts';
import type { Slice } from '../../src/radar/slices.ts';
import { createClip } from '../../src/renderer/ray/modules/clip.ts';
import { createCutout } from '../../src/renderer/ray/modules/cutout.ts';
import { createPlanes } from '../../src/renderer/ray/modules/plane-slices.ts';
import type { RayCut } from '../../src/renderer/ray/ray-module.ts';
import { planeInCube } from '../../src/viewer/cuts/plane-in-cube.ts';
import { boundingSphere, unitToWorld } from '../../src/volume/grid.ts';
import { invertAffine, multiply, scaleAndTranslate } from '../../src/volume/matrix.ts';
import type { ShownLabels } from '../../src/volume/labels.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { isPolar } from '../../src/volume/volume.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import type { Lines } from '../../src/x3d/scene-lines.ts';
import { changePlan, drawAt } from '../helpers/change-plan.ts';
import { listAtlases } from './atlases.ts';
import { median } from './table.mjs';
import { processorSeconds } from './turns.ts';

export interface ShapesOptions {
  /** Pixels along each side. */
  readonly size: number;
  readonly steps: number;
  /** 1/255. */
  readonly maxCurvature: number;
  readonly turns: number;
}

export interface ShapesRow {
  readonly scene: string;
  readonly shapes: string;
  /** Median of frames with adaptive rays. */
  readonly ms: number;
  /** The median of that over the frames without shapes beside it. */
  readonly ratio: number;
  /** Processor time of the process that draws, ms a frame, and the median of that over the one without shapes. */
  readonly work: number;
  readonly workRatio: number;
  /** The same of frames in which each pixel gets a ray. */
  readonly allRays: number;
  /** Quads of the last lattice whose rays end at shapes unforeseen. */
  readonly share: number;
}

/** What a frame took. */
interface Timed {
  readonly ms: number;
  /** Of the processors' time. */
  readonly seconds: number;
}

/** Frames that are timed together: processor time is counted in hundredths of a second. */
const framesATurn = 4;

interface BenchScene {
  readonly name: string;
  readonly url: string;
  readonly preset: string;
  /** World length, as a share of the radius. */
  readonly referenceLength: number;
}

const scenes: readonly BenchScene[] = [
  { name: 'MRI of a brain', url: '/demos/data/mni152-t1.nii.gz', preset: 'mri', referenceLength: 0.01 },
  {
    name: 'Radar, synthetic storm',
    url: '/demos/data/storm-radar-1510.json',
    preset: 'radar-dbz',
    referenceLength: 0.02,
  },
];

const limits = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 31 };

/** What stands in the scene: X3D, and lines in the world. */
interface Variant {
  readonly name: string;
  readonly children: string;
  readonly lines: Lines;
  readonly slices?: readonly Slice[];
  readonly cuts?: readonly RayCut[];
  readonly labels?: ShownLabels;
}

function listVariants(volume: Volume): Variant[] {
  const { center, radius } = boundingSphere(volume.grid);
  const slice: PlaneSlice = { kind: 'plane', normal: [0.6, 0.8, 0], offset: 0.7, slab: null, window: volume.range };
  const color = '<appearance><material emissiveColor="1 0.6 0" diffuseColor="0 0 0"></material></appearance>';
  const put = (at: Vector3, shape: string): string =>
    `<transform translation="${center.map((c, axis) => c + at[axis] * radius).join(' ')}"><shape>${color}${shape}</shape></transform>`;
  const rings = isPolar(volume)
    ? buildRings(planRings(volume.grid, null, null)).lines
    : [0.2, 0.3, 0.4, 0.5, 0.6].map((share) => circle(center, share * radius));
  return [
    { name: 'none', children: '', lines: [] },
    { name: 'one marker', children: put([0.2, 0.1, 0.05], `<sphere radius="${0.03 * radius}"></sphere>`), lines: [] },
    { name: 'rings', children: '<group></group>', lines: rings },
    {
      name: 'a slice, upright',
      children: '',
      lines: [],
      ...(isPolar(volume)
        ? { slices: [{ kind: 'upright', from: [0, 0], direction: [0.6, 0.8], length: Infinity }] }
        : { cuts: [{ create: createPlanes, items: [slice] }] }),
    },
    ...listCuts(volume),
    ...(isPolar(volume) ? [] : listAtlases(volume).map((atlas) => ({ ...atlas, children: '', lines: [] }))),
    {
      name: 'a plane across',
      children: put([0, 0, 0], `<box size="${2 * radius} ${2 * radius} ${0.002 * radius}"></box>`),
      lines: [],
    },
  ];
}

/** What cuts nothing of the volume away shows what it costs by itself; the others show less of it. */
function listCuts({ grid }: Volume): Variant[] {
  const { center, radius } = boundingSphere(grid);
  const away = (by: number): Vector3 => center.map((x) => x + by * radius) as unknown as Vector3;
  const box = (at: number): Cutout => ({
    kind: 'cutout',
    unitToBox: multiply(
      invertAffine(scaleAndTranslate([2 * radius, 2 * radius, 2 * radius], away(at)))!,
      unitToWorld(grid),
    ),
  });
  const half = (at: number): HalfSpace => ({
    kind: 'half-space',
    ...planeInCube([-0.6, -0.8, 0], at * radius - 0.6 * center[0] - 0.8 * center[1], grid),
  });
  const plain = { children: '', lines: [] };
  return [
    {
      name: 'six clip planes outside',
      ...plain,
      cuts: [{ create: createClip, items: [-2, -3, -4, -5, -6, -7].map(half) }],
    },
    { name: 'a cutout outside', ...plain, cuts: [{ create: createCutout, items: [box(3)] }] },
    { name: 'cut in half', ...plain, cuts: [{ create: createClip, items: [half(0)] }] },
    { name: 'an eighth cut out', ...plain, cuts: [{ create: createCutout, items: [box(0)] }] },
  ];
}

function circle(center: Vector3, radius: number): Vector3[] {
  return Array.from({ length: 181 }, (_, i) => [
    center[0] + radius * Math.cos((i * Math.PI) / 90),
    center[1] + radius * Math.sin((i * Math.PI) / 90),
    center[2],
  ]);
}

export async function compareShapes(options: ShapesOptions): Promise<ShapesRow[]> {
  const rows: ShapesRow[] = [];
  for (const scene of scenes) rows.push(...(await compareScene(scene, options)));
  return rows;
}

async function compareScene(
  { name, url, preset, referenceLength }: BenchScene,
  options: ShapesOptions,
): Promise<ShapesRow[]> {
  const { size, steps, maxCurvature, turns } = options;
  const volume = await loadVolume(
    { url, settings: { verticalExaggeration: 5 }, limits },
    { signal: new AbortController().signal, onProgress: () => {} },
  );
  const transferFunction = await resolveTransferFunction(preset, volume.range);
  const { center, radius } = boundingSphere(volume.grid);
  const variants = listVariants(volume);
  const drawings = await Promise.all(
    variants.map(async ({ children, lines, slices = [], cuts = [], labels }) => {
      const [host, container] = [document.createElement('div'), document.createElement('div')];
      host.innerHTML = children;
      document.body.append(host, container);
      const scene = await VolumeScene.create(host, container, () => {}, fieldProviders);
      const optics = { transferFunction, referenceLength: referenceLength * radius, opacityFactor: 1, lightFactor: 1 };
      await scene.prepare(volume, optics);
      changePlan(scene, { picture: { width: size, height: size } });
      scene.setVolume(volume);
      await scene.setAppearance({ optics });
      changePlan(scene, { ground: { lines } });
      changePlan(scene, { slices, cuts });
      if (labels) await scene.setLabels(labels);
      changePlan(scene, {
        camera: orbitCamera({ theta: 0.5, phi: 1.1, radius: framingDistance(radius, 0.5, 1) }, center, 0.5),
      });
      const draw = async (curvature: number): Promise<number> => {
        changePlan(scene, { maxCurvature: curvature, edgeCurvature: Infinity });
        const began = performance.now();
        drawAt(scene, stepLengthOf(volume.grid, steps));
        await scene.finished();
        return performance.now() - began;
      };
      await draw(maxCurvature);
      await draw(0);
      const jumps = scene.readVolume()?.startJumps(1, false)();
      const share = jumps
        ? Array.from(jumps.data).filter((x, i) => i % 4 === 0 && x > 0).length / (jumps.data.length / 4)
        : 0;
      return {
        draw,
        share,
        dispose: () => scene.dispose(),
        timed: [] as { shown: Timed; none: Timed }[],
        all: [] as Timed[],
      };
    }),
  );
  const time = async (draw: (curvature: number) => Promise<number>, curvature: number): Promise<Timed> => {
    const before = await processorSeconds();
    const times: number[] = [];
    for (let i = 0; i < framesATurn; i++) times.push(await draw(curvature));
    return { ms: median(times), seconds: ((await processorSeconds()) - before) / framesATurn };
  };
  const [plain] = drawings;
  for (let turn = 0; turn < turns; turn++) {
    for (const one of drawings) {
      // Each beside one without shapes, before it and after it by turns: the machine is the same for both.
      const pair = turn % 2 ? [plain, one] : [one, plain];
      const timed = new Map<typeof one, Timed>();
      for (const each of pair) timed.set(each, await time(each.draw, maxCurvature));
      one.timed.push({ shown: timed.get(one)!, none: timed.get(plain)! });
    }
    if (turn % 5 === 0) for (const one of drawings) one.all.push(await time(one.draw, 0));
  }
  for (const { dispose } of drawings) dispose();
  return drawings.map(({ timed, all, share }, i) => ({
    scene: name,
    shapes: variants[i].name,
    ms: median(timed.map(({ shown }) => shown.ms)),
    ratio: median(timed.map(({ shown, none }) => shown.ms / none.ms)),
    work: 1000 * median(timed.map(({ shown }) => shown.seconds)),
    workRatio: median(timed.map(({ shown, none }) => shown.seconds / none.seconds)),
    allRays: 1000 * median(all.map(({ seconds }) => seconds)),
    share,
  }));
}

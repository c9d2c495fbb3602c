import { listFunctions, loadScene, studyScenes } from '../../demos/accuracy/scenes.ts';
import type { StudyFunction, StudyScene } from '../../demos/accuracy/scenes.ts';
import { parseTransferFunction } from '../../src/optics/transfer/parse-transfer-function.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { windowFromHistogram } from '../../src/optics/transfer/window.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { marschnerLobb } from '../accuracy/error-scenes.ts';
import {
  makeLesions,
  makeMesh,
  makeText,
  makeWires,
  scatter,
  smallFunctions,
  veilValue,
} from '../accuracy/small-volumes.ts';
import type { SmallVolume } from '../accuracy/small-volumes.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';

/** A volume with the transfer functions that it is drawn with. */
export interface BenchVolume {
  readonly name: string;
  readonly volume: Volume;
  /** A smooth one, three narrow peaks, an opaque surface; of small things one of their own. */
  readonly functions: readonly { readonly name: string; readonly transferFunction: TransferFunction }[];
  /** Of volumes made with small things: the same without them, and where they are in the volume, in voxel indices. */
  readonly small?: { readonly bare: Volume; readonly places: readonly Vector3[] };
}

/**
 * A veil, so that depth is seen, and an opaque surface that begins over a tenth of the window. The study's sharp step
 * would do peers wrong: their tables smear it, and no number of steps makes up for that.
 */
const opaqueRamp = '0% #2a4a7a 0, 40% #2a4a7a 4%, 50% #ffe8c0 100%, 100% white 100%';

async function listBenchFunctions(scene: StudyScene, volume: Volume): Promise<BenchVolume['functions']> {
  const functions: StudyFunction[] = await listFunctions(scene, volume);
  const window = volume.window ?? windowFromHistogram(volume.histogram);
  return [
    ...functions.filter(({ id }) => id !== 'step'),
    { name: 'Opaque from a ramp', transferFunction: parseTransferFunction(opaqueRamp, window) },
  ];
}

/** A thin shell in empty space. */
function shell(x: number, y: number, z: number): number {
  return Math.exp(-(((Math.hypot(x - 0.5, y - 0.5, z - 0.5) - 0.35) * 60) ** 2));
}

const made: Readonly<
  Record<string, { name: string; edge: number; field: (x: number, y: number, z: number) => number }>
> = {
  shell: { name: 'Thin shell, synthetic, mostly empty', edge: 256, field: shell },
  'marschner-lobb': { name: 'Marschner-Lobb, synthetic', edge: 128, field: marschnerLobb },
};

/** One-voxel specks in a veil; one-voxel wires, bars and strokes in empty space; balls that are a little denser than what is around them. */
const small: Readonly<Record<string, { name: string; make: () => SmallVolume; functionName: string; stops: string }>> =
  {
    specks: {
      name: 'Specks of 1 voxel, synthetic',
      make: () => scatter(128, veilValue, 300, 0),
      functionName: 'Specks in a veil',
      stops: smallFunctions.veil,
    },
    wires: {
      name: 'Wires of 1 voxel, synthetic',
      make: () => makeWires(128, 40),
      functionName: 'Solid wires',
      stops: smallFunctions.solid,
    },
    mesh: {
      name: 'Mesh of bars of 1 voxel, synthetic',
      make: () => makeMesh(128),
      functionName: 'Solid bars',
      stops: smallFunctions.solid,
    },
    text: {
      name: 'Strokes of 1 voxel, synthetic',
      make: () => makeText(72),
      functionName: 'Solid strokes',
      stops: smallFunctions.solid,
    },
    lesions: {
      name: 'Balls of radius 2, synthetic',
      make: makeLesions,
      functionName: 'A little denser',
      stops: '0 #400 0, 60 #400 0, 80 #a64 1.5%, 170 #fda 6%, 255 white 10%',
    },
  };

/**
 * A volume by its id: one of the accuracy study's, or a synthetic one. Null where its file is not here.
 * @throws Error where there is no such id
 */
export async function loadBenchVolume(id: string, signal: AbortSignal): Promise<BenchVolume | null> {
  if (Object.hasOwn(made, id)) {
    const { name, edge, field } = made[id];
    const volume = { ...syntheticVolume({ dimensions: [edge, edge, edge], field }), window: [0, 1] as const };
    return { name, volume, functions: await listBenchFunctions(studyScenes[0], volume) };
  }
  if (Object.hasOwn(small, id)) {
    const { name, make, functionName, stops } = small[id];
    const { block, bare, places } = make();
    const volume = block.toVolume();
    return {
      name,
      volume,
      small: { bare: bare.toVolume(), places },
      functions: [{ name: functionName, transferFunction: parseTransferFunction(stops, volume.range) }],
    };
  }
  const scene = studyScenes.find((one) => one.id === id);
  if (!scene)
    throw new Error(
      `SCENES got "${id}"; expected ${[...studyScenes.map((one) => one.id), ...Object.keys(made), ...Object.keys(small)].join(', ')}`,
    );
  const volume = await loadScene(scene, signal);
  return volume && { name: scene.name, volume, functions: await listBenchFunctions(scene, volume) };
}

/** Volumes one after the other, so that one at a time is held. */
export async function* eachVolume(ids: readonly string[], signal: AbortSignal): AsyncGenerator<BenchVolume> {
  for (const id of ids) {
    const scene = await loadBenchVolume(id, signal);
    if (scene) yield scene;
  }
}

// In the browser: small things in an element's pictures at rest, where the volume is cut, shapes stand in it, or slices.
import type { VolumeView } from '../../components/volume-view/volume-view.ts';
import { transformPoint } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { exactView } from './among-rays.ts';
import type { ExactView } from './among-rays.ts';
import { amongScenes } from './among-scenes.ts';
import type { AmongScene } from './among-scenes.ts';
import { measureThing } from './compare-shown.ts';
import type { ComparedPictures, KeptThing } from './compare-shown.ts';
import { cameraOf, placeElement, setSight, takeAtRest, webglOf } from './element-picture.ts';
import { findPixel } from './full-rays.ts';
import { serveVolume, sightOf } from './small-page.ts';

/** What is left of things at an angle: in their order, null where the view does not hold one, or rays see nothing of it. */
export interface SeenThings {
  /** But for the next ones. */
  readonly things: readonly (KeptThing | null)[];
  /** Those beside which the edge of a shape runs. */
  readonly atEdges: readonly (KeptThing | null)[];
}

/** A scene from several angles. */
export interface AmongResult {
  readonly name: string;
  readonly kind: string;
  /** null where it is drawn without. */
  readonly webgl: 1 | 2 | null;
  readonly pixelsPerVoxel: number;
  readonly ratio: number;
  readonly minContrast: number;
  readonly fewest: number;
  readonly whole: number | null;
  /** By angle. */
  readonly pictures: readonly SeenThings[];
  /** Of some pixels at the first angle, how far their rays are from such with twice the steps: the largest, 1/255. null where they were not. */
  readonly uncertain: number | null;
}

/** Things count that stand out by this many times `max-error`. */
const countsPerError = 8;

const stepsPerVoxel = 4;

/** Pixels at the first angle that are cast with twice the steps too. */
const doubted = 60;

/** How a scene is measured. */
interface HowMeasured {
  /** Their number, a degree apart. */
  readonly angles: number;
  /** Whether some rays are held against such with twice the steps. */
  readonly doubts?: boolean;
  /** The attribute; things count that stand out by eight times as much. */
  readonly maxError?: number;
  /** More of an element's attributes. */
  readonly attributes?: Readonly<Record<string, string>>;
  readonly notify?: (what: string) => void;
}

/** A volume's elements, alike but for their small things. */
interface Pair {
  readonly full: VolumeView;
  readonly bare: VolumeView;
}

/** What is looked at in a view. */
interface Looked {
  readonly around: readonly (readonly [x: number, y: number])[];
  /** Pixels. */
  readonly reach: number;
  readonly size: number;
}

/** @param name - of a scene */
export async function measureAmong(
  name: string,
  { angles, doubts = false, maxError = 1, attributes, notify }: HowMeasured,
): Promise<AmongResult> {
  const scene = amongScenes.find((one) => one.name === name)!;
  const { view, reach, fewest, kind, whole } = scene;
  const minContrast = Math.max(scene.minContrast, countsPerError * maxError);
  const made = scene.make();
  const volume = made.block.toVolume();
  const places = made.places.map((place): Vector3 => transformPoint(volume.grid.indexToWorld, place));
  await Promise.all(
    ['volume-clip', 'volume-slice']
      .filter((tag) => scene.children.includes(`<${tag}`))
      .map((tag) => import(`../../components/${tag}/define.ts`)),
  );
  const [full, bare] = [volume, made.bare.toVolume()].map((one) =>
    placeElement({
      src: serveVolume(one),
      sight: sightOf(volume, view, 0),
      attributes: {
        'max-error': String(maxError),
        ...scene.attributes,
        ...attributes,
        'transfer-function': scene.transferFunction!,
      },
      children: scene.children,
      ...view,
    }),
  );
  const pictures: SeenThings[] = [];
  let uncertain: number | null = null;
  for (let angle = 0; angle < angles; angle++) {
    notify?.(`${name}, angle ${angle + 1} of ${angles}`);
    const sight = sightOf(volume, view, angle);
    for (const element of [full, bare]) setSight(element, sight);
    const around = places.map((place) => findPixel(cameraOf(sight), place, view.pixels));
    const looked = { around, reach: Math.max(1, reach * view.pixelsPerVoxel), size: view.pixels };
    const compared = await comparePair({ full, bare }, scene, looked);
    const things = around.map((at) => measureThing(compared, at, looked.reach));
    const isAtEdge = around.map((at) =>
      listPixels({ ...looked, around: [at] }).some((pixel) => compared.edges.has(pixel)),
    );
    pictures.push({
      things: things.map((thing, n) => (isAtEdge[n] ? null : thing)),
      atEdges: things.map((thing, n) => (isAtEdge[n] ? thing : null)),
    });
    if (angle === 0 && doubts) uncertain = await doubtRays(full, scene, { ...looked, compared });
  }
  const webgl = webglOf(full);
  for (const element of [full, bare]) element.remove();
  return {
    name,
    kind,
    webgl,
    pixelsPerVoxel: view.pixelsPerVoxel,
    ratio: view.ratio,
    minContrast,
    fewest,
    whole,
    pictures,
    uncertain,
  };
}

/** All pixels that are looked at, each once. */
function listPixels({ around, reach, size }: Looked): number[] {
  const pixels = new Set<number>();
  for (const [x, y] of around) {
    for (let row = Math.max(0, Math.floor(y - reach)); row <= Math.min(size - 1, y + reach); row++) {
      for (let column = Math.max(0, Math.floor(x - reach)); column <= Math.min(size - 1, x + reach); column++)
        pixels.add(row * size + column);
    }
  }
  return [...pixels];
}

/**
 * The pictures at rest, and the same pixels in float64 where things are looked for; nothing elsewhere. Through some pixels the edge of a shape runs. Of
 * these the screen has some samples on the shape, other ones than the reference: so there only that counts by which the two pictures differ.
 */
async function comparePair(
  { full, bare }: Pair,
  scene: AmongScene,
  looked: Looked,
): Promise<ComparedPictures & { readonly edges: ReadonlySet<number> }> {
  const { size } = looked;
  const pictures = [await takeAtRest(full, size), await takeAtRest(bare, size)].map(({ data }) => data);
  const [fullView, bareView] = [await viewOf(full, scene, stepsPerVoxel), await viewOf(bare, scene, stepsPerVoxel)];
  const shown = Float32Array.from(pictures[0]);
  const edges = new Set<number>();
  const casts = [fullView, bareView].map(() => new Float32Array(4 * size * size));
  for (const pixel of listPixels(looked)) {
    const at = [pixel % size, Math.floor(pixel / size)] as const;
    casts[0].set(fullView.cast(...at), 4 * pixel);
    casts[1].set(bareView.cast(...at), 4 * pixel);
    if (!fullView.isEdge(...at)) continue;
    edges.add(pixel);
    for (let c = 4 * pixel; c < 4 * pixel + 4; c++) shown[c] += 255 * casts[1][c] - pictures[1][c];
  }
  return { shown, full: casts[0], bare: casts[1], size, edges };
}

/** @throws Error where what is to be among the things is not there */
async function viewOf(
  element: VolumeView,
  { name, kind, shape, view, attributes }: AmongScene,
  steps: number,
): Promise<ExactView> {
  const exact = await exactView(element, { shape, size: view.pixels, stepsPerVoxel: steps });
  if (kind !== 'shape' && exact.ends === 0 && !attributes.region)
    throw new Error(`${name}: nothing ends its rays; expected cuts or slices`);
  return exact;
}

async function doubtRays(
  element: VolumeView,
  scene: AmongScene,
  { compared: { full, size }, ...looked }: Looked & { readonly compared: ComparedPictures },
): Promise<number> {
  const finer = await viewOf(element, scene, 2 * stepsPerVoxel);
  const pixels = listPixels({ ...looked, size });
  const every = Math.ceil(pixels.length / doubted);
  const off = pixels
    .filter((_, i) => i % every === 0)
    .map((pixel) => {
      const exact = finer.cast(pixel % size, Math.floor(pixel / size));
      return Math.max(...exact.map((x, c) => 255 * Math.abs(x - full[4 * pixel + c])));
    });
  return Math.max(...off);
}

export function listAmong(): string[] {
  return amongScenes.map(({ name }) => name);
}

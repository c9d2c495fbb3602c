// The one file that knows the package's inside: scenes are described in words of this program's own, and drawn here.
import { allSubsteps } from '../../src/optics/cells/substeps.ts';
import { fieldProviders } from '../../components/internal/field-providers.ts';
import { orbitCamera } from '../../src/optics/rays/camera.ts';
import type { Slice } from '../../src/radar/slices.ts';
import { boundingSphere, longestDiagonal } from '../../src/volume/grid.ts';
import { cutRegion } from '../../src/volume/region.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { changePlan, drawAt } from '../helpers/change-plan.ts';
import { radarVolume } from '../helpers/synthetic-radar.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';
import { drawInPieces } from '../helpers/draw-in-pieces.ts';
import { readPixels } from '../helpers/read-pixels.ts';
import { probe } from '../helpers/probe.ts';
import '../helpers/provide-substeps.ts';

type Triple = readonly [number, number, number];

/** A box of voxels of one field, 0..1, on the unit cube; NaN where there are no data, in floats. */
export interface Box {
  readonly dimensions: Triple;
  readonly kind: 'uint8' | 'uint16' | 'float32';
  readonly field: (x: number, y: number, z: number) => number;
}

/** Sweeps of a radar: 8 and 16 bits hold numbers from 1 up and 0 for no data; floats hold NaN for these. */
export interface Radar {
  readonly sweeps: readonly {
    readonly elevation: number;
    readonly azimuths: readonly number[];
    /** Degrees, by azimuth; the sweep's where absent. */
    readonly rayElevation?: (azimuth: number) => number;
    readonly gates: number;
    readonly kind: 'uint8' | 'uint16' | 'float32';
    readonly stored: (azimuth: number, gate: number) => number;
    readonly slope: number;
    readonly intercept: number;
    readonly nyquist?: number;
  }[];
  readonly exaggeration: number;
  readonly isVelocity?: boolean;
  readonly straightBeams?: boolean;
}

export type Cut =
  | { readonly cut: 'sweep'; readonly number: number }
  | { readonly cut: 'height'; readonly metres: number }
  | {
      readonly cut: 'upright';
      readonly from: readonly [number, number];
      readonly direction: readonly [number, number];
      readonly length: number;
    };

export interface Shown {
  readonly volume: Box | Radar;
  /** Angles in radians, and the radius in diagonals of the volume. */
  readonly orbit: { readonly theta: number; readonly phi: number; readonly radius: number };
  readonly stops: readonly { readonly value: number; readonly color: Triple; readonly opacity: number }[];
  /** Of the diagonal. */
  readonly referenceLength: number;
  readonly opacityFactor?: number;
  readonly lightFactor?: number;
  readonly cuts?: readonly Cut[];
  /** Two corners, world units. */
  readonly region?: readonly number[];
  /** X3D, as HTML. */
  readonly children?: string;
  readonly width: number;
  readonly height: number;
  /** Along the diagonal. */
  readonly steps: number;
}

export interface Drawing {
  /** RGBA, premultiplied, top row first. */
  draw(): Uint8ClampedArray;
  /** With rays where the picture curvatures by more than this, 1/255, and pixels interpolated elsewhere. */
  drawAdaptive(curvature: number): Uint8ClampedArray;
  /** Piece by piece, where nobody sees it, and shown at the end. @param rows - of a piece. @param curvature - 0: a ray a pixel */
  drawInPieces(rows: number, curvature: number): Uint8ClampedArray;
  /** RGBA floats of a lattice of rays, with once, twice and four times the steps. */
  probe(stride: number): Float32Array;
  /** Without crossing empty space at once. */
  drawSlowly(): Uint8ClampedArray;
  /** With steps that are cut into no more substeps than this. */
  drawCoarsely(substeps: number): Uint8ClampedArray;
}

/** Draw something with a scene of its own, which is taken down afterwards. @param webgl2 - which the page has to give */
export async function withDrawing<T>(shown: Shown, webgl2: boolean, use: (drawing: Drawing) => T): Promise<T> {
  const host = document.createElement('div');
  host.innerHTML = shown.children ?? '';
  const container = document.createElement('div');
  document.body.append(host, container);
  const scene = await VolumeScene.create(host, container, () => {}, fieldProviders);
  try {
    if (scene.device.webgl2 !== webgl2)
      throw new Error(`the scene got WebGL ${scene.device.webgl2 ? 2 : 1}; expected the other one`);
    return use(startDrawing(scene, shown, await applyTo(scene, shown)));
  } finally {
    scene.dispose();
    host.remove();
    container.remove();
  }
}

const buildVolume = (options: Box | Radar): Volume =>
  'field' in options
    ? syntheticVolume(options)
    : radarVolume(
        { sweeps: options.sweeps, moments: [options.isVelocity ? ['VRAD', 'velocity'] : ['DBZH', 'reflectivity']] },
        { verticalExaggeration: options.exaggeration, ...(options.straightBeams ? { beamModel: 'straight' } : {}) },
      );

function toSlice(cut: Cut): Slice {
  if (cut.cut === 'sweep') return { kind: 'cone', sweep: cut.number };
  if (cut.cut === 'height') return { kind: 'level', height: cut.metres };
  return { kind: 'upright', from: cut.from, direction: cut.direction, length: cut.length };
}

/** @returns the step's world length */
async function applyTo(scene: VolumeScene, shown: Shown): Promise<number> {
  const volume = buildVolume(shown.volume);
  const diagonal = longestDiagonal(volume.grid);
  await scene.prepare(volume);
  changePlan(scene, { picture: { width: shown.width, height: shown.height } });
  scene.setVolume(volume);
  await scene.setAppearance({
    optics: {
      transferFunction: shown.stops,
      referenceLength: shown.referenceLength * diagonal,
      opacityFactor: shown.opacityFactor ?? 1,
      lightFactor: shown.lightFactor ?? 1,
    },
  });
  changePlan(scene, { slices: (shown.cuts ?? []).map(toSlice), cuts: [] });
  changePlan(scene, { region: shown.region ? cutRegion(volume.grid, shown.region) : null });
  changePlan(scene, {
    camera: orbitCamera(
      { ...shown.orbit, radius: shown.orbit.radius * diagonal },
      boundingSphere(volume.grid).center,
      0.6,
    ),
  });
  return diagonal / shown.steps;
}

function startDrawing(scene: VolumeScene, { width, height }: Shown, stepLength: number): Drawing {
  const draw = (): Uint8ClampedArray => {
    drawAt(scene, stepLength, 0);
    return readPixels(scene);
  };
  return {
    draw,
    drawAdaptive(curvature) {
      changePlan(scene, { maxCurvature: curvature, edgeCurvature: Infinity });
      if (!scene.adaptive) throw new Error('the scene got no adaptive rays; expected that this device has them');
      return draw();
    },
    drawInPieces(rows, curvature) {
      changePlan(scene, { maxCurvature: curvature, edgeCurvature: Infinity });
      drawAt(scene, stepLength * 4, 0);
      if (!scene.gatherable) throw new Error('the scene is drawn at once alone; expected one that is drawn in pieces');
      drawInPieces(scene, stepLength, { width, height }, rows);
      changePlan(scene, { stepLength });
      scene.drawGathered(0);
      return readPixels(scene);
    },
    probe(stride) {
      draw();
      const first = Math.floor(stride / 2);
      const [columns, lines] = [width, height].map((pixels) => Math.floor((pixels - 1 - first) / stride) + 1);
      const floats = probe(
        scene,
        [1, 0.5, 0.25].map((share) => share * stepLength),
        { stride, first: [first, first], width: columns, height: lines },
        { width, height },
      );
      if (!floats) throw new Error('the scene got no probe; expected a device that draws floats');
      return Float32Array.from(floats.flatMap((some) => [...some]));
    },
    drawSlowly() {
      scene.layers[0].skipping = false;
      return draw();
    },
    drawCoarsely(substeps) {
      changePlan(scene, { substeps: { ...allSubsteps, max: substeps } });
      return draw();
    },
  };
}

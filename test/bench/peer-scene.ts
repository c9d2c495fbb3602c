import { CameraRig } from '../../src/viewer/camera/camera-rig.ts';
import { defaultReferenceLength } from '../../demos/accuracy/study-view.ts';
import type { Camera } from '../../src/optics/rays/camera.ts';
import type { LitMaterial } from '../../src/optics/transfer/lights.ts';
import { evaluate } from '../../src/optics/transfer/transfer-function.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { boundingSphere, cartesianGrid } from '../../src/volume/grid.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import { scaleAndTranslate } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';

/** What a peer is given, see peers/README.md. */
export interface PeerScene {
  readonly dimensions: Vector3;
  readonly spacing: Vector3;
  readonly samples: Uint8Array | Float32Array;
  readonly domain: readonly [number, number];
  readonly table: Float32Array;
  readonly referenceLength: number;
  readonly camera: PeerCamera;
  /** What is absent is not lit. */
  readonly light?: PeerLight;
}

/** A white light at the eye, and a material as of `LitMaterial`. */
export interface PeerLight extends LitMaterial {
  /** Where values hardly change opacity goes to 0: the change from voxel to voxel at which all of it is left, as a share of the domain. */
  readonly fadesFlat?: number;
}

/** A camera on an orbit. */
export interface PeerCamera extends Camera {
  readonly theta: number;
  readonly phi: number;
  readonly distance: number;
}

/** Texels of a peer's table. */
const tableSize = 1024;

/**
 * The same volume on axes that are the world's, its centre at the origin, so that no peer has to know of affines.
 * @throws Error where its axes are not the world's, in either direction
 */
export function alignVolume(volume: Volume): Volume {
  const { dimensions, indexToWorld: m, spacing } = volume.grid;
  const [nx, ny, nz] = dimensions;
  if ([1, 2, 4, 6, 8, 9].some((i) => Math.abs(m[i]) > 1e-6 * Math.min(...spacing)))
    throw new Error('peers get no oblique volumes');
  const samples = volume.samples.slice();
  const [flipX, flipY, flipZ] = flipsOf(volume);
  for (let k = 0, at = 0; k < nz; k++) {
    for (let j = 0; j < ny; j++) {
      const row = nx * ((flipY ? ny - 1 - j : j) + ny * (flipZ ? nz - 1 - k : k));
      for (let i = 0; i < nx; i++) samples[at++] = volume.samples[row + (flipX ? nx - 1 - i : i)];
    }
  }
  const first = dimensions.map((n, axis) => (-(n - 1) / 2) * spacing[axis]) as unknown as Vector3;
  return {
    ...volume,
    samples,
    grid: cartesianGrid(dimensions, scaleAndTranslate(spacing, first)),
    macrocells: buildMacrocells(samples, dimensions),
  };
}

/** Which axes of a volume go against the world's. */
function flipsOf({ grid: { indexToWorld: m } }: Volume): [boolean, boolean, boolean] {
  return [m[0] < 0, m[5] < 0, m[10] < 0];
}

/** Where a voxel of a volume is in the world, once the volume is aligned. @param place - in voxel indices of the volume as it was */
export function alignPlace(volume: Volume, place: Vector3): Vector3 {
  const { dimensions, spacing } = volume.grid;
  const flips = flipsOf(volume);
  return place.map((i, axis) => {
    const last = dimensions[axis] - 1;
    return ((flips[axis] ? last - i : i) - last / 2) * spacing[axis];
  }) as unknown as Vector3;
}

/** The default view of `<volume-view>`. */
export function findCamera(volume: Volume): PeerCamera {
  const rig = new CameraRig();
  rig.setSubject(boundingSphere(volume.grid));
  rig.setAspect(1);
  const { theta, phi, radius } = rig.orbit;
  return { ...rig.camera, theta, phi, distance: radius };
}

/** @param volume - of alignVolume */
export function describeScene(volume: Volume, transferFunction: TransferFunction, camera: PeerCamera): PeerScene {
  const { samples, slope, intercept } = volume;
  const { dimensions, spacing } = volume.grid;
  const isBytes = samples instanceof Uint8Array;
  const [low, high] = [transferFunction[0].value, transferFunction[transferFunction.length - 1].value];
  const toSample = (value: number): number => (isBytes ? (value - intercept) / slope : value);
  return {
    dimensions,
    spacing,
    samples: isBytes ? samples : Float32Array.from(samples, (sample) => slope * sample + intercept),
    domain: [toSample(low), toSample(high)],
    table: buildTable(transferFunction, low, high),
    referenceLength: defaultReferenceLength(volume),
    camera,
  };
}

/** Straight colour and opacity; what can't be seen gets a trace of opacity, so that its colour can be told. */
function buildTable(transferFunction: TransferFunction, low: number, high: number): Float32Array {
  const visible = transferFunction.map((stop) => ({ ...stop, opacity: Math.max(stop.opacity, 1e-6) }));
  const table = new Float32Array(tableSize * 4);
  for (let i = 0; i < tableSize; i++) {
    const value = low + (i / (tableSize - 1)) * (high - low);
    const [red, green, blue, alpha] = evaluate(visible, value);
    table.set([red / alpha, green / alpha, blue / alpha, evaluate(transferFunction, value)[3]], i * 4);
  }
  return table;
}

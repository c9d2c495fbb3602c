// The same picture in float64, for the attributes that the page is given. Runs in Node and in pages.
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import type { Camera, Orbit } from '../../../src/optics/rays/camera.ts';
import { projectionGather } from '../../../src/optics/rays/projection.ts';
import type { ProjectionKind } from '../../../src/optics/rays/ray-style.ts';
import { setUpRays } from '../../../src/optics/rays/rays.ts';
import { renderReference } from '../../../src/optics/reference.ts';
import type { TransferFunction } from '../../../src/optics/transfer/transfer-function.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { remember } from '../../helpers/remember.ts';
import type { Picture } from './pictures.ts';
import { field } from './volumes.ts';

/** Every attribute that the picture depends on, so that nothing is left to defaults. */
export const plainAttributes = {
  'transfer-function': '0.15 #003 0, 0.4 #c63 4%, 0.8 #ffc 0.3',
  'reference-length': '1',
  'camera-orbit': '35deg 65deg 90',
  'camera-target': '0 0 0',
  'field-of-view': '32deg',
  steps: '30',
} as const;

const plainStops: TransferFunction = [
  { value: 0.15, color: [0, 0, 0.2], opacity: 0 },
  { value: 0.4, color: [0.8, 0.4, 0.2], opacity: 0.04 },
  { value: 0.8, color: [1, 1, 0.8], opacity: 0.3 },
];

const radians = (degrees: number): number => (degrees * Math.PI) / 180;

export const plainOrbit: Orbit = { theta: radians(35), phi: radians(65), radius: 90 };
export const plainCamera: Camera = orbitCamera(plainOrbit, [0, 0, 0], radians(32));

/** The plain attributes as HTML, with others over them. */
export function attributesOf(changes: Record<string, string> = {}): string {
  return Object.entries({ ...plainAttributes, ...changes })
    .map(([name, value]) => `${name}="${value}"`)
    .join(' ');
}

export interface ReferenceView {
  readonly volume?: Volume;
  readonly camera?: Camera;
  readonly steps?: number;
  readonly projection?: ProjectionKind;
  readonly width?: number;
  readonly height?: number;
  /** What shines through from behind, 0..255. */
  readonly background?: Vector3;
}

/** What the element should show. */
export function drawReference(view: ReferenceView = {}): Picture {
  const { volume = field, camera = plainCamera, steps = 30, width = 120, height = 90, projection, background } = view;
  const data = castOnce(volume)(JSON.stringify({ camera, steps, width, height, projection }));
  return { width, height, data: background ? putOver(data, background) : data };
}

// Half a second of work, and most tests ask for the same few.
const castOnce = remember((volume: Volume) =>
  remember((key: string): Float64Array => {
    const { camera, steps, width, height, projection } = JSON.parse(key) as Required<
      Pick<ReferenceView, 'camera' | 'steps' | 'width' | 'height'>
    > &
      Pick<ReferenceView, 'projection'>;
    const rays = setUpRays(
      volume.grid,
      viewMatrix(camera),
      projectionMatrix(camera.fieldOfView, width / height, 1, 2),
    )!;
    const optics = { transferFunction: plainStops, referenceLength: 1, opacityFactor: 1, lightFactor: 1 };
    const gather = projection && projectionGather(projection);
    const scene = {
      ...volume,
      ...optics,
      stepLength: longestDiagonal(volume.grid) / steps,
      ...(gather ? { gather } : {}),
    };
    return renderReference(scene, rays, width, height).map((x) => x * 255);
  }),
);

function putOver(data: Float64Array, background: Vector3): Float64Array {
  return data.map((x, i) => (i % 4 === 3 ? 255 : x + background[i % 4] * (1 - data[i - (i % 4) + 3] / 255)));
}

// In the browser: small things in panes with slices, at several sizes.
import { interpolate } from '../../src/optics/rays/interpolate.ts';
import { boxAround, fitFrame, placeAt, pointAt } from '../../src/panes/pane-frame.ts';
import { planeOf, toPlane, toWorld } from '../../src/panes/slice-plane.ts';
import type { SlicePlane } from '../../src/panes/slice-plane.ts';
import { corners, unitToWorld } from '../../src/volume/grid.ts';
import { invertAffine, transformPoint } from '../../src/volume/matrix.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import type { AmongResult, SeenThings } from './among-page.ts';
import { scatterOn, speckValue } from './among-scenes.ts';
import { ontoPlane } from './among-shapes.ts';
import { measureThing } from './compare-shown.ts';
import { serveVolume } from './small-page.ts';
import '../../components/volume-slice-view/define.ts';

/** Pixels a voxel. */
export const paneZooms = [1, 1.13, 1.5, 2.3, 4.2] as const;

/** In the middle of a layer of voxels. */
const at = 0.5;

/** Of one degree a step: the first slice is in the middle of its layer, and the others leave it at their rims. */
const normalOf = (angle: number): Vector3 => [Math.sin((angle * Math.PI) / 180), 0, Math.cos((angle * Math.PI) / 180)];

/** Specks on a slice that fills a pane. @param angles - their number, a degree apart */
export async function measurePane(zoom: number, angles: number): Promise<AmongResult> {
  const { block, bare, places } = scatterOn(0, [ontoPlane([0, 0, 1], at)], 1);
  const volume = block.toVolume();
  const world = places.map((place) => transformPoint(volume.grid.indexToWorld, place));
  const pane = document.createElement('volume-slice-view');
  const css = Math.round(zoom * block.edge);
  Object.defineProperty(window, 'devicePixelRatio', { configurable: true, value: 1 });
  pane.style.cssText = `display: block; inline-size: ${css}px; block-size: ${css}px; min-block-size: 0; aspect-ratio: auto`;
  for (const [name, value] of Object.entries({
    src: serveVolume(volume),
    type: 'oblique',
    at: String(at),
    'value-window': '0 255',
    'window-function': 'linear-exact',
    colors: 'gray',
  }))
    pane.setAttribute(name, value);
  document.body.append(pane);
  const pictures: SeenThings[] = [];
  for (let angle = 0; angle < angles; angle++) {
    const normal = normalOf(angle);
    pane.setAttribute('normal', normal.join(' '));
    await pane.whenRendered();
    const { width, height, data } = readPane(pane);
    if (width !== css || height !== css) throw new Error(`the pane has ${width} x ${height} pixels; expected ${css}`);
    const [full, without] = [volume, bare.toVolume()].map((one) => slicePicture(one, planeOf('oblique', normal), css));
    const point = pointOf(volume, planeOf('oblique', normal), css);
    const compared = { shown: data, full, bare: without, size: css };
    pictures.push({
      things: world.map((place) => measureThing(compared, point(place), Math.max(1, zoom))),
      atEdges: [],
    });
  }
  pane.remove();
  return {
    name: 'Specks on a slice in a pane',
    kind: 'pane',
    webgl: null,
    pixelsPerVoxel: zoom,
    ratio: 1,
    minContrast: 8,
    fewest: 40,
    whole: speckValue,
    pictures,
    uncertain: null,
  };
}

function readPane(pane: HTMLElement): ImageData {
  const canvas = pane.shadowRoot!.querySelector('canvas')!;
  return canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
}

/** The slice pixel by pixel, from the samples: grey, opaque, 0..1, top row first. */
function slicePicture(volume: Volume, plane: SlicePlane, size: number): Float32Array {
  const { grid, samples } = volume;
  const frame = fitFrame(boxAround(plane, corners(grid)), { width: size, height: size });
  const toUnit = invertAffine(unitToWorld(grid))!;
  const picture = new Float32Array(4 * size * size).fill(1);
  for (let pixel = 0; pixel < size * size; pixel++) {
    const { u, v } = placeAt(frame, { width: size, height: size }, [
      (pixel % size) + 0.5,
      Math.floor(pixel / size) + 0.5,
    ]);
    const value = interpolate(samples, grid.dimensions, transformPoint(toUnit, toWorld(plane, { u, v, d: at })));
    picture.fill(value / 255, 4 * pixel, 4 * pixel + 3);
  }
  return picture;
}

function pointOf({ grid }: Volume, plane: SlicePlane, size: number): (place: Vector3) => readonly [number, number] {
  const frame = fitFrame(boxAround(plane, corners(grid)), { width: size, height: size });
  return (place) => pointAt(frame, { width: size, height: size }, toPlane(plane, place));
}

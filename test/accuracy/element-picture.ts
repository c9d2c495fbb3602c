// In the browser: an element that shows a volume, and the bytes that it shows at rest.
import type { VolumeView } from '../../components/volume-view/volume-view.ts';
import { orbitCamera } from '../../src/optics/rays/camera.ts';
import type { Camera } from '../../src/optics/rays/camera.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { RenderStats } from '../../src/viewer/model/render-stats.ts';
import '../../src/index.ts';

/** A square picture as it stands on the screen: RGBA, premultiplied, bottom row first. */
export interface ShownPicture {
  readonly data: Uint8Array;
  readonly size: number;
  readonly stats: RenderStats;
}

/** Where the camera of a picture stands. */
export interface Sight {
  /** Degrees. */
  readonly theta: number;
  readonly phi: number;
  /** World length. */
  readonly radius: number;
  readonly target: Vector3;
}

/** Degrees, of all pictures. */
const fieldOfView = 30;

/** A picture that is not at rest by then never will be, ms. */
const longest = 120_000;

/** What is done to an element before its first picture. */
export interface ElementSetup {
  readonly src: string;
  readonly sight: Sight;
  /** Device pixels along each side. */
  readonly pixels: number;
  readonly ratio: number;
  readonly attributes?: Readonly<Record<string, string>>;
  /** Between its tags, as HTML. */
  readonly children?: string;
}

/** Put an element into the page, as a person would, at its default settings but for what is given. */
export function placeElement({ src, sight, pixels, ratio, attributes = {}, children = '' }: ElementSetup): VolumeView {
  const element = document.createElement('volume-view');
  element.setAttribute('src', src);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.innerHTML = children;
  setSize(element, pixels, ratio);
  setSight(element, sight);
  document.body.append(element);
  return element;
}

/** Device pixels of a CSS pixel: what zooming the page does. */
export function setSize(element: VolumeView, pixels: number, ratio: number): void {
  Object.defineProperty(window, 'devicePixelRatio', { configurable: true, value: ratio });
  element.style.cssText = `display: block; width: ${pixels / ratio}px; height: ${pixels / ratio}px; max-height: none; aspect-ratio: auto`;
}

export function setSight(element: VolumeView, { theta, phi, radius, target }: Sight): void {
  element.setAttribute('field-of-view', `${fieldOfView}deg`);
  element.setAttribute('camera-target', target.join(' '));
  element.setAttribute('camera-orbit', `${theta}deg ${phi}deg ${radius}`);
}

/** The same camera. */
export function cameraOf({ theta, phi, radius, target }: Sight): Camera {
  return orbitCamera({ theta: radians(theta), phi: radians(phi), radius }, target, radians(fieldOfView));
}

/** Distance from which a voxel at the target has so many pixels. @param voxel - world length */
export function distanceFor({
  pixels,
  pixelsPerVoxel,
  voxel,
}: {
  pixels: number;
  pixelsPerVoxel: number;
  voxel: number;
}): number {
  return (pixels * voxel) / pixelsPerVoxel / (2 * Math.tan(radians(fieldOfView) / 2));
}

/** The picture at rest. @throws Error where it has another size than was asked for, or does not come to rest */
export async function takeAtRest(element: VolumeView, pixels: number): Promise<ShownPicture> {
  await element.whenRendered();
  const began = performance.now();
  while (!element.renderStats?.converged) {
    if (performance.now() - began > longest) throw new Error('the picture does not come to rest');
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  const stats = element.renderStats;
  const canvas = canvasOf(element);
  if (canvas.width !== pixels || canvas.height !== pixels)
    throw new Error(`the picture has ${canvas.width} x ${canvas.height} pixels; expected ${pixels}`);
  return { data: readCanvas(canvas), size: pixels, stats };
}

export function canvasOf(element: VolumeView): HTMLCanvasElement {
  return element.shadowRoot!.querySelector('canvas')!;
}

/** What an element draws with, once it has drawn. */
export function webglOf(element: VolumeView): 1 | 2 {
  return canvasOf(element).getContext('webgl2') ? 2 : 1;
}

/** The canvas keeps what it shows, so it can be read at any time. */
function readCanvas(canvas: HTMLCanvasElement): Uint8Array {
  const gl = (canvas.getContext('webgl2') ?? canvas.getContext('webgl')) as WebGL2RenderingContext; // Of WebGL 1 all that is called here is there too.
  if (!gl.getContextAttributes()?.preserveDrawingBuffer) throw new Error('the canvas does not keep its picture');
  const bound = gl.getParameter(gl.FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
  const data = new Uint8Array(canvas.width * canvas.height * 4);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  gl.bindFramebuffer(gl.FRAMEBUFFER, bound);
  return data;
}

function radians(degrees: number): number {
  return (degrees * Math.PI) / 180;
}

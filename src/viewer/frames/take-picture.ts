// Writes pictures as files. It is loaded when a page asks for the first one.
import { allRays } from '../../quality/sampling-outcome.ts';
import type { FrameDrawing } from './frame-drawing.ts';
import { pictureSize } from '../model/picture-size.ts';
import type { PictureSize } from '../model/picture-size.ts';
import type { Scene } from '../model/scene.ts';

/** The requested file: its type, and its size in device pixels, as far as the caller gives it. */
export interface FileGoal extends Partial<PictureSize> {
  readonly type: string;
}

/** A picture file of the view at rest; a missing width or height follows from the element's shape. */
export async function takePicture(scene: Scene, frames: FrameDrawing, { type, ...goal }: FileGoal): Promise<Blob> {
  const { pictures, planAtRest, host } = frames;
  const size = askedSize(host, goal, scene.device.maxTextureSize);
  const own = frames.sizeIn(scene);
  // Which pixels can be interpolated was chosen for the element's size.
  const isOwn = size.width === own.width && size.height === own.height;
  pictures.drawAtRest(scene, isOwn ? planAtRest : { ...planAtRest, sampling: allRays }, size);
  const blob = await new Promise<Blob | null>((resolve) => {
    scene.canvas.toBlob(resolve, type);
    // `toBlob` takes the canvas during the call; the element's own picture must be back before the page is painted.
    if (!isOwn) pictures.drawAtRest(scene, planAtRest, own);
  });
  if (!blob) throw new Error(`toBlob() got the type "${type}", which this browser can't write`);
  return blob;
}

/** @throws {RangeError} where the device can't draw so many pixels */
function askedSize(host: Element, { width, height }: Partial<PictureSize>, maxSide: number): PictureSize {
  if (width === undefined && height === undefined) return pictureSize(host, maxSide);
  const ratio = host.clientWidth / Math.max(1, host.clientHeight);
  const [w, h] = [width ?? height! * ratio, height ?? width! / ratio].map(Math.round);
  if (!(w >= 1 && h >= 1 && w <= maxSide && h <= maxSide)) {
    throw new RangeError(`toBlob got ${w} x ${h} pixels; expected 1 to ${maxSide} on each side`);
  }
  return { width: w, height: h };
}

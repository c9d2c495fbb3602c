import { allRays } from '../quality/sampling-outcome.ts';
import type { FrameDrawing } from './frame-drawing.ts';
import type { PictureDrawing } from './picture-drawing.ts';
import { pictureSize } from './picture-size.ts';
import type { PictureSize } from './picture-size.ts';
import type { Scene } from './scene.ts';

/** A picture of what a scene shows, as a file: loaded when a script asks for the first one. */
export async function takePicture(
  scene: Scene,
  { type, goal }: { type: string; goal: Partial<PictureSize> },
  host: Element,
  { frames, pictures }: { frames: FrameDrawing; pictures: PictureDrawing },
): Promise<Blob> {
  const plan = frames.planAtRest;
  const size = askedSize(host, goal, scene.device.maxTextureSize);
  pictures.drawAtRest(scene, { ...plan, sampling: allRays }, size);
  const blob = await new Promise<Blob | null>((resolve) => {
    scene.canvas.toBlob(resolve, type);
    // The file is taken by the call; the element's own picture has to be back before the page is painted.
    pictures.drawAtRest(scene, plan, frames.sizeIn(scene));
  });
  if (!blob) throw new Error(`toBlob() got the type "${type}", which this browser can't write`);
  return blob;
}

/**
 * The size of a picture that a script asks for; what is absent follows from the element's shape.
 * @throws {RangeError} where the device does not draw so many pixels
 */
function askedSize(host: Element, { width, height }: Partial<PictureSize>, maxSide: number): PictureSize {
  if (width === undefined && height === undefined) return pictureSize(host, maxSide);
  const ratio = host.clientWidth / Math.max(1, host.clientHeight);
  const [w, h] = [width ?? height! * ratio, height ?? width! / ratio].map(Math.round);
  if (!(w >= 1 && h >= 1 && w <= maxSide && h <= maxSide)) {
    throw new RangeError(`toBlob got ${w} x ${h} pixels; expected 1 to ${maxSide} on each side`);
  }
  return { width: w, height: h };
}

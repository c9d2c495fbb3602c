// In the browser: scenes with the source's own parts.
import { innerScenes } from './inner-scenes.ts';
import { withDrawing } from './scene-adapter.ts';

/** What comes out of the page. */
export interface DrawnInside {
  readonly family: string;
  readonly width: number;
  readonly height: number;
  readonly kind: 'bytes' | 'floats';
  /** A data URL of the bytes. */
  readonly data: string;
}

export const listNames = (): string[] => innerScenes.map(({ name }) => name);

export async function drawInside(name: string, webgl2: boolean): Promise<DrawnInside> {
  const scene = innerScenes.find((one) => one.name === name);
  if (!scene) throw new Error(`a scene got the name "${name}"; expected one of ${listNames().join('; ')}`);
  const data = await withDrawing(scene.shown, webgl2, scene.use);
  const { width, height } = scene.shown;
  return {
    family: scene.family,
    width,
    height,
    kind: data instanceof Float32Array ? 'floats' : 'bytes',
    data: await toDataUrl(Uint8Array.from(new Uint8Array(data.buffer))),
  };
}

function toDataUrl(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.addEventListener('load', () => resolve(reader.result as string));
    reader.addEventListener('error', () => reject(reader.error ?? new Error('the bytes could not be read')));
    reader.readAsDataURL(new Blob([bytes]));
  });
}

import { VolumeViewError } from '../errors.ts';
import { urlOf, X3dFields } from './x3d-fields.ts';

/** A row of colours: RGBA, 0 to 255. */
type Row = readonly (readonly number[])[];

/** Stops that are made of a texture at most. */
const mostStops = 256;

/**
 * The texture of X3D's OpacityMapVolumeStyle as a transfer function that spans the window. Without alpha, opacity is the brightness.
 * @throws {VolumeViewError} `attribute/invalid`
 */
export async function readOpacityMap(texture: Element): Promise<string> {
  const name = texture.localName.toLowerCase();
  if (name !== 'pixeltexture' && name !== 'imagetexture' && name !== 'texture') {
    throw wrong(`<${texture.localName}>`, 'an ImageTexture or a PixelTexture');
  }
  const row = name === 'pixeltexture' ? readPixels(new X3dFields(texture, 'PixelTexture')) : await loadRow(new X3dFields(texture, 'ImageTexture'));
  const picked = row.length > mostStops ? Array.from({ length: mostStops }, (_, i) => row[Math.round((i * (row.length - 1)) / (mostStops - 1))]) : row;
  const last = picked.length - 1;
  return picked.map(([red, green, blue, alpha], i) => `${last > 0 ? (100 * i) / last : 100}% rgb(${red} ${green} ${blue}) ${(100 * alpha) / 255}%`).join(', ');
}

function wrong(got: string, expected: string): VolumeViewError {
  return new VolumeViewError('attribute/invalid', `the transferFunction of <OpacityMapVolumeStyle> got ${got}; expected ${expected}. Or write transfer-function="0% #000 0%, 100% #fff 80%" on the volume-view.`);
}

/** Without alpha, that is the brightness. */
function withAlpha([red, green, blue, alpha]: readonly (number | undefined)[]): number[] {
  return [red!, green!, blue!, alpha ?? Math.max(red!, green!, blue!)];
}

/** The middle row of "width height components pixel pixel ...". */
function readPixels(fields: X3dFields): Row {
  const [width, height, components, ...pixels] = fields.text('image').split(/[\s,]+/).map(Number);
  const isSound = [width, height].every((size) => Number.isInteger(size) && size >= 1 && size <= 4096) && [1, 2, 3, 4].includes(components);
  const row = isSound ? pixels.slice(width * Math.floor(height / 2), width * (Math.floor(height / 2) + 1)) : [];
  if (!isSound || row.length !== width || !row.every((pixel) => Number.isInteger(pixel) && pixel >= 0 && pixel < 2 ** (8 * components))) {
    throw fields.error('image', '"width height components" and as many pixels, like "2 1 4 0x00000000 0xFFFFFFFF"');
  }
  return row.map((pixel) => {
    const bytes = Array.from({ length: components }, (_, i) => Math.floor(pixel / 256 ** (components - 1 - i)) % 256);
    return components < 3 ? withAlpha([bytes[0], bytes[0], bytes[0], bytes[1]]) : withAlpha(bytes);
  });
}

async function loadRow(fields: X3dFields): Promise<Row> {
  const url = urlOf(fields);
  try {
    const image = new Image();
    image.crossOrigin = 'anonymous';
    image.src = new URL(url, fields.element.ownerDocument.baseURI).href;
    await image.decode();
    const width = Math.min(mostStops, image.naturalWidth);
    const context = Object.assign(document.createElement('canvas'), { width, height: 1 }).getContext('2d')!;
    context.drawImage(image, 0, Math.floor(image.naturalHeight / 2), image.naturalWidth, 1, 0, 0, width, 1);
    const { data } = context.getImageData(0, 0, width, 1);
    const pixels = Array.from({ length: width }, (_, i) => [...data.subarray(4 * i, 4 * i + 4)]);
    const isOpaque = pixels.every(([, , , alpha]) => alpha === 255);
    return isOpaque ? pixels.map((pixel) => withAlpha(pixel.slice(0, 3))) : pixels;
  } catch {
    throw wrong(`"${url.slice(0, 80)}"`, 'an image that can be loaded, from this server or one that allows it (CORS)');
  }
}

import { VolumeViewError } from '../../core/errors.ts';
import { urlOf, X3dFields } from './x3d-fields.ts';

/** A row of colours: RGBA, 0 to 255. */
type Row = readonly (readonly number[])[];

/** Maximum number of stops that are made of a texture. */
const maxStops = 256;

/** X3D's default without a texture, from transparent black to white. */
const ramp: Row = Array.from({ length: maxStops }, (_, i) => [i, i, i, i]);

/**
 * Converts an opacity of X3DOM's texture to that of a reference length, a hundredth of the volume's longest edge:
 * X3DOM's share of a step is the texture's times `factor` / 85, and 85 steps are the square root of 2 edges long.
 */
const perReferenceLength = (opacity: number, factor: number): number =>
  -Math.expm1((-opacity * factor) / (100 * Math.SQRT2));

/**
 * The texture of X3D's OpacityMapVolumeStyle as a transfer function that spans the window. Without alpha, opacity is
 * the brightness.
 * @param texture - null for X3D's default
 * @param factor - X3DOM's field `opacityFactor`; null if it is not set: then opacities hold for a reference length
 * @throws {VolumeViewError} `attribute/invalid`
 */
export async function readOpacityMap(texture: Element | null, factor: number | null = null): Promise<string> {
  const row = texture ? await readRow(texture) : ramp;
  const picked =
    row.length > maxStops
      ? Array.from({ length: maxStops }, (_, i) => row[Math.round((i * (row.length - 1)) / (maxStops - 1))])
      : row;
  const last = picked.length - 1;
  const opacityOf = (alpha: number): number =>
    100 * (factor === null ? alpha / 255 : perReferenceLength(alpha / 255, factor));
  return picked
    .map(
      ([red, green, blue, alpha], i) =>
        `${last > 0 ? (100 * i) / last : 100}% rgb(${red} ${green} ${blue}) ${opacityOf(alpha)}%`,
    )
    .join(', ');
}

function readRow(texture: Element): Row | Promise<Row> {
  const name = texture.localName.toLowerCase();
  if (name !== 'pixeltexture' && name !== 'imagetexture' && name !== 'texture') {
    throw wrong(`<${texture.localName}>`, 'an ImageTexture or a PixelTexture');
  }
  if (name === 'pixeltexture') return readPixels(new X3dFields(texture, 'PixelTexture'));
  const canvas = texture.querySelector('canvas');
  return canvas ? readCanvas(canvas) : loadRow(new X3dFields(texture, 'ImageTexture'));
}

/** A canvas, X3DOM's way to paint a texture. */
function readCanvas(canvas: HTMLCanvasElement): Row {
  let row: Row = [];
  try {
    row = canvas.width > 0 && canvas.height > 0 ? rowOf(canvas, canvas) : [];
  } catch {
    throw wrong('a canvas that may not be read', 'one that no picture of another server is painted on');
  }
  if (!row.some(([, , , alpha]) => alpha > 0))
    throw wrong(
      'a canvas that is clear',
      'one that has been painted: paint it, then change an attribute of the texture, then it is read again',
    );
  return row;
}

function wrong(got: string, expected: string): VolumeViewError {
  return new VolumeViewError(
    'attribute/invalid',
    `the transferFunction of <OpacityMapVolumeStyle> got ${got}; expected ${expected}. Or write transfer-function="0% #000 0%, 100% #fff 80%" on the volume-view.`,
  );
}

/** A colour with alpha; if there is none, alpha is the brightness. */
function withAlpha([red, green, blue, alpha]: readonly (number | undefined)[]): number[] {
  return [red!, green!, blue!, alpha ?? Math.max(red!, green!, blue!)];
}

/** The middle row of "width height components pixel pixel ...". */
function readPixels(fields: X3dFields): Row {
  const [width, height, components, ...pixels] = fields
    .text('image')
    .split(/[\s,]+/)
    .map(Number);
  const isSound =
    [width, height].every((size) => Number.isInteger(size) && size >= 1 && size <= 4096) &&
    [1, 2, 3, 4].includes(components);
  const row = isSound ? pixels.slice(width * Math.floor(height / 2), width * (Math.floor(height / 2) + 1)) : [];
  if (
    !isSound ||
    row.length !== width ||
    !row.every((pixel) => Number.isInteger(pixel) && pixel >= 0 && pixel < 2 ** (8 * components))
  ) {
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
    return rowOf(image, { width: image.naturalWidth, height: image.naturalHeight });
  } catch {
    throw wrong(`"${url.slice(0, 80)}"`, 'an image that can be loaded, from this server or one that allows it (CORS)');
  }
}

/** The middle row. */
function rowOf(source: CanvasImageSource, { width, height }: { readonly width: number; readonly height: number }): Row {
  const count = Math.min(maxStops, width);
  const context = Object.assign(document.createElement('canvas'), { width: count, height: 1 }).getContext('2d')!;
  context.drawImage(source, 0, Math.floor(height / 2), width, 1, 0, 0, count, 1);
  const { data } = context.getImageData(0, 0, count, 1);
  const pixels = Array.from({ length: count }, (_, i) => [...data.subarray(4 * i, 4 * i + 4)]);
  const isOpaque = pixels.every(([, , , alpha]) => alpha === 255);
  return isOpaque ? pixels.map((pixel) => withAlpha(pixel.slice(0, 3))) : pixels;
}

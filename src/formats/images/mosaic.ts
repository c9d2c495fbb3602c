import { VolumeViewError } from '../../core/errors.ts';
import { axialIndexToWorld, cartesianGrid } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { checkMosaicLayout, cutMosaic, measureTile, mosaicDimensions } from '../../volume/mosaic.ts';
import type { GrayImage, MosaicLayout } from '../../volume/mosaic.ts';
import type { Samples } from '../../volume/samples.ts';
import { Budget } from '../base/budget.ts';
import { checkDimensions } from './check-dimensions.ts';
import type { DecodedCartesianVolume, DecodeSettings } from '../base/decoded-volume.ts';
import { respace } from '../base/respace.ts';

/** An image can't give its spacing, and a wrong spacing is hard to see in a picture that is squashed or upside down. */
const hint =
  '<volume-view>: a mosaic got no spacing, so its voxels are shown as cubes and its slices from feet to head. Write spacing="X Y Z", ' +
  'the size of a pixel and the distance of the slices; make Z negative if they run from head to feet.';

let warned = false;

function warnOnce(): void {
  if (!warned) console.warn(hint);
  warned = true;
}

/**
 * Makes a volume of a mosaic's image. Its values are the pixels' own, 0..255 or 0..65535, unless a manifest's slope and
 * intercept scale them.
 * @param format - the image's format, for the volume's `format`
 * @throws {VolumeViewError} `mosaic/layout`, `format/too-large`
 */
export function readMosaic(
  image: GrayImage,
  format: string,
  settings: DecodeSettings,
  budget = Budget.ofFile(image.data.byteLength),
): DecodedCartesianVolume {
  if (!settings.mosaic) {
    throw new VolumeViewError(
      'mosaic/layout',
      `the image of ${image.width} x ${image.height} pixels got no mosaic layout; expected mosaic="COLUMNSxROWS" ` +
        '(tiles per row and column), and slices="N" where not all tiles are used; or the attribute stack for an image that is one slice',
    );
  }
  const layout = checkMosaicLayout(image, settings.mosaic, settings.slices);
  const dimensions = mosaicDimensions(image, layout);
  const [tileWidth, tileHeight] = measureTile(image, layout);
  // `spacing` is per pixel; a tile of 409.6 pixels becomes 410 voxels that are a little smaller.
  const perVoxel = ([x, y, z]: Vector3): Vector3 => [
    (x * tileWidth) / dimensions[0],
    (y * tileHeight) / dimensions[1],
    z,
  ];
  if (!settings.indexToWorld && !settings.spacing) warnOnce();
  const placed = settings.indexToWorld ?? axialIndexToWorld(dimensions, perVoxel([1, 1, 1]));
  return {
    grid: cartesianGrid(
      dimensions,
      settings.spacing ? respace(placed, dimensions, perVoxel(settings.spacing)) : placed,
    ),
    // The tiles of one column have the order of a volume's slices: no copy is needed.
    samples: isOneColumn(image, layout) ? image.data : cutTiles(image, layout, budget),
    slope: 1,
    intercept: 0,
    unit: '',
    format: `${format} mosaic`,
    ...(image.left ? { left: image.left } : {}),
  };
}

/** Steps for each row of voxels, in addition to those of its voxels. */
const stepsPerRow = 16;

function cutTiles(image: GrayImage, layout: MosaicLayout, budget: Budget): Samples {
  const what = 'the mosaic';
  const [nx, ny, nz] = mosaicDimensions(image, layout);
  checkDimensions(what, [nx, ny, nz]);
  budget.step(ny * nz * stepsPerRow, what);
  budget.take(nx * ny * nz * image.data.BYTES_PER_ELEMENT, what);
  const samples = cutMosaic(image, layout);
  budget.giveBack(image.data.byteLength);
  return samples;
}

/** Whether the image is one column of whole tiles that are all in use. */
function isOneColumn({ height }: GrayImage, { columns, rows, slices }: MosaicLayout): boolean {
  return columns === 1 && slices === rows && height % rows === 0;
}

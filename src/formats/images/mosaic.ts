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

/** What an image cannot say, and a picture that is squashed or upside down does not tell. */
const hint = '<volume-view>: a mosaic got no spacing, so its voxels are shown as cubes and its slices from feet to head. Write spacing="X Y Z", ' +
  'the size of a pixel and the distance of the slices; make Z negative if they run from head to feet.';

let warned = false;

function warnOnce(): void {
  if (!warned) console.warn(hint);
  warned = true;
}

/**
 * Make a volume of a mosaic's image. Its values are the pixels' own, 0..255 or 0..65535, until a manifest's slope and
 * intercept say otherwise.
 * @param format - what the image was, for the volume's `format`
 * @throws {VolumeViewError} `mosaic/layout`, `format/too-large`
 */
export function readMosaic(image: GrayImage, format: string, settings: DecodeSettings, budget = Budget.ofFile(image.data.byteLength)): DecodedCartesianVolume {
  if (!settings.mosaic) {
    throw new VolumeViewError(
      'mosaic/layout',
      `the image of ${image.width} x ${image.height} pixels got no mosaic layout; expected mosaic="COLUMNSxROWS" ` +
        '(tiles per row and column), and slices="N" where not all tiles are used',
    );
  }
  const layout = checkMosaicLayout(image, settings.mosaic, settings.slices);
  const dimensions = mosaicDimensions(image, layout);
  const [tileWidth, tileHeight] = measureTile(image, layout);
  // `spacing` speaks of pixels; a tile of 409.6 pixels becomes 410 voxels that are a little smaller.
  const perVoxel = ([x, y, z]: Vector3): Vector3 => [(x * tileWidth) / dimensions[0], (y * tileHeight) / dimensions[1], z];
  if (!settings.indexToWorld && !settings.spacing) warnOnce();
  const placed = settings.indexToWorld ?? axialIndexToWorld(dimensions, perVoxel([1, 1, 1]));
  return {
    grid: cartesianGrid(dimensions, settings.spacing ? respace(placed, dimensions, perVoxel(settings.spacing)) : placed),
    // The tiles of one column lie below one another as a volume's slices do: there is no second copy.
    samples: isOneColumn(image, layout) ? image.data : cutTiles(image, layout, budget),
    slope: 1,
    intercept: 0,
    unit: '',
    format: `${format} mosaic`,
    ...(image.left ? { left: image.left } : {}),
  };
}

/** Steps that a row of voxels takes before its first one. */
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

/** Whether whole tiles, all of them in use, make up one column. */
function isOneColumn({ height }: GrayImage, { columns, rows, slices }: MosaicLayout): boolean {
  return columns === 1 && slices === rows && height % rows === 0;
}

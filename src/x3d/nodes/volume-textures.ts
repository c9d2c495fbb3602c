// Textures of X3D's volume nodes that are files of voxels.
import type { LoadRequest } from '../../formats/base/load-request.ts';
import { parseMosaicSize } from '../../volume/mosaic-size.ts';
import { containerFieldOf, urlOf, X3dFields } from './x3d-fields.ts';

/** Which file, and how slices lie in it. */
export type VoxelTexture = Pick<LoadRequest, 'url' | 'mosaic' | 'slices' | 'spacing'>;

/** A volume in the place of the first one. */
export interface SecondVolume {
  readonly voxels: VoxelTexture;
  /** Its colours and opacities. */
  readonly texture: Element | null;
  /** How much of it there is for each share of the first volume. */
  readonly ratio: number;
  /** See `readOpacityMap`. */
  readonly opacityFactor: number | null;
}

/** An ImageTextureAtlas, or an ImageTexture3D, whose file says how large it is. @throws {VolumeViewError} `attribute/invalid` */
export function readVoxelTexture(texture: Element): VoxelTexture {
  const fields = new X3dFields(texture, `<${texture.localName}>`);
  const url = urlOf(fields);
  if (url === '') throw fields.error('url', 'the image or the file with the voxels');
  if (!/atlas$/i.test(texture.localName)) return { url };
  const mosaic = parseMosaicSize(`${fields.text('slicesOverX')}x${fields.text('slicesOverY')}`);
  if (!mosaic) throw fields.error('slicesOverX', 'slicesOverX and slicesOverY, whole numbers: slices beside and above one another');
  // Its place is the volume's, so an image that says no spacing is nothing to be warned of.
  return { url, mosaic, spacing: [1, 1, 1], ...(fields.text('numberOfSlices') !== '' && { slices: fields.whole('numberOfSlices', 1, [1, 1e6]) }) };
}

/** The texture of some that is a field of the node around it. */
export function textureOfField(textures: Iterable<Element>, field: string): Element | undefined {
  return [...textures].find((one) => /texture/i.test(one.localName) && containerFieldOf(one) === field);
}

// Textures of X3D's volume nodes whose files hold voxels.
import type { LoadRequest } from '../../formats/base/load-request.ts';
import { parseMosaicSize } from '../../volume/mosaic-size.ts';
import { containerFieldOf, urlOf, X3dFields } from './x3d-fields.ts';

/** The file, and the layout of its slices. */
export type VoxelTexture = Pick<LoadRequest, 'url' | 'settings'>;

/** A second volume, in the same place as the first one. */
export interface SecondVolume {
  readonly voxels: VoxelTexture;
  /** Its colours and opacities. */
  readonly texture: Element | null;
  /** Its weight for each unit of weight of the first volume. */
  readonly ratio: number;
  /** See `readOpacityMap`. */
  readonly opacityFactor: number | null;
}

/** An ImageTextureAtlas, or an ImageTexture3D, whose file gives its size. @throws {VolumeViewError} `attribute/invalid` */
export function readVoxelTexture(texture: Element): VoxelTexture {
  const fields = new X3dFields(texture, `<${texture.localName}>`);
  const url = urlOf(fields);
  if (url === '') throw fields.error('url', 'the image or the file with the voxels');
  if (!/atlas$/i.test(texture.localName)) return { url };
  const mosaic = parseMosaicSize(`${fields.text('slicesOverX')}x${fields.text('slicesOverY')}`);
  if (!mosaic)
    throw fields.error(
      'slicesOverX',
      'slicesOverX and slicesOverY, whole numbers: slices next to and above one another',
    );
  // It has the volume's place, so an image without spacing needs no warning.
  return {
    url,
    settings: {
      mosaic,
      spacing: [1, 1, 1],
      ...(fields.text('numberOfSlices') !== '' && { slices: fields.whole('numberOfSlices', 1, [1, 1e6]) }),
    },
  };
}

/** The texture among several that is a given field of the node around it. */
export function textureOfField(textures: Iterable<Element>, field: string): Element | undefined {
  return [...textures].find((one) => /texture/i.test(one.localName) && containerFieldOf(one) === field);
}

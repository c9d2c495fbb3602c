// X3D's SegmentedVolumeData: its segments become the volume's labels.
import { VolumeViewError } from '../../core/errors.ts';
import { readVoxelTexture, textureOfField } from './volume-textures.ts';
import type { VoxelTexture } from './volume-textures.ts';
import { X3dFields } from './x3d-fields.ts';

/** The texture that gives the segment of each voxel. */
export interface Identifiers extends VoxelTexture {
  /** X3DOM spreads its segment numbers over 0 to 1; null if a pixel's number is the number of its segment. */
  readonly max: number | null;
}

/** One segment, by its style: the n-th style belongs to segment n. */
export interface Segment {
  /** The element's name, for messages. */
  readonly node: string;
  /** What it draws, apart from colours and opacities of values; '' if there is nothing else. */
  readonly key: string;
  /** Its own colours and opacities of values. */
  readonly texture: Element | null;
}

/** @throws {VolumeViewError} `attribute/invalid` */
export function readIdentifiers(node: Element): Identifiers {
  const texture = textureOfField(node.getElementsByTagName('*'), 'segmentidentifiers');
  if (!texture) {
    throw new VolumeViewError(
      'attribute/invalid',
      '<SegmentedVolumeData> got no segment identifiers; expected an <ImageTextureAtlas containerField="segmentIdentifiers" url="…"> in it, with the number of a segment in each voxel.',
    );
  }
  const fields = new X3dFields(node, 'SegmentedVolumeData');
  const max = fields.text('numberOfMaxSegments') === '' ? null : fields.whole('numberOfMaxSegments', 10, [1, 255]);
  return { ...readVoxelTexture(texture), max };
}

/** Which segments are drawn, by number; all further ones are drawn. @throws {VolumeViewError} `attribute/invalid` */
export function readEnabled(node: Element): boolean[] {
  const fields = new X3dFields(node, 'SegmentedVolumeData');
  return fields
    .text('segmentEnabled')
    .toLowerCase()
    .split(/[\s,]+/)
    .filter(Boolean)
    .map((word) => {
      if (word !== 'true' && word !== 'false')
        throw fields.error('segmentEnabled', '"true" or "false" for each segment, like "false true true"');
      return word === 'true';
    });
}

/** Whether a segment is drawn: true if the field has no entry for it. */
export function isDrawn(enabled: readonly boolean[], id: number): boolean {
  return !(id in enabled) || enabled[id];
}

/**
 * The segment whose style is used for all, because a volume has one style: the first one that is drawn and has a style;
 * -1 if there is none.
 */
export function leadOf(segments: readonly Segment[], enabled: readonly boolean[]): number {
  return segments.findIndex(({ key }, id) => key !== '' && isDrawn(enabled, id));
}

/** Says in words which styles can't be drawn as they are set; null if all can. @param ids - of the segments in the data */
export function reportStyles(
  segments: readonly Segment[],
  enabled: readonly boolean[],
  ids: readonly number[],
): VolumeViewError | null {
  const lead = leadOf(segments, enabled);
  const other =
    lead < 0 ? undefined : ids.find((id) => isDrawn(enabled, id) && (segments[id]?.key ?? '') !== segments[lead].key);
  if (other === undefined) return null;
  const got = segments[other] ? `<${segments[other].node}>` : 'no style';
  return new VolumeViewError(
    'attribute/invalid',
    `<SegmentedVolumeData> got ${got} for segment ${other} and <${segments[lead].node}> for segment ${lead}; expected one style for all segments that are drawn. All of them have that of segment ${lead} now. Segments may differ in segmentEnabled, and in the textures of OpacityMapVolumeStyles.`,
  );
}

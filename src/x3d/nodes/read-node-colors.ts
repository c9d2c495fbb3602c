// Colours and opacities that X3D's volume nodes give a volume.
import { resolveTransferFunction } from '../../optics/transfer/resolve-transfer-function.ts';
import { meantChildren } from '../../page/unclosed.ts';
import { readOpacityMap } from './read-opacity-map.ts';
import { defaultReferenceLength, longestEdgeShare } from '../../volume/reference-length.ts';
import type { Grid } from '../../volume/volume.ts';
import type { VolumeOptics } from '../../viewer/model/volume-info.ts';
import { textureOfField } from './volume-textures.ts';
import { X3dFields } from './x3d-fields.ts';

/** The byte of an atlas that is 1 in X3D. */
export const atlasUnit = 255;

/** X3DOM's default factor for opacities, in an OpacityMapVolumeStyle without one, and in scenes without such a style. */
const [ofMaps, ofOthers] = [6, 10];

/**
 * A projection shows the value itself: all components of a colour are equal, and without alpha in the data alpha is 1.
 * Colours whose opacity is their brightness would be darkened twice. Source: ISO/IEC 19775-1, 41.4,
 * ProjectionVolumeStyle
 */
const intensities = '0% black 100%, 100% white 100%';

const nameOf = (node: Node): string => node.nodeName.toLowerCase();
export const isStyle = (node: Node): boolean => /volumestyle$/i.test(node.nodeName);
export const isEnabled = (style: Element): boolean =>
  new X3dFields(style, `<${style.localName}>`).flag('enabled', true);

/** The voxels of a second volume. */
export function voxelsOf(blend: Element): Element | undefined {
  const children = meantChildren(blend);
  return (
    textureOfField(children, 'voxels') ?? children.find(({ localName }) => /^imagetexture(atlas|3d)$/i.test(localName))
  );
}

/**
 * The factor for opacities in X3DOM's measure; null if the opacities hold for a reference length: if the volume is not
 * a scene's atlas, and X3DOM's field is not set.
 */
export function readOpacityFactor(host: Element, isScene: boolean): number | null {
  const styles = stylesOfFirst(host);
  const map = styles.find((one) => nameOf(one) === 'opacitymapvolumestyle' && isEnabled(one));
  const fields = map && new X3dFields(map, 'OpacityMapVolumeStyle');
  if (fields && fields.text('opacityFactor') !== '') return fields.number('opacityFactor', ofMaps);
  return !isScene ? null : map || !styles.some(isStyle) ? ofMaps : ofOthers;
}

/**
 * An appearance with the colours of an OpacityMapVolumeStyle's texture, or with X3D's own if the volume is a scene's
 * atlas. Colours of attributes override them.
 * @throws {VolumeViewError} `attribute/invalid`
 */
export async function withNodeColors(
  host: Element,
  appearance: VolumeOptics,
  { isScene, grid }: { readonly isScene: boolean; readonly grid: Grid },
): Promise<VolumeOptics> {
  if (host.hasAttribute('transfer-function') || appearance.patches) return appearance;
  const isSegmented = host.querySelector('segmentedvolumedata') !== null;
  const texture = (!isSegmented && textureIn(stylesOfFirst(host))) || null;
  const factor = readOpacityFactor(host, isScene);
  if (!texture && factor === null) return appearance;
  const isProjected =
    appearance.projection !== null ||
    stylesOfFirst(host).some((one) => nameOf(one) === 'projectionvolumestyle' && isEnabled(one));
  const window = isScene && !host.hasAttribute('value-window') ? ([0, atlasUnit] as const) : appearance.window;
  // X3DOM has no rule for thin volumes.
  const isMeasured =
    factor !== null &&
    appearance.referenceLength === defaultReferenceLength(grid) &&
    !host.hasAttribute('reference-length');
  return {
    ...appearance,
    window,
    ...(isMeasured && { referenceLength: longestEdgeShare(grid) }),
    transferFunction: await resolveTransferFunction(
      !texture && isProjected ? intensities : await readOpacityMap(texture, factor),
      window,
    ),
  };
}

/** All styles except those of a second volume. */
function stylesOfFirst(host: Element): Element[] {
  const all = [...host.querySelectorAll('*')];
  const blend = all.find((one) => nameOf(one) === 'blendedvolumestyle' && voxelsOf(one));
  return blend ? all.filter((one) => one === blend || !blend.contains(one)) : all;
}

/** The texture of the first style that has one, directly or composed in it. */
export function textureIn(styles: readonly Element[]): Element | undefined {
  const [first, ...rest] = styles.filter((one) => isStyle(one) && isEnabled(one));
  if (!first) return undefined;
  const children = meantChildren(first);
  const own =
    nameOf(first) === 'opacitymapvolumestyle'
      ? children.find(({ localName }) => /texture/i.test(localName))
      : nameOf(first) === 'composedvolumestyle'
        ? textureIn(children)
        : undefined;
  return own ?? textureIn(rest);
}

// Reads X3D's volume nodes among the children of an element: loaded with the first of them.
import { isWrapper } from '../../page/page-children.ts';
import { VolumeViewError } from '../../core/errors.ts';
import { loadPart } from '../../core/load-part.ts';
import type { ProjectionKind } from '../../optics/rays/ray-style.ts';
import type { StyleChain, VolumeStyle } from '../../optics/transfer/volume-styles.ts';
import { readIsoSurfaces } from '../../x3d/nodes/read-iso-surfaces.ts';
import {
  atlasUnit,
  isEnabled,
  isStyle,
  readOpacityFactor,
  textureIn,
  voxelsOf,
  withNodeColors,
} from '../../x3d/nodes/read-node-colors.ts';
import type { BlendController } from './blend-controller.ts';
import { leadOf, readEnabled, readIdentifiers } from '../../x3d/nodes/read-segments.ts';
import type { ScanModel } from '../model/scan-model.ts';
import type { Segment } from '../../x3d/nodes/read-segments.ts';
import type { SegmentController, Segments } from './segment-controller.ts';
import { readVolumeStyle } from '../../x3d/nodes/read-volume-style.ts';
import type { VolumeOptics } from '../model/volume-info.ts';
import { socketOf, standIn } from '../model/view-socket.ts';
import { readVoxelTexture } from '../../x3d/nodes/volume-textures.ts';
import type { SecondVolume } from '../../x3d/nodes/volume-textures.ts';
import { meantChildren } from '../../page/unclosed.ts';
import { containerFieldOf, X3dFields } from '../../x3d/nodes/x3d-fields.ts';

const nameOf = (node: Node): string => node.nodeName.toLowerCase();
/** Whether an X3D node may be around a volume's styles. */
const isAround = (node: Element): boolean =>
  isWrapper(node) ||
  /^(x3d|scene|group|transform|volumedata|isosurfacevolumedata|segmentedvolumedata)$/i.test(node.nodeName);

/** What nodes say about an appearance. */
interface Said {
  chains: StyleChain[];
  projection: ProjectionKind | null;
  /** X3D's intensity threshold: a share of the values of an atlas. 0 where there is none. */
  threshold: number;
  /** A second volume, and the weight of the first. */
  second?: Omit<SecondVolume, 'opacityFactor'> & { readonly weight: number };
}

const nothingSaid = (): Said => ({ chains: [{ weight: 1, styles: [] }], projection: null, threshold: 0 });

/** The controllers of segments, and of second volumes, for each view that has or had one. */
const segmentControllers = new WeakMap<Element, SegmentController>();
const blendControllers = new WeakMap<Element, BlendController>();

/** The last reading of nodes for each view: parts and textures of an earlier reading may come later. */
const readings = new WeakMap<Element, object>();

export { follow } from '../../x3d/nodes/read-atlas.ts';

/**
 * An appearance, completed by X3D's volume nodes among an element's children: attributes of the element have priority.
 * @throws {VolumeViewError} `attribute/invalid`
 */
export async function withVolumeNodes(
  presenter: { readonly user: { readonly host: Element } },
  appearance: VolumeOptics,
  { grid }: Pick<ScanModel, 'grid'>,
): Promise<VolumeOptics> {
  const { host } = presenter.user;
  const reading = {};
  readings.set(host, reading);
  const isLast = (): boolean => readings.get(host) === reading;
  const { second, ...styled } = readAll(
    host,
    await withNodeColors(host, appearance, { isScene: isOfAtlas(host), grid }),
  );
  if (!isLast()) return styled; // A later reading has already read the present nodes.
  const segmented = findNode(host, 'segmentedvolumedata');
  const segments = segmented ? readSegmented(host, segmented) : null;
  if (segments) await showSegments(host, segments, isLast);
  else segmentControllers.get(host)?.hide();
  if (!isLast()) return styled;
  if (second) await showSecond(host, { ...second, opacityFactor: readOpacityFactor(host, isOfAtlas(host)) }, isLast);
  else blendControllers.get(host)?.hide();
  return styled;
}

/** Whether the volume is an X3D scene's atlas. */
function isOfAtlas(host: Element): boolean {
  return Boolean(standIn(host, 'src'));
}

/** The second volume is a layer, which has its own controller. */
async function showSecond(host: Element, second: SecondVolume, isLast: () => boolean): Promise<void> {
  if (!blendControllers.has(host)) {
    const { BlendController } = await loadPart(import('./blend-controller.ts'), 'blends two volumes');
    if (!blendControllers.has(host)) blendControllers.set(host, new BlendController(socketOf(host)));
  }
  if (isLast()) await blendControllers.get(host)!.show(second);
}

function findNode(host: Element, name: string): Element | undefined {
  return [...host.querySelectorAll('*')].find((one) => nameOf(one) === name);
}

/** Segments are labels of the volume, which have their own controller. */
async function showSegments(host: Element, segments: Segments, isLast: () => boolean): Promise<void> {
  if (!segmentControllers.has(host)) {
    const { SegmentController } = await loadPart(import('./segment-controller.ts'), 'shows segments');
    if (!segmentControllers.has(host)) segmentControllers.set(host, new SegmentController(socketOf(host)));
  }
  if (isLast()) await segmentControllers.get(host)!.show(segments, isLast);
}

function readSegmented(host: Element, node: Element): Segments {
  const isShare = isOfAtlas(host) && !host.hasAttribute('value-window');
  return {
    identifiers: readIdentifiers(node),
    enabled: readEnabled(node),
    all: readSegments(host),
    window: isShare ? [0, atlasUnit] : null,
    opacityFactor: readOpacityFactor(host, isOfAtlas(host)),
  };
}

/** What each style says about its segment, in order. */
function readSegments(host: Element): Segment[] {
  return listStyles(meantChildren(host), host).map((style) => {
    const said = nothingSaid();
    readStyle(style, said);
    if (said.second)
      throw forbidden(
        '<BlendedVolumeStyle> got voxels in a <SegmentedVolumeData>; expected none, as segments have one volume. Write <VolumeData> instead.',
      );
    return {
      node: style.localName,
      key: isPlain(said) ? '' : JSON.stringify(said),
      texture: textureIn([style]) ?? null,
    };
  });
}

function isPlain({ chains, projection }: Said): boolean {
  return !projection && chains.length === 1 && chains[0].styles.length === 0;
}

/** The same without textures. @throws {VolumeViewError} `attribute/invalid` */
export function readVolumeNodes(host: Element, appearance: VolumeOptics): VolumeOptics {
  const { second: _, ...styled } = readAll(host, appearance);
  return styled;
}

function readAll(host: Element, appearance: VolumeOptics): VolumeOptics & Pick<Said, 'second'> {
  refuseOthers(host);
  const said = nothingSaid();
  const styles = listStyles(meantChildren(host), host);
  const surfaces = findNode(host, 'isosurfacevolumedata');
  const unit = isOfAtlas(host) ? atlasUnit : 1;
  if (surfaces) {
    const enabled = styles.filter(isEnabled);
    const surfaceStyles = readSurfaceStyles(enabled);
    return {
      ...appearance,
      surfaces: appearance.surfaces ?? {
        ...readIsoSurfaces(surfaces, surfaceStyles ? [] : enabled, appearance, unit),
        ...(surfaceStyles && { surfaceStyles }),
      },
    };
  }
  for (const style of findNode(host, 'segmentedvolumedata') ? leadStyle(host, styles) : styles) readStyle(style, said);
  const { second } = said;
  if (said.projection && (second || said.chains.some((chain) => chain.styles.length > 0))) {
    throw forbidden(
      '<ProjectionVolumeStyle> got other styles; expected it alone, as X3D composes no projections. Set enabled="false" on one of them.',
    );
  }
  const hasStyles = said.chains.length > 1 || said.chains[0].styles.length > 0;
  // The styles from attributes.
  const given = appearance.styles?.[0].styles ?? [];
  return {
    ...appearance,
    projection: appearance.projection ?? said.projection,
    ...(said.projection && said.threshold > 0 && { intensityThreshold: said.threshold * unit }),
    ...(second && { second, opacityFactor: appearance.opacityFactor * second.weight }),
    ...(hasStyles && { styles: said.chains.map(({ weight, styles }) => ({ weight, styles: [...styles, ...given] })) }),
  };
}

/** The styles for all surfaces together; null where each has a shaded style of its own, or none. */
function readSurfaceStyles(enabled: readonly Element[]): readonly VolumeStyle[] | null {
  const other = enabled.find((one) => !/^(shaded|opacitymap)volumestyle$/.test(nameOf(one)));
  if (!other) return null;
  if (enabled.length > 1)
    throw forbidden(
      `<IsoSurfaceVolumeData> got <${other.localName}> and other styles; expected one style for all surfaces, which may be a ComposedVolumeStyle, or a ShadedVolumeStyle for each.`,
    );
  const said = nothingSaid();
  readStyle(other, said);
  if (said.projection || said.second || said.chains.length > 1)
    throw forbidden(
      `<IsoSurfaceVolumeData> got a projection or a blend; expected other styles: surfaces are neither projected nor blended.`,
    );
  return said.chains[0].styles;
}

function refuseOthers(host: Element): void {
  const nodes = [...host.querySelectorAll('*')].filter(({ localName }) => /volumedata$/i.test(localName));
  if (nodes.length > 1)
    throw forbidden(
      `volume-view got ${nodes.length} volume nodes, <${nodes[0].localName}> and <${nodes[1].localName}>; expected one. Write a volume-view for each.`,
    );
}

/** The style that applies to all segments. */
function leadStyle(host: Element, styles: readonly Element[]): Element[] {
  const lead = leadOf(readSegments(host), readEnabled(findNode(host, 'segmentedvolumedata')!));
  return lead < 0 ? [] : [styles[lead]];
}

/** The styles among elements, in order. If a style has no end tag, HTML puts the next styles into it: these are read as its siblings. */
function listStyles(elements: Iterable<Element>, host: Element): Element[] {
  return [...elements].flatMap((one) => {
    if (isAround(one)) return listStyles(meantChildren(one), host);
    if (!isStyle(one)) return [];
    const use = one.getAttribute('USE') ?? one.getAttribute('use');
    const used =
      use === null
        ? null
        : [...host.querySelectorAll('*')].find(
            (other) => isStyle(other) && [other.getAttribute('DEF'), other.getAttribute('def'), other.id].includes(use),
          );
    if (use !== null && !used)
      throw forbidden(
        `<${one.localName}> got USE="${use.slice(0, 40)}"; expected the DEF of a style in this volume-view.`,
      );
    return [used ?? one, ...(holdsStyles(one) ? [] : listStyles(meantChildren(one), host))];
  });
}

/** Whether the styles inside an element belong to it. */
function holdsStyles(style: Element): boolean {
  return /^(composed|blended)volumestyle$/i.test(style.localName);
}

/** @param around - the styles that contain this one: if USE names one of them, reading would never end */
function readStyle(element: Element, said: Said, around: readonly Element[] = []): void {
  const fields = new X3dFields(element, `<${element.localName}>`);
  if (!fields.flag('enabled', true)) return;
  const name = nameOf(element);
  if (name === 'opacitymapvolumestyle') return; // It sets the transfer function, which is read elsewhere.
  if (name === 'composedvolumestyle') return readHeld(element, said, around);
  if (name === 'projectionvolumestyle') {
    if (around.length > 0)
      throw forbidden(
        `<${element.localName}> stands in another style; expected it alone, as X3D composes no projections.`,
      );
    said.projection = fields.word('type', 'MAX', ['MAX', 'MIN', 'AVERAGE']).toLowerCase() as ProjectionKind;
    said.threshold = said.projection === 'average' ? 0 : fields.number('intensityThreshold', 0);
    return;
  }
  if (said.chains.length > 1 || said.second)
    throw forbidden(
      `<${element.localName}> got a BlendedVolumeStyle before it; expected that to be the last one. Change their order.`,
    );
  if (name === 'blendedvolumestyle') return readBlended(fields, said, around);
  const style = readVolumeStyle(element);
  if (style === undefined)
    throw forbidden(
      `<${element.localName}> is no rendering style of X3D's; expected one that docs/guide/x3d-styles.md lists.`,
    );
  if (style) said.chains = [{ weight: 1, styles: checkLight([...said.chains[0].styles, style]) }];
}

/** Read the styles inside another one, one after the other. */
function readHeld(element: Element, said: Said, around: readonly Element[]): void {
  if (around.includes(element))
    throw forbidden(
      `<${element.localName}> got a USE of itself within it; expected the DEF of another style. Leave it out.`,
    );
  for (const one of listStyles(meantChildren(element), element.closest('volume-view') ?? element))
    readStyle(one, said, [...around, element]);
}

function checkLight(styles: readonly VolumeStyle[]): readonly VolumeStyle[] {
  if (styles.filter(({ kind }) => kind === 'shaded').length > 1)
    throw forbidden(
      'volume-view got more than one ShadedVolumeStyle; expected one. Set enabled="false" on the others.',
    );
  return styles;
}

/**
 * Blend the volume in the earlier styles with the same volume in other styles: two chains that are added by their weights. Or
 * blend it with another volume.
 */
function readBlended(fields: X3dFields, said: Said, around: readonly Element[]): void {
  const { element } = fields;
  if (around.some((one) => nameOf(one) === 'blendedvolumestyle'))
    throw forbidden(`<${element.localName}> stands in another style; expected it outside of that.`);
  const children = meantChildren(element);
  if (children.some((one) => containerFieldOf(one).startsWith('weighttransferfunction'))) {
    throw forbidden(
      '<BlendedVolumeStyle> got a weightTransferFunction; expected none: weights are the numbers weightConstant1 and weightConstant2. Leave it out.',
    );
  }
  for (const field of ['weightFunction1', 'weightFunction2']) fields.word(field, 'CONSTANT', ['CONSTANT']);
  const before = said.chains[0].styles;
  const [first, other] = ['weightConstant1', 'weightConstant2'].map((field) => fields.number(field, 0.5, [0, 1]));
  const held = nothingSaid();
  readHeld(element, held, around);
  const [{ styles }] = held.chains;
  const voxels = voxelsOf(element);
  if (!voxels) {
    checkLight([...before, ...styles]);
    said.chains = [
      { weight: first, styles: before },
      { weight: other, styles },
    ];
    return;
  }
  if (styles.length > 0)
    throw forbidden(
      '<BlendedVolumeStyle> got another style for its voxels; expected an OpacityMapVolumeStyle: a second volume is drawn by the colours and opacities of its values.',
    );
  if (first === 0)
    throw fields.error(
      'weightConstant1',
      'a number above 0, up to 1. To show the second volume alone, write it in place of the first',
    );
  said.second = {
    voxels: readVoxelTexture(voxels),
    texture: textureIn(children) ?? null,
    ratio: other / first,
    weight: first,
  };
}

function forbidden(message: string): VolumeViewError {
  return new VolumeViewError('attribute/invalid', message);
}

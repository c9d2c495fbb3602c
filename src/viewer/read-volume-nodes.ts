// X3D's volume nodes among the children of an element: loaded with the first of them.
import { VolumeViewError } from '../errors.ts';
import { loadPart } from '../load-part.ts';
import type { ProjectionKind } from '../optics/ray-style.ts';
import type { StyleChain, VolumeStyle } from '../optics/volume-styles.ts';
import { resolveTransferFunction } from '../optics/resolve-transfer-function.ts';
import { readIsoSurfaces } from './read-iso-surfaces.ts';
import { readOpacityMap } from './read-opacity-map.ts';
import { leadOf, readEnabled, readIdentifiers } from './read-segments.ts';
import type { Segment } from './read-segments.ts';
import type { SegmentKeeper } from './segment-keeper.ts';
import { readVolumeStyle } from './read-volume-style.ts';
import type { VolumeOptics } from './volume-info.ts';
import type { VolumePresenter } from './volume-presenter.ts';
import { X3dFields } from './x3d-fields.ts';

const nameOf = (node: Node): string => node.nodeName.toLowerCase();
const isStyle = (node: Node): boolean => /volumestyle$/i.test(node.nodeName);
/** What of X3D may stand around a volume's styles. */
const isAround = (node: Node): boolean => /^(x3d|scene|group|transform|volumedata|isosurfacevolumedata|segmentedvolumedata)$/i.test(node.nodeName);

/** An element whose volume may be an X3D scene's atlas. */
type Atlased = Element & { readonly _atlas?: (property: string) => unknown };

/** A byte of an atlas that X3D calls 1. */
const atlasUnit = 255;

/** What nodes say of a look. */
interface Said {
  chains: StyleChain[];
  projection: ProjectionKind | null;
}

/** Of each view that has or had segments, who keeps them. */
const keepers = new WeakMap<Element, SegmentKeeper>();

export { follow } from './read-atlas.ts';

/**
 * A look with what X3D's volume nodes among an element's children say: attributes of the element go before these.
 * @throws {VolumeViewError} `attribute/invalid`
 */
export async function withVolumeNodes(presenter: { readonly user: { readonly host: Element } }, look: VolumeOptics): Promise<VolumeOptics> {
  const { host } = presenter.user;
  const styled = readVolumeNodes(host, look);
  const segmented = findNode(host, 'segmentedvolumedata');
  if (segmented) await showSegments(presenter as VolumePresenter, segmented);
  else keepers.get(host)?.hide();
  if (segmented) return styled;
  const texture = host.hasAttribute('transfer-function') || look.patches ? null : textureOf(host);
  return texture ? { ...styled, transferFunction: await resolveTransferFunction(await readOpacityMap(texture), look.window) } : styled;
}

function findNode(host: Element, name: string): Element | undefined {
  return [...host.querySelectorAll('*')].find((one) => nameOf(one) === name);
}

/** Segments are labels of the volume, which something else keeps. */
async function showSegments(presenter: VolumePresenter, node: Element): Promise<void> {
  const { host } = presenter.user;
  const segments = { identifiers: readIdentifiers(node), enabled: readEnabled(node), all: readSegments(host) };
  if (!keepers.has(host)) {
    const { SegmentKeeper } = await loadPart(import('./segment-keeper.ts'), 'shows segments');
    if (!keepers.has(host)) keepers.set(host, new SegmentKeeper(presenter));
  }
  await keepers.get(host)!.show(segments);
}

/** What each style says of its segment, in order. */
function readSegments(host: Element): Segment[] {
  return listStyles(host.children, host).map((style) => {
    const said: Said = { chains: [{ weight: 1, styles: [] }], projection: null };
    readStyle(style, said);
    return { node: style.localName, key: isPlain(said) ? '' : JSON.stringify(said), texture: textureIn([style]) ?? null };
  });
}

function isPlain({ chains, projection }: Said): boolean {
  return !projection && chains.length === 1 && chains[0].styles.length === 0;
}

/** The transfer function of an OpacityMapVolumeStyle. */
function textureOf(host: Element): Element | undefined {
  return textureIn([...host.querySelectorAll('*')]);
}

/** The texture of the first of some styles that has one, or of what is composed in it. */
function textureIn(styles: readonly Element[]): Element | undefined {
  const [first, ...rest] = styles.filter((one) => isStyle(one) && new X3dFields(one, one.localName).flag('enabled', true));
  if (!first) return undefined;
  const children = [...first.children];
  const own = nameOf(first) === 'opacitymapvolumestyle' ? children.find(({ localName }) => /texture/i.test(localName)) : nameOf(first) === 'composedvolumestyle' ? textureIn(children) : undefined;
  return own ?? textureIn(rest);
}

/** The same but for textures. @throws {VolumeViewError} `attribute/invalid` */
export function readVolumeNodes(host: Element, look: VolumeOptics): VolumeOptics {
  refuseOthers(host);
  const said: Said = { chains: [{ weight: 1, styles: [] }], projection: null };
  const styles = listStyles(host.children, host);
  const surfaces = findNode(host, 'isosurfacevolumedata');
  if (surfaces) {
    const enabled = styles.filter((style) => new X3dFields(style, `<${style.localName}>`).flag('enabled', true));
    return { ...look, surfaces: look.surfaces ?? readIsoSurfaces(surfaces, enabled, look, (host as Atlased)._atlas?.('src') ? atlasUnit : 1) };
  }
  for (const style of findNode(host, 'segmentedvolumedata') ? leadStyle(host, styles) : styles) readStyle(style, said);
  if (said.projection && said.chains.some((chain) => chain.styles.length > 0)) {
    throw forbidden('<ProjectionVolumeStyle> got other styles beside it; expected it alone, as X3D composes no projections. Set enabled="false" on one of them.');
  }
  const hasStyles = said.chains.length > 1 || said.chains[0].styles.length > 0;
  // Those of attributes.
  const given = look.styles?.[0].styles ?? [];
  return { ...look, projection: look.projection ?? said.projection, ...(hasStyles && { styles: said.chains.map(({ weight, styles }) => ({ weight, styles: [...styles, ...given] })) }) };
}

function refuseOthers(host: Element): void {
  const nodes = [...host.querySelectorAll('*')].filter(({ localName }) => /volumedata$/i.test(localName));
  if (nodes.length > 1) throw forbidden(`volume-view got ${nodes.length} volume nodes, <${nodes[0].localName}> and <${nodes[1].localName}>; expected one. Write a volume-view for each.`);
}

/** The style that all segments have. */
function leadStyle(host: Element, styles: readonly Element[]): Element[] {
  const lead = leadOf(readSegments(host), readEnabled(findNode(host, 'segmentedvolumedata')!));
  return lead < 0 ? [] : [styles[lead]];
}

/** The styles among elements, in order; HTML puts what follows a style that was not closed into it, where it is read as what follows. */
function listStyles(elements: Iterable<Element>, host: Element): Element[] {
  return [...elements].flatMap((one) => {
    if (isAround(one)) return listStyles(one.children, host);
    if (!isStyle(one)) return [];
    const use = one.getAttribute('USE') ?? one.getAttribute('use');
    const used = use === null ? null : [...host.querySelectorAll('*')].find((other) => isStyle(other) && [other.getAttribute('DEF'), other.getAttribute('def'), other.id].includes(use));
    if (use !== null && !used) throw forbidden(`<${one.localName}> got USE="${use.slice(0, 40)}"; expected the DEF of a style in this volume-view.`);
    return [used ?? one, ...(holdsStyles(one) ? [] : listStyles(one.children, host))];
  });
}

/** Whether styles within it are its own. */
function holdsStyles(style: Element): boolean {
  return /^(composed|blended)volumestyle$/i.test(style.localName);
}

function readStyle(element: Element, said: Said): void {
  const fields = new X3dFields(element, `<${element.localName}>`);
  if (!fields.flag('enabled', true)) return;
  const name = nameOf(element);
  if (name === 'opacitymapvolumestyle') return; // It is what a volume looks like in any case.
  if (name === 'projectionvolumestyle') {
    said.projection = readProjection(fields);
    return;
  }
  if (said.chains.length > 1) throw forbidden(`<${element.localName}> got a BlendedVolumeStyle before it; expected that to be the last one. Change their order.`);
  if (name === 'blendedvolumestyle') said.chains = readBlended(fields, said.chains[0].styles);
  else said.chains = [{ weight: 1, styles: checkLight([...said.chains[0].styles, ...readComposable(element, [])]) }];
}

/**
 * A style that can be composed with others, and what is composed in it.
 * @param around - the styles that it is composed in: USE may name one of them, which would have no end
 */
function readComposable(element: Element, around: readonly Element[]): readonly VolumeStyle[] {
  if (around.includes(element)) throw forbidden(`<${element.localName}> got a USE of itself within it; expected the DEF of another style. Leave it out.`);
  if (!new X3dFields(element, `<${element.localName}>`).flag('enabled', true)) return [];
  const name = nameOf(element);
  if (name === 'projectionvolumestyle' || name === 'blendedvolumestyle') {
    throw forbidden(`<${element.localName}> stands in another style; expected ${name.startsWith('p') ? 'it alone, as X3D composes no projections' : 'it outside of that'}.`);
  }
  if (name === 'opacitymapvolumestyle') return [];
  if (name === 'composedvolumestyle') return composedIn(element, around);
  const style = readVolumeStyle(element);
  if (style === undefined) throw forbidden(`<${element.localName}> is no rendering style of X3D's; expected one that docs/x3d-styles.md lists.`);
  return style ? [style] : [];
}

/** The styles in one that holds some. */
function composedIn(element: Element, around: readonly Element[]): VolumeStyle[] {
  return listStyles(element.children, element.closest('volume-view') ?? element).flatMap((one) => readComposable(one, [...around, element]));
}

function checkLight(styles: readonly VolumeStyle[]): readonly VolumeStyle[] {
  if (styles.filter(({ kind }) => kind === 'shaded').length > 1) throw forbidden('volume-view got more than one ShadedVolumeStyle; expected one. Set enabled="false" on the others.');
  return styles;
}

function readProjection(fields: X3dFields): ProjectionKind {
  const kind = fields.word('type', 'MAX', ['MAX', 'MIN', 'AVERAGE']);
  if (fields.number('intensityThreshold', 0) > 0) throw fields.error('intensityThreshold', '0: the largest value of the whole ray is shown');
  return kind.toLowerCase() as ProjectionKind;
}

/** The volume in the styles before, and the same volume in others: two chains that are added by their weights. */
function readBlended(fields: X3dFields, before: readonly VolumeStyle[]): StyleChain[] {
  const { element } = fields;
  const children = [...element.children];
  if (children.some(({ localName }) => /texture/i.test(localName))) {
    throw forbidden('<BlendedVolumeStyle> got voxels or a weightTransferFunction; expected none: it blends two styles of one volume. Leave them out.');
  }
  for (const field of ['weightFunction1', 'weightFunction2']) fields.word(field, 'CONSTANT', ['CONSTANT']);
  const styles = checkLight(composedIn(element, []));
  checkLight([...before, ...styles]);
  return [{ weight: fields.number('weightConstant1', 0.5, [0, 1]), styles: before }, { weight: fields.number('weightConstant2', 0.5, [0, 1]), styles }];
}

function forbidden(message: string): VolumeViewError {
  return new VolumeViewError('attribute/invalid', message);
}

import { VolumeViewError } from '../../core/errors.ts';
import type { ErrorState } from '../../viewer/model/error-state.ts';
import { socketOf } from '../../viewer/model/view-socket.ts';
import { meantParent } from '../../page/unclosed.ts';
import { containerFieldOf, urlOf, X3dFields } from './x3d-fields.ts';

type Atlas = Readonly<Record<string, string | null>>;

/** A view that uses an X3D scene's values for the attributes that it lacks. */
interface AtlasView extends Element {
  requestUpdate?(name: string): void;
}

/** The view whose volume nodes are followed, and whether its appearance has been read. */
interface Presented {
  readonly user: { readonly host: AtlasView };
  readonly look: { readonly current: unknown; readonly errors: Pick<ErrorState, 'report' | 'clear'> };
}

const known = new WeakMap<Element, Atlas | null>();

/**
 * For each element, the number of searches for its atlas: images are measured, and the search that began first may end
 * last.
 */
const searches = new WeakMap<Element, number>();

const isVolumeNode = (node: Node | null): boolean => /volume(style|data)$|^x3d$/i.test(`${node?.nodeName}`);

/** A group that is added or removed has volume nodes in it; labels and layers may yield to what the nodes say. */
const hasVolumeNode = (node: Node): boolean =>
  isVolumeNode(node) ||
  /^volume-(labels|layer)$/i.test(node.nodeName) ||
  (node instanceof Element && [...node.getElementsByTagName('*')].some(isVolumeNode));

/**
 * Follows X3D's volume nodes among an element's children, and their content, as long as the element lives.
 * @param readAppearance - reads the styles again
 */
export async function follow(
  { user: { host }, look: appearance }: Presented,
  readAppearance: () => void,
): Promise<void> {
  const readAll = (): Promise<void> =>
    findAtlas(host).then(() => {
      if (appearance.current) readAppearance();
      else refuseFiles(host, appearance.errors);
    });
  new MutationObserver((records) => {
    if (
      records.some(
        ({ target, addedNodes, removedNodes }) =>
          [target, meantParent(target as Element)].some(isVolumeNode) ||
          [...addedNodes, ...removedNodes].some(hasVolumeNode),
      )
    )
      void readAll();
  }).observe(host, { childList: true, subtree: true, attributes: true });
  await readAll();
}

/** Whether an element is the voxels of the volume itself, and not those of a blend, nor its segments or normals. */
function isOwnAtlas(one: Element): boolean {
  return (
    /^imagetextureatlas$/i.test(one.localName) &&
    !/^(segmentidentifiers|surfacenormals)$/.test(containerFieldOf(one)) &&
    ![...ancestors(one)].some(({ localName }) => /^blendedvolumestyle$/i.test(localName))
  );
}

/** For each view, the file about which an error was reported. */
const refused = new WeakMap<Element, string>();

/** Reports voxels of a scene that are not an atlas: without a `src` the page would stay empty, with no reason given. */
function refuseFiles(host: AtlasView, errors: Pick<ErrorState, 'report' | 'clear'>): void {
  const texture = [...host.querySelectorAll('imagetexture3d')].find(
    (one) =>
      /volumedata$/i.test(meantParent(one)?.localName ?? '') &&
      !/^(segmentidentifiers|gradients)$/.test(containerFieldOf(one)),
  );
  if (!texture || host.hasAttribute('src') || known.get(host)) {
    if (refused.delete(host)) errors.clear('optics');
    return;
  }
  const url = urlOf(new X3dFields(texture, 'ImageTexture3D'));
  if (refused.get(host) === url) return;
  refused.set(host, url);
  errors.report(
    'optics',
    new VolumeViewError(
      'attribute/invalid',
      `<${meantParent(texture)!.localName}> got an ImageTexture3D, "${url.slice(0, 80)}", and no src; expected an ImageTextureAtlas, or that file as the src of the volume-view.`,
    ),
  );
}

/** Uses X3DOM's scene of a volume among an element's children as its source, if it has no other. */
async function findAtlas(host: AtlasView): Promise<void> {
  const node = [...host.querySelectorAll('*')].find(isOwnAtlas);
  const search = (searches.get(host) ?? 0) + 1;
  searches.set(host, search);
  const atlas = node ? await readAtlas(node) : null;
  if (search !== searches.get(host)) return;
  const before = known.get(host) ?? null;
  if (JSON.stringify(atlas) === JSON.stringify(before)) return;
  const hadOne = known.has(host);
  known.set(host, atlas);
  if (!hadOne)
    void socketOf(host).join({
      key: 'atlas',
      attribute: (property) => (host.hasAttribute('src') ? null : known.get(host)?.[property]),
    });
  host.requestUpdate?.('src');
}

/** The values of an atlas that replace attributes. The size of a slice has to be measured in pixels. */
async function readAtlas(node: Element): Promise<Atlas> {
  const text = (name: string): string => new X3dFields(node, 'ImageTextureAtlas').text(name);
  const src = urlOf(new X3dFields(node, 'ImageTextureAtlas'));
  const [across, down, count] = ['slicesOverX', 'slicesOverY', 'numberOfSlices'].map(text);
  const volume = [...ancestors(node)].find(({ localName }) => /volumedata$/i.test(localName));
  const lengths = (volume && new X3dFields(volume, 'VolumeData').text('dimensions')) || '1 1 1';
  const scales = [...ancestors(node)].filter(({ localName }) => /^transform$/i.test(localName)).map(readScale);
  const sizes = lengths
    .split(/[\s,]+/)
    .map((length, axis) => scales.reduce((size, scale) => size * scale[axis], Number(length)));
  const image = await measureImage(src, node.ownerDocument);
  const tiles = [Number(across), Number(down), Number(count)];
  const isKnown = image && sizes.length === 3 && [...sizes, ...tiles].every((x) => x > 0 && x < 1e9);
  // X3DOM's x runs to the right of an image and its y down, and not to a patient's right and front. Values that can't
  // be read are reported by the reader of the attribute that they replace.
  const spacing = isKnown
    ? [(-sizes[0] * tiles[0]) / image[0], (-sizes[1] * tiles[1]) / image[1], sizes[2] / tiles[2]].join(' ')
    : image
      ? lengths
      : null;
  return { src, mosaic: `${across}x${down}`, slices: count || null, spacing };
}

/** The factor by which a Transform scales its content. */
function readScale(transform: Element): readonly number[] {
  const scale = new X3dFields(transform, 'Transform')
    .text('scale')
    .split(/[\s,]+/)
    .map(Number);
  return scale.length === 3 && scale.every((x) => x > 0 && x < 1e9) ? scale : [1, 1, 1];
}

function* ancestors(node: Element): Generator<Element> {
  for (let one = node.parentElement; one; one = one.parentElement) yield one;
}

/** Pixels across and down; null if it is not an image. */
function measureImage(url: string, { defaultView, baseURI }: Document): Promise<[number, number] | null> {
  return new Promise((resolve) => {
    if (!defaultView || !URL.canParse(url, baseURI)) return resolve(null);
    const image = new Image();
    image.crossOrigin = 'anonymous';
    image.onload = () => resolve([image.naturalWidth, image.naturalHeight]);
    image.onerror = () => resolve(null); // The loader reports what is wrong.
    image.src = new URL(url, baseURI).href;
  });
}

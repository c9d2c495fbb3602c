import type { Budget } from '../base/budget.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { readAhead } from '../base/read-ahead.ts';
import type { FileTree } from './file-tree.ts';
import { readAxes } from './ome-axes.ts';
import type { OmeAxes } from './ome-axes.ts';
import { checkLevels, dimensionsOf, guessPlaces, readPlaces } from './ome-levels.ts';
import type { OmeLevel } from './ome-levels.ts';
import { isObject, listOf, objectOf, readJson } from './read-json.ts';
import type { Json } from './read-json.ts';
import { readArray } from './zarr-array.ts';
import type { ZarrArray } from './zarr-array.ts';

/** An image of a folder, as its metadata describe it. */
export interface OmeImage {
  /** Such as 'OME-Zarr 0.4'. */
  readonly format: string;
  readonly axes: OmeAxes;
  /** The finest one first. */
  readonly levels: readonly OmeLevel[];
  /** How a channel is shown: `omero`; empty where the file does not say it. */
  readonly omero: Json;
  /** What the file says of its labels; null where its values are none. */
  readonly labels: Json | null;
  /** What of the folder is not shown, in words. */
  readonly left: readonly string[];
}

interface Opening {
  readonly budget: Budget;
  readonly signal?: AbortSignal;
}

/** Levels of a pyramid: each one half as fine, they would hold 2^32 voxels along an axis. */
const maxLevels = 32;

/** A group or an array. */
interface Node {
  readonly attributes: Json;
  /** The metadata of an array; null for a group. */
  readonly array: Json | null;
  /** Metadata of arrays in a group that are in its own metadata, by their paths. */
  readonly inside: Json;
}

/**
 * Reads what a folder says of its image: OME-Zarr 0.1 to 0.5, or a single array.
 * @param series - which image of a folder of several, from 1
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/unknown`, `source/…`
 */
export async function openImage(tree: FileTree, series: number | undefined, opening: Opening): Promise<OmeImage> {
  let path = '';
  let node = await openNode(tree, path, opening);
  let attributes = omeOf(node?.attributes);
  if (!listOf(attributes.multiscales).length && attributes['bioformats2raw.layout'] !== undefined) {
    path = `${(series ?? 1) - 1}/`;
    node = await openNode(tree, path, opening);
    attributes = omeOf(node?.attributes);
    if (!node)
      throw corruptFile(
        'the OME-Zarr',
        `has no image ${series ?? 1}; expected the number of one of its images as series`,
      );
  }
  if (!node)
    throw unsupportedFile(
      'the folder',
      'is no Zarr: it has neither zarr.json nor .zgroup; check the address, and that the server sends files whose names begin with a dot',
    );
  const [image, ...others] = listOf(attributes.multiscales).filter(isObject);
  if (!image) return node.array ? openArray(node, path) : refuseGroup(attributes);
  const datasets = listOf(image.datasets).filter(isObject);
  if (datasets.length === 0 || datasets.length > maxLevels)
    throw corruptFile('the OME-Zarr', `lists ${datasets.length} levels; expected 1 to ${maxLevels}`);
  const arrays = await readArrays(tree, { node, path, paths: datasets.map((one) => checkPath(one.path)) }, opening);
  const axes = readAxes(image.axes, arrays[0].shape.length);
  const levels = arrays.map((array, number) => {
    const what = `level ${number} of the OME-Zarr`;
    if (array.shape.length !== axes.count)
      throw corruptFile(what, `has ${array.shape.length} axes; expected ${axes.count}, as the image says`);
    const lists = [datasets[number].coordinateTransformations, image.coordinateTransformations];
    const places = readPlaces(lists, axes.count, what) ?? guessPlaces(array.shape, arrays[0].shape);
    return { ...places, array, dimensions: dimensionsOf(array, axes) };
  });
  checkLevels(levels, axes);
  const version = attributes.version ?? image.version;
  const known = typeof version === 'string' && /^\d+\.\d+$/.test(version) ? ` ${version}` : '';
  return {
    format: axes.millimetres ? `OME-Zarr${known}` : `Zarr (OME${known})`,
    axes,
    levels,
    omero: objectOf(attributes.omero),
    labels: isObject(attributes['image-label']) ? attributes['image-label'] : null,
    left:
      others.length > 0
        ? [others.length > 1 ? `images 2 to ${others.length + 1} of the folder` : 'image 2 of the folder']
        : [],
  };
}

/** From version 0.5 on, what belongs to OME has a place of its own. */
const omeOf = (attributes: unknown): Json => {
  const all = objectOf(attributes);
  return isObject(all.ome) ? all.ome : all;
};

async function openNode(tree: FileTree, path: string, opening: Opening): Promise<Node | null> {
  const metadata = await readJson(tree, `${path}zarr.json`, opening);
  if (metadata)
    return {
      attributes: objectOf(metadata.attributes),
      array: metadata.node_type === 'array' ? metadata : null,
      inside: objectOf(objectOf(metadata.consolidated_metadata).metadata),
    };
  const attributes = await readJson(tree, `${path}.zattrs`, opening);
  const isImage = listOf(attributes?.multiscales).length > 0;
  const array = isImage ? null : await readJson(tree, `${path}.zarray`, opening);
  const isGroup = attributes !== null || array !== null || (await readJson(tree, `${path}.zgroup`, opening)) !== null;
  return isGroup ? { attributes: attributes ?? {}, array, inside: {} } : null;
}

async function readArrays(
  tree: FileTree,
  { node, path, paths }: { readonly node: Node; readonly path: string; readonly paths: readonly string[] },
  opening: Opening,
): Promise<ZarrArray[]> {
  const arrays: ZarrArray[] = [];
  const read = async (inside: string): Promise<Json | null> => {
    const known = Object.hasOwn(node.inside, inside) ? node.inside[inside] : null;
    if (isObject(known)) return known;
    return (
      (await readJson(tree, `${path}${inside}/zarr.json`, opening)) ??
      (await readJson(tree, `${path}${inside}/.zarray`, opening))
    );
  };
  for await (const one of readAhead(paths, read)) {
    if (one.status === 'rejected') throw one.reason;
    const what = `level ${arrays.length} of the OME-Zarr`;
    if (!one.value) throw corruptFile(what, 'is not there: the folder has no metadata of it');
    arrays.push(readArray(one.value, `${path}${paths[arrays.length]}/`, what));
  }
  return arrays;
}

/** A path below the group. */
function checkPath(path: unknown): string {
  const parts = typeof path === 'string' && path.length <= 200 ? path.split('/') : [''];
  if (parts.some((part) => part === '' || part === '.' || part === '..'))
    throw corruptFile('the OME-Zarr', 'has a level without a path below its own folder');
  return parts.join('/');
}

/** An array that no image lists: its last axes are those of space. */
function openArray({ array: metadata, attributes }: Node, path: string): OmeImage {
  const array = readArray(metadata!, path, 'the Zarr array');
  const names = array.names.length > 0 ? array.names : listOf(attributes._ARRAY_DIMENSIONS);
  const isNamed = ['x', 'y'].every((name) => names.includes(name)) && names.length === array.shape.length;
  const axes = readAxes(isNamed ? names : undefined, array.shape.length);
  const places = guessPlaces(array.shape, array.shape);
  return {
    format: 'Zarr',
    axes,
    levels: [{ ...places, array, dimensions: dimensionsOf(array, axes) }],
    omero: {},
    labels: null,
    left: [],
  };
}

function refuseGroup(attributes: Json): never {
  const what = 'the Zarr group';
  if (attributes.plate !== undefined || attributes.well !== undefined)
    throw unsupportedFile(
      what,
      'is a plate or a well; expected one of its images: write its path, such as "plate.zarr/A/1/0"',
    );
  if (Array.isArray(attributes.labels))
    throw unsupportedFile(
      what,
      'lists labels; expected one of them: write its path, such as "image.zarr/labels/cells"',
    );
  throw unsupportedFile(
    what,
    'has no image: its attributes have no multiscales; expected an OME-Zarr image, or an array in it',
  );
}

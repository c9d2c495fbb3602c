import { VolumeViewError } from '../../core/errors.ts';
import { decodeArray } from './gifti-array.ts';
import type { GiftiArray } from './gifti-array.ts';
import { giftiTransform } from './gifti-transform.ts';
import { checkCounts, corrupt } from './mesh-limits.ts';
import type { Mesh } from './mesh.ts';
import { readXml } from '../base/read-xml.ts';

export function isGifti(text: string): boolean {
  return /<GIFTI\b|<!DOCTYPE\s+GIFTI\b/.test(text) || /^\s*<\?xml\b/.test(text);
}

/**
 * Reads the surface of a GIfTI file: the first array of positions and the first one of triangles.
 * Source: *Geometry Format (GIfTI)*, version 1.0, NITRC 2008
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`
 */
export async function readGifti(bytes: Uint8Array<ArrayBuffer>): Promise<Mesh> {
  const arrays = listArrays(new TextDecoder().decode(bytes));
  const [points, triangles, normals] = ['POINTSET', 'TRIANGLE', 'VECTOR'].map((intent) =>
    arrays.find((one) => one.attributes.get('Intent') === `NIFTI_INTENT_${intent}`),
  );
  if (!points || !triangles) {
    throw new VolumeViewError(
      'format/unsupported',
      `the GIfTI file has no surface: it has ${arrays.length} arrays, ${points ? '' : 'none of places'}${points || triangles ? '' : ', '}${triangles ? '' : 'none of triangles'}; expected a file ".surf.gii" with both`,
    );
  }
  checkCounts('GIfTI file', points.count / 3, triangles.count / 3);
  const places = await decodeArray(points);
  const isNormal = normals?.count === points.count;
  const transform = giftiTransform(points);
  return {
    positions: transform ? transform(places) : Float32Array.from(places),
    // If the file has a transform, its normals are computed again.
    normals: isNormal && !transform ? Float32Array.from(await decodeArray(normals)) : null,
    indices: asIndices(await decodeArray(triangles)),
    colors: null,
    space: null,
    format: 'GIfTI file',
    ...listLeft(arrays),
  };
}

function listLeft(arrays: readonly GiftiArray[]): Pick<Mesh, 'left'> {
  const [places, triangles] = ['POINTSET', 'TRIANGLE'].map(
    (intent) => arrays.filter((one) => one.attributes.get('Intent') === `NIFTI_INTENT_${intent}`).length,
  );
  return places > 1 || triangles > 1
    ? { left: [`of its ${places} arrays of places and ${triangles} of triangles the first ones are shown`] }
    : {};
}

function asIndices(numbers: ArrayLike<number>): Uint32Array<ArrayBuffer> {
  const indices = new Uint32Array(numbers.length);
  for (let i = 0; i < numbers.length; i++) {
    // A cast would turn an invalid index into another vertex.
    if (!(numbers[i] >= 0) || !Number.isInteger(numbers[i]))
      throw corrupt('GIfTI file', `has a triangle with the corner ${numbers[i]}`);
    indices[i] = numbers[i];
  }
  return indices;
}

function listArrays(text: string): readonly GiftiArray[] {
  const arrays: GiftiArray[] = [];
  let current: GiftiArray | null = null;
  let root: string | null = null;
  let name = '';
  try {
    readXml(text, {
      open(opened, attributes) {
        root ??= opened;
        name = opened;
        if (opened === 'DataArray') arrays.push((current = makeArray(attributes)));
        if (opened === 'CoordinateSystemTransformMatrix') current?.transforms.push(new Map());
      },
      close(closed) {
        name = '';
        if (closed === 'DataArray') current = null;
      },
      text(part) {
        if (!current) return;
        if (name === 'Data') current.data += part;
        else if (name === 'DataSpace' || name === 'TransformedSpace' || name === 'MatrixData') {
          const last = current.transforms.at(-1);
          last?.set(name, (last.get(name) ?? '') + part);
        }
      },
    });
  } catch (cause) {
    throw new VolumeViewError(
      'format/corrupt',
      `the GIfTI file is no XML that can be read: ${String(cause).slice(0, 200)}. Fetch it again, or write it again`,
      { cause },
    );
  }
  if (root !== 'GIFTI')
    throw new VolumeViewError(
      'format/unknown',
      `the file is an XML of "${String(root).slice(0, 40)}"; expected a surface: GIfTI, STL, OBJ, PLY or glTF`,
    );
  return arrays;
}

function makeArray(attributes: ReadonlyMap<string, string>): GiftiArray {
  const dimensions = Number(attributes.get('Dimensionality') ?? 2);
  const lengths = Array.from({ length: Math.min(6, dimensions) || 0 }, (_, i) => Number(attributes.get(`Dim${i}`)));
  return {
    attributes,
    count: lengths.reduce((product, one) => product * one, 1),
    rows: lengths[0] ?? 0,
    data: '',
    transforms: [],
  };
}

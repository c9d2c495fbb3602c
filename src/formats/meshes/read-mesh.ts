import { VolumeViewError } from '../../core/errors.ts';
import { gunzip, isGzip } from '../codecs/gunzip.ts';
import { loadReader } from '../base/load-reader.ts';
import { isGifti, readGifti } from './gifti.ts';
import { maxMeshBytes } from './mesh-limits.ts';
import type { Mesh } from './mesh.ts';
import { isObj, readObj } from './obj.ts';
import { isPly } from './ply-header.ts';
import { readPly } from './ply.ts';
import { isBinaryStl, isTextStl, readStl } from './stl.ts';

/** Other formats in which people have surfaces, and what to do with such files. */
const others: readonly (readonly [name: string, is: (text: string, bytes: Uint8Array) => boolean])[] = [
  ['FreeSurfer file without triangles', (_, [a, b, c]) => a === 255 && b === 255 && (c === 253 || c === 255)],
  ['VTK file in XML', (text) => /<VTKFile\b/.test(text)],
  ['zip archive', (text) => text.startsWith('PK\u0003\u0004')],
  ['web page', (text) => /^\s*<(!doctype html|html)\b/i.test(text)],
];

/**
 * Reads a surface. Its bytes decide the format; its name decides only if the bytes do not.
 * @param name - of the file, for messages
 * @throws {VolumeViewError} `format/unknown`, `format/unsupported`, `format/corrupt`, `format/too-large`
 */
export async function readMesh(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<Mesh> {
  const plain = isGzip(bytes) ? await unpackAll(bytes, maxMeshBytes) : bytes;
  const text = new TextDecoder('latin1').decode(plain.subarray(0, 4096));
  if (isPly(text)) return readPly(plain);
  // Its mark, 0xfffffe.
  if (text.startsWith('\u00ff\u00ff\u00fe'))
    return (await loadReader(() => import('./freesurfer.ts'))).readFreeSurfer(plain);
  if (/^# vtk DataFile/i.test(text)) return (await loadReader(() => import('./vtk.ts'))).readVtk(plain);
  if (isBinaryStl(plain)) return readStl(plain);
  if (text.startsWith('glTF') || isGltfJson(text, plain))
    return (await loadReader(() => import('./gltf.ts'))).readGltf(plain);
  const other = others.find(([, is]) => is(text, plain));
  if (other) throw unknown(name, `is a ${other[0]}`);
  if (isGifti(text)) return readGifti(plain);
  if (isTextStl(text)) return readStl(plain);
  const [, ending] = /\.(stl|obj)(\.gz)?$/i.exec(name) ?? [];
  if (ending?.toLowerCase() === 'stl') return readStl(plain);
  if (ending || isObj(text)) return readObj(plain);
  throw unknown(name, 'is of no type that is known');
}

/** Members of the JSON come in any order: the one that identifies glTF may be the last. */
function isGltfJson(text: string, bytes: Uint8Array): boolean {
  if (!/^\s*\{/.test(text)) return false;
  return (
    /"(asset|bufferViews|accessors|meshes)"/.test(text) ||
    new TextDecoder('latin1').decode(bytes.subarray(-4096)).includes('"asset"')
  );
}

function unknown(name: string, what: string): VolumeViewError {
  return new VolumeViewError(
    'format/unknown',
    `${name} ${what}; expected a surface of triangles: STL, OBJ, PLY, VTK (legacy), GIfTI, FreeSurfer or glTF. MeshLab, 3D Slicer and Connectome Workbench convert others`,
  );
}

/** Unpacks a whole gzip file. @throws {VolumeViewError} `format/too-large`, `format/corrupt` */
export async function unpackAll(bytes: Uint8Array<ArrayBuffer>, maxBytes: number): Promise<Uint8Array<ArrayBuffer>> {
  const pieces: Uint8Array<ArrayBuffer>[] = [];
  let sum = 0;
  for await (const piece of gunzip(bytes)) {
    sum += piece.length;
    if (sum > maxBytes)
      throw new VolumeViewError(
        'format/too-large',
        `the gzip file unpacks to ${maxBytes.toLocaleString('en')} bytes or more; expected at most so many`,
      );
    pieces.push(piece);
  }
  return new Uint8Array(await new Blob(pieces).arrayBuffer());
}

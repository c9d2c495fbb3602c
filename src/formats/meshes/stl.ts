import { checkCounts, corrupt } from './mesh-limits.ts';
import type { Mesh } from './mesh.ts';
import { floatList } from './number-list.ts';
import { readSpace } from './space-comment.ts';
import { TextScanner } from './text-scanner.ts';

/** Bytes of a binary STL before its triangles, and of each triangle. */
const [head, each] = [84, 50];

const keywords = new Set(['', 'solid', 'endsolid', 'facet', 'endfacet', 'outer', 'endloop']);

/**
 * Whether bytes are those of a binary STL: the file's length must fit its number of triangles. Some binary files begin
 * with "solid" too.
 */
export function isBinaryStl(bytes: Uint8Array): boolean {
  return bytes.length >= head && bytes.length === head + each * countOf(bytes);
}

/** Whether a text is an STL. */
export function isTextStl(text: string): boolean {
  return /^\s*solid\b[^\n]*\n\s*(facet\b|endsolid\b)/i.test(text);
}

/**
 * Reads an STL. Its triangles are separate: those that meet are joined later. Its normals are not used, because the
 * order of the vertices says the same, and many programs write zeros.
 * Source: *StereoLithography Interface Specification*, 3D Systems, 1988
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`
 */
export function readStl(bytes: Uint8Array): Mesh {
  if (isBinaryStl(bytes) || !isTextStl(new TextDecoder('latin1').decode(bytes.subarray(0, 1000))))
    return readBinary(bytes);
  return readText(bytes);
}

function countOf(bytes: Uint8Array): number {
  return new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true);
}

function readBinary(bytes: Uint8Array): Mesh {
  if (bytes.length < head) throw corrupt('STL', `has ${bytes.length} bytes; expected at least ${head}`);
  const triangles = countOf(bytes);
  checkCounts('STL', 3 * triangles, triangles);
  if (bytes.length < head + each * triangles)
    throw corrupt(
      'STL',
      `ends early: it says that it has ${triangles.toLocaleString('en')} triangles, and has bytes for ${Math.floor((bytes.length - head) / each).toLocaleString('en')}`,
    );
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const positions = new Float32Array(9 * triangles);
  for (let triangle = 0; triangle < triangles; triangle++) {
    const from = head + each * triangle + 12;
    for (let i = 0; i < 9; i++) positions[9 * triangle + i] = view.getFloat32(from + 4 * i, true);
  }
  return separate(positions, new TextDecoder('latin1').decode(bytes.subarray(0, 80)));
}

function readText(bytes: Uint8Array): Mesh {
  const scanner = new TextScanner(bytes);
  const positions = floatList();
  let title = '';
  for (; !scanner.isAtEnd; scanner.nextLine()) {
    const word = scanner.word().toLowerCase();
    if (word === 'vertex') for (let i = 0; i < 3; i++) positions.push(scanner.number());
    else if (!keywords.has(word))
      throw corrupt(
        'STL',
        `got "${word.slice(0, 40)}" in line ${scanner.line}; expected facet, outer loop, vertex, endloop, endfacet or endsolid`,
      );
    else if (word === 'solid') title ||= scanner.rest();
    else if (word === 'endloop' && positions.length % 9 > 0)
      throw corrupt('STL', `has a facet that is no triangle before line ${scanner.line}`);
    if (word === 'vertex') {
      const last =
        positions.at(positions.length - 1) + positions.at(positions.length - 2) + positions.at(positions.length - 3);
      if (!Number.isFinite(last)) throw corrupt('STL', `has no vertex of three numbers in line ${scanner.line}`);
      checkCounts('STL', positions.length / 3, Math.floor(positions.length / 9));
    }
  }
  if (positions.length % 9 > 0) throw corrupt('STL', 'ends early, within a triangle');
  return separate(positions.take(), title);
}

function separate(positions: Float32Array<ArrayBuffer>, title: string): Mesh {
  const indices = Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  return { positions, normals: null, indices, colors: null, space: readSpace(title), format: 'STL' };
}

import type { MeshSpace } from './mesh.ts';

/**
 * Reads the directions of the axes, which 3D Slicer and ITK write into the comments of a mesh. @returns null if a text
 * does not say it
 */
export function readSpace(text: string): MeshSpace | null {
  const [, space] = /\bSPACE\s*=\s*(RAS|LPS)\b/i.exec(text) ?? [];
  return (space?.toLowerCase() as MeshSpace | undefined) ?? null;
}

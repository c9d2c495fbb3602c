import type { MeshSpace } from './mesh.ts';

/** What 3D Slicer and ITK write into the comments of a mesh: which way its axes run. @returns null where a text does not say */
export function readSpace(text: string): MeshSpace | null {
  const [, space] = /\bSPACE\s*=\s*(RAS|LPS)\b/i.exec(text) ?? [];
  return (space?.toLowerCase() as MeshSpace | undefined) ?? null;
}

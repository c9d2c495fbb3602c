// Loads a surface in a worker, or in the page itself. This part is loaded with the first surface.
import type { Surface } from '../volume/surface.ts';
import { explain } from '../formats/decode.ts';
import { fetchBytes } from '../sources/fetch-bytes.ts';
import { fetchInOrder } from '../sources/fetch-files.ts';
import type { FetchOne } from '../sources/fetch-files.ts';
import type { LoadProgressListener } from '../formats/base/load-request.ts';
import { finishMesh } from '../formats/meshes/finish-mesh.ts';
import { maxMeshBytes } from '../formats/meshes/mesh-limits.ts';
import { readMesh } from '../formats/meshes/read-mesh.ts';
import { nameOf } from '../formats/base/name-of.ts';
import type { MeshRequest, SurfaceRequest, TerrainRequest } from './surface-request.ts';
import { readHgt } from '../formats/terrain/hgt.ts';
import type { HgtTile } from '../formats/terrain/hgt.ts';
import { makeTerrain } from '../formats/terrain/make-terrain.ts';
import type { Report } from './worker-messages.ts';
import { joinTiles } from '../formats/terrain/terrain-raster.ts';

interface Environment {
  readonly signal?: AbortSignal;
  readonly pageOrigin: string;
  /** Fetches in place of the browser's own function, which is used if undefined. */
  readonly fetch?: typeof globalThis.fetch | null;
  readonly onProgress: LoadProgressListener;
}

/** The number of triangles to which terrain is simplified. */
const terrainTriangles = 200_000;

/** Loads a surface in a worker, and reports it. */
export async function runOther(request: SurfaceRequest, environment: Environment, report: Report): Promise<void> {
  const surface = await decodeSurface(request, environment);
  report({ type: 'done', volume: surface }, listSurfaceBuffers(surface));
}

/** Fetches, reads and finishes a surface. @throws {VolumeViewError} as fetchBytes, readMesh and makeTerrain do */
export async function decodeSurface(request: SurfaceRequest, environment: Environment): Promise<Surface> {
  try {
    return await (request.surface === 'mesh' ? decodeMesh(request, environment) : decodeTerrain(request, environment));
  } catch (cause) {
    throw await explain(cause, request.url);
  }
}

async function decodeMesh({ url, space }: MeshRequest, environment: Environment): Promise<Surface> {
  const [file] = await fetchAll([url], environment);
  return finishMesh(await readMesh(file.bytes, nameOf(url)), space);
}

async function decodeTerrain({ files, corner, radar }: TerrainRequest, environment: Environment): Promise<Surface> {
  const tiles: HgtTile[] = [];
  for (const [i, { bytes }] of (await fetchAll(files, environment)).entries())
    tiles.push(await readHgt(bytes, nameOf(files[i]), corner));
  return makeTerrain(joinTiles(tiles, radar.site, radar.reach), radar, terrainTriangles);
}

async function fetchAll(
  urls: readonly string[],
  { signal, pageOrigin, fetch, onProgress }: Environment,
): Promise<{ readonly bytes: Uint8Array<ArrayBuffer> }[]> {
  const fetchOne: FetchOne = (url, report) =>
    fetchBytes(url, { signal, pageOrigin, fetch, maxBytes: maxMeshBytes, onProgress: report });
  const files: { readonly bytes: Uint8Array<ArrayBuffer> }[] = [];
  for await (const file of fetchInOrder(urls, fetchOne, (loaded, total) =>
    onProgress({ loaded, total, phase: 'fetch' }),
  ))
    files.push(file);
  const sum = files.reduce((bytes, file) => bytes + file.bytes.length, 0);
  onProgress({ loaded: 0, total: sum, phase: 'decode' });
  return files;
}

/** The buffers that are transferred to the page instead of copied. */
function listSurfaceBuffers({ parts }: Surface): ArrayBuffer[] {
  return parts.flatMap(({ positions, normals, indices, colors }) =>
    [positions, normals, indices, ...(colors ? [colors] : [])].map(({ buffer }) => buffer),
  );
}

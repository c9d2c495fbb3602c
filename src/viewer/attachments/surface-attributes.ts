import { VolumeViewError } from '../../core/errors.ts';
import { resolveUrl } from '../../worker/load.ts';
import type { MeshSpace } from '../../formats/meshes/mesh.ts';
import type { MeshRequest, SurfaceRequest, TerrainRequest } from '../../worker/surface-request.ts';
import { isOnEarth } from '../../formats/terrain/hgt.ts';
import { parseCssColor } from '../../optics/transfer/css-color.ts';
import { groundReach } from '../../radar/polar-box.ts';
import { stretchOf } from '../../radar/polar-geometry.ts';
import type { ShownSurface } from '../../renderer/layers/shown-surfaces.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import { invalid, isNumber, parseNumbers, parseWord } from '../model/parse-attributes.ts';

/** What an element requests; the request is null while it is not known. */
export interface WantedSurface {
  readonly request: SurfaceRequest | null;
  readonly look: Omit<ShownSurface, 'surface'>;
}

/** Returns the text of an attribute; null where it is absent. */
type ReadText = (name: string) => string | null;

/** For a surface without colours: warm and bright, like plaster. */
const plain = { color: [0.9, 0.83, 0.73], usesOwnColors: true } as const;

/** Maximum number of tiles: those of a quarter of the area of the widest radar on Earth. */
const maxTiles = 64;

/** What a `<volume-surface>` requests. @throws {VolumeViewError} `attribute/invalid`, `source/not-found` */
export function readSurface(read: ReadText): WantedSurface {
  const space = read('space')?.trim();
  const [url, ...more] = urlsOf(read('src'), 'volume-surface', 'src="brain.surf.gii"');
  if (more.length > 0)
    throw new VolumeViewError(
      'attribute/invalid',
      'src of <volume-surface> names several files; expected one. Use an element for each',
    );
  const request: MeshRequest = {
    surface: 'mesh',
    url,
    space: space ? parseWord<MeshSpace>('space of a volume-surface', space, ['ras', 'lps']) : null,
  };
  return { request, look: readAppearance(read, 'volume-surface') };
}

/**
 * What a `<volume-terrain>` requests, under a volume; null where there is no volume yet.
 * @throws {VolumeViewError} `attribute/invalid`, `source/not-found`
 */
export function readTerrain(read: ReadText, volume: Volume | null): WantedSurface {
  const files = urlsOf(read('src'), 'volume-terrain', 'src="N46E007.hgt"');
  const text = read('corner')?.trim();
  const corner = text
    ? (parseNumbers('corner of a volume-terrain', text, 2) as unknown as readonly [number, number])
    : null;
  if (files.length > maxTiles)
    throw new VolumeViewError(
      'attribute/invalid',
      `src of <volume-terrain> names ${files.length} files; expected at most ${maxTiles}`,
    );
  if (corner && (files.length > 1 || !isOnEarth(corner) || !corner.every(Number.isInteger)))
    throw invalid(
      'corner of a volume-terrain',
      text!,
      'whole degrees north and east of the south-west corner of a single file, like "46 7"',
    );
  const appearance = readAppearance(read, 'volume-terrain');
  return {
    request: volume && { surface: 'terrain', url: files[0], files, corner, radar: radarOf(volume) },
    look: appearance,
  };
}

function radarOf(volume: Volume): TerrainRequest['radar'] {
  if (!isPolar(volume))
    throw new VolumeViewError(
      'attribute/invalid',
      "<volume-terrain> got a volume that is not a radar's; expected a radar scan, which says where on Earth it is. Other volumes take <volume-surface>",
    );
  const { latitude, longitude, height } = volume.radar?.site ?? {};
  if (latitude === undefined || longitude === undefined)
    throw new VolumeViewError(
      'attribute/invalid',
      '<volume-terrain> got a radar scan that does not say where the radar is; expected its latitude and longitude in the file, or "site" in a manifest',
    );
  return {
    site: { latitude, longitude },
    height: height ?? null,
    reach: groundReach(volume.grid),
    exaggeration: stretchOf(volume.grid),
  };
}

function urlsOf(text: string | null, tag: string, example: string): string[] {
  const trimmed = (text ?? '').trim();
  // A URL may contain commas.
  const words = trimmed.startsWith('data:') ? [trimmed] : trimmed.split(/\s+/).filter((word) => word !== '');
  if (words.length === 0) throw new VolumeViewError('attribute/invalid', `<${tag}> got no src; expected ${example}`);
  return words.map(resolveUrl);
}

function readAppearance(read: ReadText, tag: string): WantedSurface['look'] {
  const isCut = read('cut-with-volume') !== null;
  const [colored, faint] = ['color', 'opacity'].map((name) => read(name)?.trim());
  const color = colored ? parseCssColor(colored) : null;
  if (colored && !color) throw invalid(`color of a ${tag}`, colored, 'a CSS colour, like "#ff8800" or "orange"');
  const opacity = faint ? (isNumber(faint) ? Number(faint) : Number.NaN) : (color?.alpha ?? 1);
  // x3dom would draw it in front of or behind the whole volume, and not inside it.
  if (opacity !== 1) {
    throw new VolumeViewError(
      'attribute/invalid',
      `opacity of <${tag}> got ${faint ?? `${color!.alpha} by its color`}; expected 1. A translucent surface within a volume can not be drawn rightly yet: make the volume clearer instead (opacity-factor), or cut it open`,
    );
  }
  return { ...(color ? { color: color.color, usesOwnColors: false } : plain), isCut };
}

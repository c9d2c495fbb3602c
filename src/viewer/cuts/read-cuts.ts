import { VolumeViewError } from '../../core/errors.ts';
import { loadPart } from '../../core/load-part.ts';
import { childrenOf } from '../../page/page-children.ts';
import { stretchOf } from '../../radar/polar-geometry.ts';
import { maxSlices } from '../../radar/slices.ts';
import type { Slice } from '../../radar/slices.ts';
import type * as GroundMaps from '../../radar/ground-map.ts';
import type { RayCut } from '../../renderer/ray/ray-module.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { PolarGrid } from '../../volume/polar-grid.ts';
import { cutRegion } from '../../volume/region.ts';
import type { Volume } from '../../volume/volume.ts';
import type { WorldCut } from '../../volume/world-cut.ts';
import { ErrorState } from '../model/error-state.ts';
import { invalid, parseNumbers } from '../model/parse-attributes.ts';
import type * as Clips from './read-clips.ts';
import type * as Planes from './read-planes.ts';
import { placeOfRadar, readRings } from './read-rings.ts';
import type { ScanModel } from '../model/scan-model.ts';
import type { Settings } from '../model/settings.ts';
import { socketOf } from '../model/view-socket.ts';
import type { Cuts } from './shown-cuts.ts';

/** What reading cuts needs of its caller. */
interface Reader {
  readonly host: Element;
  readonly errors: ErrorState;
  readonly settings: () => Pick<Settings, 'region' | 'rings' | 'look'>;
}

/** Takes the errors of a coarse volume: they are reported only once, for the full volume. */
const untold = new ErrorState({ file: '', changed: () => {}, failed: () => {} });

/**
 * All cuts that an author requests. What can't be read is reported, and left out.
 * @param model - the volume that sets the camera
 */
export function readCuts(
  { host, errors: reported, settings }: Reader,
  volume: Volume,
  model: ScanModel,
  none: Cuts,
): Cuts {
  const errors = volume.coarse ? untold : reported;
  const { region, rings, look: appearance } = settings();
  const { error, ...slices } = readSlices(host, volume, appearance.value?.window ?? null);
  const cuts: { -readonly [key in keyof Cuts]: Cuts[key] } = { ...none, ...slices };
  errors.take('region', region, (box) => {
    cuts.region = readRegion(box, volume);
    cuts.framed = readRegion(box, model) ?? model.grid;
  });
  errors.take('rings', rings, (spacing) => (cuts.rings = readRings(spacing, volume, cuts.region, maps || null)));
  errors.attempt('slices', () => {
    if (error) throw error;
  });
  return cuts;
}

/**
 * The region that an author requests.
 * @param box - two opposite corners, world units; null for the whole volume
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function readRegion(box: readonly number[] | null, volume: ScanModel): GridFrame | null {
  if (!box) return null;
  const region = cutRegion(volume.grid, box, stretchOf(volume.grid));
  if (!region)
    throw invalid(
      'region',
      box.join(' '),
      'two opposite corners of a box that holds some of the volume, "x0 y0 z0 x1 y1 z1"',
    );
  return region;
}

/** The code that reads planes, once there are some. */
let planes: typeof Planes | null = null;

/** The code that reads what is cut away, once something is. */
let clips: typeof Clips | null = null;

/** The slices among an element's children that are not hidden. */
function shownSlices(host: Element): Element[] {
  return childrenOf(host, 'volume-slice').filter((child) => !child.hasAttribute('hidden'));
}

/** Whether a slice is a plane in the world, as all volumes have except those of radars. */
function isPlane(slice: Element): boolean {
  return /^\s*(axial|coronal|sagittal|oblique)\s*$/i.test(slice.getAttribute('type') ?? '');
}

/** Whether something other than a slice cuts an element's volume. */
function isClipped(host: Element): boolean {
  return (
    host.hasAttribute('cutout') ||
    socketOf(host).parts.some((part) => part.clip) ||
    [...host.getElementsByTagName('*')].some(({ localName }) => /^clipplane$/i.test(localName))
  );
}

/** The code that makes the map below a radar's rings, once there are some; false where it could not be loaded. */
let maps: typeof GroundMaps | false | null = null;

/** Load the code that makes maps. Pictures do not wait for it, because one without a map is right too. */
export async function prepareMap(volume: Pick<Volume, 'radar'>): Promise<void> {
  if (!placeOfRadar(volume)) return;
  maps ??= await loadPart(import('../../radar/ground-map.ts'), 'draws a map').catch((error: unknown) => {
    console.warn(error);
    return false as const;
  });
}

/** Whether an element's slices and other cuts can be read without loading more code. @param hasRings - with rings there is a map */
export function isReady(host: Element, volume: Pick<Volume, 'radar'>, hasRings: boolean): boolean {
  if (hasRings && maps === null && placeOfRadar(volume)) return false;
  return (planes !== null || !shownSlices(host).some(isPlane)) && (clips !== null || !isClipped(host));
}

/** Load the code that the cuts of an element need. */
export async function prepare(host: Element): Promise<void> {
  if (shownSlices(host).some(isPlane)) planes ??= await loadPart(import('./read-planes.ts'), 'reads slices');
  if (isClipped(host)) clips ??= await loadPart(import('./read-clips.ts'), 'cuts volumes');
}

/**
 * The slices that an element's children request, and the other cuts of its volume; what can't be read is left out, and the first
 * error is returned.
 * @param window - data values of black and white that the page gives for the volume
 */
export function readSlices(
  host: Element,
  volume: Volume,
  window: readonly [number, number] | null,
): { slices: readonly Slice[]; cuts: readonly RayCut[]; away?: WorldCut; error: VolumeViewError | null } {
  const shown = shownSlices(host);
  const { slices, error } = readRadarSlices(
    shown.filter((slice) => !isPlane(slice)),
    volume,
  );
  const read = planes?.readPlanes(shown.filter(isPlane), volume, window);
  // Other cuts come first, so that slices are not visible where the volume is cut away.
  const cut = clips?.readClips(host, volume, shown.length > 0);
  return {
    slices,
    cuts: [...(cut?.cuts ?? []), ...(read?.cuts ?? [])],
    ...(cut && { away: cut.away }),
    error: error ?? read?.error ?? cut?.error ?? null,
  };
}

function readRadarSlices(
  shown: readonly Element[],
  volume: Volume,
): { slices: Slice[]; error: VolumeViewError | null } {
  const slices: Slice[] = [];
  let error: VolumeViewError | null = null;
  for (const element of shown.slice(0, maxSlices)) {
    try {
      slices.push(readSlice(element, volume));
    } catch (thrown) {
      error ??= thrown as VolumeViewError;
    }
  }
  if (shown.length > maxSlices) {
    error ??= new VolumeViewError(
      'attribute/invalid',
      `volume-view got ${shown.length} volume-slice elements; expected at most ${maxSlices}. Set "hidden" on those that are not needed.`,
    );
  }
  return { slices, error };
}

function readSlice(element: Element, volume: Volume): Slice {
  const { grid, radar } = volume;
  const type = element.getAttribute('type')?.trim().toLowerCase() ?? '';
  const reader = new SliceAttributes(element, type);
  if (grid.kind !== 'polar')
    throw new VolumeViewError(
      'attribute/invalid',
      `volume-slice type="${type}" got a volume that is not a radar's; expected a radar scan, which alone has such cuts. Others have axial, coronal, sagittal and oblique ones.`,
    );
  if (type === 'ppi') return { kind: 'cone', sweep: readSweep(reader, grid) };
  if (type === 'cappi')
    return {
      kind: 'level',
      height: reader.numbers('height', 1, 'metres above sea level, like "3000"')[0] - (radar?.site.height ?? 0),
    };
  if (type === 'rhi') {
    const angle = (reader.numbers('azimuth', 1, 'degrees clockwise from north, like "220"')[0] * Math.PI) / 180;
    return { kind: 'upright', from: [0, 0], direction: [Math.sin(angle), Math.cos(angle)], length: Infinity };
  }
  if (type === 'section') return readSection(reader);
  throw invalid(
    'type of a volume-slice',
    type,
    "ppi, cappi, rhi or section; axial, coronal, sagittal or oblique in volumes that are not a radar's",
  );
}

function readSection(reader: SliceAttributes): Slice {
  const [x, y] = reader.numbers('from', 2, 'metres east and north, like "-20000 5000"');
  const [toX, toY] = reader.numbers('to', 2, 'metres east and north, like "40000 15000"');
  const length = Math.hypot(toX - x, toY - y);
  if (!(length > 0)) throw reader.error('to', 'another point than that of "from"');
  return { kind: 'upright', from: [x, y], direction: [(toX - x) / length, (toY - y) / length], length };
}

/** Number of the requested sweep, or of the sweep nearest to the requested elevation. */
function readSweep(reader: SliceAttributes, { sweeps }: PolarGrid): number {
  if (reader.has('sweep')) {
    const [number] = reader.numbers('sweep', 1, `a number from 0 to ${sweeps.length - 1}`);
    if (!sweeps[number]) throw reader.error('sweep', `a whole number from 0 to ${sweeps.length - 1}`);
    return number;
  }
  const [target] = reader.has('elevation')
    ? reader.numbers('elevation', 1, 'degrees, like "0.5"')
    : [sweeps[0].elevation];
  const distances = sweeps.map(({ elevation }) => Math.abs(elevation - target));
  return distances.indexOf(Math.min(...distances));
}

/** Metres and degrees above this can't belong to a radar. */
const farthest = 1e9;

/** Reads one slice's attributes; its errors name the slice. */
class SliceAttributes {
  constructor(
    readonly element: Element,
    readonly type: string,
  ) {}

  has(name: string): boolean {
    return this.element.hasAttribute(name);
  }

  /** @param expected - in words for authors */
  numbers(name: string, count: number, expected: string): number[] {
    const numbers = this.#read(name, count);
    if (numbers?.every((n) => Math.abs(n) <= farthest)) return numbers;
    throw this.error(name, expected);
  }

  #read(name: string, count: number): number[] | null {
    try {
      return parseNumbers(name, this.element.getAttribute(name) ?? '', count);
    } catch {
      return null;
    }
  }

  error(name: string, expected: string): VolumeViewError {
    return invalid(`${name} of volume-slice type="${this.type}"`, this.element.getAttribute(name) ?? '', expected);
  }
}

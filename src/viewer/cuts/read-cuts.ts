import type { VolumeViewError } from '../../core/errors.ts';
import { loadPart } from '../../core/load-part.ts';
import { childrenOf } from '../../page/page-children.ts';
import type { Slice } from '../../radar/slices.ts';
import type * as GroundMaps from '../../radar/ground-map.ts';
import type { RayCut } from '../../renderer/ray/ray-module.ts';
import type { Volume } from '../../volume/volume.ts';
import type { WorldCut } from '../../volume/world-cut.ts';
import { ErrorState } from '../model/error-state.ts';
import type * as Clips from './read-clips.ts';
import type * as Planes from './read-planes.ts';
import { readRadarSlices } from './read-radar-slices.ts';
import { readRegion } from './read-region.ts';
import { placeOfRadar, readRings } from './read-rings.ts';
import type { ScanModel } from '../model/scan-model.ts';
import type { WindowSetting } from '../model/parse-attributes.ts';
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
  window: WindowSetting | null,
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

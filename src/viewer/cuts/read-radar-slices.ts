import { VolumeViewError } from '../../core/errors.ts';
import { maxSlices } from '../../radar/slices.ts';
import type { Slice } from '../../radar/slices.ts';
import type { PolarGrid } from '../../volume/polar-grid.ts';
import type { Volume } from '../../volume/volume.ts';
import { invalid, parseNumbers } from '../model/parse-attributes.ts';

/** The slices of a radar among an element's children; what can't be read is left out, and the first error is returned. */
export function readRadarSlices(
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

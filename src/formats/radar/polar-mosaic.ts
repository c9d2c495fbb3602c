import { VolumeViewError } from '../../core/errors.ts';
import { checkMosaicLayout } from '../../volume/mosaic.ts';
import type { GrayImage } from '../../volume/mosaic.ts';
import type { ManifestSweep, PolarMosaicSettings } from '../base/radar-settings.ts';
import { momentKindOf } from './moment-kind.ts';
import type { RadarFile, RadarMoment, RadarSweep } from './radar-file.ts';
import { refuseManySweeps, refuseSweep } from './radar-limits.ts';

/** Metres: farther than any radar sees. */
const farthest = 1e9;

/** Columns and rows of pixels, from the image's top left. */
interface Tile {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/**
 * Reads a radar's mosaic: one sweep per tile, radials downwards, clockwise from north, and gates to the right. Pixels
 * of 0 are no data. It is the form of the 2011 paper, which does not define the direction of the azimuth and the
 * elevations.
 * @param format - the image's format, for the file's `format`
 * @throws {VolumeViewError} `mosaic/layout`: the message says what to add or to change
 */
export function readPolarMosaic(image: GrayImage, format: string, settings: PolarMosaicSettings): RadarFile {
  const tiles = cutTiles(image, settings);
  const { moment: name = 'value', unit, beamWidth, site = {}, time } = settings;
  return {
    format: `${format} polar mosaic`,
    ...(image.left ? { left: image.left } : {}),
    site,
    ...(time === undefined ? {} : { time }),
    ...(beamWidth === undefined ? {} : { beamWidth }),
    moments: [{ name, unit, ...kindOf(settings, name) }],
    sweeps: tiles.map((tile, i) => readTile(image, tile, name, describeTile(settings, i))),
  };
}

function kindOf({ labels, nyquist, unit }: PolarMosaicSettings, name: string): Pick<RadarMoment, 'kind' | 'numbers'> {
  const numbers = labels?.map(({ id }) => id) ?? [];
  if (numbers.length > 0) return { kind: 'kinds', numbers: [Math.min(...numbers), Math.max(...numbers)] };
  if (labels) return { kind: 'kinds' };
  return { kind: nyquist === undefined ? momentKindOf({ name, unit }) : 'velocity' };
}

function cutTiles(image: GrayImage, { mosaic, slices, elevations }: PolarMosaicSettings): Tile[] {
  if (!mosaic) {
    throw layout(
      `the radar's image of ${image.width} x ${image.height} pixels got no mosaic layout; expected mosaic="COLUMNSxROWS" ` +
        `(tiles per row and column), with a tile for each of the ${elevations.length} elevations`,
    );
  }
  if (slices !== undefined && slices !== elevations.length) {
    throw layout(`slices got ${slices}, and elevations ${elevations.length} angles; expected as many of them as tiles`);
  }
  refuseManySweeps(elevations.length);
  if (elevations.length > mosaic.columns * mosaic.rows) {
    throw layout(
      `elevations got ${elevations.length} angles; expected at most ${mosaic.columns * mosaic.rows}, the tiles of a ${mosaic.columns}x${mosaic.rows} mosaic`,
    );
  }
  const { columns, rows } = checkMosaicLayout(image, mosaic, elevations.length);
  const [width, height] = [image.width / columns, image.height / rows];
  if (!Number.isInteger(width) || !Number.isInteger(height)) {
    throw layout(
      `mosaic got ${columns} x ${rows} tiles for a radar's image of ${image.width} x ${image.height} pixels, which makes tiles of ` +
        `${width} x ${height}; expected tiles of whole pixels, as each is a gate`,
    );
  }
  return elevations.map((_, i) => ({
    left: (i % columns) * width,
    top: Math.floor(i / columns) * height,
    width,
    height,
  }));
}

/** The settings of one tile: its own, else those for all tiles. */
function describeTile(
  settings: PolarMosaicSettings,
  index: number,
): Omit<PolarMosaicSettings, 'elevations'> & ManifestSweep & { elevation: number } {
  const { sweeps = [], elevations, ...all } = settings;
  if (sweeps.length > elevations.length) {
    throw layout(
      `sweeps got ${sweeps.length} tiles; expected at most ${elevations.length}, as many as there are elevations`,
    );
  }
  return { ...all, ...sweeps[index], elevation: elevations[index] };
}

function readTile(image: GrayImage, tile: Tile, name: string, about: ReturnType<typeof describeTile>): RadarSweep {
  const {
    rays: radials = about.azimuths?.length ?? tile.height,
    gates = tile.width,
    range,
    elevation,
    nyquist,
    time,
    slope,
    intercept,
  } = about;
  const where = `the tile of elevation ${elevation}°`;
  if (radials > tile.height || gates > tile.width) {
    throw layout(
      `${where} got ${radials} radials of ${gates} gates; expected at most ${tile.height} of ${tile.width}, the pixels of a tile`,
    );
  }
  refuseSweep(where, radials, gates);
  if (
    !range ||
    !(
      range[1] > 0 &&
      Math.abs(range[0]) <= farthest &&
      range[0] + gates * range[1] > 0 &&
      range[0] + gates * range[1] <= farthest
    )
  ) {
    throw layout(
      `${where} got ${range ? `a range of "${range.join(' ')}"` : 'no range'}; expected range="FIRST GATE-LENGTH", metres to the middle of the first gate and from gate to gate, such as range="250 500", with gates between the radar and 1e9 metres`,
    );
  }
  if (about.elevations && about.elevations.length !== radials) {
    throw layout(
      `${where} got ${about.elevations.length} elevations and ${radials} radials; expected one elevation a radial`,
    );
  }
  refuseSweep(where, radials, gates);
  const [firstGate, gateLength] = range;
  return {
    elevation,
    azimuths: readAzimuths(about, radials, where),
    ...(about.elevations ? { elevations: Float64Array.from(about.elevations) } : {}),
    ...(time === undefined ? {} : { time }),
    ...(nyquist === undefined ? {} : { nyquist }),
    moments: [name],
    gridOf: (moment) => (moment === name ? { firstGate, gateLength, gates } : null),
    read: (moment) =>
      moment === name
        ? { firstGate, gateLength, gates, samples: copyPixels(image, tile, { radials, gates }), slope, intercept }
        : null,
  };
}

function readAzimuths({ azimuths, azimuth }: ManifestSweep, radials: number, where: string): Float64Array<ArrayBuffer> {
  if (azimuths && azimuths.length !== radials) {
    throw layout(`${where} got ${azimuths.length} azimuths and ${radials} radials; expected one azimuth a radial`);
  }
  const [first, step] = azimuth ?? [180 / radials, 360 / radials];
  const all = azimuths ?? [first, step];
  if (!all.every((angle) => Math.abs(angle) <= farthest))
    throw layout(`${where} got azimuths that are no angles; expected degrees clockwise from north`);
  return Float64Array.from({ length: radials }, (_, radial) =>
    wrapDegrees(azimuths?.[radial] ?? first + radial * step),
  );
}

function wrapDegrees(angle: number): number {
  // The second remainder is needed because an angle slightly below 0 is rounded to 360.
  return (((angle % 360) + 360) % 360) % 360;
}

function copyPixels(
  { data, width }: GrayImage,
  tile: Tile,
  { radials, gates }: { radials: number; gates: number },
): GrayImage['data'] {
  const samples = data instanceof Uint8Array ? new Uint8Array(radials * gates) : new Uint16Array(radials * gates);
  for (let radial = 0; radial < radials; radial++) {
    const from = (tile.top + radial) * width + tile.left;
    samples.set(data.subarray(from, from + gates), radial * gates);
  }
  return samples;
}

function layout(message: string): VolumeViewError {
  return new VolumeViewError('mosaic/layout', message);
}

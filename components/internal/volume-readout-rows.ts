import type { VolumeInfo } from '../../src/viewer/model/volume-info.ts';
import type { RadarPlace, VolumePick } from '../../src/viewer/model/volume-pick.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { isInMillimetres, isPatient } from '../../src/volume/world-axes.ts';
import { extentOf, nameLengths, unitOfPlaces } from '../../src/messages/length-unit.ts';
import type { Language } from '../../src/messages/language.ts';
import type { ReadoutMessages } from '../../src/messages/readout-messages.ts';

/** One row: a name and its value as text. */
export interface Row {
  readonly name: string;
  readonly text: string;
  /** Of the swatch, CSS; '' for a swatch that is not seen. */
  readonly color?: string;
}

/** How rows are written. */
export interface RowStyle {
  readonly language: Language;
  readonly messages: ReadoutMessages;
  /** The attribute as the author wrote it: `patient` or `xyz`; null for the system that suits the volume. */
  readonly coordinates: string | null;
  /** Whether the volume has labels. */
  readonly hasLabels?: boolean;
  /** The name of the layer over the volume; '' where it has no name, null where there is no layer. */
  readonly layer?: string | null;
}

/** Digits of a value: enough for all values of 16 bits. */
export const valueDigits = 6;

/**
 * All facts about a place, in words. A volume has the same rows at every place.
 * @param pick - null for no place
 */
export function listRows(pick: VolumePick | null, volume: VolumeInfo, style: RowStyle): Row[] {
  const { messages, language } = style;
  const none = '–';
  const write = (text: (known: VolumePick) => string): string => (pick ? text(pick) : none);
  const writeValue = (number: number, unit: string): string =>
    `${language.number(number, valueDigits)}${unit && ` ${unit}`}`;
  const value: Row = {
    name: messages.value,
    text: write(({ value: number, unit }) => (Number.isNaN(number) ? none : writeValue(number, unit))),
  };
  const writeLayer = (wanted: number | undefined): string =>
    write(({ layers = [] }) => {
      const found = layers.find(({ channel }) => channel === wanted);
      return found && found.value !== null ? writeValue(found.value, found.unit) : none;
    });
  // The sum of the channels' shares is no value of the file.
  const values: Row[] = volume.channels?.map(({ number, name, color }) => ({
    name: name || messages.channel(language.number(number)),
    text: writeLayer(number),
    color: pick ? `rgb(${color.map((part) => Math.round(255 * part)).join(' ')})` : '',
  })) ?? [value];
  const layers: Row[] =
    typeof style.layer !== 'string'
      ? []
      : [
          {
            name: style.layer || messages.layer,
            text: writeLayer(undefined),
          },
        ];
  if (isRadar(volume))
    return [value, ...layers, ...listRadarRows(pick?.radar ?? pick?.surface?.radar ?? null, volume, style)];
  const label: Row = { name: messages.label, text: pick?.labelName ?? pick?.label ?? none };
  return [
    ...(style.hasLabels ? [label, ...values] : pick?.label === undefined ? values : [label]),
    ...layers,
    { name: messages.place, text: write(({ world }) => writePlace(world, volume, style)) },
    {
      name: messages.voxel,
      text: write(({ voxel }) => voxel?.map((index) => language.fixed(index, 0)).join(', ') ?? none),
    },
  ];
}

export function isRadar({ moment, site }: VolumeInfo): boolean {
  return moment !== undefined || site !== undefined;
}

function listRadarRows(
  place: Omit<RadarPlace, 'gate'> | null,
  { site }: VolumeInfo,
  { language, messages }: RowStyle,
): Row[] {
  const row = (name: string, write: (known: Omit<RadarPlace, 'gate'>) => string): Row => ({
    name,
    text: place ? write(place) : '–',
  });
  const degrees = (angle: number, decimals: number): string => `${language.fixed(angle, decimals)}°`;
  return [
    row(messages.beamRange, ({ range }) => messages.kilometres(language.fixed(range / 1000, 2))),
    row(messages.beamAzimuth, ({ azimuth }) => degrees(azimuth, 1)),
    row(messages.beamElevation, ({ elevation }) => degrees(elevation, 2)),
    ...(site?.height === undefined
      ? []
      : [row(messages.aboveSea, ({ heightAboveSea }) => messages.metres(language.fixed(heightAboveSea!, 0)))]),
    row(messages.aboveAntenna, ({ heightAboveAntenna }) => messages.metres(language.fixed(heightAboveAntenna, 0))),
    ...(site?.latitude === undefined || site.longitude === undefined
      ? []
      : [
          row(
            messages.latitudeLongitude,
            ({ latitude, longitude }) =>
              `${degrees(Math.abs(latitude!), 3)} ${latitude! < 0 ? messages.south : messages.north} ${degrees(Math.abs(longitude!), 3)} ${longitude! < 0 ? messages.west : messages.east}`,
          ),
        ]),
  ];
}

/** A place in words, with a precision of about a tenth of a voxel. */
export function writePlace(world: Vector3, volume: VolumeInfo, { language, messages, coordinates }: RowStyle): string {
  const asked = coordinates?.trim().toLowerCase();
  // Numbers without a unit are those of the volume's world, as attributes have them.
  const hasUnit = asked === 'patient' || (asked !== 'xyz' && isInMillimetres(volume));
  const unit = unitOfPlaces(hasUnit ? extentOf(volume) : Infinity);
  const finest = unit.perMillimetre * Math.min(...volume.spacing);
  const decimals = Math.min(6, Math.max(0, Math.round(1 - Math.log10(finest))));
  const write = (length: number): string => language.fixed(unit.perMillimetre * length, decimals);
  if (asked === 'patient' || (asked !== 'xyz' && isPatient(volume))) {
    const { right, left, anterior, posterior, superior, inferior } = messages.patient;
    const signs = [
      [left, right],
      [posterior, anterior],
      [inferior, superior],
    ];
    const parts = world.map((length, axis) => `${signs[axis][length < 0 ? 0 : 1]} ${write(Math.abs(length))}`);
    return nameLengths(parts.join(' '), unit, messages);
  }
  const plain = world.map((length, axis) => `${'xyz'[axis]} ${write(length)}`).join(' ');
  // The file does not say whose axes these are; but the format says the unit.
  return hasUnit ? nameLengths(plain, unit, messages) : plain;
}

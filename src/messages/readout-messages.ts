/** The messages of <volume-readout>. Numbers are passed as text, already formatted for the language. */
export interface ReadoutMessages {
  /** Name of the whole readout. */
  readonly readout: string;
  readonly value: string;
  /** Name of the row for the label. */
  readonly label: string;
  /** Name of a second volume over the first one, where it has no name of its own. */
  readonly layer: string;
  /** @param number - of the channel, in digits */
  readonly channel: (number: string) => string;
  readonly place: string;
  readonly voxel: string;
  readonly beamRange: string;
  readonly beamAzimuth: string;
  readonly beamElevation: string;
  readonly aboveSea: string;
  readonly aboveAntenna: string;
  /** Degrees north and east. */
  readonly latitudeLongitude: string;
  readonly north: string;
  readonly south: string;
  readonly east: string;
  readonly west: string;
  /** Short for the patient's right and left, front and back, head and feet. */
  readonly patient: Readonly<Record<'right' | 'left' | 'anterior' | 'posterior' | 'superior' | 'inferior', string>>;
  readonly millimetres: (lengths: string) => string;
  readonly micrometres: (lengths: string) => string;
  readonly nanometres: (lengths: string) => string;
  readonly kilometres: (distance: string) => string;
  readonly metres: (height: string) => string;
  /** The hint while nothing is pointed at. */
  readonly pointHint: string;
  /** Nothing is visible at the place of the pointer. */
  readonly nothingThere: string;
  /** The button that shows a crosshair, which keys move. */
  readonly crosshair: string;
  /** Help for the keys of the crosshair. */
  readonly crosshairKeys: string;
  /** The button that shows the values of the kept place at all times. */
  readonly overTime: string;
}

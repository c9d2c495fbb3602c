/** The words of <volume-readout>. Numbers come as text, already written as the language writes them. */
export interface ReadoutTerms {
  /** Name of all of it. */
  readonly readout: string;
  readonly value: string;
  /** Of a label map. */
  readonly label: string;
  /** Of a second volume over the first one, where nobody says what it is called. */
  readonly layer: string;
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
  readonly kilometres: (distance: string) => string;
  readonly metres: (height: string) => string;
  /** What is said while nothing is pointed at. */
  readonly pointHint: string;
  /** Nothing shows where somebody points. */
  readonly nothingThere: string;
  /** The button that shows a crosshair, which keys move. */
  readonly crosshair: string;
  /** What the keys do to it. */
  readonly crosshairKeys: string;
}

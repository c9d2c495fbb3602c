import type { ReadoutMessages } from './readout-messages.ts';

/** English messages of the readout. The file is loaded where a page has a readout. */
export const english: ReadoutMessages = {
  readout: 'Values in the picture',
  value: 'Value',
  label: 'Label',
  layer: 'Layer',
  place: 'Place',
  voxel: 'Voxel',
  beamRange: 'Range',
  beamAzimuth: 'Azimuth',
  beamElevation: 'Elevation',
  aboveSea: 'Height above sea',
  aboveAntenna: 'Height above antenna',
  latitudeLongitude: 'Position',
  north: 'N',
  south: 'S',
  east: 'E',
  west: 'W',
  patient: { right: 'R', left: 'L', anterior: 'A', posterior: 'P', superior: 'S', inferior: 'I' },
  millimetres: (lengths) => `${lengths} mm`,
  kilometres: (distance) => `${distance} km`,
  metres: (height) => `${height} m`,
  pointHint: 'Point at the picture, or tap it.',
  nothingThere: 'Nothing is shown there.',
  crosshair: 'Crosshair',
  crosshairKeys: 'Arrow keys move the crosshair, with Shift farther. Enter keeps the place, Escape ends.',
};

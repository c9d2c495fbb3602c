import type { ViewMessages } from './messages.ts';

export const english: ViewMessages = {
  volumePicture: 'Volume picture',
  cameraKeys: 'Arrow keys turn it, with Shift they move it, plus and minus zoom, 0 goes back to the first view.',
  loading: 'Loading',
  loadingPercent: (percent) => `Loading ${percent}`,
  decoding: 'Decoding',
  loaded: 'Loaded',
  errors: {
    source: 'The file could not be loaded.',
    'source/unavailable': 'The file is not available now.',
    'source/stalled': 'Loading has stopped.',
    format: 'The file cannot be shown.',
    'format/too-large': 'The volume is too large for this device.',
    mosaic: 'The file cannot be shown.',
    manifest: 'The file cannot be shown.',
    'transfer-function': 'A setting of the picture cannot be read.',
    attribute: 'A setting of the picture cannot be read.',
    webgl: 'The picture cannot be drawn here.',
    internal: 'The program made a mistake.',
    labels: 'The labels cannot be shown.',
    x3dom: 'A part of the program could not be loaded.',
  },
  tryAgain: 'Try again',
  north: 'N',
  kilometres: (distance) => `${distance} km`,
  heightsTimes: (factor) => `heights × ${factor}`,
};

import type { MeasureMessages } from './measure-messages.ts';

/** English messages of measures. The file is loaded where a page has measures. */
export const english: MeasureMessages = {
  measure: { distance: 'Distance', angle: 'Angle', box: 'Box', sphere: 'Sphere' },
  measureButton: 'Measure',
  measureMiddle: 'Place in the middle',
  measureCancel: 'Cancel',
  measureHint: 'Press Measure, then click or tap the picture.',
  measurePlace: (number, count) => `Click or tap the picture: point ${number} of ${count}. Escape cancels.`,
  measurePoint: (number, count) => `Point ${number} of ${count}`,
  plusMinus: (value, uncertainty) => `${value} ± ${uncertainty}`,
  measureSize: 'Size',
  measureRadius: 'Radius',
  measureVolume: 'Volume',
  measureMean: 'Mean',
  measureDeviation: 'Standard deviation',
  measureRange: 'Minimum to maximum',
  measureVoxels: 'Voxels',
  measureGates: 'Gates',
  measureWithError: (mean, error) => `${mean} (standard error ${error})`,
  measureCut: (count, cut) => `${count}, ${cut} of them at the edge`,
  measureWithoutData: (count, without) => `${count}; ${without} without data left out`,
  measureNothing: 'none inside',
  measureSummingUp: 'adding up …',
  measureReduced: 'The volume was made smaller for this device: these are its larger voxels.',
};

import type { CurveMessages } from './curve-messages.ts';

/** English messages of the curve. The file is loaded with the first curve. */
export const english: CurveMessages = {
  curveHint: 'Click a place in the picture, or press Enter at the crosshair: its values over time appear here.',
  curveNone: 'The place has no value.',
  curveKeys: 'Arrow keys go to the time before or after.',
  curveReading: (percent) => `Reading all times: ${percent}`,
  curveRange: (low, lowTime, high, highTime) => `From ${low} (${lowTime}) to ${high} (${highTime}).`,
  curveGaps: (count) => `Times without data: ${count}.`,
  curveFailed: (count, all) => `Scans that could not be read: ${count} of ${all}.`,
  curveProblem: 'The values could not be read.',
  curveTable: 'Table',
  noData: 'no data',
};

// What both sides of the messages know.

/** The version of the messages. */
export const messageVersion = 1;

/** Events that the page around the frame may ask for. */
export const eventTypes: readonly string[] = [
  'load',
  'error',
  'camera-change',
  'volume-pick',
  'time-change',
  'picture-blank',
  'step-change',
  'answer',
  'tour-complete',
  'height',
];

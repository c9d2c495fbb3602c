import type { ControlTerms } from './terms.ts';

/** Of the controls, which are loaded where a page has them. */
export const english: ControlTerms = {
  controls: 'Controls of the picture',
  playScans: 'Play',
  pauseScans: 'Pause',
  views: 'Views',
  view: {
    front: 'Front', back: 'Back', left: 'Left', right: 'Right', top: 'Top', bottom: 'Bottom',
    south: 'From the south', north: 'From the north', west: 'From the west', east: 'From the east', above: 'From above',
  },
  resetView: 'First view',
  fullscreen: 'Full screen',
  leaveFullscreen: 'Leave full screen',
  more: 'More',
  savePicture: 'Save the picture',
  copyView: 'Copy this view',
  copied: 'Copied: the attributes of this view.',
  copyByHand: 'Copy these attributes:',
  help: 'Help',
  close: 'Close',
  mouseHint: 'Drag to turn. After a click, the wheel zooms.',
  touchHint: 'One finger turns, two fingers move and zoom.',
  saveFailed: 'The picture could not be saved.',
  helpLines: [
    ['Turn', 'Drag, one finger, or arrow keys'],
    ['Move', 'Drag with the right button or Shift, two fingers, or Shift and arrow keys'],
    ['Zoom', 'Wheel after a click, two fingers, or + and −'],
    ['First view', 'Double click, or 0'],
  ],
};

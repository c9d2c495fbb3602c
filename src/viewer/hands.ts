// What hands, and scripts on their behalf, do with a picture: loaded when there is one.
export { CameraInput } from './camera-input.ts';
export { checkIn } from './lazy-check.ts';
export { follow } from './follow-view.ts';
export { pickIn } from './lazy-pick.ts';
export { writeCamera, writeView } from './write-camera.ts';

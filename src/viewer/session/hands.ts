// What hands, and scripts on their behalf, do with a picture: loaded when there is one.
export { CameraInput } from '../camera/camera-input.ts';
export { checkIn } from '../picking/lazy-check.ts';
export { follow } from './follow-view.ts';
export { pickIn } from '../picking/lazy-pick.ts';
export { writeCamera, writeView } from '../view/write-camera.ts';

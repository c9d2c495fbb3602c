// All that a person, or a script instead of a person, does with a picture: loaded with the first picture.
export { CameraInput } from '../camera/camera-input.ts';
export { checkIn } from '../picking/lazy-check.ts';
export { follow } from './follow-view.ts';
export { pickIn, positionIn } from '../picking/lazy-pick.ts';
export { writeCamera, writeLive } from '../view/write-camera.ts';

// The float64 twins that many rays need, in one file: they are loaded together, with the first ray that is cast on the processor.
export { labelField, labelShade } from './attachments/labels.ts';
export { channelField, channelShade } from './attachments/channel-colors.ts';
export { cartesianOverlay, overlayField, overlayStages } from './attachments/overlay.ts';
export { planeInterval } from './attachments/plane-slices.ts';
export { groupClassify, groupShade } from './label-groups.ts';
export { classifyPicture } from './rays/classify-picture.ts';
export { clipInterval, cutoutInterval } from './rays/clip-intervals.ts';
export { pointField } from './rays/lit.ts';
export { projectionGather } from './rays/projection.ts';
export { cartesianField } from './rays/ray-field.ts';
export { compositeGather } from './rays/ray-gather.ts';
export { boxInterval, shapeInterval } from './rays/ray-intervals.ts';
export { jumpGather } from './surfaces/jump-gather.ts';

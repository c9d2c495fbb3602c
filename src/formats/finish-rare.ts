/** What few volumes need when they are finished: a part that is loaded with the first of them. */
export { checkGeometry, refuseRange } from './base/check-geometry.ts';
export { cleanVolume, refuseRadar } from './base/clean-volume.ts';
export { fitColors } from './base/fit-colors.ts';
export { reportNumbers } from './base/report-numbers.ts';

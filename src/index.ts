export { VolumeView } from '../components/volume-view.ts';
export type { CameraChangeDetail, ErrorDetail, ProgressDetail, VolumeViewEventMap } from '../components/volume-view-events.ts';
export type { RenderStats } from './viewer/render-stats.ts';
export type { PictureError } from './quality/error-estimate.ts';
import '../components/companions.ts';
export type { VolumeInfo, VolumeOptics } from './viewer/volume-info.ts';
export { VolumeViewError } from './errors.ts';
export type { ErrorCode } from './errors.ts';
export { presetNames } from './optics/presets.ts';

export { VolumeView } from '../components/volume-view/define.ts';
export type {
  CameraChangeDetail,
  ErrorDetail,
  ProgressDetail,
  VolumeViewEventMap,
} from '../components/internal/volume-view-events.ts';
export type { RenderStats } from './viewer/model/render-stats.ts';
export type { ErrorPart, ErrorParts, PictureError } from './quality/error-estimate.ts';
export type { VolumeInfo, VolumeOptics } from './viewer/model/volume-info.ts';
export type {
  EarthPlace,
  PickOptions,
  RadarGate,
  RadarPlace,
  VolumePick,
  VolumePosition,
} from './viewer/model/volume-pick.ts';
export { VolumeViewError } from './core/errors.ts';
export type { ErrorCode } from './core/errors.ts';
export { presetNames } from './optics/transfer/preset-names.ts';
export { registerTranslation } from './messages/locale-controller.ts';
export type { Messages as Terms } from './messages/messages.ts';

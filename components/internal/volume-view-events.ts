import type { VolumeViewError } from '../../src/core/errors.ts';
import type { Orbit } from '../../src/optics/rays/camera.ts';
import type { PictureCheck } from '../../src/quality/compare-rays.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { RenderStats } from '../../src/viewer/model/render-stats.ts';
import type { BlankPicture } from '../../src/viewer/view/blank-note.ts';
import type { TimeChangeDetail } from '../../src/viewer/loading/scan-player.ts';
import type { VolumePick } from '../../src/viewer/model/volume-pick.ts';
import type { VolumeInfo, VolumeOptics } from '../../src/viewer/model/volume-info.ts';

/** Detail of `progress`. */
export interface ProgressDetail {
  /** Bytes done. */
  readonly loaded: number;
  /** Bytes in all; 0 where nobody knows. */
  readonly total: number;
  /** What is going on. */
  readonly phase: 'fetch' | 'decode';
}

/** Detail of `error`. */
export interface ErrorDetail {
  /** One of the codes of `errors.ts`; they stay from version to version. */
  readonly code: VolumeViewError['code'];
  /** In words: what was got, what was expected, what to do. */
  readonly message: string;
  /** What was caught below it, if anything. */
  readonly cause: unknown;
}

/** Detail of `camera-change`. */
export interface CameraChangeDetail {
  /** Radians, and world units. */
  readonly orbit: Orbit;
  /** World coordinates. */
  readonly target: Vector3;
}

/** The element's own events beside those of every element. */
export interface VolumeViewEventMap extends Omit<HTMLElementEventMap, 'load' | 'progress' | 'error'> {
  load: CustomEvent<VolumeInfo>;
  progress: CustomEvent<ProgressDetail>;
  error: CustomEvent<ErrorDetail>;
  'camera-change': CustomEvent<CameraChangeDetail>;
  'optics-change': CustomEvent<VolumeOptics | null>;
  render: CustomEvent<RenderStats>;
  'time-change': CustomEvent<TimeChangeDetail>;
  'scans-change': CustomEvent<null>;
  'picture-check': CustomEvent<PictureCheck>;
  'picture-blank': CustomEvent<BlankPicture | null>;
  'volume-pick': CustomEvent<VolumePick | null>;
}

/** Listeners that are given the right events. */
export interface VolumeViewListeners {
  addEventListener<K extends keyof VolumeViewEventMap>(
    type: K,
    listener: (event: VolumeViewEventMap[K]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
  removeEventListener<K extends keyof VolumeViewEventMap>(
    type: K,
    listener: (event: VolumeViewEventMap[K]) => void,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | EventListenerOptions): void;
}

/** Fire an event at an element. Here, or the manifest's analyzer takes "type" for an event's name. */
export function tell(element: Element, type: string, detail: unknown): void {
  element.dispatchEvent(new CustomEvent(type, { detail }));
}

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
  /** Bytes done so far. */
  readonly loaded: number;
  /** Total bytes; 0 where the number is unknown. */
  readonly total: number;
  /** The present step. */
  readonly phase: 'fetch' | 'decode';
}

/** Detail of `error`. */
export interface ErrorDetail {
  /** One of the codes of `errors.ts`; they stay the same in later versions. */
  readonly code: VolumeViewError['code'];
  /** A message: what was received, what was expected, what to do. */
  readonly message: string;
  /** The error that caused this one, if any. */
  readonly cause: unknown;
}

/** Detail of `camera-change`. */
export interface CameraChangeDetail {
  /** Radians, and world units. */
  readonly orbit: Orbit;
  /** World coordinates. */
  readonly target: Vector3;
}

/** The element's own events, in addition to those of every element. */
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

/** Methods that give listeners the right event types. */
export interface VolumeViewListeners {
  addEventListener<K extends keyof VolumeViewEventMap>(
    type: K,
    listener: (event: VolumeViewEventMap[K]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<K extends keyof VolumeViewEventMap>(
    type: K,
    listener: (event: VolumeViewEventMap[K]) => void,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}

/**
 * Fire an event at an element. The function is in this file, as the analyzer of the manifest would otherwise take "type" for the name of an
 * event.
 */
export function emit(element: Element, type: string, detail: unknown): void {
  element.dispatchEvent(new CustomEvent(type, { detail }));
}

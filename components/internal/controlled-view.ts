import type { LitElement } from 'lit';
import type { AimedView } from '../../src/viewer/picking/aim.ts';
import type { VolumeInfo } from '../../src/viewer/model/volume-info.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { CameraState } from '../../src/viewer/view/write-camera.ts';

/** What the controls need from the element that they are drawn over. */
export interface ControlledView extends LitElement, AimedView {
  readonly authoring: boolean;
  readonly controls: boolean;
  readonly autoRotate: boolean;
  readonly orientationMarker: boolean;
  readonly camera: CameraState | null;
  readonly cameraOrbit: string | null;
  readonly cameraTarget: Vector3 | null;
  readonly src: string | null;
  readonly files: readonly unknown[] | null;
  readonly linkState: boolean;
  readonly controlslist: string | null;
  readonly interaction: string | null;
  readonly volume: VolumeInfo | null;
  readonly times: readonly (string | null)[];
  readonly paused: boolean;
  play(): Promise<void>;
  pause(): void;
  toBlob(): Promise<Blob>;
  getView(): Record<string, string>;
  getLink(): Promise<string>;
}

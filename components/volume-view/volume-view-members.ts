import type { PictureCheck } from '../../src/quality/compare-rays.ts';
import type { RenderStats } from '../../src/viewer/model/render-stats.ts';
import type { TimeChangeDetail } from '../../src/viewer/loading/scan-player.ts';
import type { VolumeInfo, VolumeOptics } from '../../src/viewer/model/volume-info.ts';
import type { PickOptions, VolumePick } from '../../src/viewer/model/volume-pick.ts';
import type { VolumeSession } from '../../src/viewer/session/volume-session.ts';
import type { CameraState } from '../../src/viewer/view/write-camera.ts';
import { warnOfOldName } from '../internal/deprecated.ts';
import { VolumeViewAttributes } from './volume-view-attributes.ts';

/** What a script reads and calls on `<volume-view>`, beside its attributes: each asks the session. */
export abstract class VolumeViewMembers extends VolumeViewAttributes {
  /** @internal */
  abstract readonly _session: VolumeSession;

  /** The loaded volume: dimensions, spacing, unit, value range, format ...; null before it is there. */
  get volume(): VolumeInfo | null {
    return this._session.presenter.info;
  }

  /** What it looks like: the transfer function's stops, the window, the factors; null before there is a volume. */
  get optics(): VolumeOptics | null {
    return this._session.presenter.look.current;
  }

  /** What the picture is seen through, in radians and world units; null before there is a volume. */
  get camera(): CameraState | null {
    return this._session.viewer?.camera ?? null;
  }

  /** Be at once where attributes, as they are now, or a person send the camera, and not glide there. */
  jumpCameraToGoal(): void {
    void this.updateComplete.then(() => this._session.viewer?.jumpToGoal());
  }

  /** The attributes that show this view again, by their names: the camera's, the editor's, and `time` of several scans; none before there is a picture. */
  getView(): Record<string, string> {
    return this._session.hands?.writeView(this, (name) => this.readText(name)) ?? {};
  }

  /** The last drawn frame; null before the first. */
  get renderStats(): RenderStats | null {
    return this._session.stats;
  }

  /** When the scans of the source began, ISO 8601 in UTC, one for each; null for one of which it is not known, or not yet. */
  get times(): readonly (string | null)[] {
    return this._session.times;
  }

  /** The scan in the picture, a single volume being the first of one; null before there is a picture. */
  get scan(): TimeChangeDetail | null {
    return this._session.scan;
  }

  /** Whether one of several scans has been asked for and is not in the picture yet. */
  get waiting(): boolean {
    return this._session.loader.scans?.waiting ?? false;
  }

  /** Show the next scan. Returns whether there is one; after the last there is none. */
  next(): boolean {
    return this._session.loader.scans?.step(1) ?? false;
  }

  /** Show the previous scan. Returns whether there is one. */
  previous(): boolean {
    return this._session.loader.scans?.step(-1) ?? false;
  }

  /** Whether scans are not gone through; true until `play` is called or `autoplay` begins it. */
  get paused(): boolean {
    return this._session.playback.paused;
  }

  /**
   * Show one scan after the other, and begin again after the last. Resolves when the source is open and its scans play; rejects with a
   * `NotSupportedError` where it has one scan only or could not be loaded, and with an `AbortError` where `pause` is called before. An
   * element far from the visible part of the page plays when it comes near.
   */
  play(): Promise<void> {
    return this._session.play();
  }

  /** Stay at the scan that is shown. */
  pause(): void {
    this._session.playback.pause();
  }

  /** Show one of several scans, whichever was shown or asked for last. @param index - its number, from 0 */
  showScan(index: number): void {
    this._session.loader.showScan(index);
  }

  /** Load the file anew, say after an error; of several scans the one that is wanted. The picture stays until it is there. */
  reload(): void {
    this._session.loader.reload();
  }

  /**
   * Resolves when the picture for the present attributes has been drawn and is final; rejects with the error that the
   * element shows where there will be none. To ask for it loads and draws what is far from the visible part of the page.
   */
  whenRendered(): Promise<void> {
    return this._session.whenRendered();
  }

  /** The old spelling of `whenRendered()`. */
  get renderComplete(): Promise<void> {
    warnOfOldName('the property renderComplete', 'whenRendered()');
    return this.whenRendered();
  }

  /** Draw one frame now with the present settings; resolves when the GPU has finished it. */
  redraw(): Promise<RenderStats> {
    return this._session.redraw();
  }

  /**
   * The picture as a file.
   * @param options - `type`: 'image/png' (default), 'image/webp' or 'image/jpeg'; `width` and `height` in pixels, by default the picture's own
   */
  toBlob(options: { type?: string; width?: number; height?: number } = {}): Promise<Blob> {
    return this._session.toBlob({ type: 'image/png', ...options });
  }

  /**
   * Whether the graphics processor draws the present picture as it should: some of its rays are cast on the processor too, in 64 bits, each
   * time others. Shapes beside the volume are left out. null where the device can't tell, and where nothing of the volume shows.
   */
  async checkPicture(): Promise<PictureCheck | null> {
    await this.whenRendered();
    return this._session.hands?.checkIn(this._session.viewer) ?? null;
  }

  /**
   * What is at a place of the picture, its value and where it is; null where nothing shows, and before there is a picture.
   * @param x - CSS pixels from the left edge of the element, inside its border, as `offsetX` of a mouse event; `y` from the top
   * @param options - `at`: `jump` (default), where the opacity jumps most; `surface`, where it passes a half; `max`, at the largest value that shows
   */
  async pick(x: number, y: number, options?: PickOptions): Promise<VolumePick | null> {
    return this._session.hands?.pickIn(this._session.viewer, [x, y], options) ?? null;
  }
}

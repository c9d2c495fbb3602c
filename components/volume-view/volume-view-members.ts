import type { PictureCheck } from '../../src/quality/compare-rays.ts';
import type { RenderStats } from '../../src/viewer/model/render-stats.ts';
import type { TimeChangeDetail } from '../../src/viewer/loading/scan-player.ts';
import type { LocalFiles } from '../../src/formats/base/load-request.ts';
import type { VolumeInfo, VolumeOptics } from '../../src/viewer/model/volume-info.ts';
import type { PickOptions, VolumePick, VolumePosition } from '../../src/viewer/model/volume-pick.ts';
import type { VolumeSession } from '../../src/viewer/session/volume-session.ts';
import type { CameraState } from '../../src/viewer/view/write-camera.ts';
import { warnOfOldName } from '../internal/deprecated.ts';
import { VolumeViewAttributes } from './volume-view-attributes.ts';

/** Choices of files so far: each has URLs of its own, of a host that no server can have (RFC 2606). */
let choices = 0;

/** The properties and methods of `<volume-view>` for scripts, in addition to its attributes. Each one calls the session. */
export abstract class VolumeViewMembers extends VolumeViewAttributes {
  static {
    // Lit keeps what a script sets before the element is defined.
    this.createProperty('files', { attribute: false, noAccessor: true });
  }

  protected _local?: LocalFiles;
  /** The texts of the attributes that the tag had at first. */
  protected _tag?: Readonly<Record<string, string>>;
  /** @internal */
  abstract readonly _session: VolumeSession;

  /**
   * Files of the reader's disk, of one volume: a `FileList` of `<input type="file">`, an array of `File`, or the handle of a folder, of
   * which all files are read. While it is set, `src` is not used; null where it is not set. Nothing is sent to a server, and no message
   * has the name of a file.
   */
  get files(): readonly (File | FileSystemDirectoryHandle)[] | null {
    return (this._local?.files as readonly File[] | undefined) ?? null;
  }

  set files(files: FileList | readonly File[] | FileSystemDirectoryHandle | null) {
    const given = (files && 'name' in Object(files) ? [files] : files) as readonly { readonly kind?: string }[] | null;
    const copy =
      given?.length === 0 ? null : given && Array.from(given, (file) => (file instanceof Blob || file?.kind) && file);
    this._local = copy ? { base: `https://local-${++choices}.invalid/`, files: copy } : undefined;
    this.requestUpdate('files');
  }

  /**
   * Fetches the files of `src`, and those of the elements inside, in place of the browser's own `fetch`, with the same arguments and result: for instance to send a token.
   * It is used for the loads that begin after it is set; `reload()` begins one. null, or no function, for the browser's own.
   */
  declare fetch?: typeof globalThis.fetch | null;

  /** The loaded volume: dimensions, spacing, unit, value range, format ...; null before it is loaded. */
  get volume(): VolumeInfo | null {
    return this._session.presenter.info;
  }

  /** The present appearance: the stops of the transfer function, the window, the factors; null before there is a volume. */
  get optics(): VolumeOptics | null {
    return this._session.presenter.look.current;
  }

  /** The present camera, in radians and world units; null before there is a volume. */
  get camera(): CameraState | null {
    return this._session.viewer?.camera ?? null;
  }

  /** Move the camera to its goal at once, without an animation. The goal comes from the present attributes, or from a person. */
  jumpCameraToGoal(): void {
    void this.updateComplete.then(() => this._session.viewer?.jumpToGoal());
  }

  /**
   * All that differs from the tag, as texts of attributes by their names: what a person has changed (the camera, the scan), and
   * what an editor, a tour or a script has written. The same tag with these attributes shows the same view.
   */
  getView(): Record<string, string> {
    const live = this._session.interaction?.writeLive(this._session);
    const view: Record<string, string> = {};
    for (const name of (this.constructor as typeof VolumeViewMembers).observedAttributes) {
      const text = live?.[name] ?? this.readText(name);
      if (text !== null && text !== this._tag?.[name]) view[name] = text;
    }
    return view;
  }

  /** The address of this page with the present view: a page with `link-state` opens it there. It is not put into the address bar. */
  async getLink(): Promise<string> {
    return (await import('../../src/viewer/links/link-state.ts')).linkOf(this, this._tag);
  }

  /** Statistics of the last drawn frame; null before the first one. */
  get renderStats(): RenderStats | null {
    return this._session.stats;
  }

  /**
   * When the scans of the source began, one for each scan: ISO 8601 in UTC, or a number with its unit, `12.5 s`, where a file counts from
   * its start; null where the time is not known, or not yet.
   */
  get times(): readonly (string | null)[] {
    return this._session.times;
  }

  /** The scan in the picture; a single volume counts as the first of one scan. null before there is a picture. */
  get scan(): TimeChangeDetail | null {
    return this._session.scan;
  }

  /** Whether one of several scans has been requested and is not in the picture yet. */
  get waiting(): boolean {
    return this._session.loader.scans?.waiting ?? false;
  }

  /** Show the next scan. Returns whether there is one; after the last scan there is none. */
  next(): boolean {
    return this._session.loader.scans?.step(1) ?? false;
  }

  /** Show the previous scan. Returns whether there is one. */
  previous(): boolean {
    return this._session.loader.scans?.step(-1) ?? false;
  }

  /** Whether the scans do not play; true until `play` is called or `autoplay` starts them. */
  get paused(): boolean {
    return this._session.playback.paused;
  }

  /**
   * Show the scans one after the other, and start again after the last. Resolves when the source is open and its scans play. Rejects with a
   * `NotSupportedError` where it has only one scan or could not be loaded, and with an `AbortError` where `pause` is called before. An
   * element far from the visible part of the page starts to play when it comes near.
   */
  play(): Promise<void> {
    return this._session.play();
  }

  /** Stop at the present scan. */
  pause(): void {
    this._session.playback.pause();
  }

  /** Show one of several scans, whichever scan is shown or was requested last. @param index - its number, from 0 */
  showScan(index: number): void {
    this._session.loader.showScan(index);
  }

  /**
   * Load the file again, for instance after an error; of several scans, load the requested one. The present picture stays until the new one
   * is there.
   */
  reload(): void {
    this._session.loader.reload();
  }

  /**
   * Resolves when the picture for the present attributes has been drawn and is final; rejects with the error that the element shows where
   * there can be no picture. Calling it loads and draws the element even if it is far from the visible part of the page.
   */
  whenRendered(): Promise<void> {
    return this._session.whenRendered();
  }

  /** The old name of `whenRendered()`. */
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
   * Check whether the GPU draws the present picture correctly: some of its rays, different ones each time, are computed on the CPU too, in
   * 64 bits. Surfaces and other shapes that are not part of the volume are ignored. null where the device does not allow the check, and
   * where nothing of the volume is visible.
   */
  checkPicture(): Promise<PictureCheck | null> {
    return this._session.checkPicture();
  }

  /**
   * The value at a point of the picture, and its position; null where nothing is visible, and before there is a picture.
   * @param x - CSS pixels from the left edge of the element, inside its border, as `offsetX` of a mouse event; `y` from the top
   * @param options - `at`: `jump` (default), where the opacity rises most steeply; `surface`, where it passes a half; `max`, at the largest
   * visible value; `half`, where half of the final opacity is reached
   */
  async pick(x: number, y: number, options?: PickOptions): Promise<VolumePick | null> {
    return this._session.interaction?.pickIn(this._session.viewer, [x, y], options) ?? null;
  }

  /**
   * The place in the volume that is seen at a point of the page: where half of the final opacity is reached, with its value, and with the
   * share of its light that reaches the eye. null where nothing is seen, outside of the picture, and before there is one.
   * @param clientX - as `clientX` of a mouse event, however the page scales or turns the element; `clientY` alike
   */
  async positionFromPoint(clientX: number, clientY: number): Promise<VolumePosition | null> {
    return this._session.interaction?.positionIn(this._session.viewer, { clientX, clientY }) ?? null;
  }
}

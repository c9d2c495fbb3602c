import type { VolumeViewError } from '../../core/errors.ts';
import type { PictureCheck } from '../../quality/compare-rays.ts';
import { ErrorState } from '../model/error-state.ts';
import type { Aspect, ErrorListener } from '../model/error-state.ts';
import { PageConnection } from './page-connection.ts';
import type { PagePlace, ConnectionListener } from './page-connection.ts';
import { PendingWork } from '../model/pending-work.ts';
import type { RingWriter } from '../cuts/ring-labels.ts';
import { loadPart } from '../../core/load-part.ts';
import { Playback } from '../loading/playback.ts';
import { Visibility } from '../scenes/visibility.ts';
import type { RenderStats } from '../model/render-stats.ts';
import type { TimeChangeDetail } from '../loading/scan-player.ts';
import type { SceneFactory } from '../model/scene.ts';
import { isSameReading } from '../model/settings.ts';
import type { Settings } from '../model/settings.ts';
import type { FileGoal } from '../frames/take-picture.ts';
import { SourceLoader } from './source-loader.ts';
import type { FetchingElement } from './source-loader.ts';
import type { LoaderHost } from './source-loader.ts';
import type { Viewer } from '../view/viewer.ts';
import { VolumePresenter } from '../view/volume-presenter.ts';
import type { PresenterHost } from '../view/volume-presenter.ts';

/** What a session reports to its element. */
export interface SessionListener {
  /** Progress, the shown error, the volume, or whether there is a picture, has changed. */
  changed(): void;
  /** Send an event to the page. */
  emit(type: string, detail: unknown): void;
  /** Write the label of a ring around a radar, see ViewerListener. */
  labelRing: RingWriter;
  /** Resolves when changed settings have been applied; null where none are pending. */
  settingsComing(): Promise<unknown> | null;
}

/**
 * All that a <volume-view> does, without the element: settings come in by `apply`, and go to the classes that load (SourceLoader),
 * show volumes with appearance and cuts (VolumePresenter), play (Playback) and draw (Viewer). These classes keep the state that a
 * person changes; nothing is ever written back into the settings.
 */
export class VolumeSession implements LoaderHost, PresenterHost, ErrorListener, ConnectionListener {
  readonly errors = new ErrorState(this);
  readonly presenter: VolumePresenter;
  readonly playback = new Playback((event) => {
    this.emit(event, null);
    this.scansChanged();
    this.changed();
  });
  readonly loader: SourceLoader;
  #settings: Settings | null = null;
  #connection: PageConnection | null = null;
  #stats: RenderStats | null = null;
  #hasPicture = false;
  /** Resolves when a person can move the camera. */
  #interaction: Promise<void> | null = null;
  readonly #work = new PendingWork();
  readonly #visibility = new Visibility(() => this.#followVisibility());

  constructor(
    readonly host: FetchingElement,
    readonly scenes: SceneFactory,
    readonly listener: SessionListener,
  ) {
    this.presenter = new VolumePresenter(this, this.errors);
    this.loader = new SourceLoader(this, this);
  }

  labelRing(what: Parameters<RingWriter>[0]): string {
    return this.listener.labelRing(what);
  }

  /** The code for interaction; null before there is a picture. */
  get interaction(): PageConnection['interaction'] {
    return this.#connection?.interaction ?? null;
  }

  /** null while the element is in no page. */
  get viewer(): Viewer | null {
    return this.#connection?.viewer ?? null;
  }

  /** Available after the first call of `apply`. */
  get settings(): Settings {
    return this.#settings!;
  }

  /** The last drawn frame. */
  get stats(): RenderStats | null {
    return this.#stats;
  }

  /** Whether a picture is on the page. */
  get hasPicture(): boolean {
    return this.#hasPicture;
  }

  /** When the scans of the source began, as far as it is known. */
  get times(): readonly (string | null)[] {
    const { scans, isCurrent } = this.loader;
    const { info } = this.presenter;
    if (scans) return scans.times;
    return info && isCurrent ? [info.time ?? null] : [];
  }

  /** The scan in the picture. */
  get scan(): TimeChangeDetail | null {
    const { scans } = this.loader;
    if (scans) return scans.shown;
    const [time] = this.times;
    return time === undefined ? null : { index: 0, time, count: 1 };
  }

  /** Play the scans. @throws {DOMException} see Playback */
  async play(): Promise<void> {
    const playing = this.playback.play();
    void this.#refuseToPlayNothing();
    return playing;
  }

  async #refuseToPlayNothing(): Promise<void> {
    await this.listener.settingsComing();
    if (!this.loader.scans && !this.loader.isExpecting) this.playback.giveUp();
  }

  /** Apply settings that may have changed. @param placed - whether to place the camera again, even at the same place as before */
  apply(settings: Settings, placed: boolean): void {
    const before = this.#settings;
    this.#settings = settings;
    const changed = (name: 'look' | 'limits' | 'quality' | 'region' | 'rings' | 'playSpeed'): boolean =>
      !before || !isSameReading(before[name], settings[name]);
    if (before && before.eager !== settings.eager) this.#followVisibility();
    const [source, sourceBefore] = [settings, before].map((one) => JSON.stringify([one?.src, one?.stack, one?.source]));
    if (source !== sourceBefore) this.loader.load();
    else if (changed('look')) this.#readAppearance();
    if (settings.autoplay && before?.autoplay === false && this.loader.scans) this.playback.startByItself();
    if (changed('playSpeed')) this.#readSpeed();
    if (!this.#connection) return;
    if (changed('limits')) this.#readLimits();
    if (placed) this.#readCamera();
    if (changed('quality')) this.#readQuality();
    if (changed('region') || changed('rings')) this.presenter.cutAgain();
    if (before?.controls !== settings.controls && this.#hasPicture) this.#addInteraction();
  }

  /** The element has come into a page. */
  enter({ picture, container }: PagePlace): void {
    if (this.#connection) return;
    const { host, scenes, loader, presenter } = this;
    this.#connection = new PageConnection(picture, { host, container, scenes, visibility: this.#visibility }, this);
    presenter.viewer = this.#connection.viewer;
    this.#readLimits();
    this.#readCamera();
    this.#readQuality();
    this.#connection.watch(this.#visibility);
    this.motionChanged();
    if (loader.scans && loader.isCurrent) loader.showWanted();
    else if (presenter.volume && (loader.isCurrent || !this.settings.src)) presenter.look.readAgain();
    else loader.load();
  }

  motionChanged(): void {
    this.playback.motionChanged(this.settings.autoplay);
  }

  /** The element has left its page: stop all work, and free the GPU. */
  leave(): void {
    this.loader.leave();
    this.#connection?.dispose();
    this.#connection = null;
    this.presenter.viewer = null;
    this.#hasPicture = false;
    this.changed();
  }

  /** Resolves when the picture for the present settings is final. @throws the error that is shown */
  whenRendered(): Promise<void> {
    return this.#visibility.ask(() => this.#settle());
  }

  redraw(): Promise<RenderStats> {
    return this.#visibility.ask(async () => {
      await this.#workDone();
      return this.#requireViewer().redraw();
    });
  }

  toBlob(goal: FileGoal): Promise<Blob> {
    return this.#visibility.ask(async () => {
      await this.#settle();
      return this.#requireViewer().toBlob(goal);
    });
  }

  checkPicture(): Promise<PictureCheck | null> {
    return this.#visibility.ask(async () => {
      await this.#settle();
      return this.interaction?.checkIn(this.viewer) ?? null;
    });
  }

  async #settle(): Promise<void> {
    // The first picture may start more work, as of bricks.
    await this.#workDone();
    await this.viewer?.settled();
    await this.#workDone();
    await this.viewer?.settled();
    await this.#interaction;
    const { first } = this.errors;
    if (first && first.code !== 'webgl/inaccurate') throw first; // With this error there is still a picture.
  }

  #workDone(): Promise<void> {
    return this.#work.done(() => this.listener.settingsComing());
  }

  #requireViewer(): Viewer {
    const { viewer } = this;
    if (!viewer?.ready) throw this.errors.first ?? new Error('no volume is loaded yet; wait for the load event');
    return viewer;
  }

  #followVisibility(): void {
    this.loader.followVisibility();
    this.viewer?.followVisibility();
  }

  #readAppearance(): void {
    const { look: appearance } = this.presenter;
    if (this.loader.isLoading) appearance.readLater();
    else appearance.readAgain();
  }

  /** Without a picture there is nothing to turn: the code for interaction is loaded with the first picture. */
  #addInteraction(): void {
    this.#interaction = this.#connection!.setControls(this.settings.controls).then(
      () => this.interaction?.follow(this.host, this.presenter),
      (error: unknown) => this.errors.report('camera', error),
    );
  }

  #readCamera(): void {
    this.errors.take('camera', this.settings.camera, (camera) => this.viewer?.setCamera(camera));
  }

  #readLimits(): void {
    this.errors.take('limits', this.settings.limits, (limits) => this.viewer?.setLimits(limits));
  }

  #readQuality(): void {
    this.errors.take('steps', this.settings.quality, (quality) => this.viewer?.setQuality(quality));
  }

  #readSpeed(): void {
    this.errors.take('play', this.settings.playSpeed, (speed) => this.playback.setSpeed(speed));
    this.scansChanged();
  }

  // What the parts of the session need of it and report to it.

  get inPage(): boolean {
    return this.#connection !== null;
  }

  get awake(): boolean {
    return this.#visibility.awake || this.#settings?.eager === true;
  }

  get inSight(): boolean {
    return this.#visibility.inSight;
  }

  get file(): string {
    return this.settings.src ?? '';
  }

  /** Without a source there is no picture, as with an image; the poster appears again. */
  sourceGone(): void {
    this.#stats = null;
    if (!this.#connection) return;
    const { picture, viewer } = this.#connection;
    this.leave();
    this.enter({ picture, container: viewer.place.container });
  }

  rendered(stats: RenderStats): void {
    this.#stats = stats;
    if (!this.#hasPicture) {
      this.#hasPicture = true;
      this.#addInteraction();
    }
    this.changed();
    this.errors.clear('scene');
    this.emit('render', stats);
    if (this.presenter.isInPicture) this.loader.scans?.drawn();
  }

  cameraMoved(): void {
    const camera = this.viewer?.camera;
    if (camera) this.emit('camera-change', { orbit: camera.orbit, target: camera.target });
  }

  slicesChanged(isLook?: boolean): void {
    if (isLook)
      this.presenter.followNodes(
        () => loadPart(import('../attachments/read-volume-nodes.ts'), 'reads styles'),
        () => this.#readAppearance(),
      );
    else this.presenter.cutAgain();
  }

  changed(): void {
    this.listener.changed();
  }

  scansChanged(): void {
    this.emit('scans-change', null);
  }

  emit(type: string, detail: unknown): void {
    this.listener.emit(type, detail);
  }

  track(work: Promise<unknown>): void {
    this.#work.track(work);
  }

  drawingFailed(error: unknown): void {
    this.errors.report('scene', error);
  }

  failed(aspect: Aspect, { code, message, cause }: VolumeViewError): void {
    if (aspect === 'source') this.loader.fail();
    this.emit('error', { code, message, cause });
  }
}

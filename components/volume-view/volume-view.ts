import { html, nothing } from 'lit';
import type { LitElement, PropertyValues } from 'lit';
import { query } from 'lit/decorators.js';
import { readControls, readSettings } from '../../src/viewer/model/settings.ts';
import { VolumeSession } from '../../src/viewer/session/volume-session.ts';
import { english } from '../../src/messages/english-view.ts';
import { Words } from '../../src/messages/words.ts';
import { companionComing } from '../internal/coming-companions.ts';
import { CustomStates } from '../internal/custom-states.ts';
import { LazyPart } from '../internal/lazy-part.ts';
import { OwnSize } from '../internal/own-size.ts';
import { tell } from '../internal/volume-view-events.ts';
import type { VolumeViewListeners } from '../internal/volume-view-events.ts';
import { VolumeViewMembers } from './volume-view-members.ts';
import { describeRing, describeStatus, renderError, renderPoster, renderProgress } from './volume-view-parts.ts';
import { styles } from './volume-view-styles.ts';
import { x3dScenes } from '../internal/x3d-scenes.ts';
import { keepScenesFromX3dom } from '../../src/x3d/own-scenes.ts';

/**
 * A volume in the page: a CT, an MRI or any other scan, drawn with correct opacity, turning under mouse, finger and
 * keys. X3D elements between the tags (`<shape>`, `<viewpoint>`, `<directionallight>` ...) are live parts of the scene.
 *
 * @tag volume-view
 * @slot - X3D elements that join the scene, X3D's volume styles that draw it, and `<volume-slice>` elements that cut it, `<volume-labels>` that name its parts, a `<volume-layer>` over it, `<volume-surface>` and `<volume-terrain>` that stand in it
 * @slot poster - what stands there until the first picture, instead of the `poster` image
 * @slot progress - what is shown while a file loads, instead of the bar
 * @slot error - what is shown when something failed, instead of the message
 * @csspart picture - the picture, which takes the focus
 * @csspart poster - the poster image
 * @csspart progress - around the progress bar
 * @csspart error - around the error message
 * @csspart retry - the button in it that loads the file once more
 * @csspart controls - around all of the `controls`
 * @csspart controls-bar - the bar of buttons
 * @csspart controls-panel - what a button opens: views, more, help
 * @csspart controls-hint - what is said at first
 * @csspart control - each button
 * @csspart marker - around the letters of `orientation-marker`
 * @csspart marker-side - each of them
 * @csspart blank - the words over a picture at rest in which nothing is to be seen
 * @csspart notice-sign - the sign that something of a file is not in the picture, or not as it is there
 * @csspart notice-text - what it says when it is pointed at, has the focus or is pressed
 * @csspart refining - the line at the lower edge while a picture that takes long is made finer
 * @cssproperty --volume-view-focus-color - colour of the frame around the picture that has the focus
 * @cssproperty --volume-view-progress-color - colour of the progress bar
 * @cssproperty --volume-view-error-background - what is behind an error message
 * @cssproperty --volume-view-error-color - its colour
 * @cssproperty --volume-view-controls-background - what is behind the controls
 * @cssproperty --volume-view-controls-color - their colour
 * @cssproperty --volume-view-blank-background - what is behind the words over a picture that shows nothing
 * @cssproperty --volume-view-blank-color - their colour
 * @cssproperty --volume-view-notice-color - colour of the sign for what of a file is not in the picture, and of its words
 * @cssproperty --volume-view-notice-background - what is behind both
 * @cssproperty --volume-view-refining-color - colour of the line while a picture is made finer
 * @cssproperty --volume-view-marker-color - colour of the letters and lines of `orientation-marker`
 * @cssproperty --volume-view-marker-background - what is behind its letters
 * @cssproperty --volume-view-marker-hover - the same under the pointer
 * @cssproperty --volume-view-marker-size - its side; 96px by default
 * @cssproperty --volume-view-label-color - colour of the labels of rings
 * @fires {CustomEvent<VolumeInfo>} load - a volume has been loaded; the detail describes it
 * @fires {CustomEvent<ProgressDetail>} progress - bytes came in or were decoded
 * @fires {CustomEvent<ErrorDetail>} error - something failed; the last good picture stays
 * @fires {CustomEvent<CameraChangeDetail>} camera-change - a person moved the camera; after each frame of the movement
 * @fires {CustomEvent<VolumeOptics | null>} optics-change - the volume looks otherwise; null where it is gone
 * @fires {CustomEvent<RenderStats>} render - a frame has been drawn
 * @fires {CustomEvent<PictureCheck>} picture-check - a picture at rest was checked, see `self-check`
 * @fires {CustomEvent<BlankPicture | null>} picture-blank - a picture at rest shows nothing, though it should: the detail says why, in words too; null as soon as something shows again
 * @fires {CustomEvent<VolumePick | null>} volume-pick - a place was pointed at, see `pickable`; the detail says what is there, null for nothing
 * @fires {CustomEvent<TimeChangeDetail>} time-change - of several scans, another one is in the picture
 * @fires {CustomEvent<null>} play - scans begin to be gone through
 * @fires {CustomEvent<null>} pause - they no longer are: `pause` was called, or all of them failed
 * @fires {CustomEvent<null>} scans-change - the list of scans, their times, or whether they play or load has changed
 */
// oxlint-disable-next-line typescript/no-unsafe-declaration-merging -- only overloads are merged in, see below
export class VolumeView extends VolumeViewMembers {
  static override readonly styles = styles;

  @query('.picture') private readonly _picture!: HTMLElement | null;
  @query('.scene') private readonly _sceneHost!: HTMLElement;
  /** @internal */
  override readonly _session: VolumeSession = new VolumeSession(this, x3dScenes, {
    changed: () => this.requestUpdate(),
    emit: (type, detail) => tell(this, type, detail),
    labelRing: (what) => describeRing(what, this.#words),
    settingsComing: () => (this.isUpdatePending ? this.updateComplete : companionComing(this)),
  });
  readonly #states = new CustomStates<'loading' | 'error' | 'playing'>(this);
  readonly #words = new Words(this, english);
  readonly #controls = new LazyPart(this, async () => new (await import('./view-controls.ts')).ViewControls(this, () => this._session.viewer));
  readonly #notices = new LazyPart(this, async () => new (await import('../internal/view-notices.ts')).ViewNotices(this, () => this._session.presenter));
  readonly #size = new OwnSize();

  /** Let the picture take the focus, and keys turn it. */
  override focus(options?: FocusOptions): void {
    this._picture?.focus(options);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    keepScenesFromX3dom(this);
    if (this.hasUpdated) this.#enter();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    // Being moved within the page takes an element out and puts it back at once: only a real goodbye takes it down.
    queueMicrotask(() => {
      if (!this.isConnected) this._session.leave();
    });
  }

  /** What watches the page and draws in it belongs to the document before. */
  override adoptedCallback(): void {
    super.adoptedCallback();
    this._session.leave();
    void import('../internal/frame-gone.ts').then(({ onFrameGone }) => onFrameGone(this, () => this._session.leave()), () => {});
  }

  override attributeChangedCallback(name: string, before: string | null, value: string | null): void {
    super.attributeChangedCallback(name, before, value);
    if (name === 'play' && value === null) this.pause(); // The old attribute was a switch.
  }

  protected override readSeen(attribute: 'camera-orbit' | 'camera-target'): string | null {
    const { hands, viewer } = this._session;
    const written = this.readText(attribute);
    const camera = written === null || viewer?.leftAttributes ? this.camera : null;
    return (camera && hands?.writeCamera(camera)[attribute]) ?? written;
  }

  protected override updated(changed: PropertyValues<this>): void {
    const { viewer, loader, errors, playback, hands, presenter } = this._session;
    viewer?.relabel();
    void hands?.follow(this, presenter);
    this.#states.set('loading', loader.progress !== null && !errors.first);
    this.#states.set('error', errors.first !== null);
    this.#states.set('playing', !playback.paused);
    this.#controls.follow(this.controls || this.autoRotate || this.orientationMarker);
    this.#notices.follow(presenter.hasNotices);
    if (changed.size === 0) return; // What the session itself told is shown now.
    const { given } = this;
    this.#size.set(this.shadowRoot!, given.width, given.height);
    this._session.apply(readSettings(given), (['cameraOrbit', 'cameraTarget', 'fieldOfView'] as const).some((name) => changed.has(name)));
    if (changed.has('time')) loader.showTime();
    if (this.isConnected) this.#enter();
  }

  protected override render(): unknown {
    const { loader, presenter, errors: { first: failure }, hasPicture } = this._session;
    const { terms } = this.#words;
    const controls = readControls(this.interaction);
    const decorative = this.alt === '' && !controls;
    const label = (this.alt ?? presenter.info?.title) || terms.volumePicture;
    return html`
      <div class="picture" part="picture" role=${decorative ? 'presentation' : 'img'} aria-label=${decorative ? nothing : label}
        aria-describedby=${controls ? 'keys' : nothing} tabindex=${controls ? '0' : nothing}
      ><div class="scene"></div></div>
      ${hasPicture ? nothing : renderPoster(this.poster)}
      ${loader.progress && !failure ? renderProgress(loader.progress, terms) : nothing}
      ${hasPicture ? [this.#controls.render(), this.#notices.render()] : nothing}
      ${failure ? renderError(failure, terms, this.#retry) : nothing}
      <div class="status" role="status">${failure ? '' : describeStatus(loader.progress, hasPicture, this.#words)}</div>
      <div class="status" id="keys" hidden>${terms.cameraKeys}</div>
    `;
  }

  readonly #retry = (): void => {
    this.focus(); // The button goes with its error; what reads by keys goes on at the picture.
    this.reload();
  };

  #enter(): void {
    if (this.ownerDocument.defaultView) this._session.enter({ picture: this._picture!, container: this._sceneHost });
  }
}

// Listeners get the right event types. Declaring the overloads by merging leaves the class's code alone.
// oxlint-disable-next-line typescript/no-unsafe-declaration-merging
export interface VolumeView {
  addEventListener: VolumeViewListeners['addEventListener'] & LitElement['addEventListener'];
  removeEventListener: VolumeViewListeners['removeEventListener'] & LitElement['removeEventListener'];
}

declare global {
  interface HTMLElementTagNameMap { 'volume-view': VolumeView }
}

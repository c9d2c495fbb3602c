import { html, nothing } from 'lit';
import type { LitElement, PropertyValues } from 'lit';
import { query } from 'lit/decorators.js';
import { readControls, readSettings } from '../../src/viewer/model/settings.ts';
import { VolumeSession } from '../../src/viewer/session/volume-session.ts';
import { english } from '../../src/messages/english-view.ts';
import { LocaleController } from '../../src/messages/locale-controller.ts';
import { companionComing } from '../internal/coming-companions.ts';
import { CustomStates } from '../internal/custom-states.ts';
import { LazyPart } from '../internal/lazy-part.ts';
import { OwnSize } from '../internal/own-size.ts';
import { emit } from '../internal/volume-view-events.ts';
import type { VolumeViewListeners } from '../internal/volume-view-events.ts';
import { VolumeViewMembers } from './volume-view-members.ts';
import { describeRing, describeStatus, renderError, renderPoster, renderProgress } from './volume-view-parts.ts';
import { styles } from './volume-view-styles.ts';
import { x3dScenes } from '../internal/x3d-scenes.ts';
import { keepScenesFromX3dom } from '../../src/x3d/own-scenes.ts';

/**
 * A volume in the page: a CT, an MRI or any other scan, drawn with correct opacity. Mouse, finger and
 * keys turn it. X3D elements between the tags (`<shape>`, `<viewpoint>`, `<directionallight>` ...) are live parts of the scene.
 *
 * @tag volume-view
 * @slot - X3D elements that become part of the scene, X3D's volume styles that draw the volume, `<volume-slice>` elements that cut it, `<volume-labels>` that name its parts, a `<volume-layer>` over it, `<volume-surface>` and `<volume-terrain>` that stand in it
 * @slot poster - shown until the first picture, instead of the `poster` image
 * @slot progress - shown while a file loads, instead of the bar
 * @slot error - shown when something failed, instead of the message
 * @csspart picture - the picture, which takes the focus
 * @csspart poster - the poster image
 * @csspart progress - the box around the progress bar
 * @csspart error - the box around the error message
 * @csspart retry - the button in the error message that loads the file again
 * @csspart controls - the box around all of the `controls`
 * @csspart controls-bar - the bar of buttons
 * @csspart controls-panel - the panel that a button opens: views, more, help
 * @csspart controls-hint - the text that is shown at first
 * @csspart control - each button of the controls
 * @csspart marker - the box around the letters of `orientation-marker`
 * @csspart marker-side - each letter
 * @csspart authoring - the panel of `authoring`
 * @csspart blank - the text over a picture at rest in which nothing is visible
 * @csspart notice-sign - the sign that a part of a file is not in the picture, or is shown differently
 * @csspart notice-text - its text, shown when the sign is pointed at, has the focus or is pressed
 * @csspart refining - the line at the lower edge while a picture is being refined for a long time
 * @cssproperty --volume-view-focus-color - colour of the frame around the picture that has the focus
 * @cssproperty --volume-view-progress-color - colour of the progress bar
 * @cssproperty --volume-view-error-background - background of an error message
 * @cssproperty --volume-view-error-color - colour of the text of an error message
 * @cssproperty --volume-view-controls-background - background of the controls
 * @cssproperty --volume-view-controls-color - colour of the controls
 * @cssproperty --volume-view-blank-background - background of the text over a picture that shows nothing
 * @cssproperty --volume-view-blank-color - colour of this text
 * @cssproperty --volume-view-notice-color - colour of the sign for parts of a file that are not in the picture, and of its text
 * @cssproperty --volume-view-notice-background - background of the sign and of its text
 * @cssproperty --volume-view-refining-color - colour of the line while a picture is being refined
 * @cssproperty --volume-view-marker-color - colour of the letters and lines of `orientation-marker`
 * @cssproperty --volume-view-marker-background - background of the letters of `orientation-marker`
 * @cssproperty --volume-view-marker-hover - background of a letter under the pointer
 * @cssproperty --volume-view-marker-size - width and height of `orientation-marker`; 96px by default
 * @cssproperty --volume-view-label-color - colour of the labels of rings
 * @fires {CustomEvent<VolumeInfo>} load - a volume has been loaded; the detail describes it
 * @fires {CustomEvent<ProgressDetail>} progress - bytes have arrived or have been decoded
 * @fires {CustomEvent<ErrorDetail>} error - something failed; the last good picture stays
 * @fires {CustomEvent<CameraChangeDetail>} camera-change - a person has moved the camera; fired after each frame of the movement
 * @fires {CustomEvent<VolumeOptics | null>} optics-change - the appearance of the volume has changed; null when the volume is gone
 * @fires {CustomEvent<RenderStats>} render - a frame has been drawn
 * @fires {CustomEvent<PictureCheck>} picture-check - a picture at rest was checked, see `self-check`
 * @fires {CustomEvent<BlankPicture | null>} picture-blank - a picture at rest shows nothing, though it should: the detail gives the reason, in words too; null as soon as something is visible again
 * @fires {CustomEvent<VolumePick | null>} volume-pick - a place was clicked, see `pickable`; the detail describes it, null where nothing is visible
 * @fires {CustomEvent<TimeChangeDetail>} time-change - another one of several scans is in the picture
 * @fires {CustomEvent<null>} play - scans start to play
 * @fires {CustomEvent<null>} pause - scans no longer play: `pause` was called, or all scans failed
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
    emit: (type, detail) => emit(this, type, detail),
    labelRing: (what) => describeRing(what, this.#locale),
    settingsComing: () => (this.isUpdatePending ? this.updateComplete : companionComing(this)),
  });
  readonly #states = new CustomStates<'loading' | 'error' | 'playing'>(this);
  readonly #locale = new LocaleController(this, english);
  readonly #controls = new LazyPart(
    this,
    async () => new (await import('./view-controls.ts')).ViewControls(this, () => this._session.viewer),
  );
  readonly #notices = new LazyPart(
    this,
    async () => new (await import('../internal/view-notices.ts')).ViewNotices(this, () => this._session.presenter),
  );
  readonly #size = new OwnSize();

  /** Give the focus to the picture, so that keys turn it. */
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
    // Moving an element within the page disconnects it and connects it again at once: the session ends only if the element stays out.
    queueMicrotask(() => {
      if (!this.isConnected) this._session.leave();
    });
  }

  /** The observers and the scene belong to the previous document. */
  override adoptedCallback(): void {
    super.adoptedCallback();
    this._session.leave();
    void import('../internal/frame-gone.ts').then(
      ({ onFrameGone }) => onFrameGone(this, () => this._session.leave()),
      () => {},
    );
  }

  override attributeChangedCallback(name: string, before: string | null, value: string | null): void {
    super.attributeChangedCallback(name, before, value);
    if (name === 'play' && value === null) this.pause(); // The old attribute was a switch.
  }

  protected override readSeen(attribute: 'camera-orbit' | 'camera-target'): string | null {
    const { interaction, viewer } = this._session;
    const written = this.readText(attribute);
    const camera = written === null || viewer?.leftAttributes ? this.camera : null;
    return (camera && interaction?.writeCamera(camera)[attribute]) ?? written;
  }

  protected override updated(changed: PropertyValues<this>): void {
    const { viewer, loader, errors, playback, interaction, presenter } = this._session;
    viewer?.relabel();
    void interaction?.follow(this, presenter);
    this.#states.set('loading', loader.progress !== null && !errors.first);
    this.#states.set('error', errors.first !== null);
    this.#states.set('playing', !playback.paused);
    this.#controls.follow(this.controls || this.autoRotate || this.orientationMarker || this.authoring);
    this.#notices.follow(presenter.hasNotices);
    if (changed.size === 0) return; // The update shows a change in the session; no attribute has changed.
    this._tag ??= this.getView();
    const { given } = this;
    this.#size.set(this.shadowRoot!, given.width, given.height);
    this._session.apply(
      readSettings(given, this._local),
      (['cameraOrbit', 'cameraTarget', 'fieldOfView'] as const).some((name) => changed.has(name)),
    );
    if (changed.has('time')) loader.showTime();
    if (changed.has('linkState')) this.getLink().catch(console.warn); // The code for links follows the address from now on.
    if (this.isConnected) this.#enter();
  }

  protected override render(): unknown {
    const {
      loader,
      presenter,
      errors: { first: failure },
      hasPicture,
    } = this._session;
    const { messages } = this.#locale;
    const controls = readControls(this.interaction);
    const decorative = this.alt === '' && !controls;
    const label = (this.alt ?? presenter.info?.title) || messages.volumePicture;
    return html`
      <div class="picture" part="picture" role=${decorative ? 'presentation' : 'img'} aria-label=${decorative ? nothing : label}
        aria-describedby=${controls ? 'keys' : nothing} tabindex=${controls ? '0' : nothing}
      ><div class="scene"></div></div>
      ${hasPicture ? nothing : renderPoster(this.poster)}
      ${loader.progress && !failure ? renderProgress(loader.progress, messages) : nothing}
      ${hasPicture ? [this.#controls.render(), this.#notices.render()] : nothing}
      ${failure ? renderError(failure, messages, this.#retry) : nothing}
      <div class="status" role="status">${failure ? '' : describeStatus(loader.progress, hasPicture, this.#locale)}</div>
      <div class="status" id="keys" hidden>${messages.cameraKeys}</div>
    `;
  }

  readonly #retry = (): void => {
    this.focus(); // The button disappears with the error; keyboard users go on at the picture.
    this.reload();
  };

  #enter(): void {
    if (this.ownerDocument.defaultView) this._session.enter({ picture: this._picture!, container: this._sceneHost });
  }
}

// Listeners get the right event types. The overloads are merged into the type, so the code of the class does not change.
// oxlint-disable-next-line typescript/no-unsafe-declaration-merging
export interface VolumeView {
  addEventListener: VolumeViewListeners['addEventListener'] & LitElement['addEventListener'];
  removeEventListener: VolumeViewListeners['removeEventListener'] & LitElement['removeEventListener'];
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-view': VolumeView;
  }
}

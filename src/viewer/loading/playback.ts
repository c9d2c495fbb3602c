import { prefersLessMotion } from '../scenes/page-watcher.ts';
import type { ScanPlayer } from './scan-player.ts';
import { defaultPlaySpeed } from '../model/settings.ts';

/** A caller that waits until scans play. */
interface Waiting {
  readonly resolve: () => void;
  readonly reject: (reason: DOMException) => void;
}

/**
 * Whether scans play, as a person or a script wants it: state of the viewer, which stays when the source changes. It uses the
 * words of media elements.
 */
export class Playback {
  #player: ScanPlayer | null = null;
  #isOn = false;
  #speed = defaultPlaySpeed;
  #waiting: Waiting[] = [];
  /** It plays only because of `autoplay`: nobody has called for it since. */
  #byItself = false;
  /** `autoplay` would start it, but a person has asked their system for less motion. */
  #isHeld = false;

  /** @param notify - called when playing starts or ends */
  constructor(readonly notify: (event: 'play' | 'pause') => void) {}

  get paused(): boolean {
    return !this.#isOn;
  }

  /** Scans a second. */
  setSpeed(speed: number): void {
    this.#speed = speed;
    this.#apply();
  }

  /** Start to play the scans, or play them once they are loaded. */
  start(): void {
    this.#byItself = this.#isHeld = false;
    if (this.#isOn) return;
    this.#isOn = true;
    this.#apply();
    this.notify('play');
  }

  /** The same, but only because of `autoplay`: not while a person wants less motion. */
  startByItself(): void {
    if (this.#isOn) return;
    this.#isHeld = prefersLessMotion();
    if (this.#isHeld) return;
    this.start();
    this.#byItself = true;
  }

  /** Called when a person may want less motion, or no longer. @param autoplay - whether it may start without a call */
  motionChanged(autoplay: boolean): void {
    if (this.#isHeld && autoplay) this.startByItself();
    else if (this.#byItself && prefersLessMotion()) {
      this.pause();
      this.#isHeld = true;
    }
  }

  /**
   * The same as `start`; resolves when scans play.
   * @throws {DOMException} `AbortError` where it is paused before that, `NotSupportedError` where there is at most one scan
   */
  play(): Promise<void> {
    this.start();
    if (this.#player) return Promise.resolve();
    return new Promise((resolve, reject) => this.#waiting.push({ resolve, reject }));
  }

  pause(): void {
    this.#refuse(new DOMException('play() was followed by pause()', 'AbortError'));
    this.#byItself = this.#isHeld = false;
    if (!this.#isOn) return;
    this.#isOn = false;
    this.#apply();
    this.notify('pause');
  }

  /** A source with several scans is open. @param autoplay - whether it may start without a call */
  follow(player: ScanPlayer, autoplay: boolean): void {
    this.#player = player;
    if (autoplay) this.startByItself();
    this.#apply();
    for (const { resolve } of this.#waiting.splice(0)) resolve();
  }

  /** Another source was requested. */
  forget(): void {
    this.#player = null;
    this.#isHeld = false;
  }

  /** There are no scans to play: the source has only one, or failed to load. */
  giveUp(): void {
    this.#refuse(new DOMException('play() got one scan at most; expected a source of several', 'NotSupportedError'));
    this.pause();
  }

  #apply(): void {
    this.#player?.play({ on: this.#isOn, speed: this.#speed });
  }

  #refuse(reason: DOMException): void {
    for (const { reject } of this.#waiting.splice(0)) reject(reason);
  }
}

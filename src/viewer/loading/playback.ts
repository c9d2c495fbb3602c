import { prefersLessMotion } from '../scenes/page-watcher.ts';
import type { ScanPlayer } from './scan-player.ts';
import { defaultPlaySpeed } from '../model/settings.ts';

/** Somebody who waits until scans play. */
interface Waiting {
  readonly resolve: () => void;
  readonly reject: (reason: DOMException) => void;
}

/**
 * Whether scans are gone through, as a person or a script wants it: state of the viewer, which outlives a source. It
 * speaks as media elements do.
 */
export class Playback {
  #player: ScanPlayer | null = null;
  #isOn = false;
  #speed = defaultPlaySpeed;
  #waiting: Waiting[] = [];
  /** It plays as `autoplay` says so, and nobody asked for it since. */
  #byItself = false;
  /** `autoplay` would have it play; a person has asked their system for less motion. */
  #isHeld = false;

  /** @param told - is told when it begins or ends */
  constructor(readonly told: (event: 'play' | 'pause') => void) {}

  get paused(): boolean {
    return !this.#isOn;
  }

  /** Scans a second. */
  setSpeed(speed: number): void {
    this.#speed = speed;
    this.#apply();
  }

  /** Begin to go through the scans, or do so once they are there. */
  start(): void {
    this.#byItself = this.#isHeld = false;
    if (this.#isOn) return;
    this.#isOn = true;
    this.#apply();
    this.told('play');
  }

  /** The same, as `autoplay` asks for it and nobody else: not while a person wants less motion. */
  startByItself(): void {
    if (this.#isOn) return;
    this.#isHeld = prefersLessMotion();
    if (this.#isHeld) return;
    this.start();
    this.#byItself = true;
  }

  /** A person may want less motion, or no longer. @param autoplay - whether it may play by itself */
  motionChanged(autoplay: boolean): void {
    if (this.#isHeld && autoplay) this.startByItself();
    else if (this.#byItself && prefersLessMotion()) {
      this.pause();
      this.#isHeld = true;
    }
  }

  /** The same; resolves when scans play. @throws {DOMException} `AbortError` where it is paused before, `NotSupportedError` where there is one scan at most */
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
    this.told('pause');
  }

  /** A source with several scans is open. @param autoplay - whether it plays by itself */
  follow(player: ScanPlayer, autoplay: boolean): void {
    this.#player = player;
    if (autoplay) this.startByItself();
    this.#apply();
    for (const { resolve } of this.#waiting.splice(0)) resolve();
  }

  /** Another source is wanted. */
  forget(): void {
    this.#player = null;
    this.#isHeld = false;
  }

  /** There are no scans to go through: the source has one, or did not come. */
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

/** What a frame loop draws. */
export interface FrameHost {
  /** Whether there is a scene to draw. */
  readonly canDraw: boolean;
  /** Whether a picture is wanted, and nothing is known that stands in its way. */
  readonly wantsPicture: boolean;
  /** Whether the camera has not yet arrived. */
  readonly moving: boolean;
  /** Whether the scene moves by itself, maybe for ever. */
  readonly animating: boolean;
  /** A frame is due, and there is no scene. */
  askForScene(): void;
  /** Bring the camera to where it is so many ms after the last frame. */
  advance(elapsedMs: number): void;
  /** Draw one frame. @returns whether another has to follow, though nothing changes */
  draw(time: number): Promise<boolean>;
  failed(error: unknown): void;
  /** A frame is over, drawn or failed. */
  drew(): void;
}

/** When frames of the page come. */
export interface FrameClock {
  request(callback: (time: number) => void): number;
  cancel(frame: number): void;
}

const pageClock: FrameClock = {
  request: (callback) => requestAnimationFrame(callback),
  cancel: (frame) => cancelAnimationFrame(frame),
};

/** Rests between frames that are longer than this are rests, not time that the camera has to make up for. */
const longestStepMs = 100;

/** What a frame after a rest takes to have passed, ms. */
const usualStepMs = 16;

/**
 * Decides when a frame is due: after a change, and for as long as something moves or a better picture is to follow. One is
 * drawn at a time. At rest there is no frame and no timer.
 */
export class FrameLoop {
  #frame = 0;
  #drawing: Promise<void> | null = null;
  #dirty = true;
  #lastTime = 0;
  #waiting: (() => void)[] = [];
  #ended = false;

  constructor(readonly host: FrameHost, readonly clock: FrameClock = pageClock) {}

  /** Whether something changed since the last picture was begun. */
  get dirty(): boolean {
    return this.#dirty;
  }

  /** Settles when the picture that is being drawn is there; null where none is. */
  get drawing(): Promise<void> | null {
    return this.#drawing;
  }

  /** Whether the last picture is not the last word on what is to be seen. */
  get unfinished(): boolean {
    return this.#dirty || this.#drawing !== null || this.host.moving || this.host.animating;
  }

  /** Something changed: draw soon. */
  request(): void {
    this.#dirty = true;
    this.#goOn();
  }

  /** Draw in the next frame, unless one is being drawn: that is followed by the next where it has to be. */
  plan(): void {
    if (this.#frame !== 0 || this.#drawing || !this.host.canDraw || this.#ended) return;
    this.#frame = this.clock.request((time) => void this.#onFrame(time));
  }

  /** A picture is begun: it shows all changes until now. */
  takeChanges(): void {
    this.#dirty = false;
  }

  /** Draw at once, between frames. */
  async drawNow<T>(draw: () => Promise<T>): Promise<T> {
    try {
      return await this.#hold(draw());
    } finally {
      this.wake();
      if (this.#dirty) this.plan();
    }
  }

  /** Resolves when the picture is final: nothing moves, nothing changed since; at once where none is to come. */
  async settled(): Promise<void> {
    while (!this.#ended && this.host.wantsPicture && (this.#dirty || this.#drawing || this.host.moving)) {
      this.#goOn(); // Without a change, which would begin what is being drawn anew.
      await this.change();
    }
  }

  /** Resolves after the next frame, and at the next `wake`. */
  change(): Promise<void> {
    return new Promise((resolve) => this.#waiting.push(resolve));
  }

  /** Whoever waits has to look again. */
  wake(): void {
    for (const resolve of this.#waiting.splice(0)) resolve();
  }

  /** The scene goes away. What was not right yet is drawn in the next one. */
  rest(): void {
    if (this.unfinished) this.#dirty = true;
    this.clock.cancel(this.#frame);
    this.#frame = 0;
    this.#lastTime = 0;
  }

  /** Nothing is drawn any more. */
  end(): void {
    this.#ended = true;
    this.rest();
    this.wake();
  }

  async #onFrame(time: number): Promise<void> {
    this.#frame = 0;
    this.host.advance(this.#lastTime ? Math.min(time - this.#lastTime, longestStepMs) : usualStepMs);
    this.#lastTime = time;
    this.#dirty = false; // First: what can't be drawn is not tried again until something changes.
    let again = false;
    try {
      again = await this.#hold(this.host.draw(time));
    } catch (error) {
      this.host.failed(error);
    }
    if (this.#ended) return;
    // What moves by itself, maybe for ever, is no change that somebody could wait for.
    if (this.host.animating && !this.host.moving && !this.#dirty) this.#goOn();
    else if (again || this.host.moving || this.#dirty) this.request();
    else this.#lastTime = 0;
    this.wake();
    this.host.drew();
  }

  #goOn(): void {
    if (this.host.canDraw) this.plan();
    else this.host.askForScene();
  }

  async #hold<T>(drawing: Promise<T>): Promise<T> {
    this.#drawing = drawing.then(() => {}, () => {});
    try {
      return await drawing;
    } finally {
      this.#drawing = null;
    }
  }
}

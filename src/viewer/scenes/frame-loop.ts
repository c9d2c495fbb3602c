/** What a frame loop needs of its owner. */
export interface FrameHost {
  /** Whether there is a scene to draw. */
  readonly canDraw: boolean;
  /** Whether a picture is needed, and no known obstacle prevents it. */
  readonly wantsPicture: boolean;
  /** Whether the camera is still moving to its place. */
  readonly moving: boolean;
  /** Whether the scene moves by itself, perhaps for ever. */
  readonly animating: boolean;
  /** Called when a frame is due and there is no scene. */
  askForScene(): void;
  /** Move the camera to its place at this time after the last frame, ms. */
  advance(elapsedMs: number): void;
  /** Draw one frame. @returns whether another must follow, even if nothing changes */
  draw(time: number): Promise<boolean>;
  failed(error: unknown): void;
  /** Called after each frame, drawn or failed. */
  drew(): void;
}

/** Schedules frames of the page. */
export interface FrameClock {
  request(callback: (time: number) => void): number;
  cancel(frame: number): void;
}

const pageClock: FrameClock = {
  request: (callback) => requestAnimationFrame(callback),
  cancel: (frame) => cancelAnimationFrame(frame),
};

/** If the time between two frames is longer than this, nothing moved meanwhile: the camera does not have to catch up. */
const longestStepMs = 100;

/** The assumed time before the first frame after a rest, ms. */
const usualStepMs = 16;

/**
 * Decides when a frame is due: after a change, and as long as something moves or a better picture must follow. It draws one frame
 * at a time. At rest there is no frame and no timer.
 */
export class FrameLoop {
  #frame = 0;
  #drawing: Promise<void> | null = null;
  #dirty = true;
  #lastTime = 0;
  #waiting: (() => void)[] = [];
  #ended = false;

  constructor(
    readonly host: FrameHost,
    readonly clock: FrameClock = pageClock,
  ) {}

  /** Whether something has changed since the last picture was started. */
  get dirty(): boolean {
    return this.#dirty;
  }

  /** Settles when the picture in progress is drawn; null where there is none. */
  get drawing(): Promise<void> | null {
    return this.#drawing;
  }

  /** Whether the last picture is not final. */
  get unfinished(): boolean {
    return this.#dirty || this.#drawing !== null || this.host.moving || this.host.animating;
  }

  /** Something changed: draw soon. */
  request(): void {
    this.#dirty = true;
    this.#goOn();
  }

  /** Draw in the next frame, unless a picture is in progress: it starts the next one itself where necessary. */
  plan(): void {
    if (this.#frame !== 0 || this.#drawing || !this.host.canDraw || this.#ended) return;
    this.#frame = this.clock.request((time) => void this.#onFrame(time));
  }

  /** Called when a picture is started: it shows all changes until now. */
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

  /**
   * Resolves when the picture is final: nothing moves, and nothing has changed since; at once where no picture will come.
   * @param isEnough - whether an earlier picture already does
   */
  async settled(isEnough = () => false): Promise<void> {
    while (
      !this.#ended &&
      this.host.wantsPicture &&
      (this.#dirty || this.#drawing || this.host.moving) &&
      !isEnough()
    ) {
      this.#goOn(); // Without marking a change, which would restart the picture in progress.
      await this.change();
    }
  }

  /** Resolves after the next frame, and at the next `wake`. */
  change(): Promise<void> {
    return new Promise((resolve) => this.#waiting.push(resolve));
  }

  /** Let all waiting callers check again. */
  wake(): void {
    for (const resolve of this.#waiting.splice(0)) resolve();
  }

  /** The scene goes away. What was not final yet is drawn in the next scene. */
  rest(): void {
    if (this.unfinished) this.#dirty = true;
    this.clock.cancel(this.#frame);
    this.#frame = 0;
    this.#lastTime = 0;
  }

  /** Stop drawing for good. */
  end(): void {
    this.#ended = true;
    this.rest();
    this.wake();
  }

  async #onFrame(time: number): Promise<void> {
    this.#frame = 0;
    this.host.advance(this.#lastTime ? Math.min(time - this.#lastTime, longestStepMs) : usualStepMs);
    this.#lastTime = time;
    this.#dirty = false; // First: after a failure, drawing is tried again only when something changes.
    let again = false;
    try {
      again = await this.#hold(this.host.draw(time));
    } catch (error) {
      this.host.failed(error);
    }
    if (this.#ended) return;
    // A scene that moves by itself, perhaps for ever, is no change that callers could wait for.
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
    this.#drawing = drawing.then(
      () => {},
      () => {},
    );
    try {
      return await drawing;
    } finally {
      this.#drawing = null;
    }
  }
}

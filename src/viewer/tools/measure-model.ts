import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import { inPieces } from '../../core/in-pieces.ts';
import { measure, pointCounts, readMeasurePoints, readMeasureType, sumUp } from './measuring.ts';
import type { MeasureResult, MeasureType } from './measuring.ts';

/** What a measure needs of its element. */
export interface MeasureHost {
  /** Returns null before there is a volume. */
  readonly volume: () => Volume | null;
  /** What is shown has changed. */
  readonly changed: () => void;
  /** The result has changed, or values inside have been summed up; null where there is no longer a result. */
  readonly measured: (result: MeasureResult | null) => void;
}

/** The points of one measure, whether a person is placing them, and the result. Of several changes the last one counts. */
export class MeasureModel {
  #type: MeasureType = 'distance';
  #points: readonly Vector3[] = [];
  /** While a person places points: the points before that. */
  #before: readonly Vector3[] | null = null;
  #result: MeasureResult | null = null;
  #hasNotified = false;
  #run = 0;

  constructor(readonly host: MeasureHost) {}

  get type(): MeasureType {
    return this.#type;
  }

  /** The points that are placed so far. */
  get points(): readonly Vector3[] {
    return this.#points;
  }

  get isWhole(): boolean {
    return this.#points.length === pointCounts[this.#type];
  }

  /** Whether a person is placing points. */
  get placing(): boolean {
    return this.#before !== null;
  }

  /** The result; while values inside are summed up, its statistics are null. */
  get result(): MeasureResult | null {
    return this.#result;
  }

  /**
   * Apply attributes; if one can't be read, nothing changes.
   * @param pointsAreNew - whether the points attribute has just changed: if not, points that a person has placed stay
   * @throws {VolumeViewError} `attribute/invalid`
   */
  read(typeText: string | null, pointsText: string | null, pointsAreNew: boolean): void {
    const type = readMeasureType(typeText);
    const points = readMeasurePoints(pointsText, type);
    if (!pointsAreNew && type === this.#type) return;
    this.#type = type;
    this.#before = null;
    this.place(points ?? []);
  }

  /** Measure again: the volume may have changed. */
  refresh(): void {
    const volume = this.host.volume();
    this.#result = volume && this.isWhole ? measure(volume, this.#type, this.#points) : null;
    void this.#finish(++this.#run, volume);
    this.host.changed();
  }

  /** Stop summing up. */
  stop(): void {
    this.#run++;
  }

  place(points: readonly Vector3[]): void {
    this.#points = points;
    this.refresh();
  }

  move(index: number, to: Vector3): void {
    this.place(this.#points.map((point, i) => (i === index ? to : point)));
  }

  /** A person starts to place points, one after the other. */
  begin(): void {
    this.#before = this.#points;
    this.place([]);
  }

  /** A person has placed a point. */
  add(point: Vector3): void {
    const points = [...this.#points, point];
    if (points.length === pointCounts[this.#type]) this.#before = null;
    this.place(points);
  }

  /** A person has placed all points. */
  complete(points: readonly Vector3[]): void {
    this.#before = null;
    this.place(points);
  }

  /** Restore the points from before. */
  cancel(): void {
    if (this.#before) this.complete(this.#before);
  }

  async #finish(run: number, volume: Volume | null): Promise<void> {
    const result = this.#result;
    const work = result && volume && sumUp(volume, result.type, result.points);
    const statistics = await (work ? inPieces(work, () => run === this.#run) : Promise.resolve(null));
    if (run !== this.#run) return;
    if (result && statistics) {
      this.#result = { ...result, statistics };
      this.host.changed();
    }
    // While points are placed, there is no result yet. The end of a result is reported only if there was one.
    if (this.#result || (this.#hasNotified && !this.placing)) this.host.measured(this.#result);
    this.#hasNotified = this.#result !== null || (this.#hasNotified && this.placing);
  }
}

import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import { inPieces } from '../frames/in-pieces.ts';
import { measure, pointCounts, readMeasurePoints, readMeasureType, sumUp } from './measuring.ts';
import type { MeasureResult, MeasureType } from './measuring.ts';

/** Whose measure it is. */
export interface MeasureHost {
  /** null before there is one. */
  readonly volume: () => Volume | null;
  /** Something is to be seen otherwise. */
  readonly changed: () => void;
  /** Something else has been measured, or values inside have been added up; null where there is nothing any more. */
  readonly measured: (result: MeasureResult | null) => void;
}

/** The points of one measure, who places them, and what it comes to. Of several changes the last one wins. */
export class MeasureModel {
  #type: MeasureType = 'distance';
  #points: readonly Vector3[] = [];
  /** While a person places points: those before. */
  #before: readonly Vector3[] | null = null;
  #result: MeasureResult | null = null;
  #hasTold = false;
  #run = 0;

  constructor(readonly host: MeasureHost) {}

  get type(): MeasureType {
    return this.#type;
  }

  /** As far as there are some. */
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

  /** What was measured; while values inside are added up its statistics are null. */
  get result(): MeasureResult | null {
    return this.#result;
  }

  /**
   * Take in attributes; what can't be read leaves all as it was.
   * @param pointsAreNew - whether points were just written: else those that a person has placed stay
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

  /** The volume may be another one. */
  refresh(): void {
    const volume = this.host.volume();
    this.#result = volume && this.isWhole ? measure(volume, this.#type, this.#points) : null;
    void this.#finish(++this.#run, volume);
    this.host.changed();
  }

  /** Nothing of it goes on. */
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

  /** A person places points from now on, one after the other. */
  begin(): void {
    this.#before = this.#points;
    this.place([]);
  }

  /** A person has placed one. */
  add(point: Vector3): void {
    const points = [...this.#points, point];
    if (points.length === pointCounts[this.#type]) this.#before = null;
    this.place(points);
  }

  /** A person has placed all of them. */
  complete(points: readonly Vector3[]): void {
    this.#before = null;
    this.place(points);
  }

  /** The points before are back. */
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
    // While points are placed there is none yet; that there is nothing any more is news after something.
    if (this.#result || (this.#hasTold && !this.placing)) this.host.measured(this.#result);
    this.#hasTold = this.#result !== null || (this.#hasTold && this.placing);
  }
}

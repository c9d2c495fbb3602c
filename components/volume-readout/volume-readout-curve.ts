// The curve of values over time: loaded with the first readout that shows one.
import { html } from 'lit';
import type { LitElement } from 'lit';
import { placeInElement } from '../../src/page/pointer-place.ts';
import { asVolumeViewError } from '../../src/core/errors.ts';
import type { VolumeViewError } from '../../src/core/errors.ts';
import { CurveLocale } from '../../src/messages/curve-locale.ts';
import { describeScan } from '../../src/messages/name-scans.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { VolumePick } from '../../src/viewer/model/volume-pick.ts';
import { applySheet } from '../../src/viewer/overlays/apply-sheet.ts';
import { hasValues, readOverTime } from '../../src/viewer/picking/values-over-time.ts';
import type { ValuesOverTime } from '../../src/viewer/picking/values-over-time.ts';
import type { DrawnPart } from '../internal/lazy-part.ts';
import type { VolumeView } from '../volume-view/volume-view.ts';
import {
  draw,
  renderLines,
  renderTable,
  renderTimeTicks,
  renderValueTicks,
  summarize,
  writeTime,
  writeValue,
} from './curve-parts.ts';
import type { DrawnCurve, WrittenValues } from './curve-parts.ts';
import { nearestScan } from './curve-scale.ts';
import { curveStyles } from './curve-styles.ts';

/** Page Up and Page Down move by this share of all times. */
const pageShare = 0.1;

/** The values of a place over all times: a line, which is a slider over the times, a mark at the time that is shown, and a table. */
export class Curve implements DrawnPart {
  readonly #locale: CurveLocale;
  #view: VolumeView | null = null;
  #pick: VolumePick | null = null;
  #reading = new AbortController();
  #known: ValuesOverTime | null = null;
  #problem: VolumeViewError | null = null;
  /** The scan under the mouse. */
  #pointed: number | null = null;
  /** The scan that a person chose here, until it is shown. */
  #chosen: number | null = null;
  #isTableOpen = false;
  /** The last drawing, with the values and times that it shows. */
  #last: { readonly of: Pick<WrittenValues, 'values' | 'times'>; readonly drawn: DrawnCurve } | null = null;

  /** The last table, and what it was written of. */
  #table: { readonly of: readonly unknown[]; readonly table: unknown } | null = null;

  constructor(readonly host: LitElement) {
    this.#locale = new CurveLocale(host);
  }

  /** Show the values of a place: they are read now, and those of the last place no longer. @param pick - what was found at the place */
  follow(view: VolumeView | null, pick: VolumePick | null): void {
    if (pick === this.#pick && view === this.#view) return;
    this.#view = view;
    this.#pick = pick;
    this.#reading.abort();
    this.#known = this.#problem = this.#pointed = null;
    if (view && pick && hasValues(pick)) void this.#read(view, pick);
  }

  dispose(): void {
    this.#reading.abort();
    this.host.removeController(this.#locale);
  }

  async #read(view: VolumeView, pick: VolumePick): Promise<void> {
    const { signal } = (this.#reading = new AbortController());
    const onValues = (known: ValuesOverTime): void => {
      if (signal.aborted) return;
      this.#known = known;
      this.host.requestUpdate();
    };
    try {
      await readOverTime(socketOf(view).view, pick, { signal, onValues });
    } catch (error) {
      if (signal.aborted) return;
      this.#known = null;
      this.#problem = asVolumeViewError(error, 'the scans');
      this.host.requestUpdate();
    }
  }

  render(): unknown {
    applySheet(this.host.renderRoot as ShadowRoot, curveStyles);
    return html`<div class="curve" part="curve">${this.#renderPlace()}</div>`;
  }

  #renderPlace(): unknown {
    const { messages } = this.#locale;
    const hint = (words: string): unknown => html`<p class="hint" part="hint"><span dir="auto">${words}</span></p>`;
    const [view, pick] = [this.#view, this.#pick];
    if (!view || !pick) return hint(messages.curveHint);
    if (!hasValues(pick)) return hint(messages.curveNone);
    if (this.#problem)
      return html`<p class="hint" part="hint" role="alert"><span dir="auto">${messages.curveProblem}</span> <span lang="en" dir="ltr">${this.#problem.message}</span></p>`;
    return this.#known && this.#renderValues(view, this.#write(this.#known, view, pick));
  }

  #write(known: ValuesOverTime, { times }: VolumeView, { unit }: VolumePick): WrittenValues {
    const { language, messages } = this.#locale;
    // While another source is being opened, the view has its times.
    const same = times.length === known.values.length ? times : known.values.map(() => null);
    return { ...known, times: same, unit, language, messages };
  }

  #renderValues(view: VolumeView, written: WrittenValues): unknown {
    const { language, messages, times, done } = written;
    if (!view.waiting) this.#chosen = null;
    const current = Math.min(this.#chosen ?? view.scan?.index ?? 0, times.length - 1);
    const drawn = this.#draw(written);
    const read = this.#pointed ?? current;
    return html`<p class="read" part="curve-value"><bdi>${writeTime(written, read)}</bdi>: <b><bdi>${writeValue(written, read)}</bdi></b></p>
      <div class="plot">
        ${renderValueTicks(drawn, written)}
        <div
          class="area"
          part="curve-plot"
          role="slider"
          tabindex="0"
          aria-label=${language.messages.time}
          aria-description=${messages.curveKeys}
          aria-valuemin="1"
          aria-valuemax=${times.length}
          aria-valuenow=${current + 1}
          aria-valuetext=${`${describeScan(times, current, language)}: ${writeValue(written, current)}`}
          @keydown=${(event: KeyboardEvent) => this.#onKey(event, current, times.length)}
          @pointerdown=${(event: PointerEvent) => this.#onPointer(event, drawn)}
          @pointermove=${(event: PointerEvent) => this.#onPointer(event, drawn)}
          @pointerleave=${() => this.#point(null)}
        >${renderLines(drawn, written, { current, pointed: this.#pointed })}</div>
        ${renderTimeTicks(drawn, written)}
      </div>
      <p class="hint" part="hint">${
        done === 1
          ? html`<span dir="auto">${summarize(written)}</span>`
          : html`<progress max="1" .value=${done} aria-hidden="true"></progress> <span dir="auto">${messages.curveReading(language.percent(done, 2))}</span>`
      }</p>
      ${this.#renderTable(drawn, written, current)}`;
  }

  /** It may have thousands of rows: it is written again where something in it has changed, and not with each move of the mouse. */
  #renderTable(drawn: DrawnCurve, written: WrittenValues, current: number): unknown {
    const isOpen = this.#isTableOpen;
    const of = [drawn, current, isOpen, written.language.code];
    if (!this.#table?.of.every((one, i) => one === of[i]))
      this.#table = { of, table: renderTable(written, { isOpen, current, toggled: (now) => this.#openTable(now) }) };
    return this.#table.table;
  }

  /** Draws again where values or times are others than before. */
  #draw({ values, times }: WrittenValues): DrawnCurve {
    const last = this.#last;
    if (last && last.of.values === values && last.of.times.every((time, i) => time === times[i])) return last.drawn;
    const drawn = draw({ values, times });
    this.#last = { of: { values, times }, drawn };
    return drawn;
  }

  #openTable(isOpen: boolean): void {
    this.#isTableOpen = isOpen;
    this.host.requestUpdate();
  }

  #onKey(event: KeyboardEvent, current: number, count: number): void {
    const { key, ctrlKey, metaKey, altKey } = event;
    const page = Math.max(1, Math.round(count * pageShare));
    const goals: Readonly<Record<string, number>> = {
      ArrowLeft: current - 1,
      ArrowDown: current - 1,
      ArrowRight: current + 1,
      ArrowUp: current + 1,
      PageDown: current - page,
      PageUp: current + page,
      Home: 0,
      End: count - 1,
    };
    if (ctrlKey || metaKey || altKey || !Object.hasOwn(goals, key)) return;
    event.preventDefault();
    this.#point(null);
    this.#go(Math.min(count - 1, Math.max(0, goals[key])), current);
  }

  /** Pointing shows a value; pressing goes to its time, also while the pointer moves on. */
  #onPointer(event: PointerEvent, { time: { at } }: DrawnCurve): void {
    const area = event.currentTarget as HTMLElement;
    const [x] = placeInElement(area, event);
    const nearest = nearestScan(at, x / Math.max(1, area.clientWidth));
    const isPressed = event.buttons === 1;
    if (event.type === 'pointerdown' && isPressed) area.setPointerCapture(event.pointerId);
    this.#point(nearest);
    if (isPressed) this.#go(nearest, this.#chosen ?? this.#view?.scan?.index ?? -1);
  }

  #point(index: number | null): void {
    if (index === this.#pointed) return;
    this.#pointed = index;
    this.host.requestUpdate();
  }

  #go(index: number, current: number): void {
    if (index === current) return;
    this.#chosen = index;
    this.#view?.pause();
    this.#view?.showScan(index);
    this.host.requestUpdate();
  }
}

import { html, nothing } from 'lit';
import type { PropertyValues } from 'lit';
import { invalidAttribute } from '../../src/core/errors.ts';
import type { VolumeViewError } from '../../src/core/errors.ts';
import { Language } from '../../src/messages/language.ts';
import { describeScan, isClock, scanLabeller } from '../../src/messages/name-scans.ts';
import { CompanionLocale } from '../../src/messages/companion-locale.ts';
import { property, ReflectingElement } from '../internal/reflecting-element.ts';
import { styles } from './volume-timeline-styles.ts';
import { companionGap, withViewWidth } from '../internal/view-width.ts';
import { VolumeLink } from '../internal/volume-link.ts';
import type { VolumeView } from '../volume-view/volume-view.ts';

/** Paths in a box of 24 by 24. */
const icons = {
  previous: 'M7 5h2.5v14H7zM19 5v14l-9-7z',
  next: 'M14.5 5H17v14h-2.5zM5 5l9 7-9 7z',
  play: 'M7 4.5v15l12-7.5z',
  pause: 'M7 5h3.5v14H7zM13.5 5H17v14h-3.5z',
};

/**
 * The scans of a volume in time: previous, play and next, and a slider over all of them.
 *
 * Without `for` it belongs to the nearest `<volume-view>`: the one around it, else the first one in the smallest element that
 * contains both.
 *
 * @tag volume-timeline
 * @csspart timeline - the whole timeline
 * @csspart buttons - the box around the three buttons
 * @csspart button - each of the three buttons
 * @csspart time - the time of the scan that is shown
 * @csspart slider - the slider, an input of the type range
 * @csspart ticks - a mark for each scan, at most 120, and times below some of them
 * @csspart hint - the text where there is only one scan or none
 * @csspart error - the text where `time-zone` can't be read
 * @cssproperty --volume-view-focus-color - colour of the ring around the element with the focus; by default that of the text
 * @cssproperty --volume-timeline-accent - colour of the slider's thumb; by default that of the text
 */
export class VolumeTimeline extends ReflectingElement {
  static override readonly styles = [companionGap, styles];

  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  /**
   * Time zone in which times are written: a name such as `Australia/Sydney`, or `local` for that of the reader.
   * @default UTC
   */
  @property({ attribute: 'time-zone' }) timeZone!: string | null;

  readonly #link = withViewWidth(
    new VolumeLink(this, () => this.requestUpdate(), ['load', 'time-change', 'scans-change']),
  );
  readonly #locale = new CompanionLocale(this);

  /** The scan that a person chose with the slider, until that scan is shown. */
  #chosen: number | null = null;

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
    if (!this.#link.view?.waiting) this.#chosen = null;
  }

  protected override render(): unknown {
    const { view } = this.#link;
    const { language, problem } = this.#readZone();
    const { messages } = language;
    const times = view?.times ?? [];
    const several = times.length > 1;
    const index = this.#chosen ?? view?.scan?.index ?? 0;
    const isPlaying = view?.paused === false;
    return html`<div class="timeline" part="timeline" role="group" aria-label=${messages.time} aria-busy=${view?.waiting ? 'true' : 'false'}>
      <div class="buttons" part="buttons">
        ${renderButton('previous', messages.previousScan, !several || index === 0, () => view?.previous())}
        ${renderButton(isPlaying ? 'pause' : 'play', isPlaying ? messages.pause : messages.play, !several, () => this.#togglePlay())}
        ${renderButton('next', messages.nextScan, !several || index === times.length - 1, () => view?.next())}
      </div>
      <output class="time" part="time" aria-live=${isPlaying ? 'off' : 'polite'}>${several ? renderTime(times, index, language) : html`<span class="hint" part="hint">${this.#hint(times, language)}</span>`}</output>
      <div class="track">
        <input
          type="range"
          part="slider"
          aria-label=${messages.scan}
          min="0"
          max=${Math.max(1, times.length - 1)}
          step="1"
          .value=${String(index)}
          aria-valuetext=${several ? describeScan(times, index, language) : nothing}
          ?disabled=${!several}
          @input=${this.#onInput}
        />
        ${several ? renderTicks(times, language) : nothing}
      </div>
      ${problem ? html`<p class="problem" part="error" role="alert" lang="en">${problem.message}</p>` : nothing}
    </div>`;
  }

  /** The language with the time zone. An unknown zone is reported, and times stay in UTC. */
  #readZone(): { language: Language; problem: VolumeViewError | null } {
    const { language } = this.#locale;
    const asked = this.timeZone?.trim() ?? '';
    if (asked === '') return { language, problem: null };
    try {
      const { timeZone } = new Intl.DateTimeFormat(
        'en',
        asked === 'local' ? {} : { timeZone: asked },
      ).resolvedOptions();
      return { language: new Language(language.code, language.messages, timeZone), problem: null };
    } catch {
      return {
        language,
        problem: invalidAttribute(
          'time-zone of <volume-timeline>',
          asked,
          '"local", or a zone as browsers know them, like "Europe/Brussels"',
        ),
      };
    }
  }

  #hint(times: readonly (string | null)[], language: Language): string {
    const { messages } = language;
    if (!this.#link.view || times.length === 0) return this.#link.describeLack(messages) ?? messages.noScan;
    return messages.oneScan(times[0] ? describeScan(times, 0, language) : null);
  }

  #togglePlay(): void {
    const { view } = this.#link;
    if (view?.paused) view.play().catch(() => {}); // The view itself shows the error.
    else view?.pause();
  }

  #onInput(event: Event): void {
    const { value } = event.target as HTMLInputElement;
    const view = this.#link.view as VolumeView;
    this.#chosen = Number(value);
    view.pause();
    view.showScan(this.#chosen);
    this.requestUpdate();
  }
}

function renderButton(icon: keyof typeof icons, label: string, disabled: boolean, act: () => void): unknown {
  return html`<button type="button" part="button" aria-label=${label} title=${label} ?disabled=${disabled} @click=${act}>
    <svg viewBox="0 0 24 24" aria-hidden="true"><path d=${icons[icon]}></path></svg>
  </button>`;
}

function renderTime(times: readonly (string | null)[], index: number, language: Language): unknown {
  const time = times[index];
  return html`<span class="clock">${scanLabeller(times, language)(index)}</span>
    ${isClock(time) ? html`<span class="day">${language.zone(time)} · ${language.day(time)}</span>` : nothing}
    <span class="count"><bdi dir="ltr">${language.number(index + 1)} / ${language.number(times.length)}</bdi></span>`;
}

/** Maximum number of marks below the slider: more would look like a solid bar, and need one element for each scan. */
const maxTicks = 120;

/**
 * The first and the last scan have a name, and as many between as there is room for; the thumb of the slider stays half its width from the
 * ends. Of very many scans only some have a mark; the slider, its keys and the buttons reach all of them.
 */
function renderTicks(times: readonly (string | null)[], language: Language): unknown {
  const label = scanLabeller(times, language);
  const last = times.length - 1;
  const every = Math.ceil(last / 4);
  const stride = Math.ceil(last / maxTicks);
  const isNamed = (i: number): boolean => i === last || (i % every === 0 && last - i >= every);
  const marked = [...times.keys()].filter((i) => i % stride === 0 || isNamed(i));
  return html`<div class="ticks" part="ticks" aria-hidden="true">
    ${marked.map((i) => html`<span class="tick" .style=${`--at: ${i / last}`}>${isNamed(i) ? html`<span class="name">${label(i)}</span>` : nothing}</span>`)}
  </div>`;
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-timeline': VolumeTimeline;
  }
}

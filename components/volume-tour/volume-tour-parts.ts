import { html, nothing } from 'lit';
import type { CompanionMessages } from '../../src/messages/messages.ts';
import type { TourMessages } from '../../src/messages/tour-messages.ts';

/** Paths in a box of 24 by 24. */
const icons = {
  play: 'M8 5l11 7-11 7z',
  pause: 'M9 5v14M15 5v14',
  previous: 'M15 5l-7 7 7 7',
  next: 'M9 5l7 7-7 7',
  leave: 'M6 6l12 12M18 6L6 18',
};

const classes = { play: 'play', pause: 'play', previous: 'turns', next: 'turns', leave: 'leave' };

export interface TourParts {
  readonly messages: CompanionMessages & TourMessages;
  /** Number of the open step, from 1; 0 where none is. */
  readonly step: number;
  /** The names of the steps; none where there are no buttons. */
  readonly titles: readonly string[];
  /** In the language of the reader. */
  readonly number: (value: number) => string;
  readonly problem: string | null;
  /** What is missing; null for nothing. */
  readonly lack: string | null;
  /** Which button there is to play; null for none. */
  readonly player: 'play' | 'pause' | null;
  /** Whether a person has turned the picture. */
  readonly isTurned: boolean;
  /** The sentence for screen readers. */
  readonly said: string;
  /** @param step - 0 leaves the tour */
  readonly choose: (step: number) => void;
  readonly play: (isOn: boolean) => void;
  readonly back: () => void;
}

export function renderTour(parts: TourParts): unknown {
  const { messages, step, titles, problem, lack, isTurned, said, choose, back } = parts;
  const buttons = step === 0 ? renderWords(messages.tourStart, () => choose(1)) : renderButtons(parts);
  return html`${problem ? html`<p class="error" part="error" role="alert" lang="en">${problem}</p>` : nothing}
    ${lack ? html`<p class="hint" part="hint">${lack}</p>` : nothing}
    ${titles.length === 0 ? nothing : html`<div class="bar" part="bar" role="group" aria-label=${messages.tour}>${buttons}</div>`}
    <slot></slot>
    ${isTurned ? html`<div class="bar back">${renderWords(messages.tourBack, back)}</div>` : nothing}
    <div class="spoken" role="status">${said}</div>`;
}

function renderButtons(parts: TourParts): unknown {
  const { messages, step, titles, player, choose, play } = parts;
  return html`${player ? renderIcon(player, messages[player], false, () => play(player === 'play')) : nothing}
    ${renderIcon('previous', messages.tourPrevious, step === 1, () => choose(step - 1))}
    <ol class="dots">${titles.map((title, i) => renderDot(i + 1, title, parts))}</ol>
    ${renderIcon('next', messages.tourNext, step === titles.length, () => choose(step + 1))}
    ${renderIcon('leave', messages.tourLeave, false, () => choose(0))}`;
}

function renderDot(to: number, title: string, { step, number, choose }: TourParts): unknown {
  return html`<li><button type="button" part="dot" title=${title} aria-label=${`${number(to)}. ${title}`} aria-current=${to === step ? 'step' : nothing} @click=${() => choose(to)}></button></li>`;
}

function renderIcon(icon: keyof typeof icons, label: string, isDisabled: boolean, act: () => void): unknown {
  return html`<button type="button" class=${classes[icon]} part="button" title=${label} aria-label=${label} ?disabled=${isDisabled} @click=${act}>
    <svg viewBox="0 0 24 24" aria-hidden="true"><path d=${icons[icon]}></path></svg>
  </button>`;
}

function renderWords(text: string, act: () => void): unknown {
  return html`<button type="button" class="words" part="button" @click=${act}>${text}</button>`;
}

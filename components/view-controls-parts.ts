import { html, nothing } from 'lit';
import type { StandardView } from '../src/viewer/standard-views.ts';
import type { ControlTerms } from '../src/words/terms.ts';

/** What may be left out. */
export type ControlName = 'play' | 'views' | 'reset' | 'fullscreen' | 'save' | 'copy' | 'help' | 'hint';

/** Lines in a box of 24 by 24. */
const icons = {
  play: 'M8 5v14l11-7z',
  pause: 'M8 5v14M16 5v14',
  views: 'M12 3l8 4.5v9L12 21l-8-4.5v-9zM12 12l8-4.5M12 12v9M12 12L4 7.5',
  reset: 'M4 12a8 8 0 1 0 2.6-5.9M4 4v5h5',
  fullscreen: 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5',
  leave: 'M9 4v5H4M20 9h-5V4M15 20v-5h5M4 15h5v5',
  more: 'M5 12h.01M12 12h.01M19 12h.01',
} as const;

export type Act = (action: ControlName | 'more') => void;

/** What the bar shows. */
export interface BarState {
  readonly open: string | null;
  /** Whether scans play; null where there are none to be played. */
  readonly playing: boolean | null;
  readonly isFull: boolean;
  has(name: ControlName): boolean;
}

export function renderBar(terms: ControlTerms, { open, playing, isFull, has }: BarState, act: Act): unknown {
  const button = (action: Parameters<Act>[0], icon: keyof typeof icons, label: string): unknown => html`<button
    type="button"
    part="control"
    data-action=${action}
    aria-label=${label}
    title=${label}
    aria-expanded=${action === 'views' || action === 'more' ? String(open === action || (action === 'more' && open !== null && open !== 'views')) : nothing}
    @click=${() => act(action)}
  ><svg viewBox="0 0 24 24" aria-hidden="true"><path d=${icons[icon]}></path></svg></button>`;
  const hasMore = has('save') || has('copy') || has('help');
  return html`<div class="bar" part="controls-bar">
    ${playing === null ? nothing : button('play', playing ? 'pause' : 'play', playing ? terms.pauseScans : terms.playScans)}
    ${has('views') ? button('views', 'views', terms.views) : nothing}
    ${has('reset') ? button('reset', 'reset', terms.resetView) : nothing}
    ${has('fullscreen') ? button('fullscreen', isFull ? 'leave' : 'fullscreen', isFull ? terms.leaveFullscreen : terms.fullscreen) : nothing}
    ${hasMore ? button('more', 'more', terms.more) : nothing}
  </div>`;
}

export function renderViews(terms: ControlTerms, views: readonly StandardView[], choose: (view: StandardView) => void): unknown {
  return html`<div class="panel views" part="controls-panel" role="group" aria-label=${terms.views}>
    ${views.map((view) => html`<button type="button" part="control" @click=${() => choose(view)}>${terms.view[view.name]}</button>`)}
  </div>`;
}

export function renderMore(terms: ControlTerms, has: (name: ControlName) => boolean, act: Act): unknown {
  const entry = (action: ControlName, label: string): unknown =>
    (has(action) ? html`<button type="button" part="control" @click=${() => act(action)}>${label}</button>` : nothing);
  return html`<div class="panel" part="controls-panel" role="group" aria-label=${terms.more}>
    ${entry('save', terms.savePicture)}${entry('copy', terms.copyView)}${entry('help', terms.help)}
  </div>`;
}

export function renderHelp({ help, helpLines }: ControlTerms): unknown {
  return html`<div class="panel" part="controls-panel" role="status" aria-label=${help} tabindex="0">
    <dl>${helpLines.map(([what, how]) => html`<dt>${what}</dt><dd>${how}</dd>`)}</dl>
  </div>`;
}

/** @param text - where the browser did not let us copy it */
export function renderCopied({ copied, copyByHand }: ControlTerms, text: string): unknown {
  return html`<div class="panel" part="controls-panel" role="status">
    ${text === '' ? html`<p>${copied}</p>` : html`<p>${copyByHand}</p><textarea readonly aria-label=${copyByHand} .value=${text} @focus=${selectAll}></textarea>`}
  </div>`;
}

export function renderHint({ mouseHint, touchHint }: ControlTerms): unknown {
  return html`<p class="hint" part="controls-hint">${matchMedia('(pointer: coarse)').matches ? touchHint : mouseHint}</p>`;
}

function selectAll({ target }: Event): void {
  (target as HTMLTextAreaElement).select();
}

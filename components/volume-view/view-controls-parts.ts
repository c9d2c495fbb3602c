import { html, nothing } from 'lit';
import type { StandardView } from '../../src/viewer/camera/standard-views.ts';
import type { ControlMessages } from '../../src/messages/messages.ts';

/** The controls that may be left out. */
export type ControlName =
  | 'play'
  | 'rotate'
  | 'views'
  | 'zoom'
  | 'reset'
  | 'fullscreen'
  | 'save'
  | 'copy'
  | 'link'
  | 'embed'
  | 'help'
  | 'hint';

/** Lines in a box of 24 by 24. */
const icons = {
  play: 'M8 5v14l11-7z',
  pause: 'M8 5v14M16 5v14',
  turn: 'M13 17.5c4.5-.3 8-2.7 8-5.5 0-3.1-4-5.5-9-5.5S3 8.9 3 12c0 2.1 1.9 4 4.7 4.9M15.5 14.5l-3 3 3 3',
  stay: 'M17.5 16.4c2.1-1 3.5-2.6 3.5-4.4 0-3.1-4-5.5-9-5.5S3 8.9 3 12c0 1.8 1.4 3.4 3.5 4.4M10 13.5v7M14 13.5v7',
  zoomin: 'M5 12h14M12 5v14',
  zoomout: 'M5 12h14',
  views: 'M12 3l8 4.5v9L12 21l-8-4.5v-9zM12 12l8-4.5M12 12v9M12 12L4 7.5',
  reset: 'M4 12a8 8 0 1 0 2.6-5.9M4 4v5h5',
  fullscreen: 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5',
  leave: 'M9 4v5H4M20 9h-5V4M15 20v-5h5M4 15h5v5',
  more: 'M5 12h.01M12 12h.01M19 12h.01',
} as const;

export type Act = (action: Exclude<ControlName, 'zoom'> | 'zoomin' | 'zoomout' | 'more') => void;

/** The state of the bar. */
export interface BarState {
  readonly open: string | null;
  /** Whether scans play; null where there are no scans to play. */
  readonly playing: boolean | null;
  /** Whether the camera rotates by itself; null where it never does. */
  readonly rotating: boolean | null;
  readonly isFull: boolean;
  has(name: ControlName): boolean;
}

export function renderBar(
  messages: ControlMessages,
  { open, playing, rotating, isFull, has }: BarState,
  act: Act,
): unknown {
  const button = (
    action: Parameters<Act>[0],
    icon: keyof typeof icons,
    label: string,
    more = '',
  ): unknown => html`<button
    type="button"
    part="control"
    class=${more}
    data-action=${action}
    aria-label=${label}
    title=${label}
    aria-expanded=${action === 'views' || action === 'more' ? String(open === action || (action === 'more' && open !== null && open !== 'views')) : nothing}
    @click=${() => act(action)}
  ><svg viewBox="0 0 24 24" aria-hidden="true"><path d=${icons[icon]}></path></svg></button>`;
  const hasMore = has('save') || has('copy') || has('link') || has('embed') || has('help');
  // Where there is no room for these buttons, they are under "More".
  const more = hasMore ? 'wide' : '';
  return html`<div class="bar" part="controls-bar">
    ${playing === null ? nothing : button('play', playing ? 'pause' : 'play', playing ? messages.pauseScans : messages.playScans)}
    ${rotating === null ? nothing : button('rotate', rotating ? 'stay' : 'turn', rotating ? messages.stopRotation : messages.startRotation)}
    ${has('views') ? button('views', 'views', messages.views) : nothing}
    ${has('zoom') ? html`${button('zoomin', 'zoomin', messages.zoomIn, more)}${button('zoomout', 'zoomout', messages.zoomOut, more)}` : nothing}
    ${has('reset') ? button('reset', 'reset', messages.resetView, more) : nothing}
    ${has('fullscreen') ? button('fullscreen', isFull ? 'leave' : 'fullscreen', isFull ? messages.leaveFullscreen : messages.fullscreen) : nothing}
    ${hasMore ? button('more', 'more', messages.more) : nothing}
  </div>`;
}

export function renderViews(
  messages: ControlMessages,
  views: readonly StandardView[],
  choose: (view: StandardView) => void,
): unknown {
  return html`<div class="panel views" part="controls-panel" role="group" aria-label=${messages.views}>
    ${views.map((view) => html`<button type="button" part="control" @click=${() => choose(view)}>${messages.view[view.name]}</button>`)}
  </div>`;
}

export function renderMore(messages: ControlMessages, has: (name: ControlName) => boolean, act: Act): unknown {
  const entry = (name: ControlName, label: string, action = name as Parameters<Act>[0], more = ''): unknown =>
    has(name)
      ? html`<button type="button" part="control" class=${more} @click=${() => act(action)}>${label}</button>`
      : nothing;
  return html`<div class="panel" part="controls-panel" role="group" aria-label=${messages.more}>
    ${entry('zoom', messages.zoomIn, 'zoomin', 'narrow')}${entry('zoom', messages.zoomOut, 'zoomout', 'narrow')}${entry('reset', messages.resetView, 'reset', 'narrow')}
    ${entry('save', messages.savePicture)}${entry('copy', messages.copyView)}${entry('link', messages.copyLink)}${entry('embed', messages.copyEmbed)}${entry('help', messages.help)}
  </div>`;
}

export function renderHelp({ help, helpLines }: ControlMessages): unknown {
  return html`<div class="panel" part="controls-panel" role="status" aria-label=${help} tabindex="0">
    <dl>${helpLines.map(([what, how]) => html`<dt>${what}</dt><dd>${how}</dd>`)}</dl>
  </div>`;
}

/** @param message - a sentence, and a text where the browser did not allow copying */
export function renderCopied({ sentence, text }: { readonly sentence: string; readonly text: string }): unknown {
  return html`<div class="panel" part="controls-panel" role="status">
    <p>${sentence}</p>${text === '' ? nothing : html`<textarea readonly aria-label=${sentence} .value=${text} @focus=${selectAll}></textarea>`}
  </div>`;
}

export function renderHint({ mouseHint, touchHint }: ControlMessages): unknown {
  return html`<p class="hint" part="controls-hint">${matchMedia('(pointer: coarse)').matches ? touchHint : mouseHint}</p>`;
}

function selectAll({ target }: Event): void {
  (target as HTMLTextAreaElement).select();
}

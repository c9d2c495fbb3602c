import { html, nothing } from 'lit';
import type { VolumeViewError } from '../src/errors.ts';
import type { LoadProgress } from '../src/formats/load-request.ts';

/** What stands in the picture's place until there is one. */
export function renderPoster(poster: string | null): unknown {
  return html`<slot name="poster">
    ${poster ? html`<img class="poster" part="poster" src=${poster} alt="" />` : nothing}
  </slot>`;
}

/** How far loading is; a bar that runs to and fro where nobody knows the end. */
export function renderProgress({ loaded, total }: LoadProgress): unknown {
  const share = total > 0 ? Math.min(1, loaded / total) : undefined;
  return html`<div class="progress" part="progress">
    <slot name="progress"><progress aria-label="Loading" max="1" value=${share ?? nothing}></progress></slot>
  </div>`;
}

/** What went wrong, in words. It can be focused, as it may have to be scrolled. */
export function renderError({ message }: VolumeViewError): unknown {
  return html`<div class="error" part="error" role="alert" tabindex="0"><slot name="error"><p>${message}</p></slot></div>`;
}

/** What a screen reader is told of loading, in tens of per cent, so that nobody is read a hundred numbers. */
export function describeProgress({ loaded, total, phase }: LoadProgress): string {
  if (phase === 'decode') return 'Decoding';
  return total > 0 ? `Loading ${Math.floor(Math.min(1, loaded / total) * 10) * 10} %` : 'Loading';
}

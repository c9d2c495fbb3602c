import { html, nothing } from 'lit';
import type { VolumeViewError } from '../../src/core/errors.ts';
import type { LoadProgress } from '../../src/formats/base/load-request.ts';
import type { RingWriter } from '../../src/viewer/cuts/ring-labels.ts';
import type { ViewTerms } from '../../src/messages/terms.ts';
import type { Words } from '../../src/messages/words.ts';

/** What stands in the picture's place until there is one. */
export function renderPoster(poster: string | null): unknown {
  return html`<slot name="poster">
    ${poster ? html`<img class="poster" part="poster" src=${poster} alt="" />` : nothing}
  </slot>`;
}

/** How far loading is; a bar that runs to and fro where nobody knows the end. */
export function renderProgress({ loaded, total }: LoadProgress, { loading }: ViewTerms): unknown {
  const share = total > 0 ? Math.min(1, loaded / total) : undefined;
  return html`<div class="progress" part="progress">
    <slot name="progress"><progress aria-label=${loading} max="1" value=${share ?? nothing}></progress></slot>
  </div>`;
}

/** Addresses, up to the folder and the name. A reader has no use for all of them, and they may hold what is secret; the event has them whole. */
const addresses = /\w+:\/\/[^\s"?#/]*(?:\/[^\s"?#/]+)*?\/((?:[^\s"?#/]+\/)?[^\s"?#/]+)(?![^\s"?#])[^\s";]*/g;

/** What went wrong: a line for the reader, and what the page's author can do. It can be focused, as it may have to be scrolled.
 * @param retry - loads the file once more */
export function renderError({ code, message, topic }: VolumeViewError, { errors, tryAgain }: ViewTerms, retry: () => void): unknown {
  const headline = errors[topic!] ?? errors[code] ?? errors[code.split('/')[0] as keyof typeof errors];
  return html`<div class="error" part="error" role="alert" tabindex="0"><slot name="error">
    <p><strong>${headline}</strong></p>
    <p lang="en">${message.replace(addresses, '$1')}</p>
    ${code.startsWith('source') ? html`<button part="retry" @click=${retry}>${tryAgain}</button>` : nothing}
  </slot></div>`;
}

/** What a screen reader is told: nothing of errors, which are told where they are shown. */
export function describeStatus(progress: LoadProgress | null, hasPicture: boolean, words: Words<ViewTerms>): string {
  if (progress) return describeProgress(progress, words);
  return hasPicture ? words.terms.loaded : '';
}

/** The words for a ring around a radar, for the mark of the north, and for what has to be known of the scan. */
export function describeRing(what: Parameters<RingWriter>[0], words: Words<ViewTerms>): string {
  const { north, kilometres, heightsTimes } = words.terms;
  if (what === null) return north;
  if (typeof what === 'number') return kilometres(words.number(what / 1000, { maximumSignificantDigits: 6 }));
  return [what.name, what.stretch === 1 ? '' : heightsTimes(words.number(what.stretch))].filter(Boolean).join(' · ');
}

/** How far loading is, in tens of per cent, so that nobody is read a hundred numbers. */
function describeProgress({ loaded, total, phase }: LoadProgress, words: Words<ViewTerms>): string {
  const { loading, loadingPercent, decoding } = words.terms;
  if (phase === 'decode') return decoding;
  return total > 0 ? loadingPercent(words.number(Math.floor(Math.min(1, loaded / total) * 10) / 10, { style: 'percent' })) : loading;
}

import { html, nothing } from 'lit';
import type { VolumeViewError } from '../../src/core/errors.ts';
import type { LoadProgress } from '../../src/formats/base/load-request.ts';
import type { RingWriter } from '../../src/viewer/cuts/ring-labels.ts';
import type { ViewMessages } from '../../src/messages/messages.ts';
import type { LocaleController } from '../../src/messages/locale-controller.ts';

/** The image that is shown until there is a picture. */
export function renderPoster(poster: string | null): unknown {
  return html`<slot name="poster">
    ${poster ? html`<img class="poster" part="poster" src=${poster} alt="" />` : nothing}
  </slot>`;
}

/** The progress of loading; a bar that moves to and fro where the total is unknown. */
export function renderProgress({ loaded, total }: LoadProgress, { loading }: ViewMessages): unknown {
  const share = total > 0 ? Math.min(1, loaded / total) : undefined;
  return html`<div class="progress" part="progress">
    <slot name="progress"><progress aria-label=${loading} max="1" value=${share ?? nothing}></progress></slot>
  </div>`;
}

/**
 * Addresses, matched up to the last folder and the name. Readers do not need the whole address, and it may contain secrets; the event has
 * the whole address.
 */
const addresses = /\w+:\/\/[^\s"?#/]*(?:\/[^\s"?#/]+)*?\/((?:[^\s"?#/]+\/)?[^\s"?#/]+)(?![^\s"?#])[^\s";]*/g;

/**
 * The error message: a line for the reader, and what the author of the page can do. It can have the focus, as it may have to be scrolled.
 * @param retry - loads the file once more
 */
export function renderError(
  { code, message, topic }: VolumeViewError,
  { errors, tryAgain }: ViewMessages,
  retry: () => void,
): unknown {
  const headline = errors[topic!] ?? errors[code] ?? errors[code.split('/')[0] as keyof typeof errors];
  return html`<div class="error" part="error" role="alert" tabindex="0"><slot name="error">
    <p><strong>${headline}</strong></p>
    <p lang="en">${message.replace(addresses, '$1')}</p>
    ${code.startsWith('source') ? html`<button part="retry" @click=${retry}>${tryAgain}</button>` : nothing}
  </slot></div>`;
}

/** The text for screen readers. It contains no errors, as these are read where they are shown. */
export function describeStatus(
  progress: LoadProgress | null,
  hasPicture: boolean,
  locale: LocaleController<ViewMessages>,
): string {
  if (progress) return describeProgress(progress, locale);
  return hasPicture ? locale.messages.loaded : '';
}

/** The text of a ring around a radar, of the mark of the north, and of the notes on the scan. */
export function describeRing(what: Parameters<RingWriter>[0], locale: LocaleController<ViewMessages>): string {
  const { north, kilometres, heightsTimes } = locale.messages;
  if (what === null) return north;
  if (typeof what === 'number') return kilometres(locale.number(what / 1000, { maximumSignificantDigits: 6 }));
  return [what.name, what.stretch === 1 ? '' : heightsTimes(locale.number(what.stretch))].filter(Boolean).join(' · ');
}

/** The progress of loading, in steps of ten per cent, so that a screen reader does not read a hundred numbers. */
function describeProgress({ loaded, total, phase }: LoadProgress, locale: LocaleController<ViewMessages>): string {
  const { loading, loadingPercent, decoding } = locale.messages;
  if (phase === 'decode') return decoding;
  return total > 0
    ? loadingPercent(locale.number(Math.floor(Math.min(1, loaded / total) * 10) / 10, { style: 'percent' }))
    : loading;
}

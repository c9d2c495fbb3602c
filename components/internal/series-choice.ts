import { html, nothing } from 'lit';
import { live } from 'lit/directives/live.js';
import { ref } from 'lit/directives/ref.js';
import { repeat } from 'lit/directives/repeat.js';
import type { DropMessages } from '../../src/messages/drop-messages.ts';
import type { SeriesInfo } from '../../src/volume/volume.ts';

/** What the list needs of its view. */
interface SeriesView {
  readonly volume: { readonly series?: readonly SeriesInfo[] } | null;
  series: number | null;
}

/** The series of a view's files, to choose one; nothing where there is only one. @param number - writes a number for people */
export function renderSeriesChoice(
  view: SeriesView,
  messages: DropMessages,
  number: (value: number) => string,
): unknown {
  const series = view.volume?.series;
  if (!series) return nothing;
  const chosen = view.series ?? series.find(({ shown }) => shown)?.number;
  const describe = ({ modality, seriesNumber }: SeriesInfo): string =>
    [modality, seriesNumber === undefined ? '' : messages.seriesNumber(number(seriesNumber))]
      .filter(Boolean)
      .join(' · ');
  return html`<ul class="series" part="list" role="radiogroup" aria-label=${messages.seriesList}>${repeat(
    series,
    (one) => one.number,
    (one) => html`<li part="row" role="presentation"><label>
      <input type="radio" name="series" .checked=${live(one.number === chosen)} @change=${() => (view.series = one.number)} />
      <span class="picture" part="picture">${one.picture ? html`<canvas aria-hidden="true" ${ref((canvas) => draw(canvas as HTMLCanvasElement | undefined, one.picture!))}></canvas>` : nothing}</span>
      <span class="words"><bdi class="name">${describe(one) || number(one.number)}</bdi><bdi>${one.dimensions.slice(0, 2).map(number).join(' × ')} · ${messages.seriesSlices(number(one.dimensions[2]))}</bdi></span>
    </label></li>`,
  )}</ul>`;
}

function draw(
  canvas: HTMLCanvasElement | undefined,
  { width, height, aspect, pixels }: NonNullable<SeriesInfo['picture']>,
): void {
  if (!canvas) return;
  canvas.width = width;
  canvas.height = height;
  canvas.style.aspectRatio = String(aspect);
  const image = new ImageData(width, height);
  pixels.forEach((gray, i) => image.data.set([gray, gray, gray, 255], 4 * i));
  canvas.getContext('2d')?.putImageData(image, 0, 0);
}

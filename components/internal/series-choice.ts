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
export function renderSeriesChoice(view: SeriesView, messages: DropMessages, number: NumberWriter): unknown {
  const series = view.volume?.series;
  if (!series) return nothing;
  const chosen = view.series ?? series.find(({ shown }) => shown)?.number;
  const words = series.map((one) => describe(one, messages, number));
  return html`<ul class="series" part="list" role="radiogroup" aria-label=${messages.seriesList}>${repeat(
    series,
    (one) => one.number,
    (one, i) => html`<li part="row" role="presentation"><label>
      <input type="radio" name="series" .checked=${live(one.number === chosen)} @change=${() => (view.series = one.number)} />
      <span class="picture" part="picture">${one.picture ? html`<canvas aria-hidden="true" ${ref((canvas) => draw(canvas as HTMLCanvasElement | undefined, one.picture!))}></canvas>` : nothing}</span>
      <span class="words"><bdi class="name">${nameOf(i, words, number) || number(one.number)}</bdi><bdi>${words[i].size}</bdi></span>
    </label></li>`,
  )}</ul>`;
}

interface SeriesWords {
  readonly name: string;
  readonly size: string;
}

type NumberWriter = (value: number, options?: Intl.NumberFormatOptions) => string;

/** What a series is, and how large. */
function describe(
  { modality, format, seriesNumber, dimensions, plane, spacing, files, bytes }: SeriesInfo,
  messages: DropMessages,
  number: NumberWriter,
): SeriesWords {
  const say = (value: number): string => number(value);
  return {
    name: join(format, modality, seriesNumber !== undefined && messages.seriesNumber(say(seriesNumber))),
    size: join(
      dimensions && `${say(dimensions[0])} × ${say(dimensions[1])}`,
      dimensions && messages.seriesSlices(say(dimensions[2])),
      plane && messages.seriesPlane[plane],
      spacing && `${spacing.map((mm) => number(mm, { maximumSignificantDigits: 2 })).join(' × ')} mm`,
      files !== undefined && files > 1 && messages.seriesFiles(say(files)),
      bytes !== undefined && writeBytes(bytes, number),
    ),
  };
}

const join = (...words: readonly (string | false | undefined)[]): string => words.filter(Boolean).join(' · ');

function writeBytes(bytes: number, number: NumberWriter): string {
  const [unit, size] = bytes < 1e6 ? (['kilobyte', 1e3] as const) : (['megabyte', 1e6] as const);
  return number(bytes / size, { style: 'unit', unit, maximumSignificantDigits: 3 });
}

/** Of several series of the same words each has its place among them. */
function nameOf(place: number, words: readonly SeriesWords[], number: NumberWriter): string {
  const { name, size } = words[place];
  const alike = words.flatMap((one, i) => (one.name === name && one.size === size ? [i] : []));
  return alike.length > 1 ? `${name} (${number(alike.indexOf(place) + 1)})` : name;
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

// The editor's chart of values and gradients. It is loaded with the first editor that shows it.
import { html, nothing, svg } from 'lit';
import type { ReactiveControllerHost } from 'lit';
import { nameColor } from '../../src/editor/color-names.ts';
import { countJointly } from '../../src/editor/joint-histogram.ts';
import type { PlaneSamples } from '../../src/editor/joint-histogram.ts';
import { gripReach, hasRoom, placeOfGrip } from '../../src/editor/patch-edits.ts';
import type { Grip } from '../../src/editor/patch-edits.ts';
import { PatchEditor } from '../../src/editor/patch-editor.ts';
import type { Taken } from '../../src/editor/patch-input.ts';
import { listTicks } from '../../src/editor/ticks.ts';
import { toHeight } from '../../src/editor/transfer-function-axes.ts';
import type { EditSession } from '../../src/editor/transfer-function-session.ts';
import type { Patch } from '../../src/optics/transfer/patches.ts';
import { writeColor } from '../../src/optics/transfer/write-transfer-function.ts';
import { collectSamples } from '../../src/viewer/tools/sample-plane.ts';
import type { Volume } from '../../src/volume/volume.ts';
import type { Language } from '../../src/messages/language.ts';
import { PlaneLocale } from '../../src/messages/plane-locale.ts';
import { renderValueScale } from './transfer-function-chart.ts';
import { renderPatchFields } from './transfer-function-patch-fields.ts';

/** Number of bins of the histogram, horizontally and vertically. */
const bins = [160, 80] as const;

/** Width and height of the drawing, in its own units. */
const size = 1000;

/** The inputs of the chart. */
interface PlaneChart {
  readonly volume: Volume;
  readonly domain: readonly [number, number];
  readonly unit: string;
  readonly language: Language;
}

/** A count of the values in a volume, and its result: null where it failed. */
interface Counting {
  /** A weak reference: the count must not keep the volume in memory when another mode no longer needs it. */
  readonly volume: WeakRef<Volume>;
  readonly control: AbortController;
  samples?: PlaneSamples | null;
}

/** Boxes and Gaussians over a histogram of values and gradients, with handles to edit them. */
export class Plane {
  readonly editor: PatchEditor;
  readonly #locale: PlaneLocale;
  #counted: Counting | null = null;
  #painted: readonly unknown[] = [];

  constructor(
    readonly host: ReactiveControllerHost & HTMLElement,
    session: EditSession,
  ) {
    this.#locale = new PlaneLocale(host);
    this.editor = new PatchEditor(session, {
      changed: () => host.requestUpdate(),
      focus: (taken) =>
        void host.updateComplete.then(() =>
          (this.#gripOf(taken) ?? host.shadowRoot?.querySelector<HTMLElement>('.fields button'))?.focus({
            preventScroll: true,
          }),
        ),
    });
  }

  render({ volume, domain, unit, language }: PlaneChart): unknown {
    const { messages } = this.#locale;
    if (volume.isDiscrete) return html`<p class="hint" part="hint">${messages.noGradients}</p>`;
    const { editor } = this;
    editor.span(domain, this.#samplesOf(volume));
    const { patches, input } = editor;
    const index = Math.min(editor.chosen, patches.length - 1);
    return html`<div>
      <div class="plot plane editable" role="group" aria-label=${messages.valuesAndGradients}
        @pointerdown=${input.down} @pointermove=${input.move} @pointerup=${input.up} @pointercancel=${input.up} @mousedown=${input.keepFocus}>
        <canvas part="chart" width=${bins[0]} height=${bins[1]} aria-hidden="true"></canvas>
        <svg class="chart" viewBox="0 0 ${size} ${size}" preserveAspectRatio="none" aria-hidden="true">${patches.map((patch, i) => this.#renderPatch(patch, i === index))}</svg>
        <div class="opacities" aria-hidden="true"><span class="axis">${messages.middleGradient}</span>${listTicks(
          [0, editor.range.steepest],
          4,
        )
          .slice(1)
          .map(
            (tick) => html`<span .style=${`--y: ${tick / editor.range.steepest}`}>${language.number(tick)}</span>`,
          )}</div>
        <div class="handles">${patches.map((patch, i) => this.#renderGrips(patch, i, { unit, language }))}</div>
      </div>
      ${renderValueScale({ domain, unit, language })}</div>
      ${patches[index] ? nothing : html`<p>${messages.drawBox}</p>`}
      ${renderPatchFields(
        { patch: patches[index], hasRoom: hasRoom(patches), messages, language },
        {
          number: (which, number) => editor.changeNumber(index, which, number),
          look: (appearance) => editor.changeAppearance(index, appearance),
          done: () => editor.session.commit(),
          add: (kind) => editor.add(kind),
          remove: () => editor.remove(index),
        },
      )}
      <div id="patch-keys" class="spoken">${messages.patchKeys}</div>`;
  }

  /** Draw the histogram, when the chart is in the page. */
  paint(root: ParentNode): void {
    const canvas = root.querySelector<HTMLCanvasElement>('.plane canvas');
    const samples = this.#counted?.samples;
    const { domain, steepest } = this.editor.range;
    const now = [canvas, samples, ...domain, steepest];
    if (!canvas || now.every((one, i) => one === this.#painted[i])) return;
    this.#painted = now;
    const context = canvas.getContext('2d', { willReadFrequently: true })!;
    context.clearRect(0, 0, ...bins);
    if (!samples) return;
    const counts = countJointly(samples, { domain, steepest }, bins);
    const top = Math.log1p(counts.reduce((max, count) => Math.max(max, count), 1));
    const picture = context.createImageData(...bins);
    counts.forEach((count, at) => {
      const row = bins[1] - 1 - Math.floor(at / bins[0]);
      picture.data.set(
        [232, 236, 242, Math.round(200 * (Math.log1p(count) / top) ** 0.7)],
        4 * (row * bins[0] + (at % bins[0])),
      );
    });
    context.putImageData(picture, 0, 0);
  }

  /** Handle a key that was pressed at an element. @returns whether the key has an effect */
  press(event: KeyboardEvent): boolean {
    const taken = takenBy(event.target);
    return taken !== null && this.editor.press(event, taken);
  }

  /** Called when a grip has got the focus, or a key was released at a grip. */
  follow(target: EventTarget | null): Taken | null {
    const taken = takenBy(target);
    if (taken && taken.index !== this.editor.chosen) {
      this.editor.chosen = taken.index;
      this.host.requestUpdate();
    }
    return taken;
  }

  /** Stop counting. */
  stop(): void {
    this.#counted?.control.abort();
    if (!this.#counted?.samples) this.#counted = null;
  }

  #samplesOf(volume: Volume): PlaneSamples | null {
    if (this.#counted?.volume.deref() !== volume) {
      this.#counted?.control.abort();
      const counted: Counting = { volume: new WeakRef(volume), control: new AbortController() };
      this.#counted = counted;
      void collectSamples(volume, counted.control.signal).then((samples) => {
        counted.samples = samples;
        if (this.#counted === counted) this.host.requestUpdate();
      });
    }
    return this.#counted.samples ?? null;
  }

  #renderPatch(patch: Patch, isChosen: boolean): unknown {
    const at = (place: readonly [number, number]): readonly [number, number] => {
      const { share, height } = this.editor.placeOf(place);
      return [size * share, size * (1 - height)];
    };
    const style = `--color: ${writeColor(patch.color)}; --fill: ${(0.12 + 0.6 * toHeight(patch.opacity)).toFixed(3)}`;
    if (patch.kind === 'box') {
      const [[left, bottom], [right, top]] = [
        at([patch.values[0], patch.gradients[0]]),
        at([patch.values[1], patch.gradients[1]]),
      ];
      return svg`<rect class="patch" ?data-chosen=${isChosen} style=${style} x=${left} y=${top} width=${right - left} height=${bottom - top}></rect>`;
    }
    const [x, y] = at([patch.value, patch.gradient]);
    const [right, top] = at([patch.value + patch.widths[0], patch.gradient + patch.widths[1]]);
    return [1, gripReach].map(
      (reach) =>
        svg`<ellipse class="patch" ?data-chosen=${isChosen} style=${style} cx=${x} cy=${y} rx=${reach * (right - x)} ry=${reach * (y - top)}></ellipse>`,
    );
  }

  #renderGrips(patch: Patch, index: number, { unit, language }: { unit: string; language: Language }): unknown {
    const { messages } = this.#locale;
    const {
      patches,
      range: { domain },
    } = this.editor;
    const name = (patch.kind === 'box' ? messages.boxOf : messages.gaussianOf)(
      language.number(index + 1),
      language.number(patches.length),
    );
    const [low, high] =
      patch.kind === 'box' ? patch.values : [patch.value - patch.widths[0], patch.value + patch.widths[0]];
    const [min, max] =
      patch.kind === 'box'
        ? patch.gradients
        : [Math.max(0, patch.gradient - patch.widths[1]), patch.gradient + patch.widths[1]];
    const said = messages.patchState(
      language.range(low, high, unit),
      language.range(min, max, ''),
      language.opacity(patch.opacity),
      nameColor(patch.color, language.messages),
    );
    const render = (grip: Grip): unknown => {
      const place = placeOfGrip(patch, grip);
      const { share, height } = this.editor.placeOf(place);
      return html`<div class="handle ${grip}" part="handle" role="slider" tabindex="0" data-patch=${index} data-grip=${grip}
        aria-label=${grip === 'size' ? messages.sizeOf(name) : name} aria-valuemin=${domain[0]} aria-valuemax=${domain[1]} aria-valuenow=${place[0]} aria-valuetext=${said} aria-describedby="patch-keys"
        ?data-chosen=${index === this.editor.chosen} .style=${`--x: ${Math.min(1, Math.max(0, share))}; --y: ${Math.min(1, Math.max(0, height))}; --color: ${writeColor(patch.color)}`}></div>`;
    };
    return [render('middle'), render('size')];
  }

  #gripOf({ index, grip }: Taken): HTMLElement | null {
    return this.host.shadowRoot?.querySelector<HTMLElement>(`[data-patch="${index}"][data-grip="${grip}"]`) ?? null;
  }
}

function takenBy(target: EventTarget | null): Taken | null {
  const { patch, grip } = (target as HTMLElement).dataset;
  return patch === undefined ? null : { index: Number(patch), grip: grip as Grip };
}

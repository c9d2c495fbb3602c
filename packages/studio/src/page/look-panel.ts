// How the volume looks: pictures to choose from, then light, density and the window.
import { html, nothing } from 'lit';
import { changeView } from '../model/edit.ts';
import { changesFor, hasLook, looksFor } from '../model/looks.ts';
import type { Look } from '../model/looks.ts';
import { choice, shortNumber, slider } from './fields.ts';
import type { Painter } from './painter.ts';
import type { Studio } from './studio.ts';
import { findPicture } from './view-element.ts';

export function renderLook(studio: Studio, painter: Painter): unknown {
  const { words, lesson } = studio;
  const volume = findPicture()?.volume;
  if (!volume) return nothing;
  const looks = looksFor({ unit: volume.unit, range: volume.range, isRadar: volume.sweeps !== undefined });
  const shown = looks
    .map((look) => ({ look, picture: painter.draw(look.attributes) }))
    .filter(({ picture }) => picture !== 'none');
  const chosen = looks.find((look) => hasLook(lesson.view, look));
  return html`<h2>${words.lookTitle}</h2>
    <div class="looks" role="radiogroup" aria-label=${words.lookTitle} @keydown=${moveChoice}>
      ${shown.map(({ look, picture }, i) => renderLookButton(studio, look, picture, { isChosen: look === chosen, isFirst: i === 0 && !chosen }))}
    </div>
    <p class="hint" role="status">${painter.isBusy ? words.lookDrawing : ''}</p>
    <h2>${words.finer}</h2>
    ${renderFiner(studio)}`;
}

function renderLookButton(
  studio: Studio,
  look: Look,
  picture: string | null,
  { isChosen, isFirst }: { readonly isChosen: boolean; readonly isFirst: boolean },
): unknown {
  return html`<button role="radio" class="look" id=${`look-${look.name}`} aria-checked=${isChosen} tabindex=${isChosen || isFirst ? 0 : -1}
    @click=${() => studio.edit((lesson) => changeView(lesson, changesFor(look)), { withCamera: true })}>
    ${picture ? html`<img src=${picture} alt="" width="144" height="108" />` : html`<span class="blank"></span>`}
    <span>${studio.words.look(look.name)}</span>
  </button>`;
}

/** Arrow keys go from one choice to the next, as in a group of radio buttons. */
function moveChoice(event: KeyboardEvent): void {
  const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
  if (by === undefined) return;
  event.preventDefault();
  const all = [...(event.currentTarget as HTMLElement).querySelectorAll<HTMLElement>('[role=radio]')];
  const at = all.indexOf(document.activeElement as HTMLElement);
  const next = all[(at + by + all.length) % all.length];
  next?.focus();
  next?.click();
}

function renderFiner(studio: Studio): unknown {
  const { words, lesson } = studio;
  const view = findPicture();
  const [optics, volume] = [view?.optics, view?.volume];
  if (!optics || !volume) return nothing;
  const set = (name: string, text: string | null): void =>
    studio.edit((before) => changeView(before, { [name]: text }), { mark: name, withCamera: true });
  const factor = Number(lesson.view['opacity-factor'] ?? optics.opacityFactor);
  const light = Number(lesson.view['light-factor'] ?? optics.lightFactor);
  return html`
    ${choice({
      id: 'shading',
      label: words.light,
      value: (lesson.view.shading ?? 'auto') as 'auto' | 'lit' | 'unlit',
      options: { auto: words.lightAuto, lit: words.lightOn, unlit: words.lightOff },
      onChange: (value) => set('shading', value === 'auto' ? null : value),
    })}
    ${slider({
      id: 'density',
      label: words.density,
      value: Math.log10(factor),
      min: -1.5,
      max: 1.5,
      step: 0.05,
      said: shortNumber(factor),
      onInput: (value) => set('opacity-factor', shortNumber(10 ** value)),
    })}
    ${slider({
      id: 'brightness',
      label: words.brightness,
      value: light,
      min: 0.2,
      max: 3,
      step: 0.05,
      said: shortNumber(light),
      onInput: (value) => set('light-factor', shortNumber(value)),
    })}
    ${renderWindow(studio, optics.window, volume)}`;
}

function renderWindow(
  studio: Studio,
  window: readonly [number, number],
  { range, unit }: { readonly range: readonly [number, number]; readonly unit: string },
): unknown {
  const { words, lesson } = studio;
  const given = lesson.view['value-window']?.split(/\s+/).map(Number);
  const [low, high] = given?.length === 2 && given.every(Number.isFinite) ? given : window;
  const [min, max] = [Math.min(range[0], low), Math.max(range[1], high)];
  if (!(max > min)) return nothing;
  const step = Number(((max - min) / 500).toPrecision(1));
  const set = (ends: readonly [number, number]): void =>
    studio.edit((before) => changeView(before, { 'value-window': ends.map(shortNumber).join(' ') }), {
      mark: 'value-window',
      withCamera: true,
    });
  const say = (value: number): string => `${shortNumber(value)} ${unit}`.trim();
  return html`<fieldset>
    <legend>${words.window}</legend>
    <p class="hint">${words.windowHint}</p>
    ${slider({ id: 'window-low', label: words.windowLow, value: low, min, max, step, said: say(low), onInput: (value) => set([Math.min(value, high - step), high]) })}
    ${slider({ id: 'window-high', label: words.windowHigh, value: high, min, max, step, said: say(high), onInput: (value) => set([low, Math.max(value, low + step)]) })}
    ${given ? html`<button @click=${() => studio.edit((before) => changeView(before, { 'value-window': null }), { withCamera: true })}>${words.windowReset}</button>` : nothing}
  </fieldset>`;
}

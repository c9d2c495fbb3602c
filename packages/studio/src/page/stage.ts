// The picture of the lesson, with its notes; a click places what waits for a place.
import { html, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import { icon } from './icons.ts';
import type { Studio } from './studio.ts';
import type { View } from './view-element.ts';

/** CSS pixels: a pointer that moves farther between press and release turns the picture. */
const clickDistance = 5;

let pressed: { readonly x: number; readonly y: number } | null = null;

export function renderStage(studio: Studio): unknown {
  const { words, before, lesson } = studio;
  const { placing } = before;
  const step = lesson.steps.find(({ id }) => id === before.step);
  const open = before.tab === 'notes' ? [before.note] : (step?.notes ?? []);
  return html`<section class=${placing ? 'stage placing' : 'stage'} aria-label=${words.pictureAlt}>
    <volume-view
      id="picture"
      alt=${lesson.alt || words.pictureAlt}
      controls
      controlslist="nocopy noembed nolink"
      @load=${() => studio.draw()}
      @render=${(event: Event) => rememberHome(studio, event.currentTarget as View)}
      @camera-change=${() => studio.cameraMoved()}
      @optics-change=${() => studio.draw()}
      @pointerdown=${({ clientX: x, clientY: y }: PointerEvent) => (pressed = { x, y })}
      @pointerup=${(event: PointerEvent) => release(studio, event)}
    >
      ${repeat(
        lesson.notes,
        ({ id }) => id,
        ({ id, label, position, text }) =>
          html`<volume-note id=${id} position=${position} label=${label || nothing} hide=${before.note === id ? 'never' : nothing} ?open=${open.includes(id) && text.trim() !== ''}>
            ${text.split(/\n\s*\n/).map((paragraph) => html`<p>${paragraph}</p>`)}
          </volume-note>`,
      )}
      <volume-slice hidden></volume-slice>
    </volume-view>
    ${
      placing
        ? html`<div class="aim" aria-hidden="true"></div>
            <div class="placing-bar" role="group" aria-label=${placing.kind === 'note' ? words.placeNote : words.placeQuestion}>
              <p>${placing.kind === 'note' ? words.placeNote : words.placeQuestion}</p>
              <button id="place-middle" @click=${() => placeMiddle(studio)}>${icon('place')} ${words.placeMiddle}</button>
              <button @click=${() => studio.endPlacing()}>${words.placeCancel}</button>
            </div>`
        : nothing
    }
  </section>`;
}

function release(studio: Studio, { clientX, clientY, button }: PointerEvent): void {
  if (!studio.before.placing || button !== 0 || !pressed) return;
  if (Math.hypot(clientX - pressed.x, clientY - pressed.y) <= clickDistance) void studio.place(clientX, clientY);
}

function placeMiddle(studio: Studio): void {
  const box = document.querySelector('#picture')!.getBoundingClientRect();
  void studio.place(box.left + box.width / 2, box.top + box.height / 2);
}

/** Where the camera is as long as nobody has moved it, and its distance is open. */
function rememberHome(studio: Studio, view: View): void {
  const { camera } = view;
  const orbit = view.getAttribute('camera-orbit');
  const isThere = (view.getView()['camera-orbit'] ?? null) === orbit;
  if (camera && isThere && (orbit === null || orbit.endsWith(' auto')))
    studio.home = { radius: camera.orbit.radius, target: camera.target };
}

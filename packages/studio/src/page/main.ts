// The page: it is drawn again from the lesson after each change.
import { html, nothing, render } from 'lit';
import { live } from 'lit/directives/live.js';
import { renderAbout } from './about-panel.ts';
import { renderCut } from './cut-panel.ts';
import { renderExport } from './export-dialog.ts';
import { icon } from './icons.ts';
import { renderLook } from './look-panel.ts';
import { renderNotes } from './notes-panel.ts';
import { Painter } from './painter.ts';
import { renderPreview } from './preview-dialog.ts';
import { renderStage } from './stage.ts';
import { renderStart } from './start-screen.ts';
import { renderSteps } from './steps-panel.ts';
import { Studio } from './studio.ts';
import type { Before, Tab } from './before.ts';

const place = document.querySelector<HTMLElement>('#studio')!;
const painter = new Painter(() => studio.draw());
const studio = new Studio(drawSoon);
const tabs: readonly Tab[] = ['steps', 'look', 'cut', 'notes', 'about'];

let isDue = false;

/** Several changes of one moment are drawn together. */
function drawSoon(): void {
  if (studio.before.screen === 'edit' && !place.querySelector('#picture')) return draw();
  if (isDue) return;
  isDue = true;
  queueMicrotask(draw);
}

function draw(): void {
  isDue = false;
  painter.follow(studio.data);
  render(renderPage(), place);
  for (const dialog of place.querySelectorAll('dialog')) if (!dialog.open) dialog.showModal();
  const { focusNext } = studio;
  if (focusNext === null) return;
  const found = place.querySelector<HTMLElement>(focusNext);
  if (!found) return;
  studio.focusNext = null;
  found.focus();
}

function renderPage(): unknown {
  const { before, words } = studio;
  if (before.screen === 'opening') return nothing;
  return html`${renderBar()}
    ${before.problem && !before.dialog ? html`<p class="problem" role="alert">${before.problem} <button class="link" @click=${() => studio.show({ problem: null })}>${words.close}</button></p>` : nothing}
    ${before.screen === 'start' ? renderStart(studio) : renderEditor()}
    ${before.busy ? html`<div class="busy" role="alert"><span class="spinner"></span>${before.busy}</div>` : nothing}
    ${renderDialog(before.dialog)}`;
}

function renderBar(): unknown {
  const { words, lesson, history, before } = studio;
  const isEditing = before.screen === 'edit';
  const keeping = { kept: words.kept, keeping: words.keeping, 'not-kept': words.notKept }[before.keeping];
  return html`<header class="bar">
    ${isEditing ? html`<h1 class="brand">${words.name}</h1>` : html`<span class="brand">${words.name}</span>`}
    ${
      isEditing
        ? html`<input class="lesson-title" id="lesson-title" type="text" aria-label=${words.title} placeholder=${words.untitled} autocomplete="off" .value=${live(lesson.title)}
              @input=${({ target }: Event) => studio.edit((one) => ({ ...one, title: (target as HTMLInputElement).value }), { mark: 'title' })} />
            <div class="tools">
              <button class="icon-only" id="undo" aria-label=${words.undo} title=${`${words.undo} (Ctrl+Z)`} ?disabled=${history.past.length === 0} @click=${() => studio.undo()}>${icon('undo')}</button>
              <button class="icon-only" id="redo" aria-label=${words.redo} title=${`${words.redo} (Ctrl+Shift+Z)`} ?disabled=${history.future.length === 0} @click=${() => studio.redo()}>${icon('redo')}</button>
              <button id="preview" @click=${() => studio.show({ dialog: 'preview' })}>${icon('play')} <span class="wide-only">${words.preview}</span></button>
              <button id="export" class="primary" @click=${() => studio.show({ dialog: 'export' })}>${icon('take')} ${words.export}</button>
            </div>`
        : nothing
    }
    <p class="keeping" role="status"><span class="said">${before.said}</span> <span id="keeping">${isEditing || before.keeping === 'not-kept' ? keeping : ''}</span>
      ${isEditing ? html`<button class="link" id="again" @click=${() => studio.show({ dialog: 'again' })}>${words.again}</button>` : nothing}</p>
  </header>`;
}

function renderEditor(): unknown {
  const { words, before } = studio;
  return html`<main class="editor">
    ${renderStage(studio)}
    <section class="panel" aria-label=${words.panel}>
      <div class="tabs" role="tablist" aria-label=${words.panel} @keydown=${moveTab}>
        ${tabs.map(
          (tab) =>
            html`<button role="tab" id=${`tab-${tab}`} aria-selected=${before.tab === tab} aria-controls="tab-panel" tabindex=${before.tab === tab ? 0 : -1} @click=${() => studio.show({ tab })}>${words.tabs[tab]}</button>`,
        )}
      </div>
      <div class="tab-panel" id="tab-panel" role="tabpanel" aria-labelledby=${`tab-${before.tab}`}>${renderTab(before.tab)}</div>
    </section>
  </main>`;
}

function renderTab(tab: Tab): unknown {
  switch (tab) {
    case 'steps':
      return renderSteps(studio, painter);
    case 'look':
      return renderLook(studio, painter);
    case 'cut':
      return renderCut(studio);
    case 'notes':
      return renderNotes(studio);
    case 'about':
      return renderAbout(studio);
  }
}

/** Arrow keys go from tab to tab. */
function moveTab(event: KeyboardEvent): void {
  const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
  if (by === undefined) return;
  event.preventDefault();
  const next = tabs[(tabs.indexOf(studio.before.tab) + by + tabs.length) % tabs.length];
  studio.focusNext = `#tab-${next}`;
  studio.show({ tab: next });
}

function renderDialog(dialog: Before['dialog']): unknown {
  const { words } = studio;
  const close = (): void => studio.show({ dialog: null });
  switch (dialog) {
    case null:
      return nothing;
    case 'export':
      return html`<dialog class="export" aria-labelledby="export-heading" @close=${close}>${renderExport(studio)}</dialog>`;
    case 'preview':
      return html`<dialog class="preview" aria-labelledby="preview-title" @close=${close}>${renderPreview(studio)}</dialog>`;
    case 'again':
      return html`<dialog class="again" aria-labelledby="again-title" @close=${close}>
        <h2 id="again-title">${words.againTitle}</h2>
        <p>${words.againText}</p>
        <div class="row">
          <button id="again-no" autofocus @click=${close}>${words.againNo}</button>
          <button class="danger" id="again-yes" @click=${() => void studio.startAgain()}>${words.againYes}</button>
        </div>
      </dialog>`;
  }
}

document.addEventListener('keydown', (event) => {
  const isUndo = event.key.toLowerCase() === 'z' && (event.ctrlKey || event.metaKey) && !event.altKey;
  const isRedo = (isUndo && event.shiftKey) || (event.key.toLowerCase() === 'y' && event.ctrlKey);
  if (event.key === 'Escape' && studio.before.placing) return studio.endPlacing();
  if ((!isUndo && !isRedo) || studio.before.screen !== 'edit') return;
  // The fields are of the lesson: their own undo would not know of the rest.
  event.preventDefault();
  if (isRedo) studio.redo();
  else studio.undo();
});
// A lesson that is dropped is no scan, although both may be ZIP archives.
document.addEventListener(
  'drop',
  (event) => {
    const [file, ...others] = event.dataTransfer?.files ?? [];
    if (studio.before.screen !== 'start' || !file || others.length > 0 || !/\.(zip|html?)$/i.test(file.name)) return;
    event.preventDefault();
    event.stopPropagation();
    void studio.openDropped(file);
  },
  { capture: true },
);
// Elsewhere in the page a dropped file would take its place.
for (const type of ['dragover', 'drop'] as const) document.addEventListener(type, (event) => event.preventDefault());

document.title = `${studio.words.name} · ${studio.words.brand}`;
void studio.begin();

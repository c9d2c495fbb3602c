// Takes the lesson away: as a file for a web server or a course, or as HTML to copy.
import { html, nothing } from 'lit';
import { largeFile } from '../../../lesson-writers/src/index.ts';
import type { LessonFile } from '../../../lesson-writers/src/index.ts';
import { endingOf, exportLesson, posterName } from '../data/export-lesson.ts';
import type { ExportKind } from '../data/export-lesson.ts';
import type { LessonData } from '../data/prepare.ts';
import { findLacks } from '../model/check-lesson.ts';
import type { Lack } from '../model/check-lesson.ts';
import type { Lesson } from '../model/lesson.ts';
import { writeLessonHtml } from '../model/write-lesson.ts';
import { aboutField } from './about-panel.ts';
import { textField } from './fields.ts';
import { icon } from './icons.ts';
import { drawPoster } from './painter.ts';
import type { Tab } from './before.ts';
import type { Studio } from './studio.ts';

/** What the author chose, as long as the page is open. */
const chosen = { kind: 'page' as ExportKind, pass: '', address: '', said: '', isBusy: false };

export function renderExport(studio: Studio): unknown {
  const { words, lesson } = studio;
  const lacks = findLacks(lesson);
  const choose = (kind: ExportKind): void => {
    Object.assign(chosen, { kind, said: '' });
    studio.draw();
  };
  return html`<h2 id="export-heading">${words.exportTitle}</h2>
    ${(['title', 'credits', 'licence'] as const).map((name) => aboutField(studio, name, 'export'))}
    <p class="warning">${words.faceWarning}</p>
    ${lacks.length > 0 ? renderLacks(studio, lacks) : nothing}
    <fieldset class="kinds">
      <legend>${words.format}</legend>
      ${Object.entries(words.exportKinds).map(
        ([
          kind,
          [name, hint],
        ]) => html`<label class="kind"><input type="radio" name="kind" value=${kind} .checked=${chosen.kind === kind} @change=${() => choose(kind as ExportKind)} />
          <span><b>${name}</b><br />${hint}</span></label>`,
      )}
    </fieldset>
    ${renderDetail(studio)}
    <div class="row">
      <button class="primary" id="download" ?disabled=${lacks.length > 0 || chosen.isBusy} @click=${() => void download(studio)}>${icon('take')} ${words.download}</button>
    </div>
    <p role="status" class="said">${chosen.said}</p>
    <h3>${words.copyTitle}</h3>
    <p class="hint">${words.copyHint}</p>
    <textarea id="export-html" readonly rows="5" dir="ltr" spellcheck="false" aria-label=${words.html} .value=${writeLessonHtml(lesson, 'data/volume.json')}></textarea>
    <div class="row">
      <button id="copy-html" @click=${() => void copy(studio)}>${words.copy}</button>
      <button @click=${() => studio.show({ dialog: null })}>${words.close}</button>
    </div>`;
}

/** What a format asks for in addition. */
function renderDetail(studio: Studio): unknown {
  const { words } = studio;
  const field = (name: 'pass' | 'address', label: string, hint?: string): unknown =>
    textField({
      id: `export-${name}`,
      label,
      hint,
      value: chosen[name],
      onInput: (text) => {
        chosen[name] = text;
        studio.draw();
      },
    });
  if (chosen.kind === 'embed') return field('address', words.address, words.addressHint);
  return isCourse(chosen.kind) ? field('pass', words.pass) : nothing;
}

const isCourse = (kind: ExportKind): boolean => ['scorm', 'scorm-2004', 'cmi5'].includes(kind);

function renderLacks(studio: Studio, lacks: readonly Lack[]): unknown {
  const { words } = studio;
  return html`<section class="lacks" aria-labelledby="lacks-title">
    <h3 id="lacks-title">${words.lacksTitle}</h3>
    <ul>
      ${lacks.map(
        (lack) => html`<li>
          ${describe(studio, lack)}
          ${lack.id ? html`<button class="link" @click=${() => goTo(studio, lack)}>${words.goThere}</button>` : nothing}
        </li>`,
      )}
    </ul>
  </section>`;
}

function describe({ words }: Studio, { kind, number }: Lack): string {
  const text = words.lacks[kind];
  if (number === undefined) return text;
  return kind === 'note-place' ? words.lackOfNote(number, text) : words.lackOfStep(number, text);
}

function goTo(studio: Studio, { kind, id }: Lack): void {
  const tab: Tab = kind === 'note-place' ? 'notes' : 'steps';
  studio.show({ dialog: null, tab, ...(tab === 'notes' ? { note: id ?? null } : {}) });
  if (tab === 'steps') studio.openStep(id ?? null);
}

async function download(studio: Studio): Promise<void> {
  const { words, lesson, data } = studio;
  const { kind, pass } = chosen;
  const address = chosen.address.trim();
  const say = (said: string, isBusy = false): void => {
    Object.assign(chosen, { said, isBusy });
    studio.draw();
  };
  const percent = !isCourse(kind) || pass.trim() === '' ? null : Number(pass);
  if (percent !== null && !(percent >= 1 && percent <= 100)) return say(words.passWrong);
  if (kind === 'embed' && !/^https?:\/\/[^/\s?#@]+[^\s?#]*$/.test(address)) return say(words.addressWrong);
  if (!data) return say(words.lacks.data);
  say(words.exporting, true);
  // The words are shown before the work begins.
  await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
  try {
    const poster = kind === 'embed' ? await makePoster(lesson, data) : null;
    const bytes = await exportLesson(lesson, data, { kind, pass: percent, address, poster });
    const name = `${nameOf(lesson.title)}${endingOf(kind)}`;
    save(bytes, name);
    const isLarge = kind === 'single-file' && bytes.length > largeFile;
    say(`${words.exported(name, words.megabytes(bytes.length))}${isLarge ? ` ${words.exportedLarge}` : ''}`);
  } catch (error) {
    say(words.exportFailed(error instanceof Error ? error.message : ''));
  }
}

/** The picture of the first step. */
async function makePoster(lesson: Lesson, data: LessonData): Promise<LessonFile | null> {
  const picture = await drawPoster(lesson.steps[0]?.view ?? lesson.view, data);
  return picture && { path: posterName(picture.type), bytes: new Uint8Array(await picture.arrayBuffer()) };
}

/** The name of a file that all systems take. */
const nameOf = (title: string): string =>
  title
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .replace(/[^\p{L}\p{N}]+/gu, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, 60)
    .toLowerCase() || 'lesson';

function save(bytes: Uint8Array, name: string): void {
  const address = URL.createObjectURL(
    new Blob([bytes as Uint8Array<ArrayBuffer>], { type: name.endsWith('.html') ? 'text/html' : 'application/zip' }),
  );
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

async function copy(studio: Studio): Promise<void> {
  const field = document.querySelector<HTMLTextAreaElement>('#export-html')!;
  const isCopied = await Promise.resolve()
    .then(() => navigator.clipboard.writeText(field.value))
    .then(
      () => true,
      () => false,
    );
  if (!isCopied) field.select();
  chosen.said = isCopied ? studio.words.copied : studio.words.copyByHand;
  studio.draw();
}

// The first page: open a scan of one's own, begin with a sample, or go on with a lesson.
import { html, nothing } from 'lit';
import { samples } from '../data/samples.ts';
import { icon } from './icons.ts';
import type { Studio } from './studio.ts';

export function renderStart(studio: Studio): unknown {
  const { words, before, lesson } = studio;
  const isBusy = before.busy !== null;
  return html`<main class="start">
    <div class="intro">
      <h1>${words.welcome}</h1>
      <p class="lead">${words.welcomeLead}</p>
      <p class="private">${icon('lock')} <span>${words.private}</span></p>
    </div>
    <section class="source" aria-labelledby="open-title">
      <h2 id="open-title">${words.openTitle}</h2>
      <volume-drop for="source">${words.dropHint}</volume-drop>
      <div class=${before.hasSource ? 'frame' : 'frame waits'}>
        <volume-view id="source" alt=${words.sourceAlt} controls controlslist="nocopy noembed nolink nosave" @load=${() => studio.show({ hasSource: true, problem: null })}></volume-view>
        ${before.hasSource ? nothing : html`<p class="empty" aria-hidden="true">${words.emptyPicture}</p>`}
      </div>
      ${
        before.hasSource
          ? html`<div class="taken">
              <p>${words.takeHint}</p>
              <p class="warning">${words.faceWarning}</p>
              <button class="primary" id="take" ?disabled=${isBusy} @click=${() => void studio.takeSource()}>
                ${lesson.data === null && lesson.steps.length === 0 ? words.take : words.takeOther}
              </button>
            </div>`
          : nothing
      }
    </section>
    <div class="beside">
      <section aria-labelledby="sample-title">
        <h2 id="sample-title">${words.sampleTitle}</h2>
        <ul class="samples">
          ${samples.map(
            (
              sample,
            ) => html`<li><button id=${`sample-${sample.name}`} ?disabled=${isBusy} @click=${() => void studio.openSample(sample)}>
              <img src=${`images/${sample.name}.webp`} width="160" height="120" alt="" /><span>${words.samples[sample.name]}</span>
            </button></li>`,
          )}
        </ul>
      </section>
      <section aria-labelledby="lesson-title">
        <h2 id="lesson-title">${words.lessonTitle}</h2>
        <button id="open-lesson" ?disabled=${isBusy} aria-describedby="open-lesson-hint" @click=${() => chooseLesson(studio)}>${words.openLesson}</button>
        <p class="hint" id="open-lesson-hint">${words.openLessonHint}</p>
      </section>
      ${studio.data ? html`<section><button id="back" @click=${() => goBack(studio)}>${words.back}</button></section>` : nothing}
    </div>
  </main>`;
}

function goBack(studio: Studio): void {
  studio.show({ screen: 'edit', hasSource: false, problem: null });
  studio.showLesson(true);
}

/** The browser's dialog. */
function chooseLesson(studio: Studio): void {
  const input = document.createElement('input');
  input.type = 'file';
  input.accept = '.zip,.html,.htm,.h5p';
  input.addEventListener('change', () => {
    const [file] = input.files ?? [];
    if (file) void studio.openLesson(file);
  });
  input.click();
}

// The lesson as learners see it: the page of the writers, in a frame, wide or as wide as a phone.
import { html } from 'lit';
import { ref } from 'lit/directives/ref.js';
import { LessonError, writePageFiles } from '../../../lesson-writers/src/index.ts';
import { toWritten } from '../data/export-lesson.ts';
import type { LessonData } from '../data/prepare.ts';
import type { Studio } from './studio.ts';
import type { View } from './view-element.ts';

let isPhone = false;

/** What the frame shows: it is written again only if the lesson has changed. */
let written: { readonly lesson: unknown; readonly page: string } | null = null;

export function renderPreview(studio: Studio): unknown {
  const { words, data, lesson } = studio;
  if (!data) return html`<p>${words.lacks.data}</p>`;
  if (written?.lesson !== lesson) written = { lesson, page: writePreview(studio, data) };
  const choose = (phone: boolean): void => {
    isPhone = phone;
    studio.draw();
  };
  return html`<div class="preview-bar">
      <h2 id="preview-title">${words.previewTitle}</h2>
      <div class="segments" role="group" aria-label=${words.previewTitle}>
        <button aria-pressed=${!isPhone} @click=${() => choose(false)}>${words.wide}</button>
        <button aria-pressed=${isPhone} @click=${() => choose(true)}>${words.phone}</button>
      </div>
      <button id="close-preview" @click=${() => studio.show({ dialog: null })}>${words.close}</button>
    </div>
    <div class=${isPhone ? 'device phone' : 'device'}>
      <iframe title=${words.previewTitle} allow="fullscreen" srcdoc=${written.page} @load=${({ target }: Event) => fill(target as HTMLIFrameElement, data)} ${ref(forget)}></iframe>
    </div>`;
}

/** A frame that is gone has to be written again. */
function forget(frame: Element | undefined): void {
  if (!frame) written = null;
}

/** The page of an export, with the element of the studio, and without the address of data: they are given to its view. */
function writePreview({ lesson, words }: Studio, data: LessonData): string {
  const named = { ...lesson, title: lesson.title || words.untitled };
  const said = { credits: lesson.credits || '…', licence: lesson.licence || '…', language: lesson.language || 'en' };
  const stub = [{ path: 'volume-view.iife.js', bytes: new Uint8Array() }];
  try {
    const files = writePageFiles({ ...toWritten(named, data), ...said }, stub, {
      addressOf: () => '',
      linksLeave: true,
      leftOut: ['remember', 'src'],
      head: '<link rel="stylesheet" href="player/volume-view.css"><script src="player/volume-view.iife.js"></script>',
    });
    const textOf = (path: string): string => new TextDecoder().decode(files.find((one) => one.path === path)!.bytes);
    return textOf('index.html').replace('</head>', () => `<style>${textOf('lesson.css')}</style></head>`);
  } catch (error) {
    if (!(error instanceof LessonError)) throw error;
    const paragraph = document.createElement('p');
    paragraph.textContent = error.message;
    return paragraph.outerHTML;
  }
}

/** Files of the frame's own kind: those of another window are none to its view. */
function fill(frame: HTMLIFrameElement, { files }: LessonData): void {
  const inner = frame.contentWindow as (Window & typeof globalThis) | null;
  const view = inner?.document.querySelector<View>('volume-view');
  if (inner && view)
    view.files = files.map(({ path, bytes }) => new inner.File([bytes as Uint8Array<ArrayBuffer>], path));
}

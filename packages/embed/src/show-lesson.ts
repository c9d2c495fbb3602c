import { setLanguage } from './set-language.ts';
import type { LessonContent } from '../../lesson-writers/src/check-lesson-html.ts';
import { buildNode } from './build-node.ts';
import { addProblems, addText, loadPlayer, showMessage } from './page-parts.ts';
import { parseLesson } from './parse-lesson.ts';
import { english } from './words.ts';

/** Bytes of a lesson's page: it holds texts, and no data. */
const maxBytes = 8e6;

/** Loads a lesson and shows it, or says why not. */
export async function showLesson(address: string): Promise<void> {
  const read = await fetchText(address);
  if ('problem' in read) return showMessage(english.lessonFailed, read.problem);
  const content = parseLesson(read.text);
  if (content.problems.length > 0) {
    showMessage(english.nothing, '');
    document.querySelector('main p')!.remove();
    return addProblems(
      english.lessonRefused,
      content.problems.map(({ message }) => message),
    );
  }
  document.querySelector<HTMLLinkElement>('link[rel="stylesheet"]')!.href = new URL(
    'embed-lesson.css',
    document.baseURI,
  ).href;
  const addressOf = (path: string): string => new URL(path.split('/').map(encodeURIComponent).join('/'), read.url).href;
  document.querySelector('main')!.append(...content.nodes.map((node) => buildNode(node, addressOf)));
  applyHead(content);
  await loadPlayer();
}

/** @returns the text, and the address that it came from, as redirections lead to it */
async function fetchText(address: string): Promise<{ text: string; url: string } | { problem: string }> {
  try {
    const response = await fetch(address);
    if (!response.ok) return { problem: english.lessonStatus(response.status) };
    const pieces: Uint8Array[] = [];
    let total = 0;
    const reader = response.body!.getReader();
    for (let read = await reader.read(); !read.done; read = await reader.read()) {
      pieces.push(read.value);
      if ((total += read.value.length) > maxBytes) {
        void reader.cancel();
        return { problem: english.lessonLarge };
      }
    }
    return { text: await new Blob(pieces as Uint8Array<ArrayBuffer>[]).text(), url: response.url };
  } catch {
    return { problem: english.lessonBlocked };
  }
}

/** The title, the language, and below the lesson its licence and credits. */
function applyHead({ head, nodes }: LessonContent): void {
  const { title, language, license, author } = head;
  if (title) document.title = title;
  if (language && /^[A-Za-z0-9-]{2,35}$/.test(language)) setLanguage(language);
  // A page of the writers has them already.
  const hasCredits = nodes.some(
    (node) =>
      typeof node !== 'string' &&
      node.name === 'footer' &&
      node.attributes.some(([name, value]) => name === 'class' && value === 'credits'),
  );
  if (hasCredits || (!license && !author)) return;
  const footer = document.createElement('footer');
  footer.className = 'credits';
  for (const text of [author, license]) if (text) addText('p', text, footer);
  document.querySelector('main')!.append(footer);
}

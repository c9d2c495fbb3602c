// The page for frames. Its script has an attribute `data-page` in the pages of an embed folder: `lesson`, where the lesson is in the page already, or
// `poster`, where a button leads to it. Without it, the address says what is shown.
import { setLanguage } from './set-language.ts';
import { wordOfShow } from '../../lesson-writers/src/word-of-show.ts';
import { addProblems, showMessage } from './page-parts.ts';
import { showLesson } from './show-lesson.ts';
import { showView } from './show-view.ts';
import { readAddress, readOrigins } from './read-address.ts';
import type { EmbedPlan } from './read-address.ts';
import { reportHeight } from './report-height.ts';
import { Talk } from './talk.ts';
import { english } from './words.ts';

const { page: form, next } = (document.currentScript as HTMLScriptElement).dataset;
const plan = readAddress(location.href);

function show(): void {
  if (plan.lesson !== null) void showLesson(plan.lesson);
  else showView(plan);
}

/** An image with a button, which loads nothing else before a person asks. */
function showPoster(poster: string, { attributes }: EmbedPlan): void {
  const main = document.querySelector('main')!;
  const box = document.createElement('div');
  box.className = 'poster';
  const image = document.createElement('img');
  image.src = poster;
  image.alt = attributes.find(([name]) => name === 'alt')?.[1] ?? '';
  const button = document.createElement('button');
  button.textContent = wordOfShow([plan.language ?? '', ...navigator.languages]);
  button.addEventListener('click', () => {
    box.remove();
    show();
    // Keys go on where the button was.
    main.tabIndex = -1;
    main.focus();
  });
  box.append(image, button);
  main.prepend(box);
}

function showAddress(): void {
  if (plan.language !== null) setLanguage(plan.language);
  document.title = plan.attributes.find(([name]) => name === 'alt')?.[1] || document.title;
  const hasSource = plan.lesson !== null || plan.attributes.some(([name]) => name === 'src');
  if (!hasSource) showMessage(english.nothing, english.nothingHint);
  else if (plan.poster !== null) showPoster(plan.poster, plan);
  else show();
  if (plan.problems.length > 0) addProblems(english.problems, plan.problems);
}

function begin(): void {
  if (form === undefined) showAddress();
  document.querySelector('.poster > a')?.addEventListener('click', (event) => {
    event.preventDefault();
    location.replace(next! + location.hash); // The part after the # has the secret of WordPress.
  });
  if (parent === window) return;
  const listed = document.querySelector<HTMLMetaElement>('meta[name="volume-view-parents"]')?.content ?? '';
  reportHeight(new Talk({ own: self.origin, listed: readOrigins(listed), narrowed: plan.parents }));
}

begin();

// The script of a lesson in a course. It finds the interface that a learning management system (LMS) gives to the page, continues where the
// learner stopped, and reports the step, the answers, the score and whether the lesson is complete. Without an LMS the page is as any other.
// It stands at the end of the body: all tags have been read, and no tour has opened a step yet.
(() => {
  const { scorm, pass } = document.currentScript.dataset;
  const is2004 = scorm === '2004';

  /** What the two versions of SCORM name differently. */
  const names = is2004
    ? {
        api: 'API_1484_11',
        initialize: 'Initialize',
        getValue: 'GetValue',
        setValue: 'SetValue',
        commit: 'Commit',
        terminate: 'Terminate',
        mode: 'cmi.mode',
        location: 'cmi.location',
        exit: 'cmi.exit',
        sessionTime: 'cmi.session_time',
        score: 'cmi.score',
        response: 'learner_response',
        wrong: 'incorrect',
        maxSuspended: 64000,
      }
    : {
        api: 'API',
        initialize: 'LMSInitialize',
        getValue: 'LMSGetValue',
        setValue: 'LMSSetValue',
        commit: 'LMSCommit',
        terminate: 'LMSFinish',
        mode: 'cmi.core.lesson_mode',
        location: 'cmi.core.lesson_location',
        exit: 'cmi.core.exit',
        sessionTime: 'cmi.core.session_time',
        score: 'cmi.core.score',
        response: 'student_response',
        wrong: 'wrong',
        maxSuspended: 4096,
      };

  /** The interface in a window or in one of those around it. An element with its name as an id is none. */
  function findIn(start) {
    for (let [one, depth] = [start, 0]; one && depth < 50; depth += 1) {
      try {
        const api = one[names.api];
        if (api && typeof api[names.initialize] === 'function') return api;
      } catch {
        // A window of another site shows nothing.
      }
      if (one === one.parent) return null;
      one = one.parent;
    }
    return null;
  }

  const api = findIn(window) ?? (window.top.opener ? findIn(window.top.opener) : null);
  if (!api || String(api[names.initialize]('')) !== 'true') return;

  const began = Date.now();
  const get = (name) => String(api[names.getValue](name) ?? '');
  const set = (name, value) => String(api[names.setValue](name, String(value))) === 'true';
  /** A learner who looks at the lesson again, or a teacher, changes nothing. */
  const isKept = ['', 'normal'].includes(get(names.mode));

  const tours = [...document.querySelectorAll('volume-tour')];
  const questions = [...document.querySelectorAll('volume-question')];
  const stepsOf = (tour) =>
    [...tour.querySelectorAll('volume-step')].filter((one) => one.closest('volume-tour') === tour);
  const counts = [...tours.map((tour) => stepsOf(tour).length), questions.length];

  /** Numbers of the steps that were open, by tours. */
  const seen = tours.map(() => new Set());
  /** The last answer to each question. */
  const answers = questions.map(() => null);
  /** The tour that was used last, and its open step. */
  let place = { tour: 0, step: 0 };

  /** Tours that have opened a step in this visit. */
  const begun = new Set();

  const triesOf = (question) => Number(question.getAttribute('tries')) || Infinity;
  const isDone = (answer, i) => answer !== null && (answer.correct || answer.tries >= triesOf(questions[i]));
  const isComplete = () =>
    seen.every((steps, i) => steps.size >= counts[i]) && answers.every((answer, i) => isDone(answer, i));

  restore();
  report();
  document.addEventListener('step-change', onStep, true);
  document.addEventListener('answer', onAnswer, true);
  document.addEventListener('visibilitychange', () => document.visibilityState === 'hidden' && keep());
  window.addEventListener('pagehide', end, { once: true });

  /** Read what an earlier visit kept. What belongs to another edition of the lesson, or can't be read, is ignored. */
  function restore() {
    let kept;
    try {
      kept = JSON.parse(get('cmi.suspend_data'));
      if (JSON.stringify(kept.counts) !== JSON.stringify(counts)) return;
      kept.seen.forEach((steps, i) => steps.forEach((step) => seen[i].add(Number(step))));
      kept.answers.forEach((answer, i) => {
        if (!answer) return;
        const [response, chosen, correct, tries] = answer;
        answers[i] = {
          response: String(response),
          chosen: chosen.map(Number),
          correct: correct === 1,
          tries: Number(tries),
        };
      });
    } catch {
      return;
    }
    const [tour, step] = (/^(?:(\d+)\.)?(\d+)$/.exec(get(names.location)) ?? [])
      .slice(1)
      .map((one) => Number(one ?? 1));
    if (step > 0 && step <= counts[tour - 1] && tours[tour - 1]) {
      place = { tour: tour - 1, step };
      tours[tour - 1].setAttribute('step', step);
    }
    if (answers.some(Boolean))
      void customElements
        .whenDefined('volume-question')
        .then(() => answers.forEach((answer, i) => answer && questions[i].restore(answer)));
  }

  function onStep({ target, detail }) {
    const tour = tours.indexOf(target);
    if (tour < 0 || !(detail.step > 0)) return;
    seen[tour].add(detail.step);
    // Each tour opens a step by itself as the page begins: that is not where the learner is, if there are several.
    const isFirst = !begun.has(tour);
    begun.add(tour);
    if (!isFirst || place.step === 0) place = { tour, step: detail.step };
    report();
  }

  function onAnswer({ target, detail }) {
    const i = questions.indexOf(target);
    if (i < 0) return;
    answers[i] = detail;
    if (isKept) addInteraction(i, detail);
    report();
  }

  /** One entry for each answer: teachers see all tries. */
  function addInteraction(i, { response, chosen, correct }) {
    const name = `cmi.interactions.${Number(get('cmi.interactions._count')) || 0}`;
    const question = questions[i];
    const { type, text, right } = describeAnswer(question, response, chosen);
    set(`${name}.id`, nameOf(i));
    set(`${name}.type`, type);
    const now = new Date();
    if (is2004) {
      // The standard takes a time zone only after a fraction of a second.
      set(`${name}.timestamp`, `${now.toISOString().slice(0, 21)}Z`);
      const heading = question.querySelector('h1, h2, h3, h4, h5, h6, p')?.textContent.trim().replace(/\s+/g, ' ');
      if (heading) set(`${name}.description`, heading.slice(0, 250));
    } else set(`${name}.time`, now.toTimeString().slice(0, 8));
    if (right) set(`${name}.correct_responses.0.pattern`, right);
    set(`${name}.${names.response}`, text);
    set(`${name}.result`, correct ? 'correct' : names.wrong);
  }

  /** The id of a question; both versions take no blanks in it. */
  function nameOf(i) {
    const { id } = questions[i];
    return /^[A-Za-z][\w-]{0,60}$/.test(id) ? id : `question-${i + 1}`;
  }

  /** An answer in the words of SCORM. @returns right: what is right, where it can be said */
  function describeAnswer(question, response, chosen) {
    const type = (question.getAttribute('type') ?? 'choice').trim().toLowerCase();
    const text = response.slice(0, 250);
    if (type === 'find') return { type: is2004 ? 'other' : 'performance', text, right: '' };
    if (type === 'label') return { type: 'fill-in', text, right: '' };
    if (type === 'value') {
      const number = response.trim().replace(',', '.');
      return /^-?\d{1,10}(\.\d{1,10})?$/.test(number)
        ? { type: 'numeric', text: number, right: '' }
        : { type: 'fill-in', text, right: '' };
    }
    const items = [...question.children].flatMap((list) =>
      list.matches('ul:not([slot]), ol:not([slot])') ? [...list.children].filter((one) => one.matches('li')) : [],
    );
    const letters = 'abcdefghijklmnopqrstuvwxyz0123456789';
    if (items.length > letters.length) return { type: 'fill-in', text, right: '' };
    const write = (numbers) => numbers.map((one) => letters[one]).join(is2004 ? '[,]' : ',');
    const right = items.flatMap((item, i) => (item.hasAttribute('correct') ? [i] : []));
    return { type: 'choice', text: write(chosen), right: write(right) };
  }

  /** Say how far the learner is. */
  function report() {
    if (!isKept) return;
    if (place.step > 0) set(names.location, tours.length > 1 ? `${place.tour + 1}.${place.step}` : place.step);
    set('cmi.suspend_data', writeKept());
    const right = answers.filter((answer) => answer?.correct).length;
    const share = questions.length > 0 ? right / questions.length : 1;
    if (answers.some(Boolean)) {
      set(`${names.score}.min`, 0);
      set(`${names.score}.max`, 100);
      set(`${names.score}.raw`, Math.round(100 * share));
      if (is2004) set(`${names.score}.scaled`, Math.round(1e4 * share) / 1e4);
    }
    reportStatus(share);
    keep();
  }

  /** A lesson that was complete stays so. */
  function reportStatus(share) {
    const hasPassed = pass === undefined ? null : 100 * share >= Number(pass);
    if (is2004) {
      if (get('cmi.completion_status') !== 'completed')
        set('cmi.completion_status', isComplete() ? 'completed' : 'incomplete');
      if (hasPassed !== null && isComplete() && get('cmi.success_status') !== 'passed')
        set('cmi.success_status', hasPassed ? 'passed' : 'failed');
      return;
    }
    const ended = hasPassed === null ? 'completed' : hasPassed ? 'passed' : 'failed';
    if (!['completed', 'passed'].includes(get('cmi.core.lesson_status')))
      set('cmi.core.lesson_status', isComplete() ? ended : 'incomplete');
  }

  /** What the next visit begins with. The first version of SCORM has little room: then without the texts of answers. */
  function writeKept() {
    const write = (withText) =>
      JSON.stringify({
        counts,
        seen: seen.map((steps) => [...steps]),
        answers: answers.map(
          (one) => one && [withText ? one.response : '', one.chosen, one.correct ? 1 : 0, one.tries],
        ),
      });
    const whole = write(true);
    return whole.length <= names.maxSuspended ? whole : write(false);
  }

  function keep() {
    if (isKept) api[names.commit]('');
  }

  function end() {
    if (isKept) {
      set(names.sessionTime, writeDuration(Math.round((Date.now() - began) / 1000)));
      set(names.exit, 'suspend');
      keep();
    }
    api[names.terminate]('');
  }

  function writeDuration(seconds) {
    const [hours, minutes, rest] = [Math.floor(seconds / 3600), Math.floor(seconds / 60) % 60, seconds % 60];
    if (is2004) return `PT${hours}H${minutes}M${rest}S`;
    return [
      String(Math.min(hours, 9999)).padStart(4, '0'),
      ...[minutes, rest].map((one) => String(one).padStart(2, '0')),
    ].join(':');
  }
})();

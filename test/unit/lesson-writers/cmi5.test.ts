// A lesson in a course by cmi5: its package, and what its script says to a learning record store, which this test has on 127.0.0.1.
import { runInNewContext } from 'node:vm';
import { expect } from '@esm-bundle/chai';
import cmi5 from '../../../packages/lesson-writers/src/cmi5.js?raw';
import { LessonError, writeCmi5Files } from '../../../packages/lesson-writers/src/index.ts';
import { startLrs } from '../../helpers/lrs.mjs';

const lesson = {
  html: '<volume-view src="a.nii"></volume-view><volume-question id="q" remember><ul><li>A</li><li correct>B</li></ul></volume-question>',
  files: [{ path: 'a.nii', bytes: new Uint8Array(3) }],
  title: 'Bones & "air"',
  language: 'en',
  licence: 'CC0 1.0',
  credits: 'Somebody',
};
const player = [{ path: 'volume-view.iife.js', bytes: new Uint8Array(2) }];
const textOf = (files: ReturnType<typeof writeCmi5Files>, path: string): string =>
  new TextDecoder().decode(files.find((one) => one.path === path)!.bytes);

/** What course.js finds in the page. */
interface Runtime {
  GetValue(name: string): string;
  SetValue(name: string, value: string): string;
  Commit(text: string): string;
  Terminate(text: string): string;
}

interface Opened {
  readonly api: Runtime | undefined;
  readonly loaded: readonly { readonly src: string; readonly pass?: string }[];
  readonly said: readonly string[];
  leave(): void;
}

/** Opens the page of a lesson. @param address - what its address has behind the `?` */
async function open(address: string, dataset: Record<string, string> = { pass: '60' }): Promise<Opened> {
  const loaded: { src: string; pass?: string }[] = [];
  const said: string[] = [];
  const window: { API_1484_11?: Runtime; addEventListener: (name: string, run: () => void) => void } = {
    addEventListener: (_name, run) => (leave = run),
  };
  let leave = (): void => undefined;
  await new Promise<void>((resolve) => {
    runInNewContext(cmi5, {
      window,
      location: { search: address },
      console: { error: (text: string) => said.push(text) },
      crypto: globalThis.crypto,
      ...{ fetch, URL, URLSearchParams },
      document: {
        currentScript: { dataset: { player: 'volume-view/volume-view.iife.js', ...dataset } },
        createElement: () => {
          const listeners: Record<string, () => void> = {};
          return {
            dataset: {},
            addEventListener: (name: string, run: () => void) => (listeners[name] = run),
            listeners,
          };
        },
        body: {
          append: (script: { src: string; dataset: { pass?: string }; listeners: Record<string, () => void> }) => {
            loaded.push({ src: script.src, ...('pass' in script.dataset && { pass: script.dataset.pass }) });
            script.listeners.load();
            if (script.src.startsWith('volume-view/')) resolve();
          },
        },
      },
    });
  });
  return { api: window.API_1484_11, loaded, said, leave: () => leave() };
}

/** Until a condition holds. */
async function until(holds: () => boolean): Promise<void> {
  for (let i = 0; i < 500 && !holds(); i++) await new Promise((resolve) => setTimeout(resolve, 5));
  expect(holds()).to.equal(true);
}

/** As course.js says an answer. */
function answer(api: Runtime, i: number, { right = true }: { right?: boolean } = {}): void {
  const name = `cmi.interactions.${i}`;
  for (const [part, value] of [
    ['id', 'q'],
    ['type', 'choice'],
    ['description', 'Which one?'],
    ['correct_responses.0.pattern', 'b'],
    ['learner_response', right ? 'b' : 'a'],
    ['result', right ? 'correct' : 'incorrect'],
  ])
    expect(api.SetValue(`${name}.${part}`, value)).to.equal('true');
}

describe('a lesson as a package of cmi5', () => {
  it('has a structure of one unit, whose page waits for the course', () => {
    const files = writeCmi5Files(lesson, player, { pass: 60 });
    expect(files.map(({ path }) => path)).to.deep.equal([
      'cmi5.js',
      'cmi5.xml',
      'course.js',
      'data/a.nii',
      'index.html',
      'lesson.css',
      'volume-view/volume-view.iife.js',
    ]);
    const structure = textOf(files, 'cmi5.xml');
    expect(structure).to.contain(
      '<courseStructure xmlns="https://w3id.org/xapi/profiles/cmi5/v1/CourseStructure.xsd">',
    );
    expect(structure).to.contain('<langstring lang="en">Bones &amp; &quot;air&quot;</langstring>');
    expect(structure).to.contain('moveOn="CompletedAndPassed" masteryScore="0.6"');
    expect(structure).to.contain('<url>index.html</url>');
    const page = textOf(files, 'index.html');
    expect(page).not.to.contain('<script src="volume-view/');
    expect(page).not.to.contain('remember');
    expect(page).to.contain('<script src="cmi5.js" data-player="volume-view/volume-view.iife.js" data-pass="60">');
    expect(writeCmi5Files(lesson, player, { pass: 60 }), 'the same bytes').to.deep.equal(files);
    const others = writeCmi5Files({ ...lesson, title: 'Another' }, player, { pass: null });
    const ids = [structure, textOf(others, 'cmi5.xml')].map((text) => /course id="([^"]+)"/.exec(text)![1]);
    expect(new Set(ids).size, 'another lesson has another id').to.equal(2);
    expect(textOf(others, 'cmi5.xml')).to.contain('moveOn="Completed">');
    expect(() => writeCmi5Files(lesson, player, { pass: 101 })).to.throw(LessonError);
  });
});

describe('the script of a lesson in a course by cmi5', () => {
  let lrs: Awaited<ReturnType<typeof startLrs>>;
  afterEach(() => lrs.close());

  it('fetches its key once, and says what the learner does, from the beginning to the end', async () => {
    lrs = await startLrs();
    const { api, loaded, leave, said } = await open(lrs.launch);
    expect(loaded).to.deep.equal([{ src: 'course.js', pass: '60' }, { src: 'volume-view/volume-view.iife.js' }]);
    expect(lrs.asked).to.deep.equal([
      'POST /fetch',
      'GET /xapi/activities/state',
      'GET /xapi/agents/profile',
      'GET /xapi/activities/state',
      'POST /xapi/statements',
    ]);
    expect(api!.GetValue('cmi.mode')).to.equal('normal');
    answer(api!, 0, { right: false });
    expect(api!.GetValue('cmi.interactions._count')).to.equal('1');
    api!.SetValue('cmi.score.scaled', '0');
    api!.SetValue('cmi.completion_status', 'completed');
    api!.SetValue('cmi.success_status', 'failed');
    answer(api!, 1);
    api!.SetValue('cmi.score.scaled', '1');
    api!.SetValue('cmi.success_status', 'passed');
    for (let i = 0; i < 3; i++) api!.SetValue('cmi.completion_status', 'completed');
    api!.SetValue('cmi.location', '2');
    api!.Commit('');
    await until(() => lrs.states.size === 1);
    leave();
    leave();
    await until(() => lrs.verbs().at(-1) === 'terminated');
    expect(lrs.verbs()).to.deep.equal([
      'initialized',
      'answered',
      'completed',
      'failed',
      'answered',
      'passed',
      'terminated',
    ]);
    expect(lrs.broken).to.deep.equal([]);
    const [, first] = lrs.statements;
    expect(first.object).to.deep.equal({
      objectType: 'Activity',
      id: 'https://school.test/activities/42#q',
      definition: {
        type: 'http://adlnet.gov/expapi/activities/cmi.interaction',
        interactionType: 'choice',
        description: { und: 'Which one?' },
        correctResponsesPattern: ['b'],
        choices: [{ id: 'b' }, { id: 'a' }],
      },
    });
    expect(first.result).to.deep.equal({ response: 'a', success: false });
    expect(first.context.contextActivities.parent).to.deep.equal([
      { objectType: 'Activity', id: 'https://school.test/activities/42' },
    ]);
    expect(said).to.deep.equal([]);
  });

  it('begins a second visit where the first one ended, and completes nothing twice', async () => {
    lrs = await startLrs();
    const first = await open(lrs.launch);
    first.api!.SetValue('cmi.location', '3');
    first.api!.SetValue('cmi.suspend_data', '{"a":1}');
    first.api!.SetValue('cmi.completion_status', 'completed');
    first.leave();
    await until(() => lrs.verbs().at(-1) === 'terminated' && lrs.states.size === 1);
    lrs.again();
    const { api, leave } = await open(lrs.launch);
    expect(
      ['cmi.location', 'cmi.suspend_data', 'cmi.completion_status'].map((name) => api!.GetValue(name)),
    ).to.deep.equal(['3', '{"a":1}', 'completed']);
    api!.SetValue('cmi.completion_status', 'completed');
    leave();
    await until(() => lrs.verbs().at(-1) === 'terminated');
    expect(lrs.verbs()).to.deep.equal(['initialized', 'terminated']);
    expect(lrs.broken).to.deep.equal([]);
  });

  it('takes the score to pass from the course, where it has one', async () => {
    lrs = await startLrs({ masteryScore: 0.8 });
    const { api, loaded } = await open(lrs.launch);
    expect(loaded[0]).to.deep.equal({ src: 'course.js', pass: '80' });
    api!.SetValue('cmi.score.scaled', '0.9');
    api!.SetValue('cmi.success_status', 'passed');
    await until(() => lrs.verbs().at(-1) === 'passed');
    expect(
      lrs.statements.at(-1).context.extensions['https://w3id.org/xapi/cmi5/context/extensions/masteryscore'],
    ).to.equal(0.8);
    expect(lrs.broken).to.deep.equal([]);
  });

  it('says to the lesson that a learner or a teacher only looks at it', async () => {
    lrs = await startLrs({ mode: 'Review' });
    const { api, leave } = await open(lrs.launch);
    // Then course.js sets nothing.
    expect(api!.GetValue('cmi.mode')).to.equal('review');
    leave();
    await until(() => lrs.verbs().at(-1) === 'terminated');
    expect(lrs.states.size).to.equal(0);
    expect(lrs.broken).to.deep.equal([]);
  });

  it('shows the lesson without a course, and where the course does not answer', async () => {
    lrs = await startLrs({ fail: (path) => (path === '/fetch' ? undefined : 500) });
    const closed = await startLrs();
    closed.close();
    for (const [address, words] of [
      ['', null],
      ['?endpoint=javascript:alert(1)&fetch=x&actor={}&activityId=y', null],
      [lrs.launch.replace('actor=', 'actor=%7B'), null],
      [lrs.launch, /^The course does not answer: status 500\./],
      [lrs.launch, /^The course does not answer: it gives no key \(1\)/],
      [closed.launch, /^The course does not answer: /],
    ] as const) {
      const { api, loaded, said } = await open(address);
      expect(api, address).to.equal(undefined);
      expect(loaded).to.deep.equal([{ src: 'volume-view/volume-view.iife.js' }]);
      if (words) expect(said[0]).to.match(words);
      else expect(said).to.deep.equal([]);
    }
  });

  it('goes on where the course refuses a statement, and says so', async () => {
    let refuses = false;
    lrs = await startLrs({ fail: (path) => (refuses && path.endsWith('statements') ? 403 : undefined) });
    const { api, said, leave } = await open(lrs.launch);
    refuses = true;
    answer(api!, 0);
    await until(() => said.length === 1);
    expect(said[0]).to.equal('The course did not take what the learner did: status 403');
    refuses = false;
    leave();
    await until(() => lrs.verbs().at(-1) === 'terminated');
  });
});

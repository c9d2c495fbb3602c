// A small learning record store with what a cmi5 course gives beside it, on 127.0.0.1: it keeps statements and states in memory, and notes
// what breaks the rules. Source: cmi5 1.0 (Quartz), 8 to 10; xAPI 1.0.3, part 3.
import { createServer } from 'node:http';

const cmi5 = 'https://w3id.org/xapi/cmi5/context';
const verb = 'http://adlnet.gov/expapi/verbs/';

/**
 * @param {{ mode?: 'Normal' | 'Browse' | 'Review', masteryScore?: number, fail?: (path: string) => number | undefined }} course - fail: a status in place of an answer
 */
export async function startLrs(course = {}) {
  const key = 'bGVhcm5lcjprZXk=';
  /** @type {any[]} */
  const statements = [];
  /** @type {Map<string, any>} */
  const states = new Map();
  /** @type {string[]} */
  const broken = [];
  /** @type {string[]} */
  const asked = [];
  let keys = 0;
  const template = {
    extensions: { [`${cmi5}/extensions/sessionid`]: 'session-1' },
    contextActivities: { grouping: [{ objectType: 'Activity', id: 'https://publisher.test/unit' }] },
  };
  const launchData = {
    contextTemplate: template,
    launchMode: course.mode ?? 'Normal',
    moveOn: 'CompletedAndPassed',
    ...(course.masteryScore === undefined ? {} : { masteryScore: course.masteryScore }),
  };

  /** @param {boolean} holds @param {string} rule */
  const expect = (holds, rule) => void (holds || broken.push(rule));

  /** @param {any} one */
  function check(one) {
    const name = String(one.verb?.id).replace(verb, '');
    const { context = {} } = one;
    const { category = [], grouping = [] } = context.contextActivities ?? {};
    const has = (/** @type {string} */ id) =>
      category.some((/** @type {any} */ { id: own }) => own === `${cmi5}/categories/${id}`);
    const before = statements.map((other) => String(other.verb.id).replace(verb, ''));
    expect(/^[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$/.test(one.id), `${name} has no id`);
    expect(!statements.some(({ id }) => id === one.id), `${name} has the id of another`);
    expect(!Number.isNaN(Date.parse(one.timestamp)), `${name} has no time`);
    expect(JSON.stringify(one.actor) === JSON.stringify(actor), `${name} is of another actor`);
    expect(context.registration === registration, `${name} has no registration`);
    expect(context.extensions?.[`${cmi5}/extensions/sessionid`] === 'session-1', `${name} has no session`);
    expect(
      grouping.some((/** @type {any} */ { id }) => id === 'https://publisher.test/unit'),
      `${name} lacks the template`,
    );
    expect((before.length === 0) === (name === 'initialized'), `${name} comes as number ${before.length + 1}`);
    expect(!before.includes('terminated'), `${name} comes after the end`);
    const isDefined = name !== 'answered';
    expect(has('cmi5') === isDefined, `${name} has a wrong category`);
    expect(
      isDefined ? one.object.id === activityId : one.object.id !== activityId,
      `${name} is about ${one.object.id}`,
    );
    const isOfMoving = ['completed', 'passed', 'failed'].includes(name);
    expect(has('moveon') === isOfMoving, `${name} has a wrong category for moving on`);
    if (isOfMoving) {
      expect(course.mode === undefined || course.mode === 'Normal', `${name} in mode ${course.mode}`);
      expect(!before.includes(name) || name === 'failed', `${name} twice`);
      expect(name !== 'failed' || !before.includes('passed'), 'failed after passed');
    }
    if (name === 'completed')
      expect(one.result?.completion === true && one.result.score === undefined, 'completed has a wrong result');
    if (name === 'passed' || name === 'failed') {
      expect(one.result?.success === (name === 'passed'), `${name} has a wrong result`);
      const mastery = context.extensions?.[`${cmi5}/extensions/masteryscore`];
      expect(typeof mastery === 'number', `${name} lacks the score to pass`);
      const scaled = one.result?.score?.scaled;
      expect(name === 'passed' ? scaled >= mastery : scaled < mastery, `${name} with ${scaled} of ${mastery}`);
    }
    if (isDefined && name !== 'initialized')
      expect(/^PT\d+(\.\d+)?S$/.test(one.result?.duration), `${name} has no duration`);
  }

  const actor = { objectType: 'Agent', account: { homePage: 'https://school.test', name: 'learner-7' } };
  const [registration, activityId] = ['7f1c2f0e-1111-4222-8333-444455556666', 'https://school.test/activities/42'];

  /** @param {import('node:http').IncomingMessage} request @param {import('node:http').ServerResponse} response */
  async function handle(request, response) {
    const url = new URL(request.url ?? '/', 'http://127.0.0.1');
    const answer = (/** @type {number} */ status, /** @type {unknown} */ body = '') =>
      response
        .writeHead(status, {
          'access-control-allow-origin': '*',
          'access-control-allow-headers': '*, authorization',
          'access-control-allow-methods': '*',
          'content-type': 'application/json',
        })
        .end(typeof body === 'string' ? body : JSON.stringify(body));
    if (request.method === 'OPTIONS') return answer(204);
    asked.push(`${request.method} ${url.pathname}`);
    let text = '';
    for await (const part of request) text += part;
    const status = course.fail?.(url.pathname);
    if (status !== undefined) return answer(status);
    if (url.pathname === '/fetch') {
      expect(request.method === 'POST', 'the key is not asked for by POST');
      keys += 1;
      return answer(200, keys > 1 ? { 'error-code': '1', 'error-text': 'used' } : { 'auth-token': key });
    }
    if (request.headers.authorization !== `Basic ${key}`) return answer(401);
    expect(request.headers['x-experience-api-version'] === '1.0.3', `${url.pathname} without a version`);
    if (url.pathname === '/xapi/statements' && request.method === 'POST') {
      const all = [JSON.parse(text)].flat();
      for (const one of all) {
        check(one);
        statements.push(one);
      }
      return answer(
        200,
        all.map(({ id }) => id),
      );
    }
    if (url.pathname === '/xapi/agents/profile') return answer(404);
    if (url.pathname !== '/xapi/activities/state') return answer(404);
    const of = url.searchParams;
    expect(
      of.get('activityId') === activityId && of.get('registration') === registration,
      'a state of another activity',
    );
    expect(of.get('agent') === JSON.stringify(actor), 'a state of another learner');
    const id = String(of.get('stateId'));
    if (request.method === 'PUT') {
      states.set(id, JSON.parse(text));
      return answer(204);
    }
    if (id === 'LMS.LaunchData') return answer(200, launchData);
    return states.has(id) ? answer(200, states.get(id)) : answer(404);
  }

  const server = createServer((request, response) => void handle(request, response));
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  const origin = `http://127.0.0.1:${port}`;
  const launch = new URLSearchParams({
    endpoint: `${origin}/xapi/`,
    fetch: `${origin}/fetch`,
    actor: JSON.stringify(actor),
    registration,
    activityId,
  });
  return {
    statements,
    states,
    broken,
    asked,
    origin,
    /** What the address of the page has. */
    launch: `?${launch}`,
    /** The names of all statements. */
    verbs: () => statements.map((one) => String(one.verb.id).replace(verb, '')),
    /** A second launch gets another key, and a session of its own. */
    again() {
      keys = 0;
      statements.length = 0;
    },
    close: () => {
      server.closeAllConnections();
      server.close();
    },
  };
}

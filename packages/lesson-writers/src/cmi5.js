// The script of a lesson in a course by cmi5. A learning management system (LMS) opens the page with the address of a learning record store
// (LRS) and a key that can be fetched once. This script fetches what the course says, gives course.js what an LMS of SCORM 2004 would give it,
// and writes what the learner does as statements. Then it loads the element. Without an LMS the page is as any other.
// Source: cmi5 1.0 (Quartz), https://github.com/AICC/CMI-5_Spec_Current: 8.1 launch, 9 statements, 10 state; xAPI 1.0.3.
(() => {
  const { pass, player } = document.currentScript.dataset;
  const verbs = {
    initialized: 'http://adlnet.gov/expapi/verbs/initialized',
    terminated: 'http://adlnet.gov/expapi/verbs/terminated',
    completed: 'http://adlnet.gov/expapi/verbs/completed',
    passed: 'http://adlnet.gov/expapi/verbs/passed',
    failed: 'http://adlnet.gov/expapi/verbs/failed',
    answered: 'http://adlnet.gov/expapi/verbs/answered',
  };
  const cmi5 = 'https://w3id.org/xapi/cmi5/context';
  const keptNames = [
    'cmi.location',
    'cmi.suspend_data',
    'cmi.completion_status',
    'cmi.success_status',
    'cmi.score.scaled',
  ];
  const stateId = 'volume-view';
  const began = Date.now();

  const launch = readLaunch();
  const values = new Map();
  /** The key of the LRS; '' where there is none. */
  let key = '';
  /** What the course says of this launch. */
  let data = {};
  /** Statements that are not sent yet. */
  const waiting = [];
  let isSending = false;
  /** What is not written yet of the state. */
  let isStateNew = false;
  let hasEnded = false;

  void begin();

  async function begin() {
    if (launch) {
      try {
        await open();
      } catch (error) {
        console.error(`The course does not answer: ${error.message}. The lesson goes on, and nothing of it is kept.`);
        key = '';
      }
    }
    if (key) {
      window.API_1484_11 = {
        Initialize: yes,
        Terminate: end,
        Commit: keep,
        GetLastError: () => '0',
        GetValue: get,
        SetValue: set,
      };
      window.addEventListener('pagehide', end, { once: true });
      const mastery = typeof data.masteryScore === 'number' ? 100 * data.masteryScore : pass;
      await load('course.js', { scorm: '2004', ...(mastery === undefined ? {} : { pass: String(mastery) }) });
    }
    await load(player, {});
  }

  /** What the address says; null where it was not opened by an LMS. */
  function readLaunch() {
    const of = new URLSearchParams(location.search);
    const [endpoint, fetchUrl, actor, registration, activityId] = [
      'endpoint',
      'fetch',
      'actor',
      'registration',
      'activityId',
    ].map((name) => of.get(name));
    if (!endpoint || !fetchUrl || !actor || !activityId) return null;
    try {
      if (![endpoint, fetchUrl].every((url) => /^https?:$/.test(new URL(url).protocol))) return null;
      return { endpoint: endpoint.replace(/\/*$/, '/'), fetchUrl, actor: JSON.parse(actor), registration, activityId };
    } catch {
      return null;
    }
  }

  async function open() {
    const answer = await (await fetch(launch.fetchUrl, { method: 'POST' })).json();
    if (typeof answer['auth-token'] !== 'string')
      throw new Error(`it gives no key (${String(answer['error-code'] ?? 'no reason')})`);
    key = answer['auth-token'];
    data = (await read(addressOfState('LMS.LaunchData'))) ?? {};
    // A course may have preferences of the learner, which have to be asked for; none of them changes this lesson.
    await read(
      addressOf('agents/profile', { agent: JSON.stringify(launch.actor), profileId: 'cmi5LearnerPreferences' }),
    ).catch(() => null);
    const kept = await read(addressOfState(stateId));
    for (const name of keptNames) if (typeof kept?.[name] === 'string') values.set(name, kept[name]);
    const mode = String(data.launchMode ?? 'Normal').toLowerCase();
    values.set('cmi.mode', mode);
    await send(`${launch.endpoint}statements`, 'POST', [makeStatement('initialized')]);
  }

  const addressOf = (path, parameters) => `${launch.endpoint}${path}?${new URLSearchParams(parameters)}`;
  const addressOfState = (id) =>
    addressOf('activities/state', {
      activityId: launch.activityId,
      agent: JSON.stringify(launch.actor),
      ...(launch.registration ? { registration: launch.registration } : {}),
      stateId: id,
    });
  const headers = () => ({
    Authorization: `Basic ${key}`,
    'X-Experience-API-Version': '1.0.3',
    'Content-Type': 'application/json',
  });

  async function read(url) {
    const response = await fetch(url, { headers: headers() });
    if (response.status === 404) return null;
    if (!response.ok) throw new Error(`status ${response.status}`);
    return response.json();
  }

  /** The browser goes on sending when the page is gone. @param value - small: browsers take 64 kB at a time */
  async function send(url, method, value) {
    const request = { method, headers: headers(), body: JSON.stringify(value), keepalive: true };
    const response = await fetch(url, request);
    if (!response.ok) throw new Error(`status ${response.status}`);
  }

  const complain = (error) => console.error(`The course did not take what the learner did: ${error.message}`);

  /** Statements go out one request after another, so that the LRS reads them in the order in which they were written. */
  async function sendWaiting() {
    if (isSending || waiting.length === 0) return;
    isSending = true;
    await send(`${launch.endpoint}statements`, 'POST', waiting.splice(0)).catch(complain);
    isSending = false;
    await sendWaiting();
  }

  /** @param isDefined - whether cmi5 says when this verb is written @param object - the lesson where undefined */
  function makeStatement(verb, { isDefined = true, result, object, extensions } = {}) {
    const template = data.contextTemplate ?? {};
    const of = template.contextActivities ?? {};
    const category = [
      ...(of.category ?? []),
      ...(isDefined ? [{ id: `${cmi5}/categories/cmi5` }] : []),
      ...(['completed', 'passed', 'failed'].includes(verb) ? [{ id: `${cmi5}/categories/moveon` }] : []),
    ];
    const activity = { objectType: 'Activity', id: launch.activityId };
    return {
      id: crypto.randomUUID(),
      timestamp: new Date().toISOString(),
      actor: launch.actor,
      verb: { id: verbs[verb], display: { en: verb } },
      object: object ?? activity,
      context: {
        ...template,
        ...(launch.registration ? { registration: launch.registration } : {}),
        contextActivities: {
          ...of,
          ...(category.length > 0 ? { category } : {}),
          ...(object ? { parent: [...(of.parent ?? []), activity] } : {}),
        },
        extensions: { ...template.extensions, ...extensions },
      },
      ...(result ? { result } : {}),
    };
  }

  function write(verb, more) {
    waiting.push(makeStatement(verb, more));
    void sendWaiting();
  }

  const duration = () => `PT${((Date.now() - began) / 1000).toFixed(2)}S`;
  const yes = () => 'true';

  function get(name) {
    if (name !== 'cmi.interactions._count') return values.get(name) ?? '';
    return String([...values.keys()].filter((one) => /^cmi\.interactions\.\d+\.id$/.test(one)).length);
  }

  /** What course.js says as an LMS of SCORM 2004 has it. */
  function set(name, value) {
    const before = values.get(name);
    values.set(name, value);
    if (keptNames.includes(name) && before !== value) isStateNew = true;
    const [, number] = /^cmi\.interactions\.(\d+)\.result$/.exec(name) ?? [];
    if (number !== undefined) writeAnswer(`cmi.interactions.${number}`);
    if (before === value) return 'true';
    const scaled = Number(values.get('cmi.score.scaled') ?? NaN);
    if (name === 'cmi.completion_status' && value === 'completed')
      write('completed', { result: { completion: true, duration: duration() } });
    if (name === 'cmi.success_status' && ['passed', 'failed'].includes(value)) {
      const mastery = typeof data.masteryScore === 'number' ? data.masteryScore : Number(pass) / 100;
      const result = {
        success: value === 'passed',
        duration: duration(),
        ...(scaled >= 0 ? { score: { scaled } } : {}),
      };
      write(value, { result, extensions: { [`${cmi5}/extensions/masteryscore`]: mastery } });
    }
    return 'true';
  }

  /** An answer to one question, which is a part of the lesson. */
  function writeAnswer(name) {
    const of = (part) => values.get(`${name}.${part}`) ?? '';
    const right = of('correct_responses.0.pattern');
    const { activityId } = launch;
    write('answered', {
      isDefined: false,
      object: {
        objectType: 'Activity',
        id: `${activityId}${activityId.includes('#') ? '-' : '#'}${encodeURIComponent(of('id'))}`,
        definition: {
          type: 'http://adlnet.gov/expapi/activities/cmi.interaction',
          interactionType: of('type'),
          ...(of('description') && { description: { und: of('description') } }),
          ...(right && { correctResponsesPattern: [right] }),
          ...(of('type') === 'choice' && { choices: choicesOf(right, of('learner_response')) }),
        },
      },
      result: { response: of('learner_response'), success: of('result') === 'correct' },
    });
  }

  /** The ids of the choices that are named; their texts stay in the lesson. */
  function choicesOf(...patterns) {
    return [...new Set(patterns.flatMap((pattern) => pattern.split('[,]')).filter(Boolean))].map((id) => ({ id }));
  }

  function keep() {
    if (isStateNew && values.get('cmi.mode') === 'normal') {
      isStateNew = false;
      const kept = Object.fromEntries(
        keptNames.flatMap((name) => (values.has(name) ? [[name, values.get(name)]] : [])),
      );
      send(addressOfState(stateId), 'PUT', kept).catch(complain);
    }
    return 'true';
  }

  /** The page is going: what still waits goes out with the last statement. */
  function end() {
    if (!hasEnded) {
      hasEnded = true;
      keep();
      isSending = false;
      write('terminated', { result: { duration: duration() } });
    }
    return 'true';
  }

  /** @returns resolves when the script has run */
  function load(src, dataset) {
    return new Promise((resolve) => {
      const script = document.createElement('script');
      Object.assign(script.dataset, dataset);
      script.addEventListener('load', resolve);
      script.addEventListener('error', resolve);
      script.src = src;
      document.body.append(script);
    });
  }
})();

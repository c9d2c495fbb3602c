// The page for frames: what an address and a message of a stranger may say.
import { expect } from '@esm-bundle/chai';
import { mayTalk } from '../../../packages/embed/src/peers.ts';
import { toPlain } from '../../../packages/embed/src/plain-value.ts';
import { readAddress, readOrigins } from '../../../packages/embed/src/read-address.ts';
import { eventTypes } from '../../../packages/embed/src/protocol.ts';
import { readMessage } from '../../../packages/embed/src/read-message.ts';
import { isFetched, leftAttributes, viewAttributes } from '../../../packages/embed/src/view-attributes.ts';
import { volumeElements } from '../../../packages/lesson-writers/src/volume-elements.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

const page = 'https://museum.example/dist/embed.html';
const of = (query: string): ReturnType<typeof readAddress> => readAddress(`${page}?${query}`);

/** Addresses that run something, hold data, or have what is not a server's. */
const badAddresses = [
  'javascript:alert(1)',
  ' java\tscript:alert(1)',
  'JAVASCRIPT:alert(1)//x.nii',
  'data:application/json,{"image":"https://evil.example/a.png"}',
  'data:text/html,<script>alert(1)</script>',
  'blob:https://museum.example/1-2',
  'file:///etc/passwd',
  'ftp://evil.example/a.nii',
  'vbscript:x',
  'https://user:secret@evil.example/a.nii',
  'https://',
  'a.nii javascript:alert(1)',
  'https://a b',
];
const badNames = [
  'onload',
  'onclick',
  'style',
  'srcdoc',
  'id',
  'class',
  'is',
  'slot',
  'part',
  '__proto__',
  'constructor',
  'toString',
  'x"><img src=x onerror=alert(1)>',
  '\u202egnp',
  '',
  'SRC',
  'innerHTML',
  ...Object.keys(leftAttributes),
];
const badTexts = [
  '<img src=x onerror=alert(1)>',
  '"><script>alert(1)</script>',
  '\0',
  'x'.repeat(20_000),
  '\ud800',
  '{{constructor}}',
  '${1}',
  ...badAddresses,
];

describe('the address of the page for frames', () => {
  it('may set each attribute of the table, except those that are left out with a reason', () => {
    const all = volumeElements['volume-view'].split(' ');
    expect([...viewAttributes, ...Object.keys(leftAttributes)]).to.have.members(all);
    for (const name of viewAttributes) {
      const { attributes, problems } = of(`${name}=x`);
      expect([attributes, problems], name).to.deep.equal([[[name, 'x']], []]);
    }
    for (const [name, reason] of Object.entries(leftAttributes)) {
      const { attributes, problems } = of(`${name}=x`);
      expect([attributes, problems]).to.deep.equal([[], [`${name} is not taken: ${reason}`]]);
    }
  });

  it('says in words what it does not know', () => {
    expect(of('src=a.nii&colour=red&onload=alert(1)').problems).to.deep.equal([
      '"colour" is no attribute of <volume-view> that this page knows',
      '"onload" is no attribute of <volume-view> that this page knows',
    ]);
    expect(of('src=a.nii&src=b.nii').attributes).to.deep.equal([['src', 'a.nii']]);
    expect(of('src=a.nii&src=b.nii').problems[0]).to.match(/twice/);
    expect(of('src=a.nii&lang=%22%3E').problems[0]).to.match(/lang is no language/);
    expect(of('src=&alt=x').problems[0]).to.equal('src names no file');
    expect(of('lesson=a.html&src=b.nii').problems[0]).to.match(/with lesson/);
    const { length } = of(Array.from({ length: 500 }, (_, i) => `x${i}`).join('&')).problems;
    expect(length).to.equal(8);
  });

  it('takes a poster whose address has blanks, and refuses one that can not be read', () => {
    expect(of('src=a.nii&poster=my+image.png').poster).to.equal('https://museum.example/dist/my%20image.png');
    // Each part of it could be an address.
    const plan = of('src=a.nii&poster=https://a+b');
    expect([plan.poster, plan.attributes]).to.deep.equal([null, [['src', 'a.nii']]]);
    expect(plan.problems[0]).to.match(/^poster got an address that this page does not fetch/);
    expect(of('poster=+').problems).to.deep.equal(['poster names no file']);
  });

  it('takes companions, a lesson, a poster, a language and origins', () => {
    const plan = of(
      'src=a.nii+b.nii&legend&readout&timeline&poster=p.png&lang=de&parent=https://a.example/x+https://b.example',
    );
    expect(plan.companions).to.deep.equal(['volume-legend', 'volume-readout', 'volume-timeline']);
    expect([plan.poster, plan.language, plan.parents, plan.problems]).to.deep.equal([
      'https://museum.example/dist/p.png',
      'de',
      ['https://a.example', 'https://b.example'],
      [],
    ]);
    expect(of('lesson=../course/lesson.html').lesson).to.equal('https://museum.example/course/lesson.html');
    // A list that can't be read narrows to nobody.
    expect(of('src=a.nii&parent=*').parents).to.deep.equal([]);
    expect(readOrigins('https://a.example null javascript:x')).to.deep.equal(['https://a.example']);
  });

  it('keeps nothing hostile of 1,000 made addresses', () => {
    const random = randomNumbers(3901);
    const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)];
    const good = [...viewAttributes, 'legend', 'lesson', 'poster', 'lang', 'parent'];
    let said = 0;
    for (let i = 0; i < 1000; i += 1) {
      const parts = Array.from({ length: 1 + Math.floor(random() * 8) }, () => {
        const name = random() < 0.5 ? pick(good) : pick(badNames);
        const text = random() < 0.3 ? 'a.nii' : pick(badTexts);
        // Some are not encoded, or damaged.
        return random() < 0.2
          ? `${name.replace(/[&=#\ud800]/g, '')}=${text.replace(/[&#\ud800]/g, '')}%`
          : `${encodeURIComponent(name)}=${encodeURIComponent(text.replace(/\ud800/g, '\ufffd'))}`;
      });
      const plan = of(parts.join(pick(['&', '&', '&&', '&amp;'])));
      for (const [name, text] of plan.attributes) {
        expect(viewAttributes.has(name), name).to.equal(true);
        expect(text.length).to.be.at.most(16_000);
        if (name === 'poster') expect(new URL(text, page).protocol, text).to.match(/^https?:$/);
        if (name === 'src')
          for (const one of text.split(/[\t\n\f\r ]+/).filter(Boolean))
            expect(new URL(one, page).protocol, text).to.match(/^https?:$/);
      }
      for (const one of [plan.lesson, plan.poster]) if (one !== null) expect(one).to.match(/^https?:\/\/[^@]*$/);
      for (const one of plan.companions) expect(one).to.match(/^volume-[a-z]+$/);
      for (const one of plan.parents ?? []) expect(one).to.match(/^https?:\/\/[^/]+$/);
      for (const one of plan.problems) expect(one.length).to.be.lessThan(250);
      if (plan.problems.length > 0) said += 1;
    }
    expect(said).to.be.greaterThan(800);
    expect(({} as { polluted?: unknown }).polluted).to.equal(undefined);
  });

  it('fetches from servers, and from where the page itself is', () => {
    for (const one of badAddresses) expect(isFetched(one, page) && !one.includes(' '), one).to.equal(false);
    for (const one of ['a.nii', '../a.nii', '/a.nii', '//b.example/a.nii', 'https://b.example/a.nii#channels=1'])
      expect(isFetched(one, page), one).to.equal(true);
    expect(isFetched('a.nii', 'file:///home/x/embed.html')).to.equal(true);
    expect(isFetched('file:///a.nii', page)).to.equal(false);
  });
});

describe('messages to the page for frames', () => {
  const read = (data: unknown): ReturnType<typeof readMessage> => readMessage(data, page);

  it('are read as they are documented', () => {
    expect(read({ volumeView: 1, id: 3, get: true })).to.deep.equal({ id: 3, request: { kind: 'get' }, problem: null });
    expect(read({ volumeView: 1, set: { 'camera-orbit': '1deg 2deg auto', legend: null } })!.problem).to.match(
      /"legend"/,
    );
    expect(
      read({ volumeView: 1, set: { steps: 40, controls: true, 'auto-rotate': false, region: null } })!.request,
    ).to.deep.equal({
      kind: 'set',
      attributes: [
        ['steps', '40'],
        ['controls', ''],
        ['auto-rotate', null],
        ['region', null],
      ],
    });
    expect(read({ volumeView: 1, step: 'next' })!.request).to.deep.equal({ kind: 'step', step: 'next' });
    expect(read({ volumeView: 1, events: ['load', 'load'] })!.request).to.deep.equal({
      kind: 'events',
      types: ['load'],
    });
    expect(read({ volumeView: 2, get: true })!.problem).to.match(/another version/);
    expect(read({ volumeView: 1, get: true, set: {} })!.problem).to.match(/got 2 requests/);
    expect(read({ volumeView: 1, events: ['load', 'click'] })!.problem).to.match(/"click"; expected load/);
    for (const other of [null, undefined, 1, 'volumeView', [], ['volumeView'], { message: 'ready', secret: 'x' }])
      expect(read(other)).to.equal(null);
  });

  it('1,000 made ones set nothing that the address may not say', () => {
    const random = randomNumbers(3902);
    const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)];
    const deep = (n: number): unknown => (n === 0 ? 'x' : { a: deep(n - 1), b: [deep(n - 1)] });
    const values: (() => unknown)[] = [
      () => pick(badTexts),
      () => 'a.nii',
      () => random() * 1e9,
      () => pick([NaN, Infinity, -1, 0, 1.5, 1n, true, false, null, undefined]),
      () => deep(4),
      () => [],
      () => new Map([['src', 'x']]),
      () => new Uint8Array(9),
      () => JSON.parse('{"__proto__": {"polluted": 1}, "src": "a.nii"}') as unknown,
      () =>
        Object.fromEntries(
          Array.from({ length: Math.floor(random() * 150) }, () => [
            pick([...viewAttributes, ...badNames]),
            pick(values.slice(0, 9))(),
          ]),
        ),
      () => Array.from({ length: Math.floor(random() * 40) }, () => pick([...eventTypes, 'click', '__proto__', {}])),
    ];
    const counts = { request: 0, problem: 0, ignored: 0 };
    for (let i = 0; i < 1000; i += 1) {
      const message: Record<string, unknown> = {};
      if (random() < 0.9) message.volumeView = random() < 0.9 ? 1 : pick(values)();
      if (random() < 0.7) message.id = random() < 0.5 ? i : pick(values)();
      for (const kind of ['get', 'set', 'step', 'events', 'eval', '__proto__'])
        if (random() < 0.25)
          Object.defineProperty(message, kind, { value: pick(values)(), enumerable: true, writable: true });
      if (random() < 0.3) message.set = { [pick([...viewAttributes])]: pick(badTexts) };
      const got = read(random() < 0.05 ? pick(values)() : message);
      if (got === null) {
        counts.ignored += 1;
        continue;
      }
      expect(got.id === null || Number.isFinite(got.id)).to.equal(true);
      expect((got.request === null) !== (got.problem === null)).to.equal(true);
      if (got.problem !== null) {
        counts.problem += 1;
        expect(got.problem.length).to.be.lessThan(400);
        continue;
      }
      counts.request += 1;
      const request = got.request!;
      if (request.kind === 'set')
        for (const [name, text] of request.attributes) {
          expect(viewAttributes.has(name), name).to.equal(true);
          if (text !== null && name === 'poster') expect(isFetched(text, page), text).to.equal(true);
          if (text !== null && name === 'src')
            for (const one of text.split(/\s+/).filter(Boolean)) expect(isFetched(one, page), text).to.equal(true);
        }
      if (request.kind === 'step')
        expect(request.step).to.satisfy(
          (one: unknown) => one === 'next' || one === 'previous' || Number.isInteger(one),
        );
      if (request.kind === 'events') for (const one of request.types) expect(eventTypes).to.include(one);
    }
    expect(counts.request).to.be.greaterThan(100);
    expect(counts.problem).to.be.greaterThan(300);
    expect(({} as { polluted?: unknown }).polluted).to.equal(undefined);
  });

  it('are answered to the own site, to those that the server lists, and from a sandbox to all; the address only narrows', () => {
    const own = 'https://museum.example';
    const other = 'https://other.example';
    expect(mayTalk(own, { own, listed: [], narrowed: null })).to.equal(true);
    expect(mayTalk(other, { own, listed: [], narrowed: null })).to.equal(false);
    expect(mayTalk('null', { own, listed: [], narrowed: null })).to.equal(false);
    expect(mayTalk(other, { own, listed: [other], narrowed: null })).to.equal(true);
    // Who writes the address can not let itself in.
    expect(mayTalk(other, { own, listed: [], narrowed: [other] })).to.equal(false);
    expect(mayTalk(own, { own, listed: [], narrowed: [other] })).to.equal(false);
    expect(mayTalk(other, { own: 'null', listed: [], narrowed: null })).to.equal(true);
    expect(mayTalk(other, { own: 'null', listed: [], narrowed: [own] })).to.equal(false);
  });

  it('have plain values only, and not much of them', () => {
    class Other {
      readonly x = 1;
    }
    expect(
      toPlain({ a: 1, b: 'x'.repeat(9000), c: [1, null, undefined], d: () => 1, e: new Uint8Array(3), f: new Other() }),
    ).to.deep.equal({ a: 1, b: 'x'.repeat(2000), c: [1, null, null] });
    let deep: unknown = 1;
    for (let i = 0; i < 5000; i += 1) deep = { deep };
    expect(JSON.stringify(toPlain(deep))).to.equal('{"deep":{"deep":{"deep":{}}}}');
    const round: Record<string, unknown> = {};
    round.round = round;
    expect(JSON.stringify(toPlain(round)).length).to.be.lessThan(100);
  });
});

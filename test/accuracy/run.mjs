// `npm run accuracy`: the study of error and time. `npm run accuracy -- small`: small things in the element's pictures at
// rest, and what it says of their errors; `npm run accuracy -- moving`: in its pictures in motion; `npm run accuracy -- among`: in those at rest, among cuts, shapes and slices, and in WebGL 1. `npm run accuracy -- stated`: what it says of random scenes; `npm run accuracy -- lit`:
// of lit scenes, surfaces, styles, and radars; `npm run accuracy -- hard`: of scenes that were made to break it; `npm run accuracy -- projected`: of projections; `npm run accuracy -- opaque`: of opaque steps, made to break it; `npm run accuracy -- count`: of the rays that pictures at rest need; `npm run accuracy -- trade`: what pictures cost and show by `max-error` and `detail`; `npm run accuracy -- detail`: what pictures in bricks say of their error; `npm run accuracy -- claims`: the tests that leave cases out, with all of them. `--quick` after one of the latter makes a short run; DRY=1 writes nothing into docs/numbers/accuracy.md.

const programs = [
  'study',
  'small',
  'moving',
  'among',
  'stated',
  'lit',
  'hard',
  'projected',
  'opaque',
  'count',
  'trade',
  'detail',
  'claims',
];

const flags = process.argv.slice(2);
const quick = flags.includes('--quick');
const [name = 'study', ...more] = flags.filter((flag) => flag !== '--quick');
if (!programs.includes(name) || more.length > 0 || (quick && name === 'study')) {
  throw new Error(
    `accuracy got ${flags.join(' ')}; expected nothing, or small, moving, among, stated, lit, hard, projected, opaque, count, trade, detail or claims, --quick after it for a short run`,
  );
}
const { run } = /** @type {{ run: (options: { quick: boolean }) => Promise<void> }} */ (await import(`./${name}.mjs`));
await run({ quick });

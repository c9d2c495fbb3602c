// `npm run bench`: all tables, or those that are named: `npm run bench -- quality load`. Tests nothing, and nothing waits
// for it. Run it on a machine that does nothing else. VOLUME_VIEW_GPU=1 takes the GPU instead of software GL; REPEATS=1,
// SIZES=128 and SCENES=mni152 make a quick run of those programs that know them.

/** In the order in which they run. */
const programs = [
  'page',
  'quality',
  'limit',
  'peers',
  'starts',
  'controller',
  'load',
  'cells',
  'phases',
  'growth',
  'radar',
  'shapes',
  'pairs',
  'pick',
  'slices',
  'notes',
  'lit',
  'edges',
  'choices',
  'motion',
  'gpu',
  'dial',
  'default-look',
  'codecs',
  'folder',
  'bricks',
  'bricked',
  'bricked-frames',
  'bricked-peers',
  'soak',
  'many-bricked',
  'video',
  'video-looks',
  'video-loops',
  'prepare-peers',
];

/** What measures nothing runs only where it is named. */
const named = ['looks'];

const asked = process.argv.slice(2);
const unknown = asked.filter((name) => ![...programs, ...named].includes(name));
if (unknown.length > 0)
  throw new Error(
    `bench got ${unknown.join(', ')}; expected some of ${[...programs, ...named].join(', ')}, or nothing for all`,
  );

for (const name of asked.length > 0 ? asked : programs) {
  const began = performance.now();
  console.log(`\n=== ${name} ===`);
  const { run } = /** @type {{ run: () => Promise<void> }} */ (await import(`./${name}.mjs`));
  await run();
  console.log(`${name}: ${Math.round((performance.now() - began) / 1000)} s`);
}

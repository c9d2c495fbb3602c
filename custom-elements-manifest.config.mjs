// custom-elements.json from the class comments of components/.
export default {
  globs: ['components/**/*.ts'],
  exclude: ['**/*.test.ts'],
  outdir: '.',
  litelement: true,
  packagejson: false,
};

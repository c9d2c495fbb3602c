/**
 * Sort the modules by their paths. The analyzer keeps the order in which the file system lists them, which differs between
 * machines.
 */
const sortModules = {
  name: 'sort-modules',
  /** @param {{ customElementsManifest: { modules: { path: string }[] } }} input */
  packageLinkPhase: ({ customElementsManifest: { modules } }) => {
    modules.sort((one, other) => (one.path < other.path ? -1 : 1));
  },
};

// custom-elements.json from the class comments of components/.
export default {
  globs: ['components/**/*.ts'],
  exclude: ['**/*.test.ts'],
  outdir: '.',
  litelement: true,
  packagejson: false,
  plugins: [sortModules],
};

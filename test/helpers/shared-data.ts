// Larger real data are in a folder outside of the repository, and not on every machine: tests that need them report it and are skipped.

/**
 * The bytes of a file of the shared data folder. Skips the test, with the reason, if the folder is absent.
 * @param context - `this` of a mocha `function () {}` test
 * @param path - relative to the folder, such as `medical/README.md`
 */
export async function fetchSharedData(context: Mocha.Context, path: string): Promise<ArrayBuffer> {
  const response = await fetch(`/shared-data/${path}`);
  if (!response.ok) {
    console.log(`left out "${context.test?.fullTitle()}": the shared data have no ${path}`);
    context.skip(); // It throws.
  }
  return response.arrayBuffer();
}

// Larger real data lie beside the checkout, and not on every machine: tests that need them say so and step aside.

/**
 * The bytes of a file of the shared data folder; leaves the test out, with the reason, where the folder is absent.
 * @param context - `this` of a mocha `function () {}` test
 * @param path - below the folder, such as `medical/README.md`
 */
export async function fetchSharedData(context: Mocha.Context, path: string): Promise<ArrayBuffer> {
  const response = await fetch(`/shared-data/${path}`);
  if (!response.ok) {
    console.log(`left out "${context.test?.fullTitle()}": the shared data have no ${path}`);
    context.skip(); // throws
  }
  return response.arrayBuffer();
}

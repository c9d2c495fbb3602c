// The small frame of the tests that run in Node: each check is named, and the end is the line scripts/test.mjs adds up.
let passed = 0;
let failed = 0;

/**
 * @param {string} name
 * @param {() => void | string | Promise<void | string>} body - throws where it fails; may return a remark
 */
export async function check(name, body) {
  try {
    const remark = await body();
    passed += 1;
    console.log(`ok: ${name}${remark ? ` (${remark})` : ''}`);
  } catch (error) {
    failed += 1;
    console.log(`FAILED: ${name}\n${error instanceof Error ? error.message : String(error)}`);
  }
}

export function finish() {
  console.log(`${passed} passed, ${failed} failed`);
  process.exitCode = failed > 0 ? 1 : 0;
  // A check that failed may have left a server or a program that runs, and then this process would never end.
  setTimeout(() => {
    console.error('something still runs 10 seconds after the last check; it is ended');
    process.exit();
  }, 10_000).unref();
}

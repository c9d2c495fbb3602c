// Ends an end-to-end run with the names of the failed and of the slowest tests, and the line that scripts/test.mjs adds up.
import { stripVTControlCharacters } from 'node:util';

export default class CountsReporter {
  /**
   * @param {import('@playwright/test/reporter').FullConfig} _config
   * @param {import('@playwright/test/reporter').Suite} suite
   */
  onBegin(_config, suite) {
    this.suite = suite;
    this.errors = 0;
  }

  /** An error outside any test: a file that does not load, a failed setup. */
  onError() {
    this.errors = (this.errors ?? 0) + 1;
  }

  onExit() {
    const tests = this.suite?.allTests() ?? [];
    const passed = tests.filter((test) => ['expected', 'flaky'].includes(test.outcome())).length;
    const failed = tests.filter((test) => test.outcome() === 'unexpected');
    for (const test of tests.filter((one) => one.outcome() === 'flaky'))
      console.log(`passed at the second try: ${nameOf(test)}: ${firstLine(test.results[0])}`);
    for (const test of failed) console.log(`not ok: ${nameOf(test)}: ${firstLine(test.results.at(-1))}`);
    const longest = tests.map((test) => ({ test, ms: test.results.reduce((sum, { duration }) => sum + duration, 0) }));
    longest.sort((a, b) => b.ms - a.ms);
    if (tests.length > 20)
      for (const { test, ms } of longest.slice(0, 12))
        console.log(`${(ms / 1000).toFixed(1).padStart(6)} s ${nameOf(test)}`);
    console.log(`${passed} passed, ${failed.length + (this.errors ?? 0)} failed`);
    return Promise.resolve();
  }
}

/** @param {import('@playwright/test/reporter').TestCase} test */
const nameOf = (test) => test.titlePath().filter(Boolean).join(' > ');

/** @param {import('@playwright/test/reporter').TestResult | undefined} result */
function firstLine(result) {
  const message = result?.error?.message ?? 'no message';
  // Without the colours of a terminal.
  return stripVTControlCharacters(message).split('\n').slice(0, 6).join(' ').slice(0, 400);
}

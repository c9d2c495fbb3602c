// Ends an end-to-end run with the names of what failed, and the line that scripts/test.mjs adds up.

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
    const passed = tests.filter((test) => test.outcome() === 'expected').length;
    const failed = tests.filter((test) => ['unexpected', 'flaky'].includes(test.outcome()));
    for (const test of failed) console.log(`not ok: ${test.titlePath().filter(Boolean).join(' > ')}: ${firstLine(test)}`);
    console.log(`${passed} passed, ${failed.length + (this.errors ?? 0)} failed`);
    return Promise.resolve();
  }
}

/** @param {import('@playwright/test/reporter').TestCase} test */
function firstLine(test) {
  const message = test.results.at(-1)?.error?.message ?? 'no message';
  // Without the colours of a terminal.
  return message.replace(/\u001b\[\d+m/g, '').split('\n').slice(0, 6).join(' ').slice(0, 400);
}

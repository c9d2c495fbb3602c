// Ends an end-to-end run with the line that scripts/test.mjs adds up.

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
    const outcomes = this.suite?.allTests().map((test) => test.outcome()) ?? [];
    const passed = outcomes.filter((outcome) => outcome === 'expected').length;
    const failed = outcomes.filter((outcome) => outcome === 'unexpected' || outcome === 'flaky').length;
    console.log(`${passed} passed, ${failed + (this.errors ?? 0)} failed`);
    return Promise.resolve();
  }
}

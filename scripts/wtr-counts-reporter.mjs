// Ends a unit-test run with the line that scripts/test.mjs adds up, and names what failed and what was left out.

/** @typedef {import('@web/test-runner-core').TestSuiteResult} TestSuiteResult */

/** @param {TestSuiteResult | undefined} suite @returns {import('@web/test-runner-core').TestResult[]} */
function listTests(suite) {
  return suite ? [...suite.tests, ...suite.suites.flatMap(listTests)] : [];
}

/** @returns {import('@web/test-runner-core').Reporter} */
export function countsReporter() {
  return {
    onTestRunFinished({ sessions }) {
      let passed = 0;
      let failed = 0;
      for (const session of sessions) {
        const tests = listTests(session.testResults);
        const failures = tests.filter((test) => !test.passed && !test.skipped).length;
        passed += tests.filter((test) => test.passed).length;
        // A file that does not load has no failed test, and is a failure all the same.
        failed += session.passed ? failures : Math.max(failures, 1);
        for (const test of tests.filter((one) => !one.passed && !one.skipped)) console.log(`\nnot ok: ${test.name}: ${test.error?.message.slice(0, 400) ?? 'no message'}`);
        if (!session.passed && failures === 0) console.log(`\nnot ok: ${session.testFile ?? 'a file'}: ${session.errors[0]?.message.slice(0, 400) ?? 'it ended badly'}`);
        for (const test of tests.filter((one) => one.skipped)) console.log(`left out: ${test.name}`);
      }
      // On a line of its own: the runner's progress may have left terminal codes on the present one.
      console.log(`\n${passed} passed, ${failed} failed`);
    },
  };
}

// Ends a unit-test run with the line that scripts/test.mjs adds up, and names the failed, the skipped and the slowest tests.
import { relative } from 'node:path';
import { projectRoot } from './shared-data.mjs';

/** Maximum number of characters of a message. */
const longest = 400;

/** @typedef {import('@web/test-runner-core').TestSuiteResult} TestSuiteResult */

/** @param {TestSuiteResult | undefined} suite @returns {import('@web/test-runner-core').TestResult[]} */
function listTests(suite) {
  return suite ? [...suite.tests, ...suite.suites.flatMap(listTests)] : [];
}

/** @returns {import('@web/test-runner-core').Reporter} */
export function countsReporter() {
  /** @type {Map<string, number>} when each session began, ms */
  const begun = new Map();
  /** @type {{ file: string, seconds: number }[]} */
  const times = [];
  return {
    start({ sessions }) {
      const start = Date.now();
      sessions.on('session-status-updated', ({ id, status, testFile }) => {
        // The first sessions have already begun.
        if (!begun.has(id)) begun.set(id, status === 'INITIALIZING' ? Date.now() : start);
        if (status === 'FINISHED')
          times.push({
            file: relative(projectRoot, testFile),
            seconds: (Date.now() - /** @type {number} */ (begun.get(id))) / 1000,
          });
      });
    },

    onTestRunFinished({ sessions }) {
      let passed = 0;
      let failed = 0;
      for (const session of sessions) {
        const tests = listTests(session.testResults);
        const failures = tests.filter((test) => !test.passed && !test.skipped).length;
        passed += tests.filter((test) => test.passed).length;
        // A file that does not load has no failed test, but counts as a failure.
        failed += session.passed ? failures : Math.max(failures, 1);
        const file = relative(projectRoot, session.testFile ?? 'a file');
        // Errors of a file that does not load, and of hooks, as they belong to no test.
        for (const { message } of session.passed ? [] : session.errors)
          console.log(`\nnot ok: ${file}: ${message.slice(0, longest)}`);
        if (!session.passed && failures === 0 && session.errors.length === 0)
          console.log(`\nnot ok: ${file}: it ended badly`);
        for (const test of tests.filter((one) => !one.passed && !one.skipped))
          console.log(`\nnot ok: ${test.name}: ${test.error?.message.slice(0, longest) ?? 'it did not run'}`);
        for (const test of tests.filter((one) => one.skipped)) console.log(`left out: ${test.name}`);
      }
      times.sort((a, b) => b.seconds - a.seconds);
      if (times.length > 1)
        for (const { file, seconds } of times.slice(0, 12)) console.log(`${seconds.toFixed(1).padStart(6)} s ${file}`);
      // On a line of its own: the runner's progress may have left terminal codes on the present line.
      console.log(`\n${passed} passed, ${failed} failed`);
    },
  };
}

// Helper processes of the engines: started here, ended here, each by its own handle.
import { spawn } from 'node:child_process';
import { createServer } from 'node:net';

/** @typedef {import('node:child_process').ChildProcess} ChildProcess */

/** @type {Set<ChildProcess>} */
const running = new Set();

/**
 * @param {string} program
 * @param {string[]} args
 * @param {{ env?: NodeJS.ProcessEnv, stdio?: import('node:child_process').StdioOptions }} [options]
 */
export function startProcess(program, args, { env = process.env, stdio = 'ignore' } = {}) {
  const child = spawn(program, args, { env, stdio });
  running.add(child);
  child.once('exit', () => running.delete(child));
  return child;
}

/** @param {ChildProcess} child */
export async function stopProcess(child) {
  if (!running.has(child)) return;
  const ended = new Promise((resolve) => void child.once('exit', resolve));
  child.kill('SIGTERM');
  const timer = setTimeout(() => child.kill('SIGKILL'), 5_000);
  await ended;
  clearTimeout(timer);
}

/** A port of 127.0.0.1 that was free a moment ago. @returns {Promise<number>} */
export function findFreePort() {
  return new Promise((resolve, reject) => {
    const server = createServer().once('error', reject);
    server.listen(0, '127.0.0.1', () => {
      const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
      server.close(() => resolve(port));
    });
  });
}

/**
 * A virtual screen: neither Firefox (headless, as root) nor WebKitGTK draws WebGL without one.
 * @returns {Promise<{ display: string, close: () => Promise<void> }>} display such as `:1`
 */
export async function startScreen() {
  // Xvfb takes a free number itself and writes it to descriptor 3.
  const child = startProcess('Xvfb', ['-displayfd', '3', '-screen', '0', '1280x1024x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  });
  const number = await new Promise((resolve, reject) => {
    let text = '';
    child.stdio[3]?.on('data', (chunk) => {
      text += chunk;
      if (text.includes('\n')) resolve(text.trim());
    });
    child.once('error', reject);
    child.once('exit', (code) => reject(new Error(`Xvfb ended at once with ${code}`)));
    setTimeout(() => reject(new Error('Xvfb did not start within 60 s')), 60_000).unref();
  });
  return { display: `:${number}`, close: () => stopProcess(child) };
}

process.once('exit', () => {
  for (const child of running) child.kill('SIGKILL');
});

import { fork } from 'node:child_process';
import type { ChildProcess } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import type { FailedLine, Job, JobResult } from './job.ts';

/** Child processes that do jobs, each one job at a time. One that ends or takes too long is replaced by a fresh one. */
export class ChildPool {
  readonly #free: ChildProcess[] = [];
  readonly #all = new Set<ChildProcess>();

  /** @param program - of a child @param timeout - maximum seconds of a job */
  constructor(
    private readonly program: URL,
    private readonly timeout: number,
  ) {}

  async run(job: Job): Promise<JobResult> {
    const child = this.#free.pop() ?? this.#start();
    return new Promise((resolve) => {
      const end = (result: JobResult | null, why: string): void => {
        clearTimeout(timer);
        child.off('message', take).off('exit', leave);
        if (result) this.#free.push(child);
        else {
          this.#all.delete(child);
          child.kill('SIGKILL');
        }
        resolve(result ?? { lines: [failed(why)], read: [], content: '' });
      };
      const take = (result: unknown): void => end(result as JobResult, '');
      const leave = (): void =>
        end(
          null,
          'the process that read it has ended, mostly because it lacked memory; use fewer --jobs, or make the volume smaller',
        );
      const timer = setTimeout(
        () => end(null, `it took more than ${this.timeout} seconds; --timeout allows more`),
        1000 * this.timeout,
      );
      child.once('message', take).once('exit', leave);
      child.send(job);
    });
  }

  close(): void {
    for (const child of this.#all) child.kill();
  }

  #start(): ChildProcess {
    const child = fork(fileURLToPath(this.program), [], { stdio: ['ignore', 'ignore', 'ignore', 'ipc'] });
    this.#all.add(child);
    return child;
  }
}

const failed = (message: string): FailedLine => ({ status: 'failed', code: 'format/too-large', message });

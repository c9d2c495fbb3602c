// `npm run lint`: oxlint with the compiler's types; further arguments (`--fix`, files) are passed on.
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { projectRoot } from './shared-data.mjs';

const oxlint = join(projectRoot, 'node_modules', 'oxlint', 'bin', 'oxlint');
const args = [oxlint, '--type-aware', '--deny-warnings', ...process.argv.slice(2)];
process.exitCode = spawnSync(process.execPath, args, { stdio: 'inherit' }).status ?? 1;

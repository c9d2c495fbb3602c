// Orthanc with its DICOMweb plugin (Debian: orthanc, orthanc-dicomweb), on this machine, with a folder of its own. In Node.
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const programs = ['/usr/sbin/Orthanc', '/usr/bin/Orthanc', '/usr/local/sbin/Orthanc'];
const plugins = [
  '/usr/share/orthanc/plugins/libOrthancDicomWeb.so',
  '/usr/local/share/orthanc/plugins/libOrthancDicomWeb.so',
];

export interface Orthanc {
  /** The root of DICOMweb. */
  readonly root: string;
  /** @returns the address of the file's series */
  upload(file: Uint8Array<ArrayBuffer>): Promise<string>;
  close(): Promise<void>;
}

/** Starts Orthanc; null where it, or its plugin, is not installed. */
export async function startOrthanc(): Promise<Orthanc | null> {
  const program = programs.find((path) => existsSync(path));
  const plugin = plugins.find((path) => existsSync(path));
  if (!program || !plugin) return null;
  const folder = mkdtempSync(join(tmpdir(), 'orthanc-'));
  const port = await findPort();
  const config = join(folder, 'orthanc.json');
  const settings = {
    StorageDirectory: join(folder, 'files'),
    IndexDirectory: join(folder, 'files'),
    HttpPort: port,
    HttpBindAddresses: ['127.0.0.1'],
    RemoteAccessAllowed: false,
    AuthenticationEnabled: false,
    DicomServerEnabled: false,
    Plugins: [plugin],
    DicomWeb: { Enable: true, Root: '/dicom-web/' },
  };
  writeFileSync(config, JSON.stringify(settings));
  const child = spawn(program, [config], { stdio: 'ignore' });
  const ended = new Promise<void>((resolve) => child.once('exit', () => resolve()));
  const origin = `http://127.0.0.1:${port}`;
  const close = async (): Promise<void> => {
    child.kill();
    await ended;
    rmSync(folder, { recursive: true, force: true });
  };
  for (let round = 0; ; round++) {
    const isUp = await fetch(`${origin}/system`).then(
      ({ ok }) => ok,
      () => false,
    );
    if (isUp) break;
    if (round === 150 || child.exitCode !== null) {
      await close();
      throw new Error('Orthanc is installed, and does not start');
    }
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
  return {
    root: `${origin}/dicom-web`,
    upload: async (file) => {
      const taken = await fetch(`${origin}/instances`, { method: 'POST', body: file });
      if (!taken.ok) throw new Error(`Orthanc does not take a file: HTTP status ${taken.status}`);
      const { ParentStudy, ParentSeries } = (await taken.json()) as Record<string, string>;
      const [study, series] = await Promise.all(
        [`studies/${ParentStudy}`, `series/${ParentSeries}`].map(async (path) => {
          const { MainDicomTags } = (await (await fetch(`${origin}/${path}`)).json()) as {
            MainDicomTags: Record<string, string>;
          };
          return MainDicomTags;
        }),
      );
      return `${origin}/dicom-web/studies/${study.StudyInstanceUID}/series/${series.SeriesInstanceUID}`;
    },
    close,
  };
}

/** A port that nothing listens at. */
async function findPort(): Promise<number> {
  const server = createServer();
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  await new Promise((resolve) => server.close(resolve));
  return port;
}

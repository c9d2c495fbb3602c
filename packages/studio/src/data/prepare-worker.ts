// Makes an image of files that the author chose, in a worker: so the page goes on meanwhile.
import { prepareChosen } from '../../../../src/prepare/prepare-chosen.ts';
import type { ChosenVolume } from '../../../../src/prepare/prepare-chosen.ts';
import { formatManifest } from '../../../prepare/src/format-manifest.ts';

/** What the page asks for. */
export interface PrepareOrder extends ChosenVolume {
  readonly files: readonly File[];
}

/** What it gets: the files of the lesson's data, or why there are none. */
export type PrepareAnswer =
  | { readonly manifest: string; readonly image: Uint8Array; readonly unit: string; readonly isRadar: boolean }
  | { readonly problem: string };

const scope = globalThis as unknown as {
  onmessage: ((event: MessageEvent<PrepareOrder>) => void) | null;
  postMessage(answer: PrepareAnswer): void;
};

scope.onmessage = ({ data: { files, ...chosen } }) => {
  void prepareChosen(files, chosen).then((made) => {
    if ('message' in made) return scope.postMessage({ problem: made.message });
    const manifest = formatManifest({ image: 'volume.png', ...made.manifest });
    return scope.postMessage({
      manifest,
      image: made.png,
      unit: made.report.unit,
      isRadar: 'elevations' in made.manifest,
    });
  });
};

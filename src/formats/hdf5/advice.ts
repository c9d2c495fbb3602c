/** What makes a file that can be read of one that can't. */
export type Remedy = 'repack' | 'repack-with-plugin' | 'h5py' | 'one-file' | 'plain-numbers';

const advices: Readonly<Record<Remedy, string>> = {
  repack: "rewrite it with HDF5's own tool: h5repack -f GZIP=6 old.h5 new.h5",
  'repack-with-plugin':
    "rewrite it with HDF5's own tool, which needs the plugin of this compression (HDF5_PLUGIN_PATH): h5repack -f GZIP=6 old.h5 new.h5",
  // h5repack does not know LZF, and leaves such data out.
  h5py: 'read it with h5py in Python, and write it again with compression="gzip"',
  'one-file': 'copy the values into one file, with the program that wrote it or with h5py in Python',
  'plain-numbers': 'write them as integers or floats of 8, 16, 32 or 64 bits',
};

export function adviceOf(remedy: Remedy): string {
  return advices[remedy];
}

// Scenes that the built package draws for `npm run bench -- gpu` and `-- dial`.

/** Tags as authors write them: attributes of `<volume-view>`, and children. */
export const scenes = {
  mri: { name: 'MRI, lit (default)', attributes: { src: '/demos/data/mni152-t1.nii.gz' } },
  fog: {
    name: 'MRI, fog',
    attributes: { src: '/demos/data/mni152-t1.nii.gz', 'transfer-function': 'mri', shading: 'unlit' },
  },
  ct: { name: 'CT (default)', attributes: { src: '/demos/data/ct-phantom.nii.gz' } },
  surface: {
    name: 'MRI, iso-surface',
    attributes: { src: '/demos/data/mni152-t1.nii.gz', 'surface-values': '38% #e2b9a6' },
  },
  maximum: {
    name: 'MRI, maximum intensity',
    attributes: { src: '/demos/data/mni152-t1.nii.gz', projection: 'max' },
  },
  storm: { name: 'Storm, radar', attributes: { src: '/demos/data/storm-radar.json' } },
};

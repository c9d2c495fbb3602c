// The files that the examples of the guide name, and what the site puts in their place: data of demos/data.

const [brain, head, torso] = ['mni152-t1.nii.gz', 'colin27-t1.nii.gz', 'ct-phantom.nii.gz'];

/** By the name in an example: the file, seen from demos/data. @type {Readonly<Record<string, string>>} */
export const sampleFiles = {
  'head.nii.gz': brain,
  't1.nii.gz': brain,
  'brain.nii.gz': brain,
  'tete.nii.gz': brain,
  'before.nii.gz': brain,
  'after.nii.gz': head,
  'atlas.nii.gz': 'brodmann-2mm.nii.gz',
  'areas.nii.gz': 'brodmann-2mm.nii.gz',
  'dseg.tsv': 'brodmann-dseg.tsv',
  'areas.tsv': 'brodmann-dseg.tsv',
  'statistics.nii.gz': 'motor-synthetic.nii.gz',
  'motor.nii.gz': 'motor-synthetic.nii.gz',
  't.nii.gz': 'motor-synthetic.nii.gz',
  'white.surf.gii': 'mni152-white.surf.gii',
  'chest.nii.gz': torso,
  'torso.nii.gz': torso,
  'torso-ct.nii.gz': torso,
  'head-ct.nii.gz': torso,
  'ct.nii.gz': torso,
  'storm.nii.gz': 'storm-radar-1500.json',
  'functional.nii': 'functional.nii',
  'functional.nii.gz': 'functional.nii',
  'study.zip': 'head-mr-dicom.zip',
  '1500.h5': 'storm-radar-1500.json',
  '1510.h5': 'storm-radar-1510.json',
  '1520.h5': 'storm-radar-1520.json',
  'demos/images/tour.webp': '../images/tour.webp',
  'storm-radar-1500.json': 'storm-radar-1500.json',
  'storm-radar-1510.json': 'storm-radar-1510.json',
  'storm-radar-1520.json': 'storm-radar-1520.json',
};

/** Files that the manifests name, by the same names. */
export const imagesOfManifests = ['storm-radar-1500.png', 'storm-radar-1510.png', 'storm-radar-1520.png'];

/** What an example names and the project has no data for: why there is no picture beside it. @type {Readonly<Record<string, string>>} */
export const missingFiles = {
  'scan.h5': 'a radar file with several moments',
  'scan.nii.gz': 'a file that is not there, on purpose',
  'organs.nii.gz': 'a segmentation of a torso',
  'segmentation.nii.gz': 'a segmentation of a torso',
  'vessels.nii.gz': 'an angiogram',
  'angio.nii.gz': 'an angiogram',
  'heart.nii.gz': 'a volume of a heart',
  'mosaic.png': 'an image of slices',
  'molecule.map.gz': 'a map of a molecule',
  'N0B.nids': 'four tilts of a radar',
  'N46E007.hgt': 'heights of the Alps',
  'above.webp': 'a picture',
};

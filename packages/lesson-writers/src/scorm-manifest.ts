import type { Lesson } from './lesson.ts';
import { escapeMarkup } from './write-html.ts';

/** `2004` means its 4th edition. */
export type ScormVersion = '1.2' | '2004';

interface ManifestOptions {
  readonly version: ScormVersion;
  readonly pass: number | null;
  readonly id: string;
}

/**
 * `imsmanifest.xml`: what an LMS reads of a package. Elements and their order: SCORM 1.2 Content Aggregation Model, 2.3; SCORM 2004 4th
 * Edition Content Aggregation Model, 3.4.
 * @param paths - of all other files
 */
export function writeManifest(lesson: Lesson, paths: readonly string[], options: ManifestOptions): string {
  return options.version === '1.2' ? writeFirst(lesson, paths, options) : writeSecond(lesson, paths, options);
}

function writeFirst(lesson: Lesson, paths: readonly string[], { pass, id }: ManifestOptions): string {
  const text = (words: string): string =>
    `<imsmd:langstring xml:lang="${escapeMarkup(lesson.language)}">${escapeMarkup(words)}</imsmd:langstring>`;
  const word = (name: string, value: string): string =>
    `<imsmd:${name}><imsmd:source><imsmd:langstring xml:lang="x-none">LOMv1.0</imsmd:langstring></imsmd:source><imsmd:value><imsmd:langstring xml:lang="x-none">${value}</imsmd:langstring></imsmd:value></imsmd:${name}>`;
  const score = pass === null ? '' : `\n        <adlcp:masteryscore>${pass}</adlcp:masteryscore>`;
  return `<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="${id}" version="1.0"
  xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2"
  xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2"
  xmlns:imsmd="http://www.imsglobal.org/xsd/imsmd_rootv1p2p1">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>1.2</schemaversion>
    <imsmd:lom>
      <imsmd:general>
        <imsmd:title>${text(lesson.title)}</imsmd:title>
        <imsmd:language>${escapeMarkup(lesson.language)}</imsmd:language>
        <imsmd:description>${text(lesson.credits)}</imsmd:description>
      </imsmd:general>
      <imsmd:rights>
        ${word('copyrightandotherrestrictions', 'yes')}
        <imsmd:description>${text(lesson.licence)}</imsmd:description>
      </imsmd:rights>
    </imsmd:lom>
  </metadata>
${listContent(lesson, paths, { scormType: 'adlcp:scormtype', rules: score })}
</manifest>
`;
}

function writeSecond(lesson: Lesson, paths: readonly string[], { pass, id }: ManifestOptions): string {
  const text = (words: string): string =>
    `<lom:string language="${escapeMarkup(lesson.language)}">${escapeMarkup(words)}</lom:string>`;
  const objective =
    pass === null
      ? ''
      : `
          <imsss:objectives>
            <imsss:primaryObjective objectiveID="score" satisfiedByMeasure="true">
              <imsss:minNormalizedMeasure>${pass / 100}</imsss:minNormalizedMeasure>
            </imsss:primaryObjective>
          </imsss:objectives>`;
  const sequencing = `
        <imsss:sequencing>${objective}
          <imsss:deliveryControls completionSetByContent="true" objectiveSetByContent="true"/>
        </imsss:sequencing>`;
  return `<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="${id}" version="1"
  xmlns="http://www.imsglobal.org/xsd/imscp_v1p1"
  xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_v1p3"
  xmlns:imsss="http://www.imsglobal.org/xsd/imsss"
  xmlns:lom="http://ltsc.ieee.org/xsd/LOM">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>2004 4th Edition</schemaversion>
    <lom:lom>
      <lom:general>
        <lom:title>${text(lesson.title)}</lom:title>
        <lom:language>${escapeMarkup(lesson.language)}</lom:language>
        <lom:description>${text(lesson.credits)}</lom:description>
      </lom:general>
      <lom:rights>
        <lom:copyrightAndOtherRestrictions><lom:source>LOMv1.0</lom:source><lom:value>yes</lom:value></lom:copyrightAndOtherRestrictions>
        <lom:description>${text(lesson.licence)}</lom:description>
      </lom:rights>
    </lom:lom>
  </metadata>
${listContent(lesson, paths, { scormType: 'adlcp:scormType', rules: sequencing })}
</manifest>
`;
}

/**
 * One activity, which is the page with all files.
 * @param how - how this version writes the name of the attribute, and the elements after the activity's title
 */
function listContent(
  { title }: Lesson,
  paths: readonly string[],
  { scormType, rules }: { readonly scormType: string; readonly rules: string },
): string {
  const name = escapeMarkup(title);
  return `  <organizations default="lesson">
    <organization identifier="lesson">
      <title>${name}</title>
      <item identifier="item" identifierref="page">
        <title>${name}</title>${rules}
      </item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="page" type="webcontent" ${scormType}="sco" href="index.html">
${listFiles(paths)}
    </resource>
  </resources>`;
}

/** Their addresses, relative to the manifest. */
const listFiles = (paths: readonly string[]): string =>
  paths
    .map((path) => `      <file href="${escapeMarkup(path.split('/').map(encodeURIComponent).join('/'))}"/>`)
    .join('\n');

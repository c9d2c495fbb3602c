/** The anchor that a heading gets, as GitHub makes it. @param {string} heading - without marks of Markdown, but perhaps of code */
export function anchorOf(heading) {
  return heading
    .toLowerCase()
    .replaceAll(/[^\p{L}\p{N}\s_-]/gu, '')
    .trim()
    .replaceAll(/\s/g, '-');
}

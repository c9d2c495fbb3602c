/**
 * HTML has no tags that close themselves: in `<Viewpoint/><VolumeData>` it reads the second element as a child of the first. For nodes of
 * X3D that can't have children, this file restores the meaning: the elements inside such a node follow it.
 */
const holdsNone =
  /^(?:(?:ortho)?viewpoint|viewfrustum|navigationinfo|background|environment|fog|worldinfo|(?:directional|point|spot)light|clipplane|material|imagetexture(?:atlas|3d)?|pixeltexture(?:3d)?|texturetransform|textureproperties|lineproperties|pointproperties|blendmode|depthmode|colormaskmode|box|sphere|cone|cylinder|torus|plane|coordinate|coordinatedouble|color|colorrgba|normal|texturecoordinate|fontstyle|route|timesensor|metadata(?:string|float|double|integer|boolean)|\w+interpolator2?d?|(?:boolean|integer)(?:filter|sequencer|toggle|trigger)|timetrigger|\w+(?:chaser|damper)2?d?)$/i;

/** Elements that do belong in such a node: metadata, the filter of a texture, and pictures that X3DOM accepts. */
const belongs = /^(?:metadata\w*|textureproperties|canvas|img|video)$/i;

const isLeaf = (element: Element | null): element is Element => element !== null && holdsNone.test(element.localName);

/** Whether an element is inside another only because that one was not closed. Materials of X3D 4 may contain textures, by their fields. */
function isSwallowed(element: Element, around: Element | null = element.parentElement): boolean {
  return (
    isLeaf(around) &&
    !belongs.test(element.localName) &&
    !(/^material$/i.test(around.localName) && element.hasAttribute('containerField'))
  );
}

/**
 * The element into which an author put another: not an unclosed one before it.
 * @param parent - its former parent, if it has been removed
 */
export function meantParent(element: Element, parent: Element | null = element.parentElement): Element | null {
  let one = parent;
  if (isSwallowed(element, parent)) while (isLeaf(one)) one = one.parentElement;
  return one;
}

/** The elements that an author put into another one, in order: those inside unclosed ones follow these. */
export function meantChildren(element: Element): Element[] {
  const own = [...element.children].filter((child) => !isSwallowed(child));
  return isLeaf(element) ? own : own.flatMap((child) => [child, ...swallowedBy(child)]);
}

/** All elements that an author put into an element, at any depth. */
export function meantWithin(element: Element): Element[] {
  return meantChildren(element).flatMap((child) => [child, ...meantWithin(child)]);
}

/** The elements inside an element that was not closed: they follow it. */
export function swallowedBy(element: Element): Element[] {
  return isLeaf(element)
    ? [...element.children].flatMap((child) => [...(isSwallowed(child) ? [child] : []), ...swallowedBy(child)])
    : [];
}

/**
 * HTML knows no tag that closes itself: in `<Viewpoint/><VolumeData>` the second is read as a child of the first. X3D's nodes that can hold
 * none are read here as what they were meant to be: what stands in one follows it.
 */
const holdsNone = /^(?:(?:ortho)?viewpoint|viewfrustum|navigationinfo|background|environment|fog|worldinfo|(?:directional|point|spot)light|clipplane|material|imagetexture(?:atlas|3d)?|pixeltexture(?:3d)?|texturetransform|textureproperties|lineproperties|pointproperties|blendmode|depthmode|colormaskmode|box|sphere|cone|cylinder|torus|plane|coordinate|coordinatedouble|color|colorrgba|normal|texturecoordinate|fontstyle|route|timesensor|metadata(?:string|float|double|integer|boolean)|\w+interpolator2?d?|(?:boolean|integer)(?:filter|sequencer|toggle|trigger)|timetrigger|\w+(?:chaser|damper)2?d?)$/i;

/** What does belong into such a node: notes, how a texture is filtered, and pictures that X3DOM takes. */
const belongs = /^(?:metadata\w*|textureproperties|canvas|img|video)$/i;

const isLeaf = (element: Element | null): element is Element => element !== null && holdsNone.test(element.localName);

/** Whether an element stands in another because that was not closed, and not as a part of it. X3D 4's materials may name textures by their fields. */
function isSwallowed(element: Element, around: Element | null = element.parentElement): boolean {
  return isLeaf(around) && !belongs.test(element.localName) && !(/^material$/i.test(around.localName) && element.hasAttribute('containerField'));
}

/**
 * The element that an author put another into: not one that was not closed before it.
 * @param parent - where it stood, if it has been taken out
 */
export function meantParent(element: Element, parent: Element | null = element.parentElement): Element | null {
  let one = parent;
  if (isSwallowed(element, parent)) while (isLeaf(one)) one = one.parentElement;
  return one;
}

/** The elements that an author put into another, in order: those that stand in unclosed ones follow these. */
export function meantChildren(element: Element): Element[] {
  const own = [...element.children].filter((child) => !isSwallowed(child));
  return isLeaf(element) ? own : own.flatMap((child) => [child, ...swallowedBy(child)]);
}

/** All that is meant to be in an element. */
export function meantWithin(element: Element): Element[] {
  return meantChildren(element).flatMap((child) => [child, ...meantWithin(child)]);
}

/** What stands in an element only because that was not closed, and so follows it. */
export function swallowedBy(element: Element): Element[] {
  return isLeaf(element) ? [...element.children].flatMap((child) => [...(isSwallowed(child) ? [child] : []), ...swallowedBy(child)]) : [];
}

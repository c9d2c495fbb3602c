/**
 * The parts of an author's X3D that may join a scene. x3dom makes functions of `on...` attributes, loads scripts,
 * scenes, buffers and shaders from other nodes' URLs, and follows the URL of an anchor. Sanitizers, which know HTML,
 * let all of that pass. So only what is listed here joins a scene.
 */

const words = (text: string): ReadonlySet<string> => new Set(text.trim().split(/\s+/));

/** Nodes that are drawn, or that move what is drawn. None of them runs code, or loads anything except pictures. */
const nodes = words(`
  group transform matrixtransform staticgroup switch billboard collision lod
  shape appearance material twosidedmaterial physicalmaterial commonsurfaceshader surfaceshadertexture
  lineproperties pointproperties blendmode depthmode colormaskmode
  imagetexture texture pixeltexture multitexture texturetransform matrixtexturetransform
  texturecoordinate multitexturecoordinate texturecoordinategenerator textureproperties
  box sphere cone cylinder torus plane indexedfaceset indexedtriangleset indexedtrianglestripset triangleset
  indexedlineset lineset pointset particleset coordinate coordinatedouble color colorrgba normal text fontstyle
  directionallight pointlight spotlight viewpoint orthoviewpoint viewfrustum navigationinfo background fog environment clipplane
  route timesensor positioninterpolator positioninterpolator2d orientationinterpolator colorinterpolator scalarinterpolator
  coordinateinterpolator normalinterpolator splinepositioninterpolator
  colorchaser colordamper coordinatedamper orientationchaser orientationdamper positionchaser positionchaser2d
  positiondamper positiondamper2d scalarchaser scalardamper texcoorddamper2d
  booleanfilter booleansequencer booleantoggle booleantrigger integersequencer integertrigger timetrigger
  worldinfo metadataset metadatastring metadatafloat metadatadouble metadatainteger metadataboolean
`);

/** Fields of these nodes. The `buffer` of interpolators, which is a URL of data, is not among them. */
const fields = words(`
  render visible bboxcenter bboxsize bboxdisplay bboxmargin bboxcolor
  center translation rotation scale scaleorientation matrix whichchoice axisofrotation enabled range forcetransitions
  debug showdebugboxvolumes bvhtype maxobjectspernode maxdepth minrelativebboxsize
  ispickable idoffset sorttype sortkey alphaclipthreshold
  ambientintensity diffusecolor emissivecolor shininess specularcolor transparency
  backambientintensity backdiffusecolor backemissivecolor backshininess backspecularcolor backtransparency separatebackcolor
  model basecolorfactor metallicfactor roughnessfactor diffusefactor specularfactor glossinessfactor emissivefactor
  normalspace alphamode alphacutoff normalbias normalscale unlit
  language tangenttexturecoordinatesid binormaltexturecoordinatesid emissivetextureid emissivetexturecoordinatesid
  emissivetexturechannelmask ambientfactor ambienttextureid ambienttexturecoordinatesid ambienttexturechannelmask
  diffusetextureid diffusetexturecoordinatesid diffusetexturechannelmask speculartextureid speculartexturecoordinatesid
  speculartexturechannelmask shininessfactor shininesstextureid shininesstexturecoordinatesid shininesstexturechannelmask
  normalformat normaltextureid normaltexturecoordinatesid normaltexturechannelmask reflectionfactor reflectiontextureid
  reflectiontexturecoordinatesid reflectiontexturechannelmask transmissionfactor transmissiontextureid
  transmissiontexturecoordinatesid transmissiontexturechannelmask environmentfactor environmenttextureid
  environmenttexturecoordinatesid environmenttexturechannelmask relativeindexofrefraction fresnelblend displacementaxis
  displacementfactor displacementtextureid displacementtexturecoordinatesid usealpha alphafactor invertalphatexture
  alphatextureid alphatexturecoordinatesid alphatexturechannelmask
  applied linetype linewidthscalefactor pointsizescalefactor pointsizeminvalue pointsizemaxvalue attenuation
  srcfactor destfactor colortransparency alphafunc alphafuncvalue equation
  enabledepthtest depthfunc readonly znearrange zfarrange maskr maskg maskb maska
  origchannelcount url repeats repeatt crossorigin flipy channel channelmask texturecoordinatesid issrgb hidechildren image
  point mode parameter anisotropicdegree bordercolor borderwidth boundarymodes boundarymodet boundarymoder
  magnificationfilter minificationfilter texturecompression texturepriority generatemipmaps
  solid ccw usegeocache lit hashelpercolors size radius height bottomradius topradius bottom side top subdivision innerradius
  outerradius angle caps insideoutsideradius primtype draworder texturez
  coordindex colorindex normalindex texcoordindex colorpervertex normalpervertex normalupdatemode convex creaseangle
  index stripcount vertexcount drawmode color vector string length maxextent family horizontal justify lefttoright
  spacing style toptobottom quality
  intensity global on shadowintensity shadowmapsize shadowfiltersize shadowoffset shadowcascades shadowsplitfactor
  shadowsplitoffset znear zfar direction location beamwidth cutoffangle
  bind description nearclippingplane farclippingplane viewall fieldofview position orientation centerofrotation modelview
  projection headlight reversescroll type typeparams explorationmode avatarsize walkdamping visibilitylimit speed
  transitiontime transitiontype groundcolor groundangle skycolor skyangle backurl bottomurl fronturl lefturl righturl topurl
  scaling fogtype visibilityrange sorttrans shadowexcludetransparentobjects gammacorrectiondefault tonemapping frustumculling
  plane cappingstrength cappingcolor
  cycleinterval loop starttime stoptime pausetime resumetime cycletime elapsedtime fraction_changed isactive ispaused time
  first firstcycle key fraction interpolation duration keyvalue rgb keyvelocity closed normalizevelocity
  initialdestination initialvalue value destination tau tolerance order
  boolean inputfalse inputtrue inputnegate next previous toggle triggertime triggertrue triggervalue integerkey
  info title name reference
  fromnode fromfield tonode tofield containerfield
`);

export function isAllowedNode(element: Element): boolean {
  return nodes.has(element.localName.toLowerCase());
}

/** @param name - of an attribute; an event's name can also set or change a field */
export function isAllowedField(name: string): boolean {
  return fields.has(fieldOf(name));
}

/** The field that an attribute or an event belongs to. */
export function fieldOf(name: string): string {
  const lower = name.toLowerCase();
  if (fields.has(lower)) return lower;
  return lower.replace(/^set_|_changed$/g, '');
}

/** Whether an attribute would run as a script. */
export function isHandler(name: string): boolean {
  return /^on./i.test(name);
}

/** Whether a field holds URLs. The allowed fields of this kind load pictures. */
export function isUrlField(name: string): boolean {
  return fieldOf(name).endsWith('url');
}

/**
 * Sorts the URLs of a field: those that may be loaded, written so that x3dom reads exactly these; and those that may
 * not.
 */
export function sortUrls(
  text: string,
  base: string,
): { readonly allowed: string; readonly refused: readonly string[] } {
  const trimmed = text.trim();
  const given = trimmed.startsWith('"')
    ? [...trimmed.matchAll(/"((?:[^\\"]|\\.)*)"/g)].map(([, url]) => url.replace(/\\(.)/g, '$1'))
    : [trimmed];
  const [allowed, refused]: [string[], string[]] = [[], []];
  for (const url of given.filter((one) => one.trim() !== '')) {
    const found = pictureUrl(url, base);
    if (found) allowed.push(`"${found}"`);
    else refused.push(url);
  }
  return { allowed: allowed.join(' '), refused };
}

/** The absolute URL of a picture on a server or in the URL itself; null for everything else, such as a script. */
function pictureUrl(text: string, base: string): string | null {
  let url: URL;
  try {
    url = new URL(text, base);
  } catch {
    return null;
  }
  const isPicture = /^https?:$/.test(url.protocol) || (url.protocol === 'data:' && /^image\//i.test(url.pathname));
  return isPicture ? url.href.replace(/["\\]/g, encodeURIComponent) : null;
}

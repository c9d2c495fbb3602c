// An image or a form with the name "currentScript" hides document.currentScript, whatever its src. So we read the property of the
// prototype. It has a value only while the script runs.
const script: unknown = Reflect.get(Document.prototype, 'currentScript', document);

/** The URL of the classic script that contains this module; where it stands in the page itself, the base of the page. */
export const scriptUrl: string =
  (script instanceof HTMLScriptElement && script.src) || Reflect.get(Node.prototype, 'baseURI', document);

interface TextPolicy {
  createScriptURL(text: string): string;
  createHTML(text: string): string;
}

interface PolicyFactory {
  createPolicy(name: string, rules: TextPolicy): TextPolicy;
}

let policy: TextPolicy | undefined;

/**
 * A text of this package or of x3dom, as a page wants it that has Trusted Types. Nothing that a file, an attribute or an
 * element says may come here.
 */
export function trust(text: string, kind: keyof TextPolicy): string {
  const asItIs = (own: string): string => own;
  try {
    policy ??= (globalThis as { trustedTypes?: PolicyFactory }).trustedTypes?.createPolicy('volume-view', { createScriptURL: asItIs, createHTML: asItIs });
  } catch {
    // The page allows no policy of this name. It may do without.
  }
  return policy ? policy[kind](text) : text;
}

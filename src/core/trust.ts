interface TextPolicy {
  createScriptURL(text: string): string;
  createHTML(text: string): string;
}

interface PolicyFactory {
  createPolicy(name: string, rules: TextPolicy): TextPolicy;
}

let policy: TextPolicy | undefined;

/**
 * Mark a text of this package or of x3dom as trusted, for pages that use Trusted Types. Never pass a text from a file, an attribute or an
 * element.
 */
export function trust(text: string, kind: keyof TextPolicy): string {
  const asItIs = (own: string): string => own;
  try {
    policy ??= (globalThis as { trustedTypes?: PolicyFactory }).trustedTypes?.createPolicy('volume-view', {
      createScriptURL: asItIs,
      createHTML: asItIs,
    });
  } catch {
    // The page does not allow a policy of this name. It may work without one.
  }
  return policy ? policy[kind](text) : text;
}

interface TextPolicy {
  createScriptURL(text: string): string;
  createHTML(text: string): string;
}

interface PolicyFactory {
  createPolicy(name: string, rules: TextPolicy): TextPolicy;
}

/**
 * A function that marks texts as trusted, for pages that use Trusted Types.
 * @param name - of the policy, which such a page has to allow
 */
export function makeTrust(name: string): (text: string, kind: keyof TextPolicy) => string {
  let policy: TextPolicy | undefined;
  const asItIs = (own: string): string => own;
  return (text, kind) => {
    try {
      policy ??= (globalThis as { trustedTypes?: PolicyFactory }).trustedTypes?.createPolicy(name, {
        createScriptURL: asItIs,
        createHTML: asItIs,
      });
    } catch {
      // The page does not allow a policy of this name. It may work without one.
    }
    return policy ? policy[kind](text) : text;
  };
}

/**
 * Mark a text of this package or of x3dom as trusted. Never pass a text from a file, an attribute or an element.
 */
export const trust = makeTrust('volume-view');

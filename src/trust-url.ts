interface ScriptPolicy {
  createScriptURL(url: string): string;
}

interface PolicyFactory {
  createPolicy(name: string, rules: ScriptPolicy): ScriptPolicy;
}

let policy: ScriptPolicy | undefined;

/**
 * The address of a script of this package, as a page wants it that has Trusted Types. Nothing that a file or an attribute
 * says may come here.
 */
export function trustUrl(url: string): string {
  try {
    policy ??= (globalThis as { trustedTypes?: PolicyFactory }).trustedTypes?.createPolicy('volume-view', { createScriptURL: (own) => own });
  } catch {
    // The page allows no policy of this name. It may do without.
  }
  return policy ? policy.createScriptURL(url) : url;
}

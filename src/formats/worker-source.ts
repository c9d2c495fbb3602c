export const inlineWorkerSource: string | null = null;

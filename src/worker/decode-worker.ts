// The worker's entry.
import { takeOrders } from './take-orders.ts';
import type { WorkerScope } from './take-orders.ts';

takeOrders(globalThis as unknown as WorkerScope);

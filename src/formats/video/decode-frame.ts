import { VolumeViewError } from '../../core/errors.ts';
import type { GrayImage } from '../../volume/mosaic.ts';
import type { ReadContext } from '../base/format.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { findRun } from './video-table.ts';
import type { PacketRun, VideoTable } from './video-table.ts';

/** What reading a frame needs. */
export type FrameAccess = Pick<ReadContext, 'budget'> & Partial<Pick<ReadContext, 'onProgress'>>;

/** Packets that wait in the decoder: their frames take memory that nobody counts. */
const maxWaiting = 4;

/** A decoder that gives nothing for so long is taken for one that never will. */
const patienceMs = 30_000;

/** Times of frames in the decoder: their numbers, so that the frame that comes is the one that was asked for. */
const microsecondsApart = 1000;

/** Kinds of pixels whose first plane is the brightness, and how many bits they have. Source: W3C WebCodecs, VideoPixelFormat */
const lumaBits = /^(?:I4(?:20|22|44)A?(?:P(?<bits>10|12))?|NV12)$/;

/**
 * Decodes one frame: the numbers of its brightness as they are in the video, of 8 bits or more, without any management of colours.
 * @param frame - from 0, in the order of time
 * @throws {VolumeViewError} `format/corrupt`, `format/unsupported`, `format/too-large`; what `onProgress` throws
 */
export async function decodeFrame(video: VideoTable, frame: number, access: FrameAccess): Promise<GrayImage> {
  const run = findRun(video, frame);
  if (!run) throw corruptFile(nameOf(frame), 'has no frame before it that can be decoded by itself');
  const config = await chooseConfig(video);
  const { budget } = access;
  const length = video.starts[run.last + 1] - video.starts[run.first];
  budget.addFile(video.bytes);
  budget.take(length, 'the video');
  const bytes = new Uint8Array(
    await video.data.slice(video.starts[run.first], video.starts[run.last + 1]).arrayBuffer(),
  );
  const decoded = await decodeRun(video, { ...run, frame, bytes }, config, access);
  budget.giveBack(length);
  try {
    return await copyLuma(decoded, video, frame, access);
  } finally {
    decoded.close();
  }
}

const nameOf = (frame: number): string => `frame ${frame + 1} of the video`;

/** The decoder in software gives every frame in memory; one in hardware gives the same numbers. */
async function chooseConfig({ codec, description, width, height }: VideoTable): Promise<VideoDecoderConfig> {
  const base = { codec, description, codedWidth: width, codedHeight: height };
  for (const config of [{ ...base, hardwareAcceleration: 'prefer-software' as const }, base])
    if (await isSupported(config)) return config;
  throw unsupportedFile(
    'the video',
    `got the codec "${codec.slice(0, 40)}", which this browser can not decode; expected VP9 or AV1, which nearly all can`,
  );
}

async function isSupported(config: VideoDecoderConfig): Promise<boolean> {
  try {
    return (await VideoDecoder.isConfigSupported(config)).supported === true;
  } catch {
    return false; // A codec that is no name of one.
  }
}

/** Feeds the packets that a frame needs, and keeps that frame alone. */
async function decodeRun(
  { packets, keys, starts }: VideoTable,
  { first, last, frame, bytes }: PacketRun & { readonly frame: number; readonly bytes: Uint8Array<ArrayBuffer> },
  config: VideoDecoderConfig,
  { onProgress }: FrameAccess,
): Promise<VideoFrame> {
  let found: VideoFrame | null = null;
  let fail = (_cause: unknown): void => {};
  const broken = new Promise<never>((_, reject) => (fail = reject));
  broken.catch(() => {}); // It is heard where something is awaited.
  const decoder = new VideoDecoder({
    output(one) {
      if (one.timestamp !== frame * microsecondsApart || found) one.close();
      else found = one;
    },
    error: fail,
  });
  const wait = async (event: Promise<unknown>): Promise<void> => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const late = new Promise<never>((_, reject) => {
      timer = setTimeout(() => reject(new Error('the decoder gives nothing')), patienceMs);
    });
    await Promise.race([event, broken, late]).finally(() => clearTimeout(timer));
  };
  const numbers = new Map(Array.from(packets, (packet, number) => [packet, number]));
  try {
    decoder.configure(config);
    for (let packet = first; packet <= last; packet++) {
      onProgress?.(packet - first, last + 1 - first);
      while (decoder.decodeQueueSize >= maxWaiting)
        await wait(new Promise((resolve) => decoder.addEventListener('dequeue', resolve, { once: true })));
      decoder.decode(
        new EncodedVideoChunk({
          type: keys[packet] ? 'key' : 'delta',
          timestamp: numbers.get(packet)! * microsecondsApart,
          data: bytes.subarray(starts[packet] - starts[first], starts[packet + 1] - starts[first]),
        }),
      );
    }
    await wait(decoder.flush());
  } catch (cause) {
    (found as VideoFrame | null)?.close();
    if (isOfLoad(cause)) throw cause;
    throw new VolumeViewError('format/corrupt', `${nameOf(frame)} is damaged; fetch or save the video again`, {
      cause,
    });
  } finally {
    if (decoder.state !== 'closed') decoder.close();
  }
  if (!found) throw corruptFile(nameOf(frame), 'gives no picture; save the video again');
  return found;
}

/** Whether the load was stopped: errors of a decoder have other names. */
const isOfLoad = (cause: unknown): boolean =>
  cause instanceof VolumeViewError || (cause instanceof DOMException && cause.name === 'AbortError');

async function copyLuma(
  decoded: VideoFrame,
  { width, height }: VideoTable,
  frame: number,
  { budget }: FrameAccess,
): Promise<GrayImage> {
  const { visibleRect, format } = decoded;
  if (visibleRect?.width !== width || visibleRect.height !== height)
    throw corruptFile(
      nameOf(frame),
      `got ${visibleRect?.width} x ${visibleRect?.height} pixels; expected ${width} x ${height} as the file says`,
    );
  const kind = lumaBits.exec(format ?? '');
  if (!kind)
    throw unsupportedFile(
      nameOf(frame),
      `comes from this browser's decoder as "${format}"; expected brightness in a plane of its own, as of yuv420p`,
    );
  const size = decoded.allocationSize();
  budget.take(size, 'the video');
  const planes = new Uint8Array(size);
  const [{ offset, stride }] = await decoded.copyTo(planes);
  const isWide = kind.groups?.bits !== undefined;
  const rowBytes = width * (isWide ? 2 : 1);
  budget.take(rowBytes * height, 'the video');
  const rows = new Uint8Array(rowBytes * height);
  for (let y = 0; y < height; y++)
    rows.set(planes.subarray(offset + y * stride, offset + y * stride + rowBytes), y * rowBytes);
  budget.giveBack(size);
  return { width, height, data: isWide ? new Uint16Array(rows.buffer) : rows };
}

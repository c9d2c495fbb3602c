import { VolumeViewError } from '../../core/errors.ts';
import type { Budget } from '../base/budget.ts';
import { corruptFile, unsupportedFile } from '../base/file-problem.ts';
import { loadReader } from '../base/load-reader.ts';
import { refusePixels } from '../images/max-pixels.ts';
import { checkTables } from './check-tables.ts';
import type { VideoTable } from './video-table.ts';

/** As many as a manifest may list. */
const maxFrames = 10_000;

const what = 'the video';

/** Memory for each packet while the table is made. */
const bytesPerPacket = 256;

/** One packet, with the time at which its frame is shown. */
interface Packet {
  readonly data: Uint8Array;
  readonly isKey: boolean;
  readonly time: number;
}

/**
 * Finds the packets of a WebM or MP4 file. No frame is decoded.
 * @param canDecode - whether there is WebCodecs here
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`, `format/unsupported`
 * @throws {NeedsMainThread} in a worker without the library
 */
export async function openVideo(
  bytes: Uint8Array<ArrayBuffer>,
  budget: Budget,
  canDecode: boolean,
): Promise<VideoTable> {
  const { BufferSource, EncodedPacketSink, Input, Logging, LogLevel, MP4, WEBM } = await loadReader(
    () => import('#mediabunny'),
  );
  // Its words have parts of the file.
  Logging.level = LogLevel.Silent;
  checkTables(bytes);
  const source = countQuestions(new BufferSource(bytes), budget);
  const input = new Input({ source, formats: [WEBM, MP4] });
  try {
    if (!(await input.canRead()))
      throw unsupportedFile(what, 'got a file that is neither WebM nor MP4; expected one of them');
    const track = await input.getPrimaryVideoTrack();
    const config = await track?.getDecoderConfig();
    if (!track || !config) throw unsupportedFile(what, 'has no track of VP9, AV1 or H.264; expected one of them');
    const { codec, codedWidth: width = 0, codedHeight: height = 0, description } = config;
    if (!(width > 0 && height > 0)) throw corruptFile(what, `got ${width} x ${height} pixels; expected some`);
    refusePixels(what, { width, height });
    const packets: Packet[] = [];
    for await (const { data, type, timestamp } of new EncodedPacketSink(track).packets()) {
      if (packets.length === maxFrames)
        throw new VolumeViewError(
          'format/too-large',
          `${what} got more than ${maxFrames.toLocaleString('en')} frames; expected at most so many`,
        );
      budget.take(bytesPerPacket, what);
      packets.push({ data, isKey: type === 'key', time: timestamp });
    }
    if (packets.length === 0) throw corruptFile(what, 'has no frame; fetch or save it again');
    const { fullRange, matrix } = await track.getColorSpace();
    return {
      ...listPackets(packets, canDecode ? null : new Blob([bytes])),
      codec,
      ...(description ? { description: copyOf(description) } : {}),
      width,
      height,
      // Without a matrix, players take the range for limited.
      isFullRange: fullRange === true && (matrix ?? null) !== null,
      bytes: bytes.length,
    };
  } catch (cause) {
    if (cause instanceof VolumeViewError) throw cause;
    throw new VolumeViewError('format/corrupt', `${what} is damaged or cut short; fetch or save it again`, { cause });
  } finally {
    input.dispose();
  }
}

/** Steps for each question to the source of the bytes: a sound file takes some for each frame. */
const stepsPerQuestion = 100;

/**
 * The source of the bytes, whose questions are counted: of a file that is cut inside of the head of an element, mediabunny 1.61 reads the same
 * place for ever, without a pause in which anything else could end it.
 */
function countQuestions<T extends object>(source: T, budget: Budget): T {
  return new Proxy(source, {
    get(target, name, receiver) {
      budget.step(stepsPerQuestion, what);
      return Reflect.get(target, name, receiver) as unknown;
    },
  });
}

function copyOf(source: AllowSharedBufferSource): Uint8Array<ArrayBuffer> {
  return ArrayBuffer.isView(source)
    ? new Uint8Array(source.buffer, source.byteOffset, source.byteLength).slice()
    : new Uint8Array(source).slice();
}

/** @param file - the whole file, where its packets are not needed */
function listPackets(
  packets: readonly Packet[],
  file: Blob | null,
): Pick<VideoTable, 'data' | 'isFile' | 'starts' | 'keys' | 'packets' | 'times'> {
  const order = packets.map((_, i) => i);
  // Packets are stored as they are decoded; frames of one time stay in that order.
  order.sort((a, b) => packets[a].time - packets[b].time || a - b);
  const starts = new Float64Array(packets.length + 1);
  for (const [i, { data }] of packets.entries()) starts[i + 1] = starts[i] + data.length;
  return {
    data: file ?? new Blob(packets.map(({ data }) => data as Uint8Array<ArrayBuffer>)),
    isFile: file !== null,
    starts,
    keys: Uint8Array.from(packets, ({ isKey }) => (isKey ? 1 : 0)),
    packets: Uint32Array.from(order),
    times: Float64Array.from(order, (i) => packets[i].time),
  };
}

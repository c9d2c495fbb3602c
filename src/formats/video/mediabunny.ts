// What this package uses of mediabunny, which finds the packets of a WebM or MP4 file.
export { BufferSource, EncodedPacketSink, Input, Logging, LogLevel, MP4, WEBM } from 'mediabunny';

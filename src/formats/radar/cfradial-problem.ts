import { VolumeViewError } from '../../core/errors.ts';

/** The error of a CfRadial file whose numbers can not be right. @param what - follows "the CfRadial file" */
export function corrupt(what: string): VolumeViewError {
  return new VolumeViewError(
    'format/corrupt',
    `the CfRadial file ${what}; check the program that wrote it, or fetch it again`,
  );
}

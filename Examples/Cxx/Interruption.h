/**
 * Ctrl-C and its like as a flag that long computations look at, so that the program can end by
 * itself and leave no half-written file.
 */
#ifndef Interruption_h
#define Interruption_h

/**
 * From now on SIGINT, SIGTERM and SIGHUP only set the flag (unless they were ignored), and too
 * large a file is a failed write instead of the end of the program.
 */
void CatchInterruptions();

bool Interrupted();

/** Throws Failure if Interrupted(). */
void StopIfInterrupted();

#endif

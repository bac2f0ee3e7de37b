/**
 * Ctrl-C and its like as a flag that long computations look at, so that the program can end by
 * itself and leave no half-written file.
 */
#ifndef Interruption_h
#define Interruption_h

/**
 * From now on SIGINT, SIGTERM and SIGHUP only set the flag (unless they were ignored); too large a
 * file and a closed pipe are failed writes instead of the end of the program.
 */
void CatchInterruptions();

bool Interrupted();

/** Throws Failure if Interrupted(). */
void StopIfInterrupted();

/**
 * Ends the program by the signal that interrupted it, if one has: from an exit status alone a shell
 * would not know that its loop is to end, too. For the end of main(), when all is cleaned up.
 */
void DieIfInterrupted();

#endif

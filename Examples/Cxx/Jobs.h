/**
 * What the command line asks for, one input after the other: which file goes where.
 */
#ifndef Jobs_h
#define Jobs_h

#include "CommandLine.h"

#include <vector>

/**
 * The options of each run, with one Input and one Output and all names filled in. Throws Failure
 * with EXIT_USAGE where files are missing, too many or have names that cannot be written.
 *
 *     INPUT OUTPUT                    as they are
 *     INPUT... FOLDER                 FOLDER/stem.extension; a folder is there or ends in a slash
 *     INPUT... --output-pattern P     P with {stem} and parameters filled in
 *     MESH... --compare REFERENCE     no output
 */
std::vector<Options> ListJobs(const Options& options);

#endif

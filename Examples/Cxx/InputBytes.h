/**
 * The bytes of an input: a file or standard input, compressed by gzip or not.
 */
#ifndef InputBytes_h
#define InputBytes_h

#include <string>

/**
 * All bytes of the file, or of standard input for "-", uncompressed. A missing, unreadable or empty
 * file, a folder and a damaged archive have their own sentences. Throws Failure.
 */
std::string ReadBytes(const std::string& path);

/** Compresses a file in its place. Throws Failure. */
void CompressFile(const std::string& path);

/** The name without a ".gz" at its end. */
std::string WithoutGz(const std::string& path);

/** The extension with its dot and without ".gz", ".ply" for "Part.PLY.gz". */
std::string LowerCaseExtension(const std::string& path);

/** The name without its extension and ".gz", "Part" for "Part.PLY.gz". */
std::string WithoutExtension(const std::string& path);

#endif

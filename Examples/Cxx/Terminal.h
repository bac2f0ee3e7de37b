/**
 * What the program says to a person: errors and warnings on standard error, results on standard
 * output. Colours only on a terminal that has some, and not if the environment has NO_COLOR.
 */
#ifndef Terminal_h
#define Terminal_h

#include <string>

enum class Color
{
  Bold,
  Red,
  Yellow,
  Green
};

/** The text in that colour if the file (STDOUT_FILENO or STDERR_FILENO) is to have colours. */
std::string Colored(const std::string& text, Color color, int file);

void PrintError(const std::string& sentence);
void PrintWarning(const std::string& sentence);

#endif

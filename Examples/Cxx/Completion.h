/**
 * What the shells need to complete the command line, made from the table of options.
 */
#ifndef Completion_h
#define Completion_h

#include <string>

/** The script for "bash", "zsh" or "fish". */
std::string CompletionText(const std::string& shell);

#endif

#include "Terminal.h"

#include <cstdlib>
#include <cstring>
#include <iostream>
#include <unistd.h>

namespace
{
bool HasColors(int file)
{
  const char* no = std::getenv("NO_COLOR");
  const char* kind = std::getenv("TERM");
  return isatty(file) != 0 && (no == nullptr || *no == '\0') && kind != nullptr &&
    std::strcmp(kind, "dumb") != 0;
}
} // namespace

std::string Colored(const std::string& text, Color color, int file)
{
  const char* code = color == Color::Red ? "1;31"
    : color == Color::Yellow             ? "1;33"
    : color == Color::Green              ? "32"
                                         : "1";
  return HasColors(file) ? std::string("\033[") + code + "m" + text + "\033[0m" : text;
}

void PrintError(const std::string& sentence)
{
  std::cerr << Colored("remesh_surface:", Color::Red, STDERR_FILENO) << ' ' << sentence << '\n';
}

void PrintWarning(const std::string& sentence)
{
  std::cerr << "remesh_surface: " << Colored("warning:", Color::Yellow, STDERR_FILENO) << ' '
            << sentence << '\n';
}

/**
 * A text file in memory, line by line and word by word.
 */
#ifndef TextLines_h
#define TextLines_h

#include <string>
#include <string_view>

class TextLines
{
public:
  enum Style
  {
    PLAIN,   // every line as it is
    COMMENTS // '#' at the start of a word begins a comment, a backslash at the end joins lines
  };

  /** Keeps no copy: `text` has to outlive it. */
  explicit TextLines(std::string_view text, Style style = PLAIN);

  /** Goes on to the next line; false at the end of the text. */
  bool Next();

  /** The next word of the line; empty at its end. */
  std::string_view Word();

  /** Reads the next word as a number; false where it is none, and at the end of the line. */
  bool Number(double& value);

  /** Of the line, from 1. Of lines that are joined: of the last. */
  long GetLineNumber() const { return this->LineNumber; }

  /** "line 7", for sentences about what is wrong. */
  std::string Where() const { return "line " + std::to_string(this->LineNumber); }

  /** Where the next line starts in the text. */
  std::size_t GetPosition() const { return this->Position; }

private:
  std::string_view Text;
  Style LineStyle;
  std::size_t Position = 0;
  long LineNumber = 0;
  std::string Joined;
  std::string_view Rest; // of the line
};

/** The whole word as a number, "nan" and "inf" among them; false where it is none. */
bool ParseNumber(std::string_view word, double& value);

/** The whole word as an integer; false where it is none or too large. */
bool ParseInteger(std::string_view word, long long& value);

std::string LowerCase(std::string_view word);

#endif

#include "TextLines.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>

namespace
{
constexpr const char* blanks = " \t\r\v\f";

std::string_view WithoutComment(std::string_view line)
{
  for (std::size_t i = line.find('#'); i != std::string_view::npos; i = line.find('#', i + 1))
  {
    if (i == 0 || std::string_view(" \t\\").find(line[i - 1]) != std::string_view::npos)
    {
      return line.substr(0, i);
    }
  }
  return line;
}

/** Without a sign that std::from_chars does not know. */
std::string_view WithoutPlus(std::string_view word)
{
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return word.substr(plus ? 1 : 0);
}
} // namespace

TextLines::TextLines(std::string_view text, Style style)
  : Text(text)
  , LineStyle(style)
{
}

bool TextLines::Next()
{
  this->Joined.clear();
  bool goesOn = true;
  for (bool first = true; goesOn; first = false)
  {
    if (this->Position >= this->Text.size())
    {
      return !first;
    }
    const std::size_t end = std::min(this->Text.find('\n', this->Position), this->Text.size());
    std::string_view line = this->Text.substr(this->Position, end - this->Position);
    this->Position = end + 1;
    ++this->LineNumber;
    line = this->LineStyle == COMMENTS ? WithoutComment(line) : line;
    line = line.substr(0, line.find_last_not_of(blanks) + 1);
    goesOn = this->LineStyle == COMMENTS && !line.empty() && line.back() == '\\';
    line.remove_suffix(goesOn ? 1 : 0);
    if (goesOn || !first)
    {
      this->Joined += line;
      this->Joined += ' ';
      line = this->Joined;
    }
    this->Rest = line;
  }
  return true;
}

std::string_view TextLines::Word()
{
  const std::size_t start = std::min(this->Rest.find_first_not_of(blanks), this->Rest.size());
  this->Rest.remove_prefix(start);
  const std::size_t size = std::min(this->Rest.find_first_of(blanks), this->Rest.size());
  const std::string_view word = this->Rest.substr(0, size);
  this->Rest.remove_prefix(size);
  return word;
}

bool TextLines::Number(double& value)
{
  return ParseNumber(this->Word(), value);
}

bool ParseNumber(std::string_view word, double& value)
{
  word = WithoutPlus(word);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range)
  {
    value = std::strtod(std::string(word).c_str(), nullptr); // 0 or infinite
  }
  return error != std::errc::invalid_argument && end == word.data() + word.size();
}

bool ParseInteger(std::string_view word, long long& value)
{
  word = WithoutPlus(word);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

std::string LowerCase(std::string_view word)
{
  std::string text(word);
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

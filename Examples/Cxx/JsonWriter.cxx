#include "JsonWriter.h"

#include <cmath>
#include <cstdio>

namespace
{
/** Length of the UTF-8 sequence that starts at `i`, 0 if there is no valid one [RFC 3629]. */
std::size_t SequenceLength(const std::string& text, std::size_t i)
{
  const auto byte = [&](std::size_t k)
  { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
  const unsigned first = byte(i);
  const unsigned second = byte(i + 1);
  const std::size_t length = first < 0x80 ? 1
    : first >= 0xC2 && first < 0xE0       ? 2
    : first >= 0xE0 && first < 0xF0       ? 3
    : first >= 0xF0 && first < 0xF5       ? 4
                                          : 0;
  for (std::size_t k = 1; k < length; ++k)
  {
    if ((byte(i + k) & 0xC0) != 0x80)
    {
      return 0;
    }
  }
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0;
  const bool tooLarge = first == 0xF4 && second >= 0x90;
  return overlong || surrogate || tooLarge ? 0 : length;
}

std::string Quoted(const std::string& text)
{
  std::string quoted = "\"";
  for (std::size_t i = 0; i < text.size();)
  {
    const std::size_t length = SequenceLength(text, i);
    const auto byte = static_cast<unsigned char>(text[i]);
    if (length == 0)
    {
      quoted += "\\ufffd";
    }
    else if (byte < 0x20)
    {
      char escape[8];
      std::snprintf(escape, sizeof(escape), "\\u%04x", static_cast<unsigned>(byte));
      quoted += escape;
    }
    else
    {
      quoted += byte == '"' || byte == '\\' ? "\\" : "";
      quoted += text.substr(i, length);
    }
    i += length == 0 ? 1 : length;
  }
  return quoted + '"';
}
} // namespace

void JsonWriter::Prefix(const std::string& key)
{
  if (!this->Text.empty())
  {
    const char last = this->Text.back();
    this->Text += last == '{' || last == '[' ? "\n" : ",\n";
    this->Text.append(2 * this->Depth, ' ');
  }
  if (!key.empty())
  {
    this->Text += Quoted(key) + ": ";
  }
}

void JsonWriter::Open(const std::string& key, char bracket)
{
  this->Prefix(key);
  this->Text += bracket;
  ++this->Depth;
}

void JsonWriter::Close(char bracket)
{
  --this->Depth;
  const char last = this->Text.back();
  if (last != '{' && last != '[')
  {
    this->Text += '\n' + std::string(2 * this->Depth, ' ');
  }
  this->Text += bracket;
  this->Text += this->Depth == 0 ? "\n" : "";
}

void JsonWriter::Add(const std::string& key, const std::string& value)
{
  this->Prefix(key);
  this->Text += Quoted(value);
}

void JsonWriter::Add(const std::string& key, double value)
{
  char digits[32];
  std::snprintf(digits, sizeof(digits), "%.17g", value);
  this->Prefix(key);
  this->Text += std::isfinite(value) ? digits : "null";
}

void JsonWriter::Add(const std::string& key, bool value)
{
  this->Prefix(key);
  this->Text += value ? "true" : "false";
}

void JsonWriter::Add(const std::string& key, long long value)
{
  this->Prefix(key);
  this->Text += std::to_string(value);
}

/**
 * Writes JSON (RFC 8259) piece by piece, indented by two spaces. VTK brings a JSON library only
 * as an implementation detail that distributions do not install.
 *
 * Doubles have 17 significant digits and so survive a round trip; those that are not finite
 * become null. Bytes that are not UTF-8 become U+FFFD.
 */
#ifndef JsonWriter_h
#define JsonWriter_h

#include <string>

class JsonWriter
{
public:
  ///@{
  /** Open and close; the key is left out in arrays and for the outermost value. */
  void BeginObject(const std::string& key = "") { this->Open(key, '{'); }
  void EndObject() { this->Close('}'); }
  void BeginArray(const std::string& key = "") { this->Open(key, '['); }
  void EndArray() { this->Close(']'); }
  ///@}

  ///@{
  /** One value; the key is "" in arrays. */
  void Add(const std::string& key, const std::string& value);
  void Add(const std::string& key, const char* value) { this->Add(key, std::string(value)); }
  void Add(const std::string& key, double value);
  void Add(const std::string& key, long long value);
  void Add(const std::string& key, bool value);
  void Add(const std::string& key, int value) { this->Add(key, static_cast<long long>(value)); }
  ///@}

  const std::string& GetText() const { return this->Text; }

private:
  void Prefix(const std::string& key);
  void Open(const std::string& key, char bracket);
  void Close(char bracket);

  std::string Text;
  int Depth = 0;
};

#endif

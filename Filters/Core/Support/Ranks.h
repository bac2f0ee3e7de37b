/**
 * @file Ranks.h
 * @brief The processes that share a run, and what they tell each other. The one seam to MPI.
 *
 * The first rank has the whole run. The others work for it (RankOrders.h) and know nothing but what
 * it sends. All run the same program on machines of one kind: values are sent as they lie in
 * memory.
 */
#ifndef remesh_Ranks_h
#define remesh_Ranks_h

#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace remesh
{
/** Values one after the other; they are taken in the order in which they were added. */
class Packet
{
public:
  Packet() = default;
  explicit Packet(std::vector<char> bytes)
    : m_bytes(std::move(bytes))
  {
  }

  /** A packet with one value. */
  template <class T>
  static Packet of(const T& value)
  {
    static_assert(std::is_trivially_copyable<T>::value, "what has pointers cannot be sent");
    const auto* bytes = reinterpret_cast<const char*>(&value);
    return Packet(std::vector<char>(bytes, bytes + sizeof(T)));
  }

  template <class T>
  void add(const T& value)
  {
    this->addBytes(&value, 1);
  }
  template <class T>
  void add(const std::vector<T>& values)
  {
    this->add(values.size());
    this->addBytes(values.data(), values.size());
  }
  void add(const std::string& text) { this->add(std::vector<char>(text.begin(), text.end())); }

  template <class T>
  void take(T& value)
  {
    this->takeBytes(&value, 1);
  }
  template <class T>
  void take(std::vector<T>& values)
  {
    std::size_t count = 0;
    this->take(count);
    values.resize(count);
    this->takeBytes(values.data(), count);
  }
  void take(std::string& text)
  {
    std::vector<char> letters;
    this->take(letters);
    text.assign(letters.begin(), letters.end());
  }

  /** Takes all out; its memory stays. */
  void clear()
  {
    m_bytes.clear();
    m_next = 0;
  }

  const std::vector<char>& bytes() const { return m_bytes; }

private:
  template <class T>
  void addBytes(const T* values, std::size_t count)
  {
    static_assert(std::is_trivially_copyable<T>::value, "what has pointers cannot be sent");
    const auto* bytes = reinterpret_cast<const char*>(values);
    m_bytes.insert(m_bytes.end(), bytes, bytes + count * sizeof(T));
  }

  template <class T>
  void takeBytes(T* values, std::size_t count)
  {
    static_assert(std::is_trivially_copyable<T>::value, "what has pointers cannot be sent");
    if (count > (m_bytes.size() - m_next) / sizeof(T))
    {
      throw std::runtime_error("A message of another process ends too early.");
    }
    if (count > 0)
    {
      std::memcpy(values, m_bytes.data() + m_next, count * sizeof(T));
      m_next += count * sizeof(T);
    }
  }

  std::vector<char> m_bytes;
  std::size_t m_next = 0;
};

class Ranks
{
public:
  static constexpr int first = 0;

  virtual ~Ranks() = default;

  virtual int count() const = 0;
  virtual int own() const = 0;

  /** What is sent to a rank comes in the order in which it was sent. Throws runtime_error. */
  virtual void send(int rank, const Packet& packet) = 0;
  /** Waits for it. Throws runtime_error; bad_alloc where there is no room for it, which is lost. */
  virtual Packet receive(int rank) = 0;
};
}

#endif

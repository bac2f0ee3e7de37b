/**
 * @file Improve.h
 * @brief The one way in which a candidate is made better: propose, judge, keep or undo.
 *
 * A candidate is anything with
 *
 *     Status judge(const RunControl&);   // brings up to date what follows from its edits
 *     Verdict verdict() const;           // what is wrong with it, as judged last; `<` is better
 *     State state() const;               // all that edits change
 *     void restore(const State&);        // to be judged again
 *
 * A table has a row for each proposal. In each round the first row that answers what is wrong edits
 * the candidate, which is judged then. Better than the best so far, it is kept. Else the rounds go
 * on from there: some edits spoil what later ones, of this or of other rows, mend. Where a row has
 * edited in vain for longer than its patience, or none answers any more, the candidate goes back to
 * the best state, and the row that left it is not asked again, unless it has another idea.
 */
#ifndef remesh_Improve_h
#define remesh_Improve_h

#include "Support/RunControl.h"
#include "Support/Status.h"

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace remesh
{
template <class Candidate>
class Proposal
{
public:
  virtual ~Proposal() = default;

  /** Whether it has something against what is wrong with the candidate. */
  virtual bool answers(const Candidate& candidate) const = 0;

  /**
   * Edits the candidate.
   *
   * @param edit 0 for the first edit of its row, 1 for the second, and so on.
   * @param done whether it did; if not, the candidate is as it was.
   */
  virtual Status edit(Candidate& candidate, int edit, const RunControl& control, bool& done) = 0;

  /** Whether its edit, though the candidate may be no better, came nearer to what mends it. */
  virtual bool nears(const Candidate& /*candidate*/) { return false; }

  /** Whether others may mend what it has spoilt. */
  virtual bool hopes(const Candidate& /*candidate*/) const { return true; }

  /**
   * Looks at what its edits led to before they are undone.
   *
   * @return whether it has another idea.
   */
  virtual bool learn(const Candidate& /*candidate*/) { return false; }
};

template <class Candidate>
struct Row
{
  const char* name;
  std::unique_ptr<Proposal<Candidate>> proposal;
  int maxEdits; ///< in all
  int patience; ///< edits in vain, since the best state, after which it has another
};

template <class Candidate>
class Improvement
{
public:
  using Table = std::vector<Row<Candidate>>;

  /** @param candidate that has been judged. Both must outlive it. */
  Improvement(Table& table, Candidate& candidate)
    : m_table(table)
    , m_candidate(candidate)
    , m_uses(table.size())
    , m_best(candidate.verdict())
  {
  }

  /** Until no row answers. The candidate is in its best state then, unless it fails. */
  Status run(const RunControl& control)
  {
    for (RunControl rest = control; !rest.cancelled(); rest = rest.step(1, 2))
    {
      Status status = Status::success();
      const std::size_t row = this->nextRow();
      const bool isOver = row == m_table.size() || m_uses[row].vain > m_table[row].patience ||
        (m_author != none && !m_table[m_author].proposal->hopes(m_candidate));
      if (!isOver)
      {
        status = this->edit(row, rest);
      }
      else if (m_author == none)
      {
        return status;
      }
      else
      {
        status = this->goBack(rest.step(0, 2));
      }
      if (!status.ok())
      {
        return status;
      }
    }
    return Status::cancelled();
  }

private:
  static constexpr std::size_t none = ~std::size_t(0);

  struct Use
  {
    int edits = 0;
    int vain = 0;          ///< edits since the best state
    bool declines = false; ///< the candidate as it is
    bool isSpent = false;
  };

  /** The first that answers. */
  std::size_t nextRow() const
  {
    std::size_t row = 0;
    for (; row < m_table.size(); ++row)
    {
      const Use& use = m_uses[row];
      if (!use.isSpent && !use.declines && use.edits < m_table[row].maxEdits &&
        m_table[row].proposal->answers(m_candidate))
      {
        break;
      }
    }
    return row;
  }

  Status edit(std::size_t row, const RunControl& control)
  {
    Use& use = m_uses[row];
    if (m_author == none)
    {
      m_bestState = m_candidate.state();
    }
    bool done = false;
    Status status = m_table[row].proposal->edit(m_candidate, use.edits, control.silent(), done);
    if (!status.ok() || !done)
    {
      use.declines = true;
      return status;
    }
    for (Use& other : m_uses)
    {
      other.declines = false;
    }
    m_author = m_author == none ? row : m_author;
    ++use.edits;
    status = m_candidate.judge(control.step(0, 2));
    use.vain += status.ok() && m_table[row].proposal->nears(m_candidate) ? 0 : 1;
    if (status.ok() && m_candidate.verdict() < m_best)
    {
      m_best = m_candidate.verdict();
      this->begin();
    }
    return status;
  }

  Status goBack(const RunControl& control)
  {
    m_uses[m_author].isSpent = !m_table[m_author].proposal->learn(m_candidate);
    m_candidate.restore(m_bestState);
    this->begin();
    return m_candidate.judge(control);
  }

  /** At the best state. */
  void begin()
  {
    m_author = none;
    for (Use& use : m_uses)
    {
      use.vain = 0;
      use.declines = false;
    }
  }

  Table& m_table;
  Candidate& m_candidate;
  std::vector<Use> m_uses;
  std::decay_t<decltype(std::declval<Candidate>().verdict())> m_best;
  decltype(std::declval<Candidate>().state()) m_bestState;
  std::size_t m_author = none; ///< the row that left the best state
};
}

#endif

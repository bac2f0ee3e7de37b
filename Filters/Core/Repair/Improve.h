/**
 * @file Improve.h
 * @brief The one way in which a candidate is made better: propose, judge, keep or undo.
 *
 * A candidate is anything with
 *
 *     Status judge(const RunControl&);   // finds out what is wrong with it after edits
 *     Verdict verdict() const;           // what the last call of judge found; `<` is better
 *     State state() const;               // a copy of all that edits change
 *     void restore(const State&);        // back to that copy; must be judged again
 *
 * A table has one row for each proposal. One round:
 *
 * 1. The first row is taken whose proposal answers: it has something against what is wrong.
 * 2. It edits the candidate, and the candidate is judged. A row that finds nothing to do is passed
 *    over until the candidate has changed.
 * 3. If the candidate is better than the best state so far, it is the best state now.
 * 4. Else the rounds go on from there. Some edits spoil what later ones mend, of this row or of
 *    another.
 * 5. If the row has edited in vain for longer than its patience, or if no row answers, the
 *    candidate goes back to the best state. The row that made the first edit after the best state
 *    is not asked again, unless it has learned something from that.
 *
 * It ends when the candidate is in its best state and no row answers.
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
/** One way to change a candidate. */
template <class Candidate>
class Proposal
{
public:
  virtual ~Proposal() = default;

  /** Whether it may mend something that is wrong with the candidate. */
  virtual bool answers(const Candidate& candidate) const = 0;

  /**
   * Edits the candidate.
   *
   * @param edit 0 for the first edit of its row, 1 for the second, and so on.
   * @param done gets whether it did; if not, the candidate must be as it was.
   */
  virtual Status edit(Candidate& candidate, int edit, const RunControl& control, bool& done) = 0;

  /**
   * Asked after each of its edits. True if it came nearer to its aim, though the candidate may be
   * no better yet: then the edit does not count as one in vain.
   */
  virtual bool nears(const Candidate& /*candidate*/) { return false; }

  /** Whether later edits may mend what it has spoilt. False: back to the best state at once. */
  virtual bool hopes(const Candidate& /*candidate*/) const { return true; }

  /**
   * Called before its edits are undone, to learn from what they led to.
   *
   * @return whether it would do something else next time; if not, it is not asked again.
   */
  virtual bool learn(const Candidate& /*candidate*/) { return false; }
};

/** A line of the table of proposals. */
template <class Candidate>
struct Row
{
  const char* name; ///< as Documentation/Tuning.md has it
  std::unique_ptr<Proposal<Candidate>> proposal;
  int maxEdits; ///< of this row, in all
  int patience; ///< edits in vain since the best state; one more, and they are undone
};

/** Makes a candidate better by the rows of a table. */
template <class Candidate>
class Improvement
{
public:
  using Table = std::vector<Row<Candidate>>;

  /** @param candidate must have been judged. Both must outlive the improvement. */
  Improvement(Table& table, Candidate& candidate)
    : m_table(table)
    , m_candidate(candidate)
    , m_uses(table.size())
    , m_best(candidate.verdict())
  {
  }

  /**
   * Goes on until no row answers. Leaves the candidate in its best state.
   *
   * @return what an edit or a judgement returns that fails, or Cancelled; then the candidate is of
   *         no use.
   */
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
    int vain = 0;          ///< edits since the best state that did not come nearer
    bool declines = false; ///< found nothing to do with the candidate as it is
    bool isSpent = false;  ///< its edits were undone, and it has not learned
  };

  /** The first row that answers, or the number of rows. */
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

  /** Begins anew, as the candidate is in its best state. */
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
  std::size_t m_author = none; ///< the row of the first edit after the best state; none: no edit
};
}

#endif

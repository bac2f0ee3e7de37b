// Repair/Improve: what is kept, what is undone, and which row is asked next, on a toy candidate.

#include "Repair/Improve.h"
#include "TestChecks.h"

#include <functional>
#include <string>

using namespace remesh;

namespace
{
/** A number, the lower the better; judging counts. */
struct Toy
{
  int value = 0;
  int judged = 0;
  int failsAt = -1; ///< the judgement that fails

  Status judge(const RunControl& control)
  {
    ++this->judged;
    return control.cancelled()        ? Status::cancelled()
      : this->judged == this->failsAt ? Status::invalid("no")
                                      : Status::success();
  }
  int verdict() const { return this->value; }
  int state() const { return this->value; }
  void restore(int state) { this->value = state; }
};

/** Adds a number where the value is at least another one. */
struct Step : Proposal<Toy>
{
  Step(int least, int step, std::string& log, char name, int ideas = 0)
    : m_least(least)
    , m_step(step)
    , m_log(log)
    , m_name(name)
    , m_ideas(ideas)
  {
  }

  bool answers(const Toy& toy) const override { return toy.value >= m_least; }
  Status edit(Toy& toy, int /*edit*/, const RunControl&, bool& done) override
  {
    done = m_step != 0;
    toy.value += m_step;
    m_log += m_name;
    return Status::success();
  }
  bool learn(const Toy&) override
  {
    m_log += '!';
    m_step = --m_ideas == 0 ? -1 : m_step;
    return m_ideas >= 0;
  }

private:
  int m_least;
  int m_step;
  std::string& m_log;
  char m_name;
  int m_ideas;
};

struct Case
{
  Toy toy;
  std::string log;
  Improvement<Toy>::Table table;

  void add(int least, int step, char name, int edits, int patience, int ideas = 0)
  {
    this->table.push_back(
      { "step", std::make_unique<Step>(least, step, this->log, name, ideas), edits, patience });
  }

  Status run(const RunControl& control = RunControl())
  {
    return Improvement<Toy>(this->table, this->toy).run(control);
  }
};

/** The first row that answers edits, as often as it may. */
void testKeeps()
{
  Case some;
  some.toy.value = 10;
  some.add(8, -1, 'a', 10, 0);
  some.add(1, -2, 'b', 2, 0);
  CHECK(some.run().ok());
  CHECK_EQUAL(some.log, std::string("aaabb"));
  CHECK_EQUAL(some.toy.value, 3);
  CHECK_EQUAL(some.toy.judged, 5);
}

/** What is no better is undone, and not tried again. */
void testUndoes()
{
  Case some;
  some.toy.value = 5;
  some.add(1, 2, 'a', 10, 0);
  some.add(1, -1, 'b', 2, 0);
  CHECK(some.run().ok());
  CHECK_EQUAL(some.log, std::string("a!bb"));
  CHECK_EQUAL(some.toy.value, 3);
}

/** A step that spoils is kept with another row's step that more than mends it. */
void testTogether()
{
  Case some;
  some.toy.value = 5;
  some.add(7, -6, 'm', 10, 0); // answers only what the other has spoilt
  some.add(5, 2, 's', 10, 1);
  CHECK(some.run().ok());
  CHECK_EQUAL(some.log, std::string("sm"));
  CHECK_EQUAL(some.toy.value, 1);
}

/** As many vain edits as there is patience for, and one more; then back to the best. */
void testPatience()
{
  Case some;
  some.toy.value = 5;
  some.add(1, 1, 'a', 10, 3);
  CHECK(some.run().ok());
  CHECK_EQUAL(some.log, std::string("aaaa!"));
  CHECK_EQUAL(some.toy.value, 5);
}

/** A row with another idea is asked again. */
void testLearns()
{
  Case some;
  some.toy.value = 5;
  some.add(4, 1, 'a', 10, 0, 2);
  CHECK(some.run().ok());
  CHECK_EQUAL(some.log, std::string("a!a!aa")); // the second idea helps twice
  CHECK_EQUAL(some.toy.value, 3);
}

/** A row that declines does not keep others from acting. */
void testDeclines()
{
  Case some;
  some.toy.value = 5;
  some.add(1, 0, 'a', 10, 0);
  some.add(5, -1, 'b', 10, 0);
  CHECK(some.run().ok());
  CHECK_EQUAL(some.log, std::string("aba"));
}

void testStops()
{
  Case none;
  CHECK(none.run().ok());
  CHECK_EQUAL(none.toy.judged, 0);

  Case failing;
  failing.toy = { 9, 0, 2 };
  failing.add(1, -1, 'a', 10, 0);
  CHECK(failing.run().code == StatusCode::InvalidInput);
  CHECK_EQUAL(failing.toy.judged, 2);

  Case cancelled;
  cancelled.toy.value = 5;
  cancelled.add(1, -1, 'a', 10, 0);
  const RunControl control(nullptr, [&]() { return cancelled.toy.value < 4; });
  CHECK(cancelled.run(control).code == StatusCode::Cancelled);
}

/** Progress never falls, and never passes its end. */
void testProgress()
{
  double last = 0.0;
  bool rises = true;
  RunControl control(
    [&](double fraction, const char*)
    {
      rises = rises && fraction >= last && fraction <= 1.0;
      last = fraction;
    },
    nullptr);
  Case some;
  some.toy.value = 50;
  some.add(1, -1, 'a', 40, 0);
  CHECK(some.run(control).ok());
  CHECK(rises);
}
}

int TestImprove(int, char*[])
{
  testKeeps();
  testUndoes();
  testTogether();
  testPatience();
  testLearns();
  testDeclines();
  testStops();
  testProgress();
  return test::result();
}

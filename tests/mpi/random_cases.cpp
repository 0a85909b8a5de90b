// SPDX-License-Identifier: BSD-3-Clause
#include "../verification/random_scenarios.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/io/history_csv.hpp"
#include "brinell/mpi/mpi_communicator.hpp"
#include "brinell/simulation/run.hpp"
#include "brinell/simulation/scenarios.hpp"
#include "sweep.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

/// Random cases that all ranks of mpirun compute together, and one of them alone, with the same digits. A program that mpirun starts:
/// so many short runs take the time of starting once.
namespace brinell::mpi_test
{
namespace
{

using verification::Draw;

std::shared_ptr<const Communicator>& all_ranks()
{
  static std::shared_ptr<const Communicator> ranks = std::make_shared<const app::MpiCommunicator>(MPI_COMM_WORLD);
  return ranks;
}

/// Numbers of a run, one field after the other.
struct Numbers
{
  std::vector<double> all;
  std::vector<std::pair<std::string, std::size_t>>
      ends; ///< names of the fields, and how many numbers are before their end

  void append(const std::string& name, const std::vector<double>& field)
  {
    all.insert(all.end(), field.begin(), field.end());
    ends.emplace_back(name, all.size());
  }
  void append(const std::string& name, const simulation::BodySnapshot& body)
  {
    for (const std::vector<double>& component : body.stress)
      append(name + " stress", component);
    for (const std::vector<double>& component : body.plastic_strain)
      append(name + " plastic strain", component);
    append(name + " equivalent plastic strain", body.equivalent_plastic_strain);
    append(name + " residual displacement", body.residual_displacement);
    append(name + " height", body.height);
    append(name + " temperature", body.temperature);
  }
  [[nodiscard]] std::string field_of(std::size_t number) const
  {
    for (const auto& [name, end] : ends)
      if (number < end)
        return name;
    return "none";
  }
};

/// All numbers of a run: its history, its fields at the end, and what would be stored to continue it. For a case that is refused on
/// the way, as one whose surfaces do not carry its force, those up to there and one that says so.
template <typename Scenario>
Numbers numbers(const Scenario& scenario, std::shared_ptr<const Communicator> ranks)
{
  Numbers found;
  std::vector<double> history;
  simulation::Observer<typename Scenario::Record> observer;
  observer.ranks = std::move(ranks);
  observer.on_step = [&](const auto& record, int)
  {
    for (const io::NamedNumber& column : io::columns(record))
      history.push_back(std::visit([](auto value) { return static_cast<double>(value); }, column.value));
  };
  try
  {
    simulation::Run<Scenario> run(scenario, observer);
    simulation::finish(run, observer);
    found.append("history", history);
    const simulation::Snapshot end = run.snapshot();
    found.append("pressure", end.pressure);
    found.append("gap", end.gap);
    found.append("lower", end.lower);
    found.append("upper", end.upper);
    for (const auto& [name, field] : run.checkpoint())
      found.append("checkpoint " + name, field);
  }
  catch (const InputError&)
  {
    history.push_back(-1.0);
    found.append("history until it is refused", history);
  }
  return found;
}

/// For all ranks those numbers that one has.
void share(std::vector<double>& values, int from)
{
  auto size = static_cast<double>(values.size());
  all_ranks()->broadcast({&size, 1}, from);
  values.resize(static_cast<std::size_t>(size));
  all_ranks()->broadcast(values, from);
}

struct Comparison
{
  const test::Sweep& cases;
  int next = 0, compared = 0; ///< number of the next case; number of those computed
  double count = 0.0;         ///< of numbers compared

  template <typename Scenario>
  void one(Scenario (*make)(Draw&), const char* name)
  {
    const int number = next++;
    if (!cases.has(number))
      return;
    SCOPED_TRACE(std::string(name) + ", case " + std::to_string(number));
    Draw draw(static_cast<unsigned>(number));
    Scenario scenario = make(draw);
    if (Draw of_current(static_cast<unsigned>(1000 + number)); number % 4 == 1)
      verification::add_current(of_current, scenario, scenario.lower.material, scenario.upper.material);
    // The cases that a rank computes alone are dealt out, so that no rank waits for long.
    const int lonely = compared++ % all_ranks()->size();
    std::vector<double> alone;
    if (all_ranks()->rank() == lonely)
      alone = numbers(scenario, nullptr).all;
    share(alone, lonely);
    const Numbers shared = numbers(scenario, all_ranks());
    if (all_ranks()->rank() > 0) // has not the fields of all
      return;
    count += static_cast<double>(alone.size());
    ASSERT_GT(alone.size(), 0U);
    ASSERT_EQ(shared.all.size(), alone.size());
    for (std::size_t i = 0; i < alone.size(); ++i)
      ASSERT_EQ(std::memcmp(&shared.all[i], &alone[i], sizeof(double)), 0)
          << shared.field_of(i) << ": number " << i << " of " << alone.size() << " is " << shared.all[i]
          << " instead of " << alone[i];
  }
};

TEST(RandomCases, HaveTheDigitsOfOneProcess)
{
  constexpr int count = 100;
  const test::Sweep cases(count);
  Comparison comparison{cases};
  while (comparison.next < count)
  {
    comparison.one(verification::random_tugging, "tugging");
    comparison.one(verification::random_indentation, "indentation");
    comparison.one(verification::random_rolling, "rolling");
    comparison.one(verification::random_rubbing, "tugging with friction");
    comparison.one(verification::random_skidding, "rolling with slip");
    comparison.one(verification::random_creeping, "rolling with creepage");
    comparison.one(verification::random_hot_rubbing, "tugging with heat");
    comparison.one(verification::random_hot_skidding, "rolling with slip and heat");
    comparison.one(verification::random_hot_creeping, "rolling with creepage and heat");
    comparison.one(verification::random_fretting, "fretting");
    comparison.one(verification::random_hot_fretting, "fretting with heat");
    comparison.one(verification::random_worn_rubbing, "tugging with wear");
    comparison.one(verification::random_worn_skidding, "rolling with slip and wear");
    comparison.one(verification::random_worn_creeping, "rolling with creepage and wear");
    comparison.one(verification::random_worn_fretting, "fretting with wear");
  }
  std::printf("%d cases, %.0f numbers on %d ranks\n", comparison.compared, comparison.count, all_ranks()->size());
}

} // namespace

int run_tests()
{
  if (all_ranks()->size() == 1)
  {
    std::printf("one process has nothing to share: to be started by mpirun\n");
    return 1;
  }
  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  if (all_ranks()->rank() > 0)
    delete listeners.Release(listeners.default_result_printer());
  const int status = RUN_ALL_TESTS();
  all_ranks().reset();
  return status;
}

} // namespace brinell::mpi_test

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  testing::InitGoogleTest(&argc, argv);
  testing::FLAGS_gtest_catch_exceptions = false; // ends all ranks, which would wait for ever
  const int status = brinell::mpi_test::run_tests();
  MPI_Finalize();
  return status;
}

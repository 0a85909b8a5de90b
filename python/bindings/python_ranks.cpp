// SPDX-License-Identifier: BSD-3-Clause
#include "python_ranks.hpp"

#include <utility>

namespace nb = nanobind;

namespace brinell::python
{

namespace
{

/// Numbers as a buffer of Python, without a copy; only for as long as the call that gets it.
nb::object buffer(const double* values, std::size_t size, int access)
{
  static double none = 0.0; // mpi4py wants an address, also of nothing
  void* const place = size > 0 ? const_cast<double*>(values) : &none;
  return nb::steal(
      PyMemoryView_FromMemory(static_cast<char*>(place), static_cast<Py_ssize_t>(size * sizeof(double)), access));
}

nb::object sent(std::span<const double> values)
{
  return buffer(values.data(), values.size(), PyBUF_READ);
}

nb::object received(std::span<double> values)
{
  return buffer(values.data(), values.size(), PyBUF_WRITE);
}

/// Numbers of values by rank, and where they begin.
std::pair<nb::list, nb::list> parts(std::span<const std::size_t> counts)
{
  std::pair<nb::list, nb::list> result;
  std::size_t first = 0;
  for (const std::size_t count : counts)
  {
    result.first.append(count);
    result.second.append(first);
    first += count;
  }
  return result;
}

class PythonRanks : public Communicator
{
public:
  explicit PythonRanks(nb::object comm)
      : comm_(std::move(comm)), double_(nb::module_::import_("mpi4py.MPI").attr("DOUBLE")),
        rank_(nb::cast<int>(comm_.attr("Get_rank")())), size_(nb::cast<int>(comm_.attr("Get_size")()))
  {
  }
  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }

  void all_to_all(std::span<const double> send, std::span<const std::size_t> sent_counts, std::span<double> receive,
                  std::span<const std::size_t> received_counts) const override
  {
    call("Alltoallv", [&](const nb::object& pass)
         { pass(by_rank(sent(send), sent_counts), by_rank(received(receive), received_counts)); });
  }
  void all_gather(std::span<const double> own, std::span<const std::size_t> counts,
                  std::span<double> all) const override
  {
    call("Allgatherv",
         [&](const nb::object& pass) { pass(whole(sent(own), own.size()), by_rank(received(all), counts)); });
  }
  void broadcast(std::span<double> values, int from) const override
  {
    call("Bcast", [&](const nb::object& pass) { pass(whole(received(values), values.size()), from); });
  }
  void gather(std::span<const double> own, std::span<const std::size_t> counts, std::span<double> all) const override
  {
    call("Gatherv",
         [&](const nb::object& pass)
         {
           const nb::object to = rank_ == 0 ? nb::object(by_rank(received(all), counts)) : nb::none();
           pass(whole(sent(own), own.size()), to, 0);
         });
  }

private:
  /// Calls a function of mpi4py with the interpreter's lock, which mpi4py gives back while it waits. It is compiled, so that Ctrl-C
  /// cannot come between: `RunMonitor::wants_stop` hears of that.
  template <typename Use>
  void call(const char* name, const Use& use) const
  {
    const nb::gil_scoped_acquire lock;
    try
    {
      use(comm_.attr(name));
    }
    catch (nb::python_error& error)
    {
      error.restore();
      PyErr_Print();
      comm_.attr("Abort")(1);
    }
  }
  [[nodiscard]] nb::tuple whole(const nb::object& values, std::size_t count) const
  {
    return nb::make_tuple(values, count, double_);
  }
  [[nodiscard]] nb::tuple by_rank(const nb::object& values, std::span<const std::size_t> counts) const
  {
    const auto [numbers, first] = parts(counts);
    return nb::make_tuple(values, nb::make_tuple(numbers, first), double_);
  }

  nb::object comm_, double_;
  int rank_, size_;
};

} // namespace

std::shared_ptr<const Communicator> ranks_of(const nb::object& comm)
{
  if (comm.is_none())
    return nullptr;
  return std::make_shared<const PythonRanks>(comm);
}

} // namespace brinell::python

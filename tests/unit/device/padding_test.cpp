// SPDX-License-Identifier: BSD-3-Clause
#include "device/padding_kernels.hpp"

#include "device/host_executor.hpp"
#include "random_field.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace brinell::device::padding_test
{
namespace
{

TEST(DevicePadding, TakesFieldsIntoPlanesOfZerosAndBack)
{
  const HostExecutor host;
  for (const Padding padding : {Padding{3, 2, 6, 5}, Padding{4, 1, 7, 1}, Padding{1, 4, 1, 8}})
  {
    constexpr std::size_t planes = 3;
    const std::vector<double> fields = test::random_field(planes * padding.cells(), 1, 1.0, 2.0);
    std::vector<double> padded(planes * padding.padded(), 7.0), back(fields.size());
    host.run("embed", padded.size(), Embed{padding, fields.data(), padded.data()});
    double sum = 0.0, sum_of_fields = 0.0;
    for (const double value : padded)
      sum += value;
    for (const double value : fields)
      sum_of_fields += value;
    EXPECT_NEAR(sum, sum_of_fields, 1e-13); // all else is zero
    EXPECT_EQ(padded[padding.padded()], fields[padding.cells()]);
    if (padding.ny > 1)
    {
      EXPECT_EQ(padded[padding.pitch()], fields[padding.nx]);
    }
    host.run("extract", back.size(), Extract{padding, padded.data(), back.data()});
    EXPECT_EQ(back, fields);
  }
}

} // namespace
} // namespace brinell::device::padding_test

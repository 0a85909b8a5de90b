// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/error.hpp"
#include "io/case/raw_case.hpp"
#include "io/case/toml_text.hpp"
#include "io/files.hpp"
#include "sample.hpp"

#include <sys/stat.h>

/// Files that are no case, and cases that are made to break a parser.
namespace brinell::io::input_files_test
{

namespace
{

template <typename Function>
std::string message_of(const Function& function)
{
  try
  {
    function();
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return "";
}

std::string repeated(const std::string& text, int count)
{
  std::string result;
  for (int i = 0; i < count; ++i)
    result += text;
  return result;
}

// toml++ recurses into each part of a key: 40,000 of them overflowed the stack.
TEST(InputFiles, DeepKeysAreRefusedWithTheirLine)
{
  const std::string deep = repeated("a.", 100000) + "a";
  for (const std::string& text : {"\n" + deep + " = 1", "\n[" + deep + "]", "\n[[" + deep + "]]",
                                  "\nx = {" + deep + " = 1}", "\n" + repeated("\"a\" . ", 100000) + "'a' = 1"})
  {
    const std::string message = message_of([&] { (void)parse_case(text, "deep.toml"); });
    EXPECT_TRUE(message.starts_with("deep.toml:2: a key of more than 30 parts")) << message.substr(0, 200);
  }
  const std::string message = message_of([&] { (void)parse_case(sample::case_text, "x.toml", {deep + "=1"}); });
  EXPECT_NE(message.find("a key of more than 30 parts"), std::string::npos) << message.substr(0, 200);
  EXPECT_LT(message.size(), 300u);
  EXPECT_NE(message_of([&] { (void)parse_case(sample::case_text, "x.toml", {"lower={" + deep + "=1}"}); })
                .find("a key of more than 30 parts"),
            std::string::npos);
}

TEST(InputFiles, DotsElsewhereAreNoKeys)
{
  const std::string dots = repeated(".", 1000);
  for (const std::string& text :
       {"title = \"" + dots + "\"", "title = '" + dots + "'", "# " + dots,
        "title = \"\"\"\n" + dots + "\"\"\"\"\" # " + dots, "title = '''" + dots + "\n'''''\nb = 1",
        "heights = [" + repeated("0.1, ", 1000) + "1.0]", "title = \"\\\"" + dots + "\"", "title = \"\\\\\" # " + dots})
    EXPECT_EQ(line_of_deep_key(text), std::nullopt) << text.substr(0, 60);
  const std::string deep = "\n" + repeated("a.", 31) + "a = 1";
  for (const char* before : {"title = \"\"\"x\"\"\"\"\"", "title = '''\n'''''", "title = \"\\\\\"", "title = '\\'"})
    EXPECT_NE(line_of_deep_key(before + deep), std::nullopt) << before;
}

TEST(InputFiles, DevicesPipesAndFoldersAreRefused)
{
  const sample::TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::filesystem::path& file : {pipe, std::filesystem::path("/dev/zero")})
  {
    EXPECT_NE(message_of([&] { (void)read_case(file); }).find(file.string() + ": is a device or a pipe"),
              std::string::npos);
    EXPECT_NE(
        message_of(
            [&] { (void)sample::parsed({"lower.material.hardening={law=\"table\", file=\"" + file.string() + "\"}"}); })
            .find("is a device or a pipe"),
        std::string::npos);
    EXPECT_NE(message_of([&] { (void)input_text(file); }).find("is a device or a pipe"), std::string::npos);
  }
  EXPECT_NE(message_of([&] { (void)input_text(folder.path()); }).find("is a folder"), std::string::npos);
  EXPECT_NE(message_of(
                [&] {
                  (void)sample::parsed(
                      {"lower.material.hardening={law=\"table\", file=\"" + folder.path().string() + "\"}"});
                })
                .find("is a folder"),
            std::string::npos);
}

TEST(InputFiles, TooLargeOnesAreRefused)
{
  const sample::TemporaryFolder folder;
  const auto file = folder.path() / "large.toml";
  std::ofstream(file) << "x = 1";
  std::filesystem::resize_file(file, largest_input + 1); // takes no room on the disk
  EXPECT_NE(message_of([&] { (void)read_case(file); }).find("is too large; allowed: up to 100 MB"), std::string::npos);
}

TEST(InputFiles, ThoseThatCannotBeReadAreNoBug)
{
  EXPECT_THROW((void)read_case("/proc/self/mem"), IoError);
}

TEST(InputFiles, MayBeginWithTheMarkOfUtf8)
{
  const sample::TemporaryFolder folder;
  const auto file = folder.path() / "curve.csv";
  std::ofstream(file) << "\xef\xbb\xbf"
                      << "0, 900e6\n0.01, 950e6\n";
  const Case c = sample::parsed({"lower.material.hardening={law=\"table\", file=\"" + file.string() + "\"}"});
  EXPECT_EQ(c.values.get<std::vector<double>>("lower.material.hardening.plastic_strain"), (std::vector{0.0, 0.01}));
  std::ofstream(folder.path() / "case.toml") << "\xef\xbb\xbf" << sample::case_text;
  EXPECT_EQ(read_case(folder.path() / "case.toml").title, "sample");
}

// Results carry their case: it must be one that can be read again.
TEST(InputFiles, OverridesAreUtf8)
{
  EXPECT_NE(message_of(
                []
                {
                  (void)sample::parsed({"title=a\xff"
                                        "b"});
                })
                .find("0xff, is not UTF-8"),
            std::string::npos);
  EXPECT_EQ(sample::parsed({"title=\u03b1\u2217 \U0001F600"}).title, "\u03b1\u2217 \U0001F600");
  for (const char* bad :
       {"\x80", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82", "\xf5\x80\x80\x80"})
    EXPECT_EQ(valid_utf8(std::string("ab") + bad), 2u);
  EXPECT_EQ(valid_utf8("\u00e4\u20ac\U0010FFFF"), 9u);
}

TEST(InputFiles, ManyProblemsAreCountedOnly)
{
  std::string text(sample::case_text);
  for (int i = 0; i < 1000; ++i)
    text += "wrong" + std::to_string(i) + " = 1\n";
  const std::string message = message_of([&] { (void)parse_case(text, "x.toml"); });
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 20);
  EXPECT_TRUE(message.ends_with("\nand 980 more")) << message.substr(message.size() - 40);
}

TEST(InputFiles, ModulusBeyondAllSolidsIsWarnedOf)
{
  const auto warned = [](const char* modulus)
  {
    const Case c = sample::parsed({std::string("upper.material.young_modulus=") + modulus});
    return std::any_of(c.warnings.begin(), c.warnings.end(),
                       [](const auto& w) { return w.text.find("stiffer than any solid") != std::string::npos; });
  };
  EXPECT_TRUE(warned("1e109"));
  EXPECT_FALSE(warned("1.1e12")) << "diamond";
}

} // namespace

} // namespace brinell::io::input_files_test

// SPDX-License-Identifier: Apache-2.0
// CSV files as spreadsheets and instruments write them: the same numbers, or a refusal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "base/csv_table.hpp"
#include "case_folder.hpp"

namespace {

class csv_dialect : public ::testing::Test {
 protected:
  coupled::Folder folder_;

  driver::CsvTable table(const std::string& text) const {
    std::ofstream(folder_.path / "a.csv") << text;
    return driver::read_csv(folder_.path / "a.csv", {"t", "p"});
  }
  // What is wrong, after the folder; empty if nothing is.
  std::string fault(const std::string& text) const {
    try {
      table(text);
    } catch (const driver::CaseError& error) {
      return std::string(error.what()).substr(folder_.path.string().size() + 1);
    }
    return {};
  }
};

TEST_F(csv_dialect, all_spellings_have_the_same_numbers) {
  const std::vector<std::vector<double>> known{{0.0, 0.5, 1000.25}, {-1.5e-3, 101325.0, 2.0}};
  for (const char* text :
       {"t,p\n0,-1.5e-3\n0.5,101325\n1000.25,2\n", "t;p\n0;-1.5e-3\n0.5;101325\n1000.25;2\n",
        "t;p\n0;-1,5e-3\n0,5;101325\n1000,25;2\n", "t\tp\n0\t-1,5e-3\n0,5\t101325\n1000,25\t2\n",
        "t\tp\n0\t-1.5e-3\n0.5\t101325\n1000.25\t2\n",
        "\xef\xbb\xbf\"t\";\"p\";\r\n0,0;-1,5E-3;\r\n\r\n;;;\r\n\"0,5\";101325,0;\r\n1000,25; 2 ;\r\n",
        "# a comment;;\n\"Druck, abs.\";p;t\n;-1,5e-3;0\n;101325;0,5\n;2;1000,25\n"}) {
    ASSERT_EQ(fault(text), "") << text;
    EXPECT_EQ(table(text).values, known) << text;
  }
}

TEST_F(csv_dialect, what_may_mean_two_numbers_is_refused) {
  EXPECT_EQ(
      fault("t;p\n0,5;1\n1,5;1.234\n"),
      "a.csv:3:5: '1.234' is ambiguous, as line 2 has a decimal comma; allowed: the same in all numbers, "
      "and nothing between thousands");
  EXPECT_EQ(fault("t;p\n0.5;1\n1.5;1,234\n").substr(0, 28), "a.csv:3:5: '1,234' is ambigu");
  EXPECT_EQ(fault("t;p\n0;1.234,5\n").substr(0, 30), "a.csv:2:3: '1.234,5' is ambigu");
  EXPECT_EQ(fault("t;p\n0;1,234.5\n").substr(0, 30), "a.csv:2:3: '1,234.5' is ambigu");
  EXPECT_EQ(fault("t;p\n0;1,234,567\n"), "a.csv:2:3: '1,234,567' is not a finite number");
  EXPECT_EQ(fault("t;p\n0;,\n"), "a.csv:2:3: ',' is not a finite number");
  const std::string advice = "; decimal commas need semicolons between columns";
  EXPECT_EQ(fault("t,p\n0,5,1,5\n"), "a.csv:2:1: has 4 columns, but the header 2" + advice);
  EXPECT_EQ(fault("t,p\n\"0,5\",1\n"), "a.csv:2:2: '0,5' is not a finite number" + advice);
  EXPECT_EQ(fault("t;p, abs\n0;1\n"),
            "a.csv:1:1: t: no such column, the header has t;p, abs; put names with "
            "commas in quotes");
  EXPECT_EQ(fault("t,p\n0;1\n"), "a.csv:2:1: '0;1' is not a finite number");
}

TEST_F(csv_dialect, random_numbers_keep_their_bits) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  std::string points = "t,p\n", commas = "t;p\n";
  for (int i = 0; i < 500; ++i) {
    char line[80];
    std::snprintf(line, sizeof line, "%.17g;%.17g\n", i + 0.5, std::pow(10.0, exponent(random)));
    std::string text = line;
    std::replace(text.begin(), text.end(), '.', ',');
    commas += text;
    text = line;
    std::replace(text.begin(), text.end(), ';', ',');
    points += text;
  }
  EXPECT_EQ(table(commas).values, table(points).values);
}

}  // namespace

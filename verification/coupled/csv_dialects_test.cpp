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

TEST_F(csv_dialect, comments_end_before_the_separators_of_a_spreadsheet) {
  EXPECT_EQ(driver::comment_of("# runs: 64;;;"), "# runs: 64");
  EXPECT_EQ(driver::comment_of("\"# runs: 6;4\";; "), "# runs: 6;4");
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
  EXPECT_EQ(fault("t,p\n0;1\n"), "a.csv:2:1: '0;1' is not a finite number");
}

TEST_F(csv_dialect, thousands_are_not_taken_for_decimals) {
  const std::string advice = " of the file has three digits after it; write ";
  EXPECT_EQ(fault("t;p\n0;99\n1;101,325\n"),
            "a.csv:3:3: '101,325' may be 101.325 or 101325, as every comma" + advice + "101,3250 or 101325");
  EXPECT_EQ(fault("t\tp\n0\t-1.000\n1\t-2.500\n"),
            "a.csv:2:3: '-1.000' may be -1.000 or -1000, as every point" + advice + "-1.0000 or -1000");
  EXPECT_EQ(fault("t;p;q\n0;99;0.5\n1;101,325;12.5.2024\n").substr(0, 30), "a.csv:3:3: '101,325' may be 10");
  // One number that can only have a decimal mark decides, also in a column that is not needed.
  for (const char* text :
       {"t;p\n0;99\n1;101,3250\n", "t;p\n0,5;99\n1;101,325\n", "t;p\n0;99\n1;101,325\n2;1013,250\n",
        "t;p\n0,000;99\n0,125;101,325\n", "t;p\n0;99\n1;101,325e0\n", "t;p\n,125;99\n1;101,325\n",
        "t;p;q\n0;99;7\n1;101,325;7,5\n", "t,p\n0,99\n1,101.325\n"})
    EXPECT_EQ(fault(text), "") << text;
}

TEST_F(csv_dialect, header_has_the_needed_name_by_any_separator) {
  const auto header = [&](const std::string& text) {
    std::ofstream(folder_.path / "a.csv") << text;
    const auto found =
        driver::read_csv_header(folder_.path / "a.csv", [](const std::string& name) { return name == "t"; });
    return std::make_pair(found.line, found.names);
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(header("t;p;a, free\n0;1;2\n"), std::make_pair(std::size_t{1}, Names{"t", "p", "a, free"}));
  EXPECT_EQ(header("t;a, b, c, d\n0;1\n"), std::make_pair(std::size_t{1}, Names{"t", "a, b, c, d"}));
  EXPECT_EQ(header("# made\ntitle, long\nq\tt\n1\t0\n"), std::make_pair(std::size_t{3}, Names{"q", "t"}));
  EXPECT_EQ(header("x;y;a, free\n0;1;2\n"), std::make_pair(std::size_t{1}, Names{"x", "y", "a, free"}));
}

// As LabVIEW and oscilloscopes write them.
TEST_F(csv_dialect, header_may_have_titles_above_it) {
  const std::vector<std::vector<double>> known{{20.5, 20.75}, {-1e-3, 1.4e-3}};
  EXPECT_EQ(
      table("waveform\t[0]\nt0\t24.07.2015  09:54:20.160527\n\nt\tp\n  20.5\t-1.0E-3\n  20.75\t1.4E-3\n")
          .values,
      known);
  EXPECT_EQ(table("Anlage 3, Versuch; 2\nt;p, abs;p\n20,5;7;-1e-3\n20,75;7;1,4e-3\n").values, known);
  EXPECT_EQ(table(std::string(99, '\n') + "p\n" + "t,p\n20.5,-1e-3\n20.75,1.4e-3\n").values, known);
  std::string titles;
  for (int i = 0; i < 100; ++i) titles += "title\n";
  EXPECT_EQ(table(titles.substr(6) + "t,p\n20.5,-1e-3\n20.75,1.4e-3\n").values, known);
  EXPECT_EQ(fault(titles + "t,p\n1,2\n"), "a.csv:1:1: t: no such column, the header has title");
  EXPECT_EQ(fault("# made by X\nt;q\n1;2\n"), "a.csv:2:1: p: no such column, the header has t, q");
  EXPECT_EQ(fault("t,p\ns,Pa\n1,2\n"), "a.csv:2:1: 's' is not a finite number; put # before a row of units");
  EXPECT_EQ(fault("t,p\n1,2\ns,Pa\n"), "a.csv:3:1: 's' is not a finite number");
  EXPECT_EQ(fault("t,p,t\n1,2,3\n"), "a.csv:1:1: t: is more than one column");
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

// SPDX-License-Identifier: Apache-2.0
// Histories of this program and of others: columns, units, offsets, and what is refused.
#include <gtest/gtest.h>

#include "case_folder.hpp"
#include "compare/compare.hpp"

namespace {

using coupled::Folder;

struct Files : Folder {
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name) << text;
    return path / name;
  }
};

std::string refused(const std::filesystem::path& file, const std::filesystem::path& map = {}) {
  try {
    driver::read_history(file, map);
  } catch (const driver::CaseError& error) {
    return error.what();
  }
  return "accepted";
}

const std::string kMaps = GASJET_SOURCE_DIR "/cases/maps/";

// Two airbags; a legend before the first state; the last row's fields run into each other, as printf's do
// when an exponent has three digits.
const std::string kAbstat = R"(

  airbag/control volume statistics

 legend 1 airbag left

      time   airbag/cv #  volume        pressure    internal energy      dm/dt in      density dm/dt out  total mass gas temp. surface area   reaction
 0.00000E+00       1     6.0000E+07     1.0000E-04     0.0000E+00     2.0000E-03     1.2000E-09  0.000E+00  7.000E-02  2.931E+02  9.000E+05  0.000E+00
 0.00000E+00       2     1.0000E+07     2.0000E-04     0.0000E+00     0.0000E+00     1.2000E-09  0.000E+00  7.000E-02  2.931E+02  9.000E+05  0.000E+00


      time   airbag/cv #  volume        pressure    internal energy      dm/dt in      density dm/dt out  total mass gas temp. surface area   reaction
 5.00000E-01       1     6.1000E+07     1.1000E-04     0.0000E+00     2.0000E-03     1.2000E-09  1.000E-03  8.000E-02  3.000E+02  9.100E+05  0.000E+00
 5.00000E-01       2     1.0000E+07     2.0000E-04     0.0000E+00     0.0000E+00     1.2000E-09  0.000E+00  7.000E-02  2.931E+02  9.000E+05  0.000E+00


      time   airbag/cv #  volume        pressure    internal energy      dm/dt in      density dm/dt out  total mass gas temp. surface area   reaction
 1.00000E+00       1     6.2000E+07     1.2000E-04     0.0000E+00     2.0000E-03     1.2000E-09 -2.500E-03  9.000E-02  3.100E+02  9.200E+05-1.000E+100
 1.00000E+00       2     1.0000E+07     2.0000E-04     0.0000E+00     0.0000E+00     1.2000E-09  0.000E+00  7.000E-02  2.931E+02  9.000E+05  0.000E+00
)";

TEST(history, abstat_in_si_units) {
  const Files files;
  const auto history = driver::read_history(files.write("abstat", kAbstat), kMaps + "lsdyna_abstat.toml");
  ASSERT_EQ(history.time.size(), 3u);
  const auto expect = [&](const char* name, const std::vector<double>& values) {
    ASSERT_TRUE(history.find(name)) << name;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ((*history.find(name))[i], values[i]) << name << i;
  };
  EXPECT_DOUBLE_EQ(history.time[1], 5e-4);
  expect("volume_m3", {0.06, 0.061, 0.062});
  expect("pressure_Pa", {1e5, 1.1e5, 1.2e5});
  expect("inflow_kg_s", {2.0, 2.0, 2.0});
  expect("vent_outflow_kg_s", {0.0, 1.0, -2.5});
  expect("gas_mass_kg", {0.07, 0.08, 0.09});
  expect("temperature_K", {293.1, 300.0, 310.0});
  expect("skin_area_m2", {0.9, 0.91, 0.92});
}

TEST(history, offset_and_the_second_airbag) {
  const Files files;
  const auto map = files.write("map.toml",
                               "format = \"abstat\"\nvolume_number = 2\n[time]\ncolumn = \"time\"\n"
                               "[[quantity]]\nname = \"pressure_Pa\"\ncolumn = \"pressure\"\nscale = 1e9\n"
                               "offset = 101325.0\n");
  const auto history = driver::read_history(files.write("abstat", kAbstat), map);
  EXPECT_DOUBLE_EQ(history.columns[0].second[2], 2e5 + 101325.0);
}

TEST(history, openradioss_csv_in_si_units) {
  const Files files;
  const auto csv = files.write(
      "bagT01.csv",
      "\"time\",\"INTERNAL ENERGY\",\"MASS\",\"TIME STEP\",\"TH_BAG, main  1 bag       P         \","
      "\"TH_BAG, main  1 bag       VOL       \",\"TH_BAG, main  1 bag       MASS      \"\n"
      "0.000000,0.000000,1.000000,0.100000,0.000100,60000000.000000,0.070000\n"
      "0.500000,0.000000,1.000000,0.100000,0.000110,61000000.000000,0.080000\n"
      "1.000000,0.000000,1.000000,0.100000,0.000120,62000000.000000,0.090000\n");
  const auto history = driver::read_history(csv, kMaps + "openradioss_monvol.toml");
  EXPECT_DOUBLE_EQ(history.time[2], 1e-3);
  for (const char* name : {"pressure_Pa", "volume_m3", "gas_mass_kg"})
    ASSERT_TRUE(history.find(name)) << name;
  EXPECT_DOUBLE_EQ((*history.find("pressure_Pa"))[1], 1.1e5);
  EXPECT_DOUBLE_EQ((*history.find("volume_m3"))[1], 0.061);
  EXPECT_DOUBLE_EQ((*history.find("gas_mass_kg"))[0], 0.07);  // the volume's, not the model's
  EXPECT_FALSE(history.find("temperature_K"));                // not in the file
}

TEST(history, bad_histories_are_refused_where_they_stand) {
  const Files files;
  const std::string head = "# made by hand\ntime_s,pressure_Pa\n";
  const auto expect = [&](const std::string& text, const std::string& message) {
    const auto answer = refused(files.write("mine.csv", text));
    EXPECT_NE(answer.find(message), std::string::npos) << answer;
  };
  expect(head + "0,1\n1,2\n2,3\n", "accepted");
  expect(head + "0,1\n1,2\n1,3\n", "mine.csv:5:1: time_s: 1 s follows 1 s");
  expect(head + "0,+1\n1,1e-400\n2,-1e-320\n", "accepted");
  expect(head + "0,1\n1,1e400\n2,3\n", "mine.csv:4:3: '1e400'");
  expect(head + "0,1\n1,-1e100\n2,3\n", "accepted");
  expect(head + "0,1\n1,-1.01e100\n2,3\n",
         "mine.csv:4:3: pressure_Pa: -1.01e+100 in SI units, allowed: a magnitude of at most 1e100");
  expect(head + "0,1\n1,+-2\n2,3\n", "mine.csv:4:3: '+-2'");
  expect(head + "0,1\n1,nan\n2,3\n", "mine.csv:4:3: 'nan'");
  expect(head + "0,1\n1\n2,3\n", "mine.csv:4:1: has 1 columns");
  expect(head + "0,1\n1,2\n", "mine.csv:4:1: has 2 rows, needed: 3 or more");
  expect(head + "0,1,\n1,2,\n2,3,\n", "accepted");
  expect("time_s;pressure_Pa;Notiz, frei\n0;1;0\n1;2;0\n2;3;0\n", "accepted");
  expect("Test 7, bag\ntime_s;pressure_Pa\n0;1\n1;2\n2;3\n", "accepted");
  expect(head + "0,1\n0,5,101,3\n2,3\n", "mine.csv:4:1: has 4 columns, but the header 2");
  expect("time_s,time_s\n0,1\n1,2\n2,3\n", "mine.csv:1:1: 'time_s' is more than one column");
  expect("t,pressure_Pa\n0,1\n1,2\n2,3\n", "mine.csv:1:1: time_s: no such column");
  expect("# nothing\n", "has no header row");
  EXPECT_NE(refused(files.path).find("is a folder"), std::string::npos);
}

TEST(history, bad_maps_are_refused_where_they_stand) {
  const Files files;
  const auto csv = files.write("mine.csv", "t,p left,p right\n0,1,2\n1,2,3\n2,3,4\n");
  const std::string good =
      "format = \"csv\"\n[time]\ncolumn = \"t\"\n[[quantity]]\nname = \"pressure_Pa\"\ncolumn = ";
  const auto expect = [&](const std::filesystem::path& file, const std::string& text,
                          const std::string& message) {
    const auto answer = refused(file, files.write("map.toml", text));
    EXPECT_NE(answer.find(message), std::string::npos) << answer;
  };
  expect(csv, good + "\"p left\"\n", "accepted");
  expect(csv, good + "\"p*\"\n", "'p*' is more than one column: p left; p right");
  expect(csv, good + "\"* *\"\n",
         "map.toml:6:1: quantity.0.column: is '* *', allowed: a name with at most one *");
  expect(csv, good + "\"\"\n", "quantity.0.column: is ''");
  expect(csv, "format = \"csv\"\n[time]\ncolumn = \"t\"\n[[quantity]]\nname = \"\"\ncolumn = \"p left\"\n",
         "map.toml:5:1: quantity.0.name: is empty");
  expect(csv, good + "\"p left\"\nscale = 0\n",
         "map.toml:7:1: quantity.0.scale: is 0, which erases the column");
  expect(csv, good + "\"p left\"\nscale = 1e300\noffset = 1e308\n", "mine.csv:2:3: p left: ");
  expect(csv, good + "\"p left\"\nfactor = 2\n", "unknown key");
  expect(csv, good + "\"p left\"\nunit = \"Pa\"\n", "accepted");
  expect(csv, good + "\"p left\"\nunit = \"kPa absolute\"\n", "accepted");
  expect(csv, good + "\"p left\"\nunit = \"kPa gauge\"\n", "which needs the ambient pressure");
  const std::string overpressure =
      "format = \"csv\"\n[time]\ncolumn = \"t\"\n[[quantity]]\nname = \"overpressure_Pa\"\ncolumn = \"p "
      "left\"\nunit = ";
  expect(csv, overpressure + "\"kPa gauge\"\n", "accepted");
  expect(csv, overpressure + "\"kPa absolute\"\n",
         "map.toml:7:1: quantity.0.unit: is \"kPa absolute\", which needs the ambient pressure");
  expect(csv, good + "\"p left\"\n[[quantity]]\nname = \"pressure_Pa\"\ncolumn = \"p right\"\n",
         "given twice");
  expect(csv, "format = \"xls\"\n[time]\ncolumn = \"t\"\n", "format");
  expect(csv, "format = \"csv\"\n[time]\ncolumn = \"clock\"\n", "mine.csv:1:1: clock: no such column");
  const std::string abstat = "format = \"abstat\"\n[time]\ncolumn = \"time\"\n";
  const auto log = files.write("abstat", kAbstat);
  expect(log, abstat, "accepted");
  expect(log, abstat + "[[quantity]]\nname = \"p\"\ncolumn = \"speed\"\n", "has no 'speed'");
  expect(log, "format = \"abstat\"\nvolume_number = 3\n[time]\ncolumn = \"time\"\n",
         "no such airbag; the first is 1");
  expect(csv, abstat, "no state of an abstat file");
  std::string numbered = kAbstat;
  numbered.replace(numbered.rfind("       1"), 8, "   1e300");
  expect(files.write("numbered", numbered), abstat, "a whole number from 1 to 1e9");
  expect(files.write("cut", kAbstat.substr(0, kAbstat.size() - 40)), abstat,
         "cut:19:107: the row ends in field 9");
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Whole runs and comparison through gasjet.h.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "meshes.hpp"

using namespace border_test;

namespace {

const std::string kCases = std::string(GASJET_SOURCE_DIR) + "/cases/";

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<double> column(gasjet_handle run, const char* name) {
  int64_t columns = 0, rows = 0;
  EXPECT_OK(gasjet_run_size(run, GASJET_HISTORY, &columns, &rows));
  const double* values = nullptr;
  EXPECT_OK(gasjet_run_find(run, GASJET_HISTORY, name, &values));
  return values ? std::vector<double>(values, values + rows) : std::vector<double>();
}

std::string summary(gasjet_handle run) {
  int64_t needed = 0;
  EXPECT_OK(gasjet_run_summary(run, nullptr, 0, &needed));
  EXPECT_STREQ(gasjet_last_error(), "");
  char little[2];
  EXPECT_EQ(gasjet_run_summary(run, little, 2, &needed), GASJET_BAD_INPUT);
  std::string text(static_cast<std::size_t>(needed), '\0');
  EXPECT_OK(gasjet_run_summary(run, text.data(), needed, &needed));
  return text;
}

/// A folder that goes with the test.
struct Folder {
  Folder()
      : path(std::filesystem::path(testing::TempDir()) / ("gasjet_border_" + std::to_string(getpid()))) {}
  ~Folder() { std::filesystem::remove_all(path); }
  std::filesystem::path path;
};

TEST(c_run, file_text_and_folder_give_the_same_bits) {
  const std::string file = kCases + "tank_blowdown.toml";
  Handle of_file, of_text, of_folder;
  Folder folder;
  const char* overrides = "scene.end_time=0.1\noutput.history_every=0.01\n";
  ASSERT_OK(gasjet_run(file.c_str(), nullptr, overrides, nullptr, 1, nullptr, nullptr, &of_file.value));
  ASSERT_OK(gasjet_run("nowhere.toml", text_of(file).c_str(), overrides, nullptr, 2, nullptr, nullptr,
                       &of_text.value));
  ASSERT_OK(gasjet_run(file.c_str(), nullptr, overrides, folder.path.c_str(), 1, nullptr, nullptr,
                       &of_folder.value));
  const auto pressure = column(of_file.value, "pressure_Pa");
  EXPECT_EQ(pressure.size(), 11u);
  EXPECT_EQ(pressure, column(of_text.value, "pressure_Pa"));
  EXPECT_EQ(pressure, column(of_folder.value, "pressure_Pa"));
  EXPECT_NE(summary(of_file.value).find("\"status\": \"done\""), std::string::npos);
  EXPECT_NE(text_of(folder.path / "summary.json").find("\"done\""), std::string::npos);
  // What the file says reads back to the same doubles.
  std::istringstream history(text_of(folder.path / "history.csv"));
  std::vector<double> written;
  for (std::string line; std::getline(history, line);)
    if (!line.empty() && (std::isdigit(line[0]) != 0))
      written.push_back(std::stod(line.substr(line.find(',') + 1)));
  EXPECT_EQ(written, pressure);
  char name[64];
  ASSERT_OK(gasjet_run_name(of_file.value, GASJET_ENERGY, 0, name, sizeof name));
  EXPECT_STREQ(name, "time_s");
}

TEST(c_run, overrides_may_have_blanks_and_returns) {
  const std::string file = kCases + "tank_blowdown.toml";
  Handle plain, spaced;
  ASSERT_OK(gasjet_run(file.c_str(), nullptr, "scene.end_time=0.05\ntank.volume=0.03\nscene.name=other",
                       nullptr, 1, nullptr, nullptr, &plain.value));
  ASSERT_OK(gasjet_run(file.c_str(), nullptr,
                       "scene.end_time = 0.05\r\n\ttank.volume =0.03 \r\n\r\nscene.name= other\r\n", nullptr,
                       1, nullptr, nullptr, &spaced.value));
  EXPECT_EQ(column(spaced.value, "pressure_Pa"), column(plain.value, "pressure_Pa"));
  EXPECT_NE(summary(spaced.value).find("\"scene\": \"other\""), std::string::npos) << summary(spaced.value);
}

TEST(c_run, summary_holds_the_warnings_of_case_and_jet) {
  Handle fine, warned;
  const std::string file = kCases + "jet_bag.toml", end = "scene.end_time=0.006\n";
  ASSERT_OK(gasjet_run(file.c_str(), nullptr, end.c_str(), nullptr, 1, nullptr, nullptr, &fine.value));
  EXPECT_NE(summary(fine.value).find("\"warnings\": []"), std::string::npos) << summary(fine.value);
  const std::string late = end + "inflator.1.start_time=0.1";
  ASSERT_OK(gasjet_run(file.c_str(), nullptr, late.c_str(), nullptr, 1, nullptr, nullptr, &warned.value));
  const std::string said = summary(warned.value);
  EXPECT_NE(said.find("inflator.1 delivers nothing before end_time"), std::string::npos) << said;
  EXPECT_NE(said.find("jet of inflator 1: no flow up to the end"), std::string::npos) << said;
}

struct Watch {
  int calls = 0;
  double last = 0.0;
  static int count(double time, double, void* user) {
    auto* watch = static_cast<Watch*>(user);
    watch->last = time;
    ++watch->calls;
    return 0;
  }
  static int stop(double, double, void*) { return 1; }
  static int raise(double, double, void*) { throw std::runtime_error("callback"); }
};

TEST(c_run, callback_watches_stops_and_may_throw) {
  const std::string file = kCases + "jet_bag.toml";
  const char* overrides = "scene.end_time=1e-3";
  Watch watch;
  Handle whole, part, thrown;
  ASSERT_OK(gasjet_run(file.c_str(), nullptr, overrides, nullptr, 1, Watch::count, &watch, &whole.value));
  EXPECT_GE(watch.calls, 2);  // the start and the end at least
  EXPECT_EQ(watch.last, 1e-3);
  EXPECT_EQ(gasjet_run(file.c_str(), nullptr, overrides, nullptr, 1, Watch::stop, nullptr, &part.value),
            GASJET_STOPPED);
  EXPECT_NE(summary(part.value).find("\"interrupted\""), std::string::npos);
  EXPECT_FALSE(column(part.value, "time_s").empty());
  EXPECT_EQ(gasjet_run(file.c_str(), nullptr, overrides, nullptr, 1, Watch::raise, nullptr, &thrown.value),
            GASJET_STOPPED);
  EXPECT_EQ(std::string(gasjet_last_error()).rfind("progress: ", 0), 0u) << gasjet_last_error();
}

TEST(c_run, case_errors_name_file_line_and_key) {
  gasjet_handle run = 0;
  EXPECT_EQ(gasjet_run("mine.toml", "[scene]\nname = \"x\"\nend_tim = 1.0\n", nullptr, nullptr, 1, nullptr,
                       nullptr, &run),
            GASJET_BAD_INPUT);
  const std::string message = gasjet_last_error();
  EXPECT_EQ(message.rfind("mine.toml:", 0), 0u) << message;
  EXPECT_NE(message.find("scene.end_time"), std::string::npos) << message;
  EXPECT_EQ(run, 0);
}

TEST(c_run, what_is_gpl_is_refused_by_name) {
  gasjet_handle run = 0;
  EXPECT_EQ(gasjet_run((kCases + "jet_bag.toml").c_str(), nullptr, "inflator.0.jet.visibility=cgal_tree",
                       nullptr, 1, nullptr, nullptr, &run),
            GASJET_BAD_INPUT);
  EXPECT_NE(std::string(gasjet_last_error()).find("inflator.0.jet.visibility"), std::string::npos)
      << gasjet_last_error();
}

TEST(c_run, a_run_past_its_domain_keeps_what_it_has) {
  Handle run;
  EXPECT_EQ(gasjet_run((kCases + "jet_bag.toml").c_str(), nullptr,
                       "scene.end_time=0.02\ntime.step=1e-3\ntime.unsafe_step=true", nullptr, 1, nullptr,
                       nullptr, &run.value),
            GASJET_DOMAIN);
  EXPECT_NE(std::string(gasjet_last_error()), "");
  ASSERT_NE(run.value, 0);
  EXPECT_FALSE(column(run.value, "time_s").empty());
}

TEST(c_compare, a_history_is_inside_its_own_band) {
  const std::string file = kCases + "reference/tank_blowdown.csv";
  int verdict = -1;
  int64_t needed = 0;
  EXPECT_OK(gasjet_compare(file.c_str(), file.c_str(), nullptr, nullptr, 0.0, &verdict, nullptr, 0, &needed));
  std::string text(static_cast<std::size_t>(needed), '\0');
  ASSERT_OK(gasjet_compare(file.c_str(), file.c_str(), nullptr, nullptr, 0.0, &verdict, text.data(), needed,
                           &needed));
  EXPECT_EQ(verdict, GASJET_INSIDE);
  EXPECT_NE(text.find("\"pressure_Pa\""), std::string::npos);
  EXPECT_NE(text.find("\"temperature_K\""), std::string::npos);
  ASSERT_OK(gasjet_compare(file.c_str(), file.c_str(), nullptr, "pressure_Pa, volume_m3", 0.0, &verdict,
                           text.data(), needed, &needed));
  text = text.c_str();  // shorter
  EXPECT_NE(text.find("\"volume_m3\""), std::string::npos);
  EXPECT_EQ(text.find("\"temperature_K\""), std::string::npos);
  EXPECT_EQ(
      gasjet_compare(file.c_str(), file.c_str(), nullptr, "presure_Pa", 0.0, &verdict, nullptr, 0, &needed),
      GASJET_BAD_INPUT);
  EXPECT_NE(std::string(gasjet_last_error()).find("presure_Pa"), std::string::npos) << gasjet_last_error();
}

}  // namespace

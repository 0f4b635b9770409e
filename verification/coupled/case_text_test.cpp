// SPDX-License-Identifier: Apache-2.0
// A case taken apart by `unset`, and written as text that means the same.
#include <gtest/gtest.h>

#include "base/number_text.hpp"
#include "case_folder.hpp"

namespace {

using coupled::Folder;
namespace fs = std::filesystem;

const fs::path kCases = GASJET_SOURCE_DIR "/cases";

// Every setting but the names of files.
std::vector<std::string> settings_of(const fs::path& file) {
  driver::CaseDocument document(file, {});
  driver::load_scene(document);
  std::vector<std::string> list;
  for (const auto& setting : document.settings())
    if (setting.path.find("file") == std::string::npos)
      list.push_back(setting.path + (setting.is_default ? " * " : " = ") + setting.value);
  return list;
}

TEST(case_text, numbers_that_differ_never_look_alike) {
  EXPECT_EQ(driver::digits_beside(0.0123456, 1.0), "0.0123");
  EXPECT_EQ(driver::digits_beside(1e-3, 1.0 / 1024.0), "0.001");
  EXPECT_EQ(driver::digits_beside(20000.25, 20000.0), "20000.2");
  EXPECT_EQ(driver::digits_beside(20000.0, 20000.25), "20000");
  EXPECT_EQ(driver::digits_beside(20000.0, 1e5), "20000");
  EXPECT_EQ(driver::digits_beside(0.5, 0.5), "0.5");
}

TEST(case_text, means_the_same_in_another_folder) {
  Folder folder;
  int count = 0, with_files = 0;
  for (const auto& entry : fs::directory_iterator(kCases)) {
    if (entry.path().extension() != ".toml") continue;
    const std::string text = driver::CaseDocument(entry.path(), {}).text(folder.path);
    const fs::path copy = folder.path / entry.path().filename();
    std::ofstream(copy) << text;
    EXPECT_EQ(settings_of(copy), settings_of(entry.path())) << entry.path();
    with_files += text.find("file = ") != std::string::npos;
    ++count;
  }
  EXPECT_GE(count, 20);
  EXPECT_GE(with_files, 2) << "a mesh and a curve";
}

TEST(case_text, unset_takes_out_a_key_and_a_table) {
  driver::CaseDocument document(kCases / "passenger_pendulum.toml",
                                {"unset inflator.0.jet", "unset scene.gravity"});
  const auto scene = driver::load_scene(document);
  EXPECT_TRUE(scene.jets.empty());
  EXPECT_TRUE(scene.gravity.isZero(0.0));
}

TEST(case_text, unset_of_what_is_not_there_is_refused) {
  const auto file = kCases / "passenger_pendulum.toml";
  for (const char* key : {"inflator.3.jet", "inflator.3"})
    EXPECT_NE(coupled::message_of(file, {std::string("unset ") + key}).find("inflator is a list of one"),
              std::string::npos)
        << key;
  for (const char* key : {"scene.no_such", "no_table.key", "scene.name.x", ""})
    EXPECT_NE(coupled::message_of(file, {std::string("unset ") + key}).find("no such key"), std::string::npos)
        << key;
  EXPECT_NE(coupled::message_of(file, {"unset inflator.0"}).find("one entry of a list, allowed: a key"),
            std::string::npos);
  EXPECT_NE(coupled::message_of(file, {"unset scene.end_time"}).find("end_time: is missing"),
            std::string::npos);
}

}  // namespace

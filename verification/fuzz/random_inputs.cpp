// SPDX-License-Identifier: Apache-2.0
// The harnesses without libFuzzer, for any compiler: each on COUNT inputs, copies of the seed files with
// random faults, the same ones each time. The input that runs is kept in KEPT, so that the one that breaks a
// harness is there after it. Usage: random_inputs HARNESS COUNT KEPT [SEED_FILE...]
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

using Harness = int(const std::uint8_t*, std::size_t);
extern "C" {
Harness fuzz_obj, fuzz_keyword, fuzz_visibility, fuzz_contact, fuzz_control_volume, fuzz_case_reader,
    fuzz_curve, fuzz_history, fuzz_written_mesh;
}

namespace {

const std::map<std::string, Harness*> kHarnesses{{"obj", fuzz_obj},
                                                 {"keyword", fuzz_keyword},
                                                 {"contact", fuzz_contact},
                                                 {"control_volume", fuzz_control_volume},
                                                 {"curve", fuzz_curve},
                                                 {"case_reader", fuzz_case_reader},
                                                 {"history", fuzz_history},
                                                 {"visibility", fuzz_visibility},
                                                 {"written_mesh", fuzz_written_mesh}};

constexpr std::size_t kLongest = 4096, kMostFaults = 6;
constexpr std::size_t kOneWhole = 10;  // of so many inputs of a longer seed file one is a copy of all of it

const std::vector<std::string> kTokens{
    "nan", "inf",  "-1",   "0", "1e999", "1e-320", "4294967296", "\r",
    "\n",  "\"\"", "= [ ", ",", "#",     "*PART",  "\xff\xfe",   std::string(1, '\0')};

class Faults {
 public:
  explicit Faults(std::vector<std::string> seeds) : seeds_(std::move(seeds)) {}

  std::string next() {
    std::string text = seeds_.empty() ? noise() : one_of(seeds_);
    if (text.size() > kLongest && below(kOneWhole) != 0)
      text = text.substr(below(2) == 0 ? 0 : below(text.size() - kLongest), kLongest);
    for (std::size_t n = 1 + below(kMostFaults); n > 0; --n) damage(text);
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }
  const std::string& one_of(const std::vector<std::string>& list) { return list[below(list.size())]; }
  std::string noise() {
    std::string bytes(1 + below(512), '\0');
    std::ranges::generate(bytes, [&] { return static_cast<char>(below(256)); });
    return bytes;
  }

  void damage(std::string& text) {
    const std::size_t at = below(text.size() + 1),
                      length = below(std::min<std::size_t>(text.size() - at, 64) + 1);
    const std::size_t digit = text.find_first_of("0123456789", at);
    switch (below(7)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 1:
        text.insert(at, one_of(kTokens));
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, text.substr(at, length));
        break;
      case 4:
        if (digit != std::string::npos) text[digit] = static_cast<char>('0' + below(10));
        break;
      case 5:
        if (digit != std::string::npos) text.replace(digit, 1, one_of(kTokens));
        break;
      default:
        text.resize(at);
    }
  }

  std::vector<std::string> seeds_;
  std::mt19937_64 random_{1};
};

std::string content(const char* file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) {
  const auto harness = argc > 3 ? kHarnesses.find(argv[1]) : kHarnesses.end();
  const long count = argc > 3 ? std::strtol(argv[2], nullptr, 10) : 0;
  if (harness == kHarnesses.end() || count < 1) {
    std::cerr << "usage: random_inputs HARNESS COUNT KEPT [SEED_FILE...]\n";
    return 2;
  }
  std::vector<std::string> seeds;
  for (int i = 4; i < argc; ++i) seeds.push_back(content(argv[i]));
  Faults faults(std::move(seeds));
  for (long i = 0; i < count; ++i) {
    const std::string input = faults.next();
    std::ofstream(argv[3], std::ios::binary) << input;
    harness->second(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
  }
  std::cout << argv[1] << ": " << count << " inputs, nothing found\n";
}

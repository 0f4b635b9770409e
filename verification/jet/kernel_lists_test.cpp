// SPDX-License-Identifier: Apache-2.0
// Kernels that project, list, merge and add up: parts against the whole, and loops that do the same one by
// one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "kernel_table.hpp"
#include "scenes.hpp"

namespace {

const jet::KernelTable* const kBothTables[] = {&jet::baseline::kTable, &jet::kernel_table()};

bool same(const jet::ProjectFlags& a, const jet::ProjectFlags& b) {
  return a.outside == b.outside && a.small == b.small && a.tiny == b.tiny;
}

/// Each is found by every kernel that projects, wherever it stands.
TEST(kernels, nodes_out_of_range_are_noticed) {
  const auto count = 21;
  const std::uint32_t rows[] = {0,  4,  8,  12, 16, 20, 24, 28, 32, 36, 40, 44,
                                48, 52, 56, 60, 64, 68, 72, 76, 80, 80, 80, 80};
  for (const jet::KernelTable* kernels : kBothTables) {
    for (int node = 0; node < count; ++node) {
      for (const double value : {1.5, static_cast<double>(NAN), 1e-120, -1e-120}) {
        Eigen::Matrix3Xd nodes = Eigen::Matrix3Xd::Constant(3, count, 0.5);
        nodes(node % 3, node) = value;
        const auto last = nodes.rightCols<1>();
        std::vector<float> local(4 * count + 32);
        std::vector<std::int32_t> codes(count + 8);
        jet::ProjectArrays a{{nodes.data(), 3, count - 1, {last[0], last[1], last[2], 0.0}},
                             count,
                             {},
                             {},
                             local.data(),
                             codes.data(),
                             nullptr,
                             nullptr,
                             {},
                             {},
                             rows};
        for (int i = 0; i < 3; ++i) a.column[i][i] = 1.0;
        const bool tiny = std::abs(value) < 1e-100;
        for (const jet::ProjectFlags& flags :
             {kernels->project_nodes(a), kernels->code_nodes(a), kernels->project_listed(a, 24)}) {
          EXPECT_EQ(flags.outside, !tiny);
          EXPECT_FALSE(flags.small);
        }
        for (const jet::ProjectFlags& flags : {kernels->project_nodes(a), kernels->code_nodes(a)})
          EXPECT_EQ(flags.tiny, tiny);
      }
    }
  }
}

/// Listed nodes, with rows of three and of four numbers behind the last of which there is nothing, and codes
/// alone are as those of all nodes.
TEST(kernels, listed_nodes_and_codes_eq_those_of_all) {
  const Eigen::Matrix3Xd nodes = scenes::crumpled(2, 0.05, 42).points();
  const auto count = static_cast<std::size_t>(nodes.cols());
  std::vector<double> padded;
  for (Eigen::Index i = 0; i < nodes.cols(); ++i)
    padded.insert(padded.end(), {nodes(0, i), nodes(1, i), nodes(2, i), NAN});
  const std::vector<double> four(padded.begin(), padded.end() - 1);
  const auto last = nodes.rightCols<1>();
  std::vector<float> whole(4 * count + 32), local(whole.size());
  std::vector<std::int32_t> codes(count + 8), sides(count + 8);
  std::vector<std::uint32_t> listed;  // every third node and the last
  for (std::size_t i = 0; i + 1 < count; i += 3) listed.push_back(static_cast<std::uint32_t>(4 * i));
  listed.resize(listed.size() / 8 * 8 + 8, static_cast<std::uint32_t>(4 * (count - 1)));
  jet::ProjectArrays a{{nodes.data(), 3, static_cast<int>(count) - 1, {last[0], last[1], last[2], 0.0}},
                       static_cast<int>(count),
                       {0.1, 0.02, 0.03},
                       {},
                       whole.data(),
                       codes.data(),
                       nullptr,
                       nullptr,
                       {-0.5f, 0.5f, -0.5f, 0.5f},
                       {0.1f, 0.1f, 0.1f, 0.1f, 0.1f},
                       listed.data()};
  for (int i = 0; i < 3; ++i) a.column[i][(i + 1) % 3] = 0.25;
  for (const jet::KernelTable* kernels : kBothTables) {
    a.local = whole.data();
    a.codes = codes.data();
    const jet::ProjectFlags flags = kernels->project_nodes(a);
    a.codes = sides.data();
    EXPECT_TRUE(same(kernels->code_nodes(a), flags));
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(sides[i], codes[i] & jet::kSides);
      EXPECT_EQ(std::memcmp(&codes[i], &whole[4 * i + 3], 4), 0);
    }
    a.local = local.data();
    for (const bool padded_rows : {false, true}) {
      a.nodes.first = padded_rows ? four.data() : nodes.data();
      a.nodes.stride = padded_rows ? 4 : 3;
      for (const std::size_t left_out : {8, 0}) {  // without the last node of all, and with it
        std::fill(local.begin(), local.end(), 0.0f);
        const std::span<const std::uint32_t> rows(listed.data(), listed.size() - left_out);
        EXPECT_TRUE(same(kernels->project_listed(a, static_cast<int>(rows.size())), flags));
        std::vector<float> expected(local.size());
        for (const std::uint32_t row : rows) std::memcpy(&expected[row], &whole[row], 16);
        EXPECT_EQ(std::memcmp(local.data(), expected.data(), 4 * local.size()), 0);
      }
    }
    a.nodes.first = nodes.data();
    a.nodes.stride = 3;
  }
}

TEST(kernels, bits_are_listed_in_order) {
  scenes::Random random(7);
  for (const std::size_t size : {32u, 64u, 1120u}) {  // the last beyond what is listed in one go
    for (const double share : {0.002, 0.1, 0.9}) {
      std::vector<std::uint8_t> bytes(size);
      std::vector<int> expected;
      for (int i = 0; i < static_cast<int>(8 * size); ++i) {
        if (0.5 * (random.vector(1.0).x() + 1.0) > share) continue;
        auto& byte = bytes[static_cast<std::size_t>(i / 8)];
        byte = static_cast<std::uint8_t>(byte | 1 << i % 8);
        expected.push_back(i);
      }
      for (const jet::KernelTable* kernels : kBothTables) {
        std::vector<int> places(expected.size() + 8);
        const int count = kernels->list_bits(bytes.data(), static_cast<int>(size), places.data());
        ASSERT_EQ(count, static_cast<int>(expected.size()));
        places.resize(expected.size());
        EXPECT_EQ(places, expected);
      }
    }
  }
}

TEST(kernels, merged_boxes_hold_eight_and_no_more) {
  scenes::Random random(8);
  for (const int count : {1, 2, 7, 8, 9, 24}) {
    const auto blocks = static_cast<std::size_t>(count);
    std::vector<float> boxes(jet::kBoxFloats * blocks);
    for (float& x : boxes) x = static_cast<float>(random.vector(1.0).x());
    for (const jet::KernelTable* kernels : kBothTables) {
      std::vector<float> merged(jet::kBoxFloats * ((blocks + 7) / 8));
      kernels->merge(boxes.data(), count, merged.data());
      for (std::size_t i = 0; i < blocks; ++i) {
        for (std::size_t row = 0; row < 5; ++row) {
          const auto first = boxes.begin() + static_cast<std::ptrdiff_t>(jet::kBoxFloats * i + 8 * row);
          const bool high = row == 1 || row == 3;
          EXPECT_EQ(merged[jet::kBoxFloats * (i / 8) + 8 * row + i % 8],
                    high ? *std::max_element(first, first + 8) : *std::min_element(first, first + 8))
              << count << ' ' << i << ' ' << row;
        }
      }
    }
  }
}

/// With rows of three and of four numbers, behind the last of which there is nothing, and in between NaN.
TEST(kernels, force_eq_sum_of_its_terms) {
  scenes::Random random(9);
  for (const int count : {1, 3, 4, 5, 8, 203}) {
    Eigen::Matrix3Xd areas(3, count);
    std::vector<double> overpressure;
    std::vector<int> elements;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), size = sum;
    for (int e = 0; e < count; ++e) {
      areas.col(e) = random.vector(1e-3);
      overpressure.push_back(1e5 * random.vector(1.0).x());
      if (e % 3 == 1 && e + 1 < count) continue;
      elements.push_back(e);
      sum += overpressure.back() * areas.col(e);
      size += (overpressure.back() * areas.col(e)).cwiseAbs();
    }
    const auto last = areas.col(count - 1);
    std::vector<double> four;
    for (int e = 0; e < count; ++e) four.insert(four.end(), {areas(0, e), areas(1, e), areas(2, e), NAN});
    four.pop_back();
    four.shrink_to_fit();
    const jet::Rows rows[2] = {{areas.data(), 3, count - 1, {last.x(), last.y(), last.z(), 0.0}},
                               {four.data(), 4, count - 1, {last.x(), last.y(), last.z(), 0.0}}};
    double bits[2][4];
    for (int i = 0; i < 2; ++i)
      kBothTables[i]->force(rows[i], overpressure.data(), elements.data(), static_cast<int>(elements.size()),
                            bits[i]);
    for (int j = 0; j < 3; ++j) {
      EXPECT_EQ(bits[0][j], bits[1][j]);
      // Each addition, here and there, errs by half a rounding of a partial sum.
      EXPECT_NEAR(bits[0][j], sum[j], count * std::numeric_limits<double>::epsilon() * size[j]);
    }
  }
}

/// Patches without any are left out; of the others, the chosen keep their boxes, and nothing overlaps the
/// rest.
TEST(kernels, chosen_boxes_keep_their_lanes) {
  const int patches[] = {9, 2, 5, 7, 0};
  const std::uint8_t chosen[10] = {0x80, 0xff, 0x05, 0xff, 0xff, 0, 0xff, 0xff, 0xff, 0x7e};
  std::vector<float> boxes(5 * jet::kBoxFloats), out(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = static_cast<float>(i);
  for (const jet::KernelTable* kernels : kBothTables) {
    int left[5] = {};
    ASSERT_EQ(kernels->choose_boxes({boxes.data(), patches, 5}, chosen, out.data(), left), 4);
    for (int k = 0, from = 0; k < 4; ++k, ++from) {
      if (chosen[patches[from]] == 0) ++from;
      EXPECT_EQ(left[k], patches[from]);
      for (int i = 0; i < jet::kBoxFloats; ++i) {
        const bool kept = (chosen[left[k]] >> i % 8 & 1) != 0, low = i / 8 % 2 == 0;
        const float none = low ? HUGE_VALF : -HUGE_VALF;
        EXPECT_EQ(out[static_cast<std::size_t>(k * jet::kBoxFloats + i)],
                  kept ? boxes[static_cast<std::size_t>(from * jet::kBoxFloats + i)] : none);
      }
    }
  }
}

}  // namespace

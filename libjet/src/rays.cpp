// SPDX-License-Identifier: Apache-2.0
#include "rays.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "checks.hpp"

namespace jet {
namespace {

constexpr std::size_t kMostAside = 64;  // more of them are quicker in a tree
constexpr float kSteepest = 1e3f;       // steeper bounds keep out too little to be worth their margin
constexpr double kLargestRatio =
    1e5;                          // coordinates over extent: sources lie beside their line by 4e-16 of it
constexpr double kMargin = 1e-6;  // 16 times the error of local coordinates
constexpr std::uint8_t kFloor = 0x80;
constexpr double kStepsAhead = 6.0;  // motion that the choice of close patches is made for

double extent(const Surface& surface, const Eigen::Vector3d& centre) {
  double largest = 0.0;
  for (int i = 0; i < surface.node_count; ++i) {
    const double* x = surface.node(i);
    largest = std::max(largest, (Eigen::Vector3d(x[0], x[1], x[2]) - centre).squaredNorm());
  }
  return std::sqrt(largest);
}

}  // namespace

void RayBundle::reserve(const OrderedMesh& mesh, std::size_t element_count, std::size_t node_count) {
  mesh_ = &mesh;
  boxes_.reserve(element_count);
  aside.reserve(kMostAside);
  local_.resize(4 * (node_count + 8));
  local_targets_.resize(4 * (element_count + 8));
  codes_.resize(node_count + 8);
  aside_bits_.resize(element_count / 8 + 1);
  made_.resize(element_count);
  sorted_.resize(element_count);
  given.resize(element_count);
  given_at_.resize(element_count);
  chosen_.resize(element_count / 64 + 1);
  is_made_.resize(element_count);
  close_.reserve(mesh, node_count);
  all_.resize(static_cast<std::size_t>(mesh.patches));
  std::iota(all_.begin(), all_.end(), 0);
}

bool RayBundle::build(const Surface& surface, const RaySource& source, std::span<const int> as_given,
                      double travelled) {
  surface_ = surface;
  source_ = &source;
  step_ = travelled - travelled_;
  travelled_ = travelled;
  if (!(step_ >= 0.0)) close_.forget();
  sort(as_given);
  std::fill_n(is_made_.begin(), candidates.size(), std::uint8_t{0});
  const double centre = source.centre.cwiseAbs().maxCoeff();
  if (frame_.build(source)) {
    if (scale_ == 0.0) rescale();
    if (!project()) {
      rescale();
      project();
    }
    size = centre + 1.8 / scale_;  // the square root of 3, and the frame's roundings
    const bool within = size <= kLargest && size * scale_ <= kLargestRatio && !flags_.outside;
    if (within && aside.size() <= kMostAside && aside.size() < candidates.size()) return true;
  }
  const double reach =
      source.half_long == 0.0 ? 0.0 : source.half_long * source.long_direction.cwiseAbs().maxCoeff();
  size = std::max(check_nodes(surface), centre + reach);
  return false;
}

// Candidates in the mesh's order; as given if one is named twice.
void RayBundle::sort(std::span<const int> as_given) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < as_given.size(); ++k) {
    const auto i = static_cast<std::size_t>(mesh_->rank[static_cast<std::size_t>(as_given[k])]);
    chosen_[i / 64] |= std::uint64_t{1} << i % 64;
    given_at_[i] = static_cast<int>(k);
  }
  for (std::size_t word = 0; word < chosen_.size(); ++word) {
    for (std::uint64_t bits = std::exchange(chosen_[word], 0); bits != 0; bits &= bits - 1) {
      const std::size_t i = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
      sorted_[count] = mesh_->elements[i];
      given[count++] = given_at_[i];
    }
  }
  candidates = std::span<const int>(sorted_).first(count);
  if (count == as_given.size()) return;
  candidates = as_given;
  std::iota(given.begin(), given.end(), 0);
}

// A scale that keeps the nodes and the sources within 1/2, with room to move. The magnitude of a refused node
// is not known, so this is where all of them are looked at.
void RayBundle::rescale() {
  close_.forget();
  check_nodes(surface_);
  const double largest = std::max({extent(surface_, source_->centre), source_->half_long, 1e-150});
  scale_ = std::ldexp(1.0, -std::ilogb(largest) - 2);
}

// False where the scale does not fit the nodes any more, or one of them is to be refused.
bool RayBundle::project() {
  const KernelTable& kernels = kernel_table();
  const int last = surface_.node_count - 1;
  const double* x = surface_.node(last);
  arrays_ = {{surface_.nodes, surface_.stride, last, {x[0], x[1], x[2], 0.0}},
             surface_.node_count,
             {},
             {},
             local_targets_.data(),
             surface_.triangles->data(),
             candidates.data(),
             codes_.data(),
             {},
             {},
             nullptr};
  for (int i = 0; i < 3; ++i) {
    arrays_.centre[i] = source_->centre[i];
    const Eigen::Vector3d* const axes[] = {&frame_.across, &frame_.along, &frame_.forward};
    for (int j = 0; j < 3; ++j) arrays_.column[i][j] = scale_ * (*axes[j])[i];
  }
  kernels.project_centroids(arrays_, static_cast<int>(candidates.size()));
  rays_ = {local_targets_.data(), static_cast<float>(scale_ * source_->half_long), boxes_.boxes()};
  bounds_ = kernels.make_rays(rays_, static_cast<int>(candidates.size()), aside_bits_.data());
  find_aside(candidates.size());
  arrays_.local = local_.data();
  return project_nodes();
}

// Of all nodes, or of those close to the rays.
bool RayBundle::project_nodes() {
  const KernelTable& kernels = kernel_table();
  if (!close_.holds(*source_, scale_, bounds_, travelled_)) {
    close_.forget();
    const double reach = kStepsAhead * step_;
    if (reach >= 0.0 && !choose_close(reach)) return false;
  }
  set_sides(bounds_);
  if (close_.any()) {
    arrays_.listed = close_.nodes().data();
    flags_ = kernels.project_listed(arrays_, static_cast<int>(close_.nodes().size()));
    return !flags_.outside && !flags_.tiny;
  }
  flags_ = kernels.project_nodes(arrays_);
  return !flags_.outside && !flags_.small && !flags_.tiny;
}

// Patches that can come between the rays' wider bounds while nodes move by `reach` [m].
bool RayBundle::choose_close(double reach) {
  const RayBounds wide = CloseSet::widened(bounds_);
  set_sides(wide, 1.001 * scale_ * reach);
  flags_ = kernel_table().project_nodes(arrays_);
  if (flags_.outside || flags_.small || flags_.tiny) return false;
  constexpr unsigned sides = 0x1f;  // what is in the sources' plane now may rise from it
  close_.choose(*source_, scale_, wide, travelled_, reach,
                [&](int* patches) { return find_patches(all_, sides, patches); });
  return true;
}

void RayBundle::find_aside(std::size_t count) {
  aside.clear();
  for (std::size_t b = 0; b < (count + 7) / 8; ++b) {
    for (unsigned bits = aside_bits_[b]; bits != 0; bits &= bits - 1u) {
      if (aside.size() > kMostAside) return;
      aside.push_back(static_cast<std::uint32_t>(8 * b) + static_cast<std::uint32_t>(__builtin_ctz(bits)));
    }
  }
}

void RayBundle::set_side(int bit, double slope, double bound, double reach) {
  const bool steep = !(std::abs(slope) <= static_cast<double>(kSteepest));
  arrays_.slope[bit] = steep ? 0.0f : static_cast<float>(slope);
  arrays_.bound[bit] =
      steep ? HUGE_VALF
            : static_cast<float>(bound + kMargin * (1.0 + std::abs(slope)) + reach * std::hypot(1.0, slope));
}

// Half-spaces that hold all rays not aside, beyond their targets, too, and what is within `reach` of them.
void RayBundle::set_sides(const RayBounds& bounds, double reach) {
  set_side(0, bounds.low_u, 0.0, reach);
  set_side(1, bounds.high_u, 0.0, reach);
  set_side(2, frame_.line ? 0.0 : bounds.low_v, frame_.line ? -bounds.low_v : 0.0, reach);
  set_side(3, frame_.line ? 0.0 : bounds.high_v, frame_.line ? bounds.high_v : 0.0, reach);
  set_side(4, 0.0, 0.0, reach);
  // What is not above the sources' own plane meets no ray: a source on it starts above, by eps.
  outside_ = 0x1fu | (frame_.aligned() ? kFloor : 0u);
}

int RayBundle::find_patches(int* patches) const {
  return find_patches(close_.any() ? close_.patches() : all_, outside_, patches);
}

int RayBundle::find_patches(std::span<const int> among, unsigned all_outside, int* patches) const {
  const std::uint8_t* codes = codes_.data();
  const int *nodes = mesh_->patch_nodes.data(), *begin = mesh_->patch_begin.data();
  int count = 0;
  for (const int patch : among) {
    unsigned outside = all_outside;
    for (const int *node = nodes + begin[patch], *end = nodes + begin[patch + 1]; node < end; node += 4)
      outside &= static_cast<unsigned>(codes[node[0]] & codes[node[1]] & codes[node[2]] & codes[node[3]]);
    patches[count] = patch;  // kept if the next does not overwrite it: no branch to predict
    count += outside == 0;
  }
  return count;
}

const blocking::Ray& RayBundle::ray(std::size_t k) const {
  if (is_made_[k] == 0) {
    is_made_[k] = 1;
    made_[k] = blocking::make_ray(surface_, candidates[k], *source_);
    made_[k].moved = blocking::Moved::unknown;
  }
  return made_[k];
}

// A general slope within the bounds: bags are symmetric about the axis. Local coordinates of the end are
// above 1.
RayBundle::Way RayBundle::way() const {
  std::size_t first = 0;
  while (first < aside.size() && aside[first] == first) ++first;
  Way way{this->ray(first), {}};
  way.ray.moved = blocking::Moved::yes;
  const auto within = [](float low, float high, double share) {
    const double a = std::clamp(low, -kSteepest, kSteepest), b = std::clamp(high, -kSteepest, kSteepest);
    return a + share * (b - a);
  };
  const double u = within(bounds_.low_u, bounds_.high_u, 0.382);
  const double v = frame_.line ? 0.0 : within(bounds_.low_v, bounds_.high_v, 0.618);
  for (int i = 0; i < 3; ++i)
    way.ray.target[i] =
        way.ray.source[i] + 2.0 / scale_ * (frame_.forward[i] + u * frame_.across[i] + v * frame_.along[i]);
  const Eigen::Map<const Eigen::Vector3d> from(way.ray.source);
  way.line[0] = static_cast<float>(u);
  way.line[1] = static_cast<float>(v);
  way.line[2] = frame_.line ? static_cast<float>(scale_ * (from - source_->centre).dot(frame_.along)) : 0.0f;
  return way;
}

}  // namespace jet

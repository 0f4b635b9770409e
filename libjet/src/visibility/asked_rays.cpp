// SPDX-License-Identifier: Apache-2.0
#include "visibility/asked_rays.hpp"

#include <algorithm>
#include <bit>

#include "bits.hpp"
#include "kernel_table.hpp"

namespace jet {

void AskedRays::reserve(const OrderedMesh& mesh, std::size_t patches) {
  mesh_ = &mesh;
  const std::size_t elements = 8 * patches;
  given_.reserve(elements);
  asked_.resize(patches);
  outside_.resize(patches);
  listed_.resize(elements + 8);
  made_.resize(elements);
  is_made_.resize(elements);
  made_places_.reserve(elements);
}

void AskedRays::ask(const Surface& surface, const RaySource& source, std::span<const int> candidates) {
  surface_ = surface;
  source_ = &source;
  given_.resize(candidates.size());
  std::fill(asked_.begin(), asked_.end(), std::uint8_t{0});
  const int* rank = mesh_->rank.data();  // local, so that the bytes written cannot change it
  int* given = given_.data();
  std::uint8_t* asked = asked_.data();
  for (const int element : candidates) {
    const auto place = static_cast<unsigned>(rank[element]);
    *given++ = static_cast<int>(place);
    asked[place / 8] = static_cast<std::uint8_t>(asked[place / 8] | 1u << place % 8);
  }
  patches_ = count_used(asked_);
  for (const int place : made_places_) is_made_[static_cast<std::size_t>(place)] = 0;
  made_places_.clear();
}

std::size_t AskedRays::count() const {
  std::size_t count = 0;
  for (const std::uint8_t bits : asked_) count += static_cast<std::size_t>(std::popcount(bits));
  return count;
}

const blocking::Ray& AskedRays::ray(int place) const {
  const auto i = static_cast<std::size_t>(place);
  if (is_made_[i] == 0) {
    is_made_[i] = 1;
    made_places_.push_back(place);
    made_[i] = blocking::make_ray(surface_, mesh_->elements[i], *source_);
    made_[i].moved = blocking::Moved::unknown;
  }
  return made_[i];
}

std::span<const int> AskedRays::list_outside(std::span<const int> patches) {
  outside_ = asked_;
  for (const int patch : patches) outside_[static_cast<std::size_t>(patch)] = 0;
  const int count =
      kernel_table().list_bits(outside_.data(), static_cast<int>(outside_.size()), listed_.data());
  return std::span(listed_).first(static_cast<std::size_t>(count));
}

}  // namespace jet

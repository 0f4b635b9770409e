// SPDX-License-Identifier: Apache-2.0
#include "embree_visibility.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace benchmarks {

struct EmbreeVisibility::Impl {
  RTCDevice device;
  RTCScene scene;
  RTCGeometry geometry;
  float* vertices;
};

EmbreeVisibility::EmbreeVisibility(const Eigen::Matrix3Xi& triangles, int node_count,
                                   const jet::SurfaceRoles& roles)
    : impl_(new Impl) {
  std::vector<std::uint8_t> left_out(static_cast<std::size_t>(triangles.cols()), 0);
  for (const int e : roles.null_elements) left_out[static_cast<std::size_t>(e)] = 1;
  for (const int e : roles.attachment_elements) left_out[static_cast<std::size_t>(e)] = 1;
  const auto blockers = static_cast<std::size_t>(std::count(left_out.begin(), left_out.end(), 0));
  impl_->device = rtcNewDevice("threads=1");
  if (impl_->device == nullptr) throw std::runtime_error("no Embree device");
  impl_->scene = rtcNewScene(impl_->device);
  rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_DYNAMIC);
  impl_->geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetGeometryBuildQuality(impl_->geometry, RTC_BUILD_QUALITY_REFIT);
  impl_->vertices = static_cast<float*>(rtcSetNewGeometryBuffer(impl_->geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                                RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                                static_cast<std::size_t>(node_count)));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      impl_->geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), blockers));
  for (Eigen::Index e = 0; e < triangles.cols(); ++e)
    if (left_out[static_cast<std::size_t>(e)] == 0)
      for (int i = 0; i < 3; ++i) *indices++ = static_cast<unsigned>(triangles(i, e));
  rtcAttachGeometry(impl_->scene, impl_->geometry);
}

EmbreeVisibility::~EmbreeVisibility() {
  rtcReleaseGeometry(impl_->geometry);
  rtcReleaseScene(impl_->scene);
  rtcReleaseDevice(impl_->device);
  delete impl_;
}

void EmbreeVisibility::refit(const Eigen::Matrix3Xd& nodes) {
  const double* from = nodes.data();
  for (Eigen::Index i = 0; i < nodes.size(); ++i) impl_->vertices[i] = static_cast<float>(from[i]);
  rtcUpdateGeometryBuffer(impl_->geometry, RTC_BUFFER_TYPE_VERTEX, 0);
  rtcCommitGeometry(impl_->geometry);
  rtcCommitScene(impl_->scene);
}

void EmbreeVisibility::query(const jet::RaySource& source, const Eigen::Matrix3Xd& area_vectors,
                             const Eigen::Matrix3Xd& centroids, std::span<const int> candidates,
                             std::span<std::uint8_t> lit) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const Eigen::Vector3d target = centroids.col(candidates[k]);
    const double along = (target - source.centre).dot(source.long_direction);
    const Eigen::Vector3d start =
        source.centre + std::clamp(along, -source.half_long, source.half_long) * source.long_direction;
    const Eigen::Vector3d way = target - start;
    lit[k] = 0;
    if (!(area_vectors.col(candidates[k]).dot(way) > 0.0)) continue;
    RTCRay ray{};
    ray.org_x = static_cast<float>(start.x()), ray.org_y = static_cast<float>(start.y());
    ray.org_z = static_cast<float>(start.z());
    ray.dir_x = static_cast<float>(way.x()), ray.dir_y = static_cast<float>(way.y());
    ray.dir_z = static_cast<float>(way.z());
    ray.tnear = 1e-4F, ray.tfar = 1.0F - 1e-4F;
    ray.mask = std::numeric_limits<unsigned>::max();
    rtcOccluded1(impl_->scene, &context, &ray);
    lit[k] = ray.tfar < 0.0F ? 0 : 1;
  }
}

}  // namespace benchmarks

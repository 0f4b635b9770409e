/// A cylinder with round ends about the origin, along an axis of length 1, as a bar across a pendulum.
struct Capsule {
  double radius = 0.0;        // [m] > 0
  double half_length = 0.15;  // [m] of the axis between the ends' centres
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();

  double size() const { return radius; }

  Eigen::Vector3d from_axis(const Eigen::Vector3d& point) const {
    return point - std::clamp(point.dot(axis), -half_length, half_length) * axis;
  }

  std::optional<Depth> depth(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d outward = from_axis(point);
    const double distance = outward.norm();
    if (!(distance < radius)) return std::nullopt;
    return Depth{radius - distance, distance, outward};
  }

  // Balls along the axis: no point of it is farther than `apart` from the next centre.
  double distance_to_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                              const Eigen::Vector3d& c) const {
    constexpr int kBalls = 16;
    const double apart = half_length / kBalls;
    double least = std::numeric_limits<double>::infinity();
    for (int i = -kBalls + 1; i < kBalls; i += 2)
      least = std::min(least, coupling::distance_to_triangle(i * apart * axis, a, b, c));
    return least - apart - radius;
  }

  double distance_to_ball(const Eigen::Vector3d& point, double reach) const {
    return (1.0 - 1e-12) * from_axis(point).norm() - reach - radius;
  }

  double distance_to_box(const Eigen::Array3d& low, const Eigen::Array3d& high) const {
    return distance_to_ball(0.5 * (low + high), 0.5 * (high - low).matrix().norm());
  }

  std::optional<Stretch> inside(const Eigen::Vector3d& start, const Eigen::Vector3d& step) const {
    return Sphere{radius + half_length}.inside(start, step);
  }
};


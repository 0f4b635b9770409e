// A brick with round edges, in its own axes: all points within a radius of a box.
struct Block {
  static constexpr const char* kSizeName = "the brick's radius";
  Eigen::Vector3d half_sides;  // [m]

  double reach() const { return half_sides.norm(); }
  Eigen::Array3d box() const { return half_sides; }
  double section(double radius) const { return std::numbers::pi * (reach() + radius) * (reach() + radius); }
  Eigen::Vector3d nearest(const Eigen::Vector3d& point) const {
    return point.cwiseMax(-half_sides).cwiseMin(half_sides);
  }
  Eigen::Vector3d farthest(const Eigen::Vector3d& direction) const {
    Eigen::Vector3d corner;
    for (int i = 0; i < 3; ++i) corner[i] = std::copysign(half_sides[i], direction[i]);
    return corner;
  }
};

inline Rounded<Block> body_of(const Brick& brick) { return {{brick.half_sides}, brick.radius}; }


// SPDX-License-Identifier: Apache-2.0
// The only file of the driver that includes CGAL: headers under the LGPL.
#include "soup.hpp"

#define CGAL_DEBUG  // its readers check files by assertions, which now throw
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <limits>
#include <new>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "mesh/fill.hpp"

namespace driver {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

// Corners of a polygon, of limited number, so that a damaged count does no harm.
class Corners : public std::vector<std::size_t> {
 public:
  void resize(std::size_t count) {
    if (count > mesh::kMostCorners)
      throw std::length_error("an element of " + std::to_string(count) + " corners, allowed: 3 to " +
                              std::to_string(mesh::kMostCorners));
    std::vector<std::size_t>::resize(count);
  }
};

bool read(SoupFormat format, std::istream& bytes, std::vector<Point>& points,
          std::vector<Corners>& polygons) {
  const auto quiet = CGAL::parameters::verbose(false);
  if (format == SoupFormat::stl) return CGAL::IO::read_STL(bytes, points, polygons, quiet);
  return CGAL::IO::read_PLY(bytes, points, polygons, quiet);
}

// Invalid numbers remain invalid.
int node_number(std::size_t corner) {
  constexpr auto most = static_cast<std::size_t>(std::numeric_limits<int>::max());
  return corner > most ? -1 : static_cast<int>(corner);
}

}  // namespace

Soup read_soup(SoupFormat format, const std::string& bytes) {
  Soup soup;
  soup.is_text = format == SoupFormat::ply && bytes.find("format ascii") < 64;
  std::vector<Point> points;
  std::vector<Corners> polygons;
  std::istringstream stream(bytes);
  // Failed assertions throw without a message on the screen.
  const auto before = CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  try {
    if (!read(format, stream, points, polygons))
      soup.fault = "this is not a number or not a vertex of the file, or the file ends";
  } catch (const std::length_error& error) {
    soup.fault = error.what();
  } catch (const std::bad_alloc&) {
    soup.fault = "a count is beyond all memory";
  } catch (const CGAL::Failure_exception&) {
    soup.fault = "this does not match the format";
  }
  CGAL::set_error_handler(before);
  stream.clear();
  soup.stopped_at = static_cast<std::size_t>(std::max<std::streamoff>(stream.tellg(), 0));
  if (!soup.fault.empty()) return soup;
  soup.nodes.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t n = 0; n < points.size(); ++n)
    soup.nodes.col(static_cast<Eigen::Index>(n)) << points[n].x(), points[n].y(), points[n].z();
  for (const Corners& polygon : polygons) {
    std::vector<int> corners;
    for (const std::size_t corner : polygon) corners.push_back(node_number(corner));
    soup.polygons.push_back(std::move(corners));
  }
  return soup;
}

}  // namespace driver

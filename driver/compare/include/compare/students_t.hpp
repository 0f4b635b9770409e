// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <boost/math/distributions/students_t.hpp>

namespace driver {

/// Student's distribution in doubles. Boost's default is long double, for which it computes as the program
/// starts: under valgrind, which has no such numbers, that would end it.
using StudentsT = boost::math::students_t_distribution<
    double, boost::math::policies::policy<boost::math::policies::promote_double<false>>>;

}  // namespace driver

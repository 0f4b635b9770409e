// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <boost/math/distributions/students_t.hpp>

namespace driver {

/// Student's distribution in doubles. Boost's default, long double, would end the program under valgrind,
/// which does not support it.
using StudentsT = boost::math::students_t_distribution<
    double, boost::math::policies::policy<boost::math::policies::promote_double<false>>>;

}  // namespace driver

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gsl/gsl_bspline.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_matrix.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_vector.h>

#include <memory>
#include <new>

#include "gas/error.hpp"

/// Owners of GSL objects.
namespace gas::gsl {

template <auto Free>
struct Release {
  template <typename T>
  void operator()(T* object) const {
    Free(object);
  }
};
using Matrix = std::unique_ptr<gsl_matrix, Release<gsl_matrix_free>>;
using Vector = std::unique_ptr<gsl_vector, Release<gsl_vector_free>>;
using Spline = std::unique_ptr<gsl_bspline_workspace, Release<gsl_bspline_free>>;
using Generator = std::unique_ptr<gsl_rng, Release<gsl_rng_free>>;

template <typename T>
T* allocated(T* object) {
  if (!object) throw std::bad_alloc();
  return object;
}
inline Matrix matrix(std::size_t rows, std::size_t columns) {
  return Matrix(allocated(gsl_matrix_calloc(rows, columns)));
}
inline Vector vector(std::size_t size) {
  return Vector(allocated(gsl_vector_calloc(size)));
}

/// While this lives, GSL functions return error codes. GSL's own handler would end the process.
class ReturnCodes {
 public:
  ReturnCodes() : previous_(gsl_set_error_handler_off()) {}
  ~ReturnCodes() { gsl_set_error_handler(previous_); }
  ReturnCodes(const ReturnCodes&) = delete;
  ReturnCodes& operator=(const ReturnCodes&) = delete;

 private:
  gsl_error_handler_t* previous_;
};

inline void check(int code, const char* what) {
  if (code != GSL_SUCCESS)
    throw DomainError(std::string("smoothing spline: ") + what + ": " + gsl_strerror(code));
}

}  // namespace gas::gsl

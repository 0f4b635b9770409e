// SPDX-License-Identifier: Apache-2.0
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <stdexcept>

#include "gas_peers.hpp"

namespace peers {
namespace {

int rates(realtype t, N_Vector y, N_Vector dydt, void* data) {
  const auto& stretch = *static_cast<const second_route::Stretch*>(data);
  const auto n = static_cast<std::size_t>(NV_LENGTH_S(y));
  try {
    second_route::rates(stretch, t, {NV_DATA_S(y), n}, {NV_DATA_S(dydt), n});
  } catch (const std::exception&) {
    return 1;  // recoverable: a smaller step
  }
  return 0;
}

/// What CVODE would print is in the error.
void silent(int, const char*, const char*, char*, void*) {}

void require(bool ok) {
  if (!ok) throw std::runtime_error("CVODE failed");
}

/// y from the begin of the stretch to its end.
void integrate(second_route::Stretch& stretch, double tolerance, N_Vector y, SUNContext context) {
  const auto n = NV_LENGTH_S(y);
  const std::vector<double> scale = second_route::scales(stretch.tank);
  N_Vector absolute = N_VClone(y);
  for (sunindextype i = 0; i < n; ++i) NV_Ith_S(absolute, i) = tolerance * scale[static_cast<std::size_t>(i)];
  void* memory = CVodeCreate(CV_BDF, context);
  SUNMatrix matrix = SUNDenseMatrix(n, n, context);
  SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
  CVodeInit(memory, rates, stretch.begin, y);
  CVodeSVtolerances(memory, tolerance, absolute);
  CVodeSetUserData(memory, &stretch);
  CVodeSetMaxNumSteps(memory, 1000000);
  CVodeSetErrHandlerFn(memory, silent, nullptr);
  CVodeSetLinearSolver(memory, solver, matrix);
  CVodeSetStopTime(memory, stretch.end);
  realtype reached = stretch.begin;
  const int status = CVode(memory, stretch.end, y, &reached, CV_NORMAL);
  CVodeFree(&memory);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  N_VDestroy(absolute);
  require(status >= 0);
}

}  // namespace

std::vector<gas::ControlVolumeState> cvode(const second_route::Tank& tank, double tolerance) {
  SUNContext context = nullptr;
  require(SUNContext_Create(nullptr, &context) == 0);
  const std::vector<double> start = second_route::unknowns(tank.start);
  N_Vector y = N_VNew_Serial(static_cast<sunindextype>(start.size()), context);
  std::copy(start.begin(), start.end(), NV_DATA_S(y));
  std::vector<gas::ControlVolumeState> states;
  double begin = 0.0;
  for (const double end : tank.stops) {
    second_route::Stretch stretch{tank, begin, end};
    integrate(stretch, tolerance, y, context);
    states.push_back(second_route::state_of(tank, {NV_DATA_S(y), start.size()}));
    begin = end;
  }
  N_VDestroy(y);
  SUNContext_Free(&context);
  return states;
}

}  // namespace peers

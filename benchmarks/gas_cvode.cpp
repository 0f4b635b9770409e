// SPDX-License-Identifier: Apache-2.0
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gas_peers.hpp"

namespace peers {
namespace {

struct Problem {
  const second_route::VentedTank& tank;
  double latest;  // [s] the inflow ends as a jump: times behind are taken from before it
};

int rates(realtype t, N_Vector y, N_Vector dydt, void* data) {
  const auto& problem = *static_cast<const Problem*>(data);
  const auto n = static_cast<std::size_t>(NV_LENGTH_S(y));
  try {
    second_route::rates(problem.tank, std::min(t, problem.latest), {NV_DATA_S(y), n}, {NV_DATA_S(dydt), n});
  } catch (const std::exception&) {
    return 1;  // recoverable: a smaller step
  }
  return 0;
}

void require(bool ok) {
  if (!ok) throw std::runtime_error("CVODE failed");
}

/// y from `begin` to `end`.
void integrate(Problem& problem, double begin, double end, double tolerance, N_Vector y, SUNContext context) {
  const auto n = NV_LENGTH_S(y);
  N_Vector absolute = N_VClone(y);
  // As the relative ones, of 0.1 kg and 1e5 J.
  for (sunindextype i = 0; i < n; ++i) NV_Ith_S(absolute, i) = tolerance * (i + 1 < n ? 0.1 : 1e5);
  void* memory = CVodeCreate(CV_BDF, context);
  SUNMatrix matrix = SUNDenseMatrix(n, n, context);
  SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
  CVodeInit(memory, rates, begin, y);
  CVodeSVtolerances(memory, tolerance, absolute);
  CVodeSetUserData(memory, &problem);
  CVodeSetMaxNumSteps(memory, 1000000);
  CVodeSetLinearSolver(memory, solver, matrix);
  CVodeSetStopTime(memory, end);
  realtype reached = begin;
  const int status = CVode(memory, end, y, &reached, CV_NORMAL);
  CVodeFree(&memory);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  N_VDestroy(absolute);
  require(status >= 0);
}

}  // namespace

gas::ControlVolumeState cvode(const second_route::VentedTank& tank, double tolerance) {
  SUNContext context = nullptr;
  require(SUNContext_Create(nullptr, &context) == 0);
  const std::size_t n = tank.start.masses.size() + 1;
  N_Vector y = N_VNew_Serial(static_cast<sunindextype>(n), context);
  std::copy(tank.start.masses.begin(), tank.start.masses.end(), NV_DATA_S(y));
  NV_DATA_S(y)[n - 1] = tank.start.internal_energy;
  Problem filling{tank, second_route::kFilled}, held{tank, second_route::kEnd};
  integrate(filling, 0.0, second_route::kFilled, tolerance, y, context);
  integrate(held, std::nextafter(second_route::kFilled, 1.0), second_route::kEnd, tolerance, y, context);
  const std::vector<double> masses(NV_DATA_S(y), NV_DATA_S(y) + n - 1);
  const double energy = NV_DATA_S(y)[n - 1];
  N_VDestroy(y);
  SUNContext_Free(&context);
  return {masses, energy,
          tank.model.thermo.temperature_from_internal_energy(masses, energy, tank.start.temperature), {}};
}

}  // namespace peers

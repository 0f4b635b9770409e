// SPDX-License-Identifier: Apache-2.0
/*
 * Gasjet for C, C++ and Fortran: plain arrays with sizes and strides, SI units.
 *
 * Every function returns a gasjet_status. If that is not GASJET_OK, gasjet_last_error() says what is wrong
 * and what is allowed, as `argument: what, allowed`; outputs are then untouched unless a function says
 * otherwise. No exception leaves a function. Functions may be called from any thread; one handle that changes
 * serves one thread at a time.
 *
 * A function computes in the default floating-point environment and leaves the caller's as it was: traps,
 * rounding and flags. Callbacks run in the caller's.
 *
 * `x[]` is an array, `*x` one value. Pointers marked GASJET_OR_NULL may be NULL, all others not. Arrays are
 * read and written during the call only. Vectors come as rows of three doubles; `stride` has two numbers of
 * doubles, from one row to the next and from one component to the next, NULL for {3, 1}; so triangles have
 * rows of three node numbers from 0. A Fortran array (3, n) has the stride {3, 1}, an array (n, 3) {1, n}.
 */
#ifndef GASJET_H
#define GASJET_H

#include <gasjet/base.h>
#include <gasjet/coupling.h>
#include <gasjet/gas.h>
#include <gasjet/jet.h>
#include <gasjet/membrane.h>
#include <gasjet/run.h>
#include <gasjet/simulation.h>

#endif

// SPDX-License-Identifier: Apache-2.0
/* Closed forms by name: like the command `gasjet exact`. This is a shared library of its own, because it
 * links GSL: a program that links it falls under the GPL, version 3 or later. Conventions as in gasjet.h,
 * but with its own handles, which gasjet.h refuses, and its own last error. */
#ifndef GASJET_EXACT_H
#define GASJET_EXACT_H

#include <gasjet/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Why the last function of gasjet_exact in this thread failed. */
GASJET_API const char* gasjet_exact_last_error(void);

/* All closed forms as JSON: an array of objects with name, title, equation, source, validity, digits,
 * family, columns and parameters (name, symbol, unit, meaning, default). Sizes as in gasjet_run_summary. */
GASJET_API int gasjet_exact_catalogue(char GASJET_OR_NULL text[], int64_t size, int64_t* needed);

/* Evaluates the form `name`. parameters: lines `name=value`. times: abscissae; NULL with count 0 means the
 * form's own. */
GASJET_API int gasjet_exact_create(const char* name, const char* GASJET_OR_NULL parameters,
                                   const double GASJET_OR_NULL times[], int64_t count, gasjet_handle* table);

/* Its columns and rows. */
GASJET_API int gasjet_exact_size(gasjet_handle table, int64_t* columns, int64_t* rows);

/* Name of a column, numbered from 0, with its unit as suffix. text has `size` bytes. */
GASJET_API int gasjet_exact_name(gasjet_handle table, int64_t column, char text[], int64_t size);

/* Values of a column. They belong to the table and are valid until it is freed. */
GASJET_API int gasjet_exact_column(gasjet_handle table, int64_t column, const double** values);

/* Frees a table. */
GASJET_API int gasjet_exact_free(gasjet_handle table);

#ifdef __cplusplus
}
#endif
#endif

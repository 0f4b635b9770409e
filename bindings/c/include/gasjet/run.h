// SPDX-License-Identifier: Apache-2.0
/* Whole runs and the comparison of histories, like the commands `gasjet run` and `gasjet compare`. */
#ifndef GASJET_RUN_H
#define GASJET_RUN_H

#include <gasjet/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Called at the start, at the end, and some ten times a second in between, with the run's time and its end
 * [s]. A result other than 0 stops the run. */
typedef int (*gasjet_progress)(double time, double end, void* user);

enum gasjet_table { GASJET_HISTORY = 0, GASJET_ENERGY = 1 };

/* Runs a case. case_file: its path. case_text: the case itself in TOML, or NULL; with it, the path is only
 * used in messages and to find the files that the case names. overrides: lines `key.path=value` or `unset
 * key.path`. out: folder for the command's result files, or NULL. threads: 1 to 1024; results do not
 * depend on it. After GASJET_DOMAIN and GASJET_STOPPED `run` has the results so far. */
GASJET_API int gasjet_run(const char* case_file, const char* GASJET_OR_NULL case_text,
                          const char* GASJET_OR_NULL overrides, const char* GASJET_OR_NULL out, int threads,
                          gasjet_progress GASJET_OR_NULL progress, void* GASJET_OR_NULL user,
                          gasjet_handle* run);

/* Columns and rows of a table (gasjet_table). */
GASJET_API int gasjet_run_size(gasjet_handle run, int table, int64_t* columns, int64_t* rows);

/* Name of a column, numbered from 0, with its unit as suffix. text has `size` bytes. */
GASJET_API int gasjet_run_name(gasjet_handle run, int table, int64_t column, char text[], int64_t size);

/* Values of a column, one per row. They belong to the run and are valid until it is freed. */
GASJET_API int gasjet_run_column(gasjet_handle run, int table, int64_t column, const double** values);

/* The same by name. */
GASJET_API int gasjet_run_find(gasjet_handle run, int table, const char* name, const double** values);

/* summary.json of the run, with its "warnings". text has `size` bytes; `needed` gets the size that is
 * needed. Pass NULL with size 0 to get only `needed`. If `size` is too small, the result is
 * GASJET_BAD_INPUT, and only `needed` is set. */
GASJET_API int gasjet_run_summary(gasjet_handle run, char GASJET_OR_NULL text[], int64_t size,
                                  int64_t* needed);

enum gasjet_verdict { GASJET_INSIDE = 0, GASJET_OUTSIDE = 1, GASJET_UNDECIDED = 4 };

/* Judges the history file `mine` by the band of `reference`. map: file that names a foreign program's
 * columns. columns: quantities to compare, separated by commas; NULL: all. tolerance [-] >= 0: share of
 * each quantity's peak, added to the bands. verdict: gasjet_verdict. text: the output of `gasjet compare
 * --format json`; sizes as in gasjet_run_summary. */
GASJET_API int gasjet_compare(const char* mine, const char* reference, const char* GASJET_OR_NULL map,
                              const char* GASJET_OR_NULL columns, double tolerance, int* verdict,
                              char GASJET_OR_NULL text[], int64_t size, int64_t* needed);

#ifdef __cplusplus
}
#endif
#endif

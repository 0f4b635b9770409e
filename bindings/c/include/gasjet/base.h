// SPDX-License-Identifier: Apache-2.0
/* Shared by all parts: status, error text, handles. */
#ifndef GASJET_BASE_H
#define GASJET_BASE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GASJET_API __attribute__((visibility("default")))
#define GASJET_OR_NULL /* the pointer may be NULL */

/* Status that functions return. */
enum gasjet_status {
  GASJET_OK = 0,
  GASJET_BAD_INPUT = 2, /* an argument, a file or a handle is wrong; nothing was changed */
  GASJET_DOMAIN = 3,    /* the computation left its domain */
  GASJET_BUSY = 4,      /* another thread uses the handle */
  GASJET_STOPPED = 5,   /* the callback stopped the run */
  GASJET_FAILED = 6     /* out of memory, or a fault of the library */
};

/* An object of the library. 0 means no object; no number is used twice. */
typedef int64_t gasjet_handle;

/* Version as "0.1.0"; belongs to the library. */
GASJET_API const char* gasjet_version(void);

/* Why the last function of this thread failed; "" if it returned GASJET_OK. Valid until the thread's next
 * call. */
GASJET_API const char* gasjet_last_error(void);

/* Frees any handle. GASJET_BAD_INPUT for a number that is not, or no longer, a handle. */
GASJET_API int gasjet_free(gasjet_handle handle);

#ifdef __cplusplus
}
#endif
#endif

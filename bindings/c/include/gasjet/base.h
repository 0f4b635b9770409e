// SPDX-License-Identifier: Apache-2.0
/* What all parts share: status, error text, handles. */
#ifndef GASJET_BASE_H
#define GASJET_BASE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GASJET_API __attribute__((visibility("default")))
#define GASJET_OR_NULL /* the pointer may be NULL */

/* What a function returns. */
enum gasjet_status {
  GASJET_OK = 0,
  GASJET_BAD_INPUT = 2, /* an argument, a file or a handle is wrong; nothing was done */
  GASJET_DOMAIN = 3,    /* the computation left its domain */
  GASJET_BUSY = 4,      /* another thread uses the handle */
  GASJET_STOPPED = 5,   /* the callback asked for it */
  GASJET_FAILED = 6     /* out of memory, or a fault of the library */
};

/* An object of the library: 0 is none, no number is used twice. */
typedef int64_t gasjet_handle;

/* Version as "0.1.0"; belongs to the library. */
GASJET_API const char* gasjet_version(void);

/* Why the last function of this thread did not return GASJET_OK; "" if it did. Holds until the thread's next
 * call. */
GASJET_API const char* gasjet_last_error(void);

/* Frees any handle. A handle that is not (or no longer) one is GASJET_BAD_INPUT. */
GASJET_API int gasjet_free(gasjet_handle handle);

#ifdef __cplusplus
}
#endif
#endif

/*
 * self - where the running program lies, so that what was installed or built beside it is found.
 */
#ifndef CLOUDMILL_SELF_H
#define CLOUDMILL_SELF_H

#include <stddef.h>

/* The folder of the running program, without a slash at its end; "" where the system does not say.
 */
void self_folder(char *folder, size_t size);

#endif

/*
 * program_dir - the folder of the running program, to find the files installed or built with it.
 */
#ifndef CLOUDMILL_PROGRAM_DIR_H
#define CLOUDMILL_PROGRAM_DIR_H

#include <stddef.h>

/* The first word of the command line, for systems that do not tell where the program is. */
void program_called(const char *word);

/* The folder of the running program, without a slash at its end; "" if unknown. */
void program_dir(char *folder, size_t size);

#endif

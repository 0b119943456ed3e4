/* fuzz - libFuzzer with one of the readers, the one that $FUZZ_READER names. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "fuzz_reader.h"

static const struct fuzz_reader *reader;

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n);

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    const char *name = getenv("FUZZ_READER");
    (void)argc;
    (void)argv;
    reader = name ? fuzz_reader_of(name) : NULL;
    if (!reader) {
        fprintf(stderr, "FUZZ_READER: found `%s`, expected a reader\n", name ? name : "");
        exit(2);
    }
    fuzz_begin();
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n)
{
    fuzz_read(reader, bytes, n);
    return 0;
}

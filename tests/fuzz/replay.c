/* replay READER FILE... - lets a reader read files as fuzz does: seeds, and what was found. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "fuzz_reader.h"

enum { MOST = 1 << 22, SECONDS = 10 };

int main(int argc, char **argv)
{
    const struct fuzz_reader *reader = argc > 2 ? fuzz_reader_of(argv[1]) : NULL;
    unsigned char *bytes = malloc(MOST);
    if (!reader || !bytes) {
        fprintf(stderr, "usage: replay READER FILE...\n");
        return 2;
    }
    fuzz_begin();
    for (int i = 2; i < argc; i++) {
        FILE *in = fopen(argv[i], "rb");
        size_t n = in ? fread(bytes, 1, MOST, in) : 0;
        if (!in || fclose(in) != 0) {
            fprintf(stderr, "replay: %s: cannot read\n", argv[i]);
            return 1;
        }
        printf("%s\n", argv[i]);
        fflush(stdout);
        alarm(SECONDS); /* a reader that runs on */
        fuzz_read(reader, bytes, n);
    }
    free(bytes);
    return 0;
}

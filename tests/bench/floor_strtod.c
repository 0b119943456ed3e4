/*
 * floor_strtod - the floor for reading a cloud as one writes it without a thought: fgets, strtod,
 * a sum; nothing is kept.
 *
 *     floor_strtod FILE
 */
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    char line[1024];
    double sum = 0;
    FILE *f = argc > 1 ? fopen(argv[1], "r") : stdin;
    if (!f) {
        perror(argv[1]);
        return 1;
    }
    while (fgets(line, sizeof line, f)) {
        char *s = line;
        for (int i = 0; i < 3; i++)
            sum += strtod(s, &s);
    }
    printf("%.6f\n", sum);
    return 0;
}

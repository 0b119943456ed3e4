/*
 * floor_mesh - the least that any maker of meshes must do with a cloud: read it and turn its
 * three columns into numbers.  Nothing is kept but their sum.
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

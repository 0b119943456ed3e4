/*
 * floor_post - the least that turns a CL file into rotary G-code: fgets, six times strtod, two
 * angles, printf.  Nothing is checked, kept or divided.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char **argv)
{
    static char line[4096];
    FILE *f = argc > 1 ? fopen(argv[1], "r") : NULL;
    const double degrees = 45 / atan2(1, 1);
    if (!f)
        return 1;
    while (fgets(line, sizeof line, f)) {
        double v[6];
        char *s = line + 5;
        if (strncmp(line, "GOTO/", 5) != 0)
            continue;
        for (int i = 0; i < 6; i++, s++)
            v[i] = strtod(s, &s);
        printf("X%.3f Y%.3f Z%.3f A%.3f C%.3f\n", v[0], v[1], v[2],
               degrees * atan2(hypot(v[3], v[4]), v[5]), degrees * atan2(v[3], -v[4]));
    }
    fclose(f);
    return 0;
}

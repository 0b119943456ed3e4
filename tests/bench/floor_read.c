/*
 * floor_read - the floor for reading a cloud: read() the file, three decimals a line by a hand
 * parser, their sum; nothing else.  No checks, no storage, plain `x y z` rows only.
 *
 *     floor_read FILE
 */
#include <fcntl.h>
#include <stdio.h>

#include "floor.h"

static unsigned long rows;
static double sum[3];

static void add(double x, double y, double z)
{
    sum[0] += x;
    sum[1] += y;
    sum[2] += z;
    rows++;
}

int main(int argc, char **argv)
{
    floor_rows(argc > 1 ? open(argv[1], O_RDONLY) : 0, add);
    printf("%lu %.3f %.3f %.3f\n", rows, sum[0], sum[1], sum[2]);
    return 0;
}

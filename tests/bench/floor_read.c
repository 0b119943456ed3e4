/*
 * floor_read - the floor for reading a cloud: read() the file, three decimals a line by a hand
 * parser, their sum; nothing else.  No checks, no storage, plain `x y z` rows only.
 *
 *     floor_read FILE
 */
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { CHUNK = 1 << 16 };

static char buffer[2 * CHUNK + 1];

static const char *number(const char *p, double *value)
{
    static const double ten[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
    while (*p == ' ')
        p++;
    int negative = *p == '-';
    p += negative;
    long mantissa = 0, decimals = 0;
    for (; *p >= '0' && *p <= '9'; p++)
        mantissa = mantissa * 10 + (*p - '0');
    if (*p == '.')
        for (p++; *p >= '0' && *p <= '9'; p++, decimals++)
            mantissa = mantissa * 10 + (*p - '0');
    *value = (double)(negative ? -mantissa : mantissa) / ten[decimals];
    return p;
}

int main(int argc, char **argv)
{
    int fd = argc > 1 ? open(argv[1], O_RDONLY) : 0;
    size_t have = 0;
    unsigned long rows = 0;
    double sum[3] = {0, 0, 0};
    for (ssize_t n; (n = read(fd, buffer + have, CHUNK)) > 0;) {
        const char *p = buffer, *end = buffer + have + (size_t)n;
        const char *last = end;
        while (last > p && last[-1] != '\n')
            last--;
        while (p < last) {
            double x, y, z;
            p = number(number(number(p, &x), &y), &z) + 1;
            sum[0] += x;
            sum[1] += y;
            sum[2] += z;
            rows++;
        }
        have = (size_t)(end - last);
        memmove(buffer, last, have);
    }
    printf("%lu %.3f %.3f %.3f\n", rows, sum[0], sum[1], sum[2]);
    return 0;
}

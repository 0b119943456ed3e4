/*
 * floor_post - the least that turns a CL file into rotary G-code: read() the file, six decimals a
 * line by a hand parser, two angles, five numbers set down from integers, write().  Nothing is
 * checked, kept, counted or divided; plain `GOTO/x,y,z,i,j,k` lines alone.
 *
 *     floor_post FILE
 */
#include <fcntl.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

enum { CHUNK = 1 << 16, LINE = 200 };

static char in[2 * CHUNK + 1], out[CHUNK + LINE];

static const char *number(const char *p, double *value)
{
    static const double ten[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
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

/* The address and the value with three decimals. */
static char *word(char *to, char address, double value)
{
    char digits[24], *p = digits + sizeof digits;
    long n = lrint(fabs(value) * 1000);
    *to++ = address;
    if (value < 0 && n)
        *to++ = '-';
    for (int i = 0; i < 4 || n; i++, n /= 10) {
        if (i == 3)
            *--p = '.';
        *--p = (char)('0' + n % 10);
    }
    size_t length = (size_t)(digits + sizeof digits - p);
    memcpy(to, p, length);
    to[length] = ' ';
    return to + length + 1;
}

int main(int argc, char **argv)
{
    int fd = argc > 1 ? open(argv[1], O_RDONLY) : 0;
    const double degrees = 45 / atan2(1, 1);
    size_t have = 0, made = 0;
    for (ssize_t n; (n = read(fd, in + have, CHUNK)) > 0;) {
        const char *p = in, *end = in + have + (size_t)n, *last = end;
        while (last > p && last[-1] != '\n')
            last--;
        while (p < last) {
            double v[6];
            const char *line = p;
            p = (const char *)memchr(p, '\n', (size_t)(last - p)) + 1;
            if (memcmp(line, "GOTO/", 5) != 0)
                continue;
            line += 5;
            for (int i = 0; i < 6; i++)
                line = number(line, &v[i]) + 1;
            char *to = out + made;
            to = word(word(word(to, 'X', v[0]), 'Y', v[1]), 'Z', v[2]);
            to = word(to, 'A', degrees * atan2(hypot(v[3], v[4]), v[5]));
            to = word(to, 'C', degrees * atan2(v[3], -v[4]));
            to[-1] = '\n';
            made = (size_t)(to - out);
            if (made > CHUNK && write(1, out, made) < 0)
                return 1;
            made = made > CHUNK ? 0 : made;
        }
        have = (size_t)(end - last);
        memmove(in, last, have);
    }
    return write(1, out, made) < 0;
}

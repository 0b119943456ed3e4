/*
 * floor_post - the least that turns a CL file into 5-axis G-code: read() the file, six decimals a
 * line by a hand parser, the words from integers, write().  Nothing is checked, kept, counted or
 * divided; plain `GOTO/x,y,z,i,j,k` lines alone.
 *
 *     floor_post tcp FILE      X Y Z A C: two angles
 *     floor_post axes FILE     without tool-centre-point control: X Y Z turned by them, F as 1/min
 *     floor_post vectors FILE  X Y Z and the tool axis as it is
 */
#include <fcntl.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "floor.h"

enum { CHUNK = FLOOR_CHUNK, LINE = 200 };

static char in[2 * CHUNK + 1], out[CHUNK + LINE];

/* The address and the value with so many decimals; `scale` is ten to that power. */
static inline char *decimals(char *to, char address, double value, double scale, int places)
{
    char digits[24], *p = digits + sizeof digits;
    long n = lrint(fabs(value) * scale);
    *to++ = address;
    if (value < 0 && n)
        *to++ = '-';
    for (int i = 0; i <= places || n; i++, n /= 10) {
        if (i == places)
            *--p = '.';
        *--p = (char)('0' + n % 10);
    }
    size_t length = (size_t)(digits + sizeof digits - p);
    memcpy(to, p, length);
    to[length] = ' ';
    return to + length + 1;
}

static char *word(char *to, char address, double value)
{
    return decimals(to, address, value, 1e3, 3);
}

static char *tcp(char *to, const double v[6])
{
    const double degrees = 45 / atan2(1, 1);
    to = word(word(word(to, 'X', v[0]), 'Y', v[1]), 'Z', v[2]);
    to = word(to, 'A', degrees * atan2(hypot(v[3], v[4]), v[5]));
    return word(to, 'C', degrees * atan2(v[3], -v[4]));
}

/* Table-table A/C with its centres at zero: the cosines and sines of both angles are in the axis.
 */
static char *axes(char *to, const double v[6])
{
    static double before[3];
    const double degrees = 45 / atan2(1, 1), flat = hypot(v[3], v[4]);
    double c = -v[4] / flat, s = v[3] / flat;
    double x = c * v[0] + s * v[1], y = c * v[1] - s * v[0];
    double dx = v[0] - before[0], dy = v[1] - before[1], dz = v[2] - before[2];
    to = word(word(to, 'X', x), 'Y', v[5] * y + flat * v[2]);
    to = word(word(to, 'Z', v[5] * v[2] - flat * y), 'A', degrees * atan2(flat, v[5]));
    to = word(to, 'C', degrees * atan2(v[3], -v[4]));
    memcpy(before, v, sizeof before);
    return word(to, 'F', 500 / sqrt(dx * dx + dy * dy + dz * dz + 1e-12));
}

static char *vectors(char *to, const double v[6])
{
    for (int i = 0; i < 3; i++)
        to = decimals(to, "XYZ"[i], v[i], 1e5, 5);
    for (int i = 0; i < 3; i++)
        to = decimals(to, "IJK"[i], v[3 + i], 1e8, 8);
    return to;
}

int main(int argc, char **argv)
{
    if (argc < 3)
        return 2;
    char *(*block)(char *, const double *) = *argv[1] == 't'   ? tcp
                                             : *argv[1] == 'a' ? axes
                                                               : vectors;
    int fd = open(argv[2], O_RDONLY);
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
                line = floor_number(line, &v[i]) + 1;
            char *to = block(out + made, v);
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

/*
 * cloud_las - LAS 1.0 to 1.4, the format of airborne and mobile scanners, not compressed; see
 * cloud_source.h.  Source: ASPRS, LAS Specification 1.4 R15.
 *
 * A head of fixed places, then records of one length, each with whole numbers X Y Z first; the
 * point is scale times number plus offset.
 */
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/bytes.h"
#include "cloud_source.h"

enum {
    HEAD_MIN = 227, /* bytes of the head up to version 1.2 */
    HEAD_1_4 = 375, /* and of 1.4, with its count of 8 bytes */
    COMPRESSED = 0xC0,
    FORMATS = 11,
    EXTENDED = 6, /* from this point format on flags have a byte of their own */
    FLAGS = 15    /* the byte of a record that says whether the point is withheld */
};

/* The shortest record of each point format. */
static const unsigned short record_min[FORMATS] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

struct las {
    uint64_t points;
    size_t data;   /* where the records begin */
    size_t record; /* length of each */
    unsigned format;
    double scale[3], offset[3];
};

static int las_error(const struct cloud_source *s, struct error *error, const char *what,
                     double found, const char *expected)
{
    return error_at(error, s->reader->name, 0, "a LAS file with %s %.9g, expected %s", what, found,
                    expected);
}

/* The head at p, of the bytes that the shortest one has, and its extension at `more` or NULL. */
static int read_values(const struct cloud_source *s, const char *p, const char *more,
                       struct las *las, struct error *error)
{
    unsigned format = (unsigned char)p[104];
    if (format & COMPRESSED)
        return error_at(error, s->reader->name, 0,
                        "a LAZ file, which is compressed, expected LAS: convert it first, as by "
                        "`laszip -i IN.laz -o OUT.las` or `pdal translate IN.laz OUT.las`");
    if (format >= FORMATS)
        return las_error(s, error, "point format", format, "0 to 10");
    las->format = format;
    las->data = (size_t)bytes_whole(p + 96, 4);
    las->record = (size_t)bytes_whole(p + 105, 2);
    las->points = bytes_whole(p + 107, 4);
    if (more && bytes_whole(more + 247 - HEAD_MIN, 8) > 0)
        las->points = bytes_whole(more + 247 - HEAD_MIN, 8);
    if (las->record < record_min[format])
        return las_error(s, error, "records of length", (double)las->record,
                         "no fewer bytes than their point format has");
    for (int i = 0; i < 3; i++) {
        las->scale[i] = bytes_double(p + 131 + 8 * i);
        las->offset[i] = bytes_double(p + 155 + 8 * i);
        if (!(fabs(las->scale[i]) > 0) || !(fabs(las->scale[i]) < CLOUD_TOO_LARGE / 4294967296.0))
            return las_error(s, error, "scale", las->scale[i], "a finite one that is not 0");
        if (!(fabs(las->offset[i]) < CLOUD_TOO_LARGE / 2))
            return las_error(s, error, "offset", las->offset[i], "a finite one");
    }
    return 0;
}

/* The next n bytes into p; `what` ends early otherwise. */
static int read_part(struct cloud_source *s, char *p, size_t n, const char *what,
                     struct error *error)
{
    long got = reader_bytes(s->reader, p, n, error);
    if (got < 0)
        return -1;
    if ((size_t)got < n)
        return error_at(error, s->reader->name, 0, "the file ends in %s, expected its points",
                        what);
    return 0;
}

static int read_head(struct cloud_source *s, struct las *las, struct error *error)
{
    char p[HEAD_MIN], more[HEAD_1_4 - HEAD_MIN], skipped[4096];
    if (read_part(s, p, sizeof p, "the head of a LAS file", error) < 0)
        return -1;
    unsigned major = (unsigned char)p[24], minor = (unsigned char)p[25];
    size_t head = (size_t)bytes_whole(p + 94, 2), read = sizeof p;
    if (major != 1 || minor > 4)
        return error_at(error, s->reader->name, 0,
                        "a LAS file of version %u.%u, expected 1.0 to 1.4", major, minor);
    if (head < (minor == 4 ? HEAD_1_4 : HEAD_MIN))
        return las_error(s, error, "a head of length", (double)head,
                         minor == 4 ? "375 bytes or more" : "227 bytes or more");
    if (minor == 4) {
        if (read_part(s, more, sizeof more, "the head of a LAS file", error) < 0)
            return -1;
        read += sizeof more;
    }
    if (read_values(s, p, minor == 4 ? more : NULL, las, error) < 0)
        return -1;
    if (las->data < head)
        return las_error(s, error, "points from byte", (double)las->data, "them after its head");
    while (read < las->data) {
        size_t n = las->data - read < sizeof skipped ? las->data - read : sizeof skipped;
        if (read_part(s, skipped, n, "the head of a LAS file", error) < 0)
            return -1;
        read += n;
    }
    return 0;
}

static bool is_withheld(const struct las *las, const char *record)
{
    unsigned char flags = (unsigned char)record[FLAGS];
    return las->format >= EXTENDED ? flags & 4 : flags & 0x80;
}

static void take_record(struct cloud_source *s, const struct las *las, const char *record)
{
    double x[3];
    if (is_withheld(las, record)) {
        s->count->withheld++;
        return;
    }
    for (int i = 0; i < 3; i++)
        x[i] = las->scale[i] * (double)(int32_t)(uint32_t)bytes_whole(record + 4 * i, 4) +
               las->offset[i];
    cloud_take_point(s, vec(x[0], x[1], x[2]));
}

int cloud_las_read(struct cloud_source *s, struct error *error)
{
    struct las las = {0};
    if (read_head(s, &las, error) < 0)
        return -1;
    char *record = mem_alloc(las.record, 1);
    int status = 0;
    for (uint64_t i = 0; i < las.points && status == 0; i++) {
        long got = reader_bytes(s->reader, record, las.record, error);
        if (got >= 0 && (size_t)got < las.record)
            error_at(error, s->reader->name, 0,
                     "the file ends after %llu points, expected the %llu of its LAS head",
                     (unsigned long long)i, (unsigned long long)las.points);
        if (got < (long)las.record)
            status = -1;
        else
            take_record(s, &las, record);
    }
    free(record);
    s->count->columns = 3;
    return status;
}

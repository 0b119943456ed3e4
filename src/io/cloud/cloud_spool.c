/* cloud_spool - see cloud_spool.h. */
#include "io/cloud/cloud_spool.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/num.h"
#include "base/spool.h"

enum {
    RECORD = 4096,   /* points at most */
    FEW = 8,         /* points by which decimals are guessed */
    MOST_PLACES = 9, /* decimals */
    NO_DECIMALS = -1 /* they are as in memory */
};

static const double WHOLE = 6755399441055744.0; /* 1.5 * 2^52: a sum with it is a whole number */

struct cloud_spool {
    FILE *file; /* NULL: given up */
    int places; /* decimals of the last record */
    struct vec3 point[RECORD], again[RECORD];
    int32_t packed[RECORD][3];
};

struct head {
    int32_t n, places;
    struct vec3 first; /* in whole numbers, as the packed ones are told from it */
};

struct cloud_spool *cloud_spool_new(void)
{
    FILE *file = spool_open();
    if (!file)
        return NULL;
    struct cloud_spool *s = mem_alloc(1, sizeof *s);
    s->file = file;
    return s;
}

static void give_up(struct cloud_spool *s)
{
    fclose(s->file);
    s->file = NULL;
}

void cloud_spool_free(struct cloud_spool *s)
{
    if (s && s->file)
        give_up(s);
    free(s);
}

bool cloud_spool_holds(const struct cloud_spool *s)
{
    return s && s->file;
}

/* ---- whole numbers */

/* The nearest one; anything where it is as large as 2^51. */
static double nearest_whole(double x)
{
    return x + WHOLE - WHOLE;
}

static int32_t from_first(double x, double scale, double first)
{
    double away = nearest_whole(x * scale) - first;
    return away > -2e9 && away < 2e9 ? (int32_t)away : 0;
}

static void unpack(const struct head *head, int32_t (*packed)[3], struct vec3 *point)
{
    double scale = num_ten[head->places];

    for (int32_t i = 0; i < head->n; i++) {
        point[i].x = (head->first.x + packed[i][0]) / scale;
        point[i].y = (head->first.y + packed[i][1]) / scale;
        point[i].z = (head->first.z + packed[i][2]) / scale;
    }
}

/* false: that does not give the same points back. */
static bool pack(struct cloud_spool *s, const struct vec3 *point, struct head *head)
{
    double scale = num_ten[head->places];

    head->first = vec(nearest_whole(point->x * scale), nearest_whole(point->y * scale),
                      nearest_whole(point->z * scale));
    for (int32_t i = 0; i < head->n; i++) {
        s->packed[i][0] = from_first(point[i].x, scale, head->first.x);
        s->packed[i][1] = from_first(point[i].y, scale, head->first.y);
        s->packed[i][2] = from_first(point[i].z, scale, head->first.z);
    }
    unpack(head, s->packed, s->again);
    return memcmp(s->again, point, (size_t)head->n * sizeof *point) == 0;
}

/* With these decimals?  A few points are asked first. */
static bool pack_with(struct cloud_spool *s, const struct vec3 *point, int32_t n, int places,
                      struct head *head)
{
    *head = (struct head){n < FEW ? n : FEW, places, {0, 0, 0}};
    if (!pack(s, point, head))
        return false;
    head->n = n;
    return n <= FEW || pack(s, point, head);
}

static struct head pack_record(struct cloud_spool *s, const struct vec3 *point, int32_t n)
{
    struct head head;

    if (pack_with(s, point, n, s->places, &head))
        return head;
    for (int places = 0; places <= MOST_PLACES; places++)
        if (pack_with(s, point, n, places, &head)) {
            s->places = places;
            return head;
        }
    return (struct head){n, NO_DECIMALS, {0, 0, 0}};
}

/* ---- the file */

static bool write_record(struct cloud_spool *s, const struct vec3 *point, size_t n)
{
    struct head head = pack_record(s, point, (int32_t)n);

    if (fwrite(&head, sizeof head, 1, s->file) != 1)
        return false;
    return head.places == NO_DECIMALS ? fwrite(point, sizeof *point, n, s->file) == n
                                      : fwrite(s->packed, sizeof *s->packed, n, s->file) == n;
}

void cloud_spool_add(struct cloud_spool *s, const struct vec3 *point, size_t n)
{
    for (size_t i = 0; cloud_spool_holds(s) && i < n; i += RECORD)
        if (!write_record(s, point + i, n - i < RECORD ? n - i : RECORD))
            give_up(s);
}

void cloud_spool_end(struct cloud_spool *s)
{
    if (cloud_spool_holds(s) && fflush(s->file) != 0)
        give_up(s);
}

static bool read_record(struct cloud_spool *s, const struct head *head)
{
    size_t n = (size_t)head->n;

    if (head->places == NO_DECIMALS)
        return fread(s->point, sizeof *s->point, n, s->file) == n;
    if (fread(s->packed, sizeof *s->packed, n, s->file) != n)
        return false;
    unpack(head, s->packed, s->point);
    return true;
}

bool cloud_spool_look(struct cloud_spool *s,
                      void (*take)(void *context, const struct vec3 *point, size_t n),
                      void *context)
{
    struct head head;

    if (!s->file || fseek(s->file, 0, SEEK_SET) != 0)
        return false;
    while (fread(&head, sizeof head, 1, s->file) == 1) {
        if (!read_record(s, &head))
            return false;
        take(context, s->point, (size_t)head.n);
    }
    return feof(s->file);
}

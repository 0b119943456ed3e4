/*
 * target - a track, sampled.
 */
#include "target.h"

#include <stdlib.h>

#include "base/array.h"

static const double NEAR = 0.75; /* of the distance asked for: nearer points are left out */

static bool other_moves_more(const struct track *track)
{
    double point = 0, other = 0;

    for (size_t k = 0; k + 1 < track->n; k++) {
        point += vec_distance(track->point[k], track->point[k + 1]);
        other += vec_distance(track->other[k], track->other[k + 1]);
    }
    return other > point;
}

/* Sample i at the part s of the way from the track's point k to the next one. */
static void put(struct target *target, size_t i, const struct track *track, size_t k, double s)
{
    size_t next = k + 1 < track->n ? k + 1 : k;

    target->point[i] = vec_mix(track->point[k], track->point[next], s);
    if (target->axis == NULL)
        return;
    target->axis[i] = vec_unit(vec_mix(track->axis[k], track->axis[next], s));
    target->other[i] = vec_mix(track->other[k], track->other[next], s);
}

/* Appends samples of the chord behind the track's point k, which is at `way`. */
static void sample_chord(struct target *target, const struct track *track, size_t k, double way,
                         double apart)
{
    double chord = track->chord[k], pieces = ceil(chord / apart - 1e-9);
    bool near = target->n > 0 && way - target->at[target->n - 1] < NEAR * apart;

    for (int j = near ? 1 : 0; j == 0 || j < pieces; j++) {
        target->at[target->n] = way + chord * j / fmax(pieces, 1);
        put(target, target->n++, track, k, j / fmax(pieces, 1));
    }
}

static void sample(struct target *target, const struct track *track, double apart)
{
    double way = 0;

    for (size_t k = 0; k + 1 < track->n; k++) {
        if (k == 0 || track->chord[k] > apart || way - target->at[target->n - 1] >= NEAR * apart)
            sample_chord(target, track, k, way, apart);
        way += track->chord[k];
    }
    if (target->n > 1 && way - target->at[target->n - 1] < NEAR / 2 * apart)
        target->n--;
    target->at[target->n] = way;
    put(target, target->n++, track, track->n - 1, 0);
}

struct target target_new(const struct track *track, size_t parts, double tolerance, double angle)
{
    struct target t = {.offset = track->offset,
                       .tolerance = tolerance,
                       .angle = angle,
                       .other_leads = track->head != NULL && other_moves_more(track)};
    double way = 0;
    size_t room = 3 * parts + 3;

    for (size_t k = 0; k + 1 < track->n; k++)
        way += track->chord[k];
    t.at = mem_alloc(room, sizeof *t.at);
    t.point = mem_alloc(room, sizeof *t.point);
    if (track->head != NULL) {
        t.other = mem_alloc(room, sizeof *t.other);
        t.axis = mem_alloc(room, sizeof *t.axis);
    }
    sample(&t, track, way / (double)parts);
    return t;
}

void target_free(struct target *target)
{
    free(target->at);
    free(target->point);
    free(target->other);
    free(target->axis);
    *target = (struct target){0};
}

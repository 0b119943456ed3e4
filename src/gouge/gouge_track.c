/* gouge_track - see gouge_track.h. */
#include "gouge/gouge_track.h"

#include <stdlib.h>
#include <string.h>

static const double AHEAD = 0.6, BEHIND = 0.1; /* mm: gathered beyond the ends of what is asked */
static const double THICK = 0.03;  /* mm: places so far beside a piece are served by it, too */
static const double LONGEST = 1.5; /* mm: of what is asked by the piece */

enum { LOOK_AHEAD = 3, POINTS_MOST = 1 << 20 };

void gouge_track_free(struct gouge_track *track)
{
    array_free(&track->beside);
    array_free(&track->point);
    array_free(&track->near);
    *track = (struct gouge_track){0};
}

/* The piece knows all guard points nearer than `radius` to the segment: no place of that is farther
 * from the piece than the farther one of its ends. */
static bool serves(const struct gouge_beside *piece, struct vec3 a, struct vec3 b, double radius)
{
    double far = fmax(vec_segment_distance(piece->from, piece->to, a),
                      vec_segment_distance(piece->from, piece->to, b));

    return radius + far <= piece->within;
}

/* The piece used last or one of the next that serves, NULL: none of them does. */
static const struct gouge_beside *find_piece(struct gouge_track *track, struct vec3 a,
                                             struct vec3 b, double radius)
{
    for (size_t i = 0; i < LOOK_AHEAD && i < track->beside.n; i++) {
        size_t k = (track->at + i) % track->beside.n;
        if (serves(&track->beside.item[k], a, b, radius)) {
            track->at = k;
            return &track->beside.item[k];
        }
    }
    return NULL;
}

/* After the one used last: so they stay in the order of the way. */
static const struct gouge_beside *insert_piece(struct gouge_track *track, struct gouge_beside piece)
{
    size_t at = track->beside.n > 0 ? track->at + 1 : 0, after = track->beside.n - at;

    array_push(&track->beside);
    struct gouge_beside *here = &track->beside.item[at];
    memmove(here + 1, here, after * sizeof *here);
    *here = piece;
    track->at = at;
    return here;
}

static const struct gouge_beside *gather(struct gouge_track *track, const struct gouge_check *guard,
                                         struct vec3 a, struct vec3 b, double radius)
{
    struct vec3 along = vec_unit(vec_sub(b, a));

    if (track->point.n > POINTS_MOST)
        track->point.n = track->beside.n = track->at = 0;
    struct gouge_beside piece = {.from = vec_along(a, -BEHIND, along),
                                 .to = vec_along(b, AHEAD, along),
                                 .within = radius + THICK,
                                 .first = track->point.n};
    gouge_points_beside(guard, piece.from, piece.to, piece.within, &track->point);
    piece.n = track->point.n - piece.first;
    return insert_piece(track, piece);
}

double gouge_track_depth(struct gouge_track *track, const struct gouge_check *guard, struct vec3 a,
                         struct vec3 b, double radius)
{
    if (!(vec_distance(a, b) <= fmin(LONGEST, radius)))
        return gouge_depth_along(guard, a, b, radius);
    b = vec_mix(a, b, 1); /* as there */
    const struct gouge_beside *piece = find_piece(track, a, b, radius);
    if (!piece)
        piece = gather(track, guard, a, b, radius);
    const struct vec3 *point = piece->n > 0 ? &track->point.item[piece->first] : NULL;
    return radius - kdtree_nearest_among(point, piece->n, a, b, radius);
}

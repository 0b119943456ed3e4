/* arcrun_link - see arcrun.h: links as few arcs. */
#include <stdlib.h>

#include "arc_output.h"
#include "arcfit/arc_link.h"
#include "arcfit/arcfit.h"

/* Of the radius: a link goes no further off the way it was planned on.  So far from a way that is
 * clear of a shell no clear one is on the other side of it. */
static const double OFF = 0.4;

static const double BESIDE = 0.25; /* of the radius: so near to its ends it touches what they cut */

/* What is looked at with each try. */
struct link_check {
    struct gouge_refit_options gouge;
    struct gouge_track track;
};

static struct motion motion_of(const struct printed *p)
{
    struct pose from = {p->piece.arc.from, p->piece.axis}, to = {p->piece.arc.to, p->piece.axis_to};

    return p->arc.radius > 0 ? motion_arc(from, to, p->arc.centre, vec_unit(p->arc.axis))
                             : motion_line(from, to);
}

/* The pieces as they are printed are clear, each as the motion that it is. */
static bool is_clear(void *context, const struct pieces *pieces)
{
    struct link_check *c = context;
    struct gouges gouges = {0};

    for (size_t i = 0; i < pieces->n && gouges.n == 0; i++) {
        const struct arc_piece *piece = &pieces->item[i];
        struct printed printed = arcprint_piece(piece, vec_round(piece->arc.from, PATH_COORDINATE));
        struct motion motion = motion_of(&printed);
        gouge_refit_motion(&c->gouge, &motion, &c->track, &gouges);
    }
    bool clear = gouges.n == 0;
    array_free(&gouges);
    return clear;
}

/* Amid the link the ball leaves no more than may be left. */
static bool cuts(const struct run *run, const struct arcrun_link *link)
{
    const struct run_point *p = run->item, *last = p + run->n - 1;
    double touch = run->radius + link->left, beside = BESIDE * run->radius;

    for (size_t i = 1; i + 1 < run->n; i++)
        if (vec_distance(p[i].ball, p->ball) > beside &&
            vec_distance(p[i].ball, last->ball) > beside &&
            gouge_distance(link->gouge->guard, p[i].ball, touch) < touch)
            return true;
    return false;
}

bool arcrun_fit_link(const struct run *run, const struct arcrun_link *link,
                     const struct arcrun_options *options, struct path *out,
                     struct arcrun_report *report)
{
    struct run dense = {.radius = run->radius};

    if (cuts(run, link))
        return false;
    run_densify(run, ARC_DENSE * options->tolerance, &dense);
    struct reference reference = reference_of(&dense, 0, dense.n, options->centre, false);
    struct link_check check = {.gouge = *link->gouge};
    struct arc_link_options search = {.leave = link->leave,
                                      .arrive = link->arrive,
                                      .out = {link->out[0], link->out[1]},
                                      .off = OFF * run->radius,
                                      .below = options->tolerance,
                                      .least = fmax(options->least, ARC_SHORTEST),
                                      .digits = PATH_COORDINATE,
                                      .clear = is_clear,
                                      .context = &check};
    struct pieces pieces = {0};
    struct printeds printed = {0};

    check.gouge.any = true;
    bool good = run->radius > 0 && arcfit_link(&reference, &search, &pieces);

    if (good) {
        struct arc_output output = {options, dense.item, &reference};
        good = isfinite(arcprint_pieces(&reference, &pieces, NULL, &printed).point);
        if (good)
            arc_output_add(&output, &printed, out, report);
    }
    array_free(&pieces);
    array_free(&printed);
    gouge_track_free(&check.track);
    reference_free(&reference);
    array_free(&dense);
    return good;
}

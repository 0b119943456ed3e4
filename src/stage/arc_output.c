/* arc_output - see arc_output.h. */
#include "arc_output.h"

#include "arcfit/arcfit.h"

/* Contact at a place of the reference. */
static bool contact_at(const struct arc_output *o, double place, struct contact *contact)
{
    size_t i = (size_t)place;
    double part = place - floor(place);
    const struct run_point *a = &o->point[i], *b = part > 0 ? a + 1 : a;
    if (vec_length(a->normal) < 0.5 || vec_length(b->normal) < 0.5)
        return false;
    contact->p = vec_mix(a->contact, b->contact, part);
    contact->n = part > 0 ? vec_slerp(a->normal, b->normal, part) : a->normal;
    return true;
}

static void add_contact(struct path *out, struct path_item *item, const struct arc_output *o,
                        double place)
{
    struct contact contact;
    if (contact_at(o, place, &contact))
        path_set_contact(out, item, contact);
}

static void add_chords(const struct arc_output *o, const struct printed *p, struct path *out)
{
    char text[ARCPRINT_MAX];
    arcprint_comment(&p->arc, text);
    path_add_text(out, text);
    const struct arc_piece *piece = &p->piece;
    int n = arcprint_chords(piece, o->reference->offset, ARC_CHORD * o->options->tolerance);
    for (int i = 1; i <= n; i++) {
        double s = (double)i / n, place = piece->from + s * (piece->to - piece->from);
        struct pose to = {arc_at(&piece->arc, s), vec_slerp(piece->axis, piece->axis_to, s)};
        add_contact(out, path_add_point(out, to, false), o, i < n ? place : piece->to);
    }
}

/* How the motion bends and how its axis turns at one end of a piece, each by its length. */
struct rates {
    struct vec3 curvature, axis; /* 1/mm, radians/mm */
};

static struct rates rates_at(const struct arc_piece *piece, double s)
{
    double length = arc_length(&piece->arc);
    struct rates r = {{0, 0, 0}, {0, 0, 0}};
    if (!arc_straight(&piece->arc))
        r.curvature = vec_scale(1 / piece->arc.radius,
                                vec_unit(vec_sub(arc_centre(&piece->arc), arc_at(&piece->arc, s))));
    if (length > 0)
        r.axis = vec_scale(vec_angle(piece->axis, piece->axis_to) / length,
                           vec_unit(vec_cross(piece->axis, piece->axis_to)));
    return r;
}

/* What a control sees of a piece: its length, and how much changes at once where it begins. */
static void report_piece(const struct arcrun_options *options, const struct printed *before,
                         const struct printed *p, struct arcrun_report *report)
{
    double length = arc_length(&p->piece.arc);
    report->length += length;
    report->shortest = report->arcs + report->lines > 1 ? fmin(report->shortest, length) : length;
    report->shorter += length < options->least;
    if (!before ||
        vec_angle(arc_tangent(&before->piece.arc, 1), p->piece.arc.tangent) > 2 * ARCFIT_KINK)
        return;
    struct rates a = rates_at(&before->piece, 1), b = rates_at(&p->piece, 0);
    report->bend = fmax(report->bend, vec_distance(a.curvature, b.curvature));
    report->turn = fmax(report->turn, vec_distance(a.axis, b.axis));
}

void arc_output_add(const struct arc_output *o, const struct printeds *printed, struct path *out,
                    struct arcrun_report *report)
{
    const struct printed *before = NULL;
    for (size_t i = 0; i < printed->n; i++) {
        const struct printed *p = &printed->item[i];
        struct pose to = {p->piece.arc.to, p->piece.axis_to};
        if (p->arc.radius <= 0)
            add_contact(out, path_add_point(out, to, false), o, p->piece.to);
        else if (o->options->chords)
            add_chords(o, p, out);
        else
            add_contact(out, path_add_arc(out, to, p->arc), o, p->piece.to);
        report->arcs += p->arc.radius > 0;
        report->lines += p->arc.radius <= 0;
        report_piece(o->options, before, p, report);
        if (before) {
            double kink = vec_angle(arc_tangent(&before->piece.arc, 1), p->piece.arc.tangent);
            bool smooth = kink <= 2 * ARCFIT_KINK,
                 arcs = before->arc.radius > 0 && p->arc.radius > 0;
            struct vec3 centre = vec_sub(before->arc.centre, p->piece.arc.from);
            bool same = vec_dot(centre, p->piece.arc.inward) > 0;
            bool counts = smooth && arcs && (before->piece.biarc || !o->options->paper);
            report->kinks += !smooth;
            report->c += counts && same;
            report->s += counts && !same;
        }
        before = p;
    }
}

/*
 * path_spline - the MOVNRB statements of a path stream, joined to one B-spline.
 *
 *   MOVNRB/5AXIS,LENGTH,l        or MOVNRB/M3AXIS
 *   MOVNRB/ON,order,knots,0,poles,length
 *   MOVNRB/1,knot,...            all knots, end knots repeated
 *   MOVNRB/2,x,y,z,...           poles of the tracked point
 *   MOVNRB/3,x,y,z,...           poles of the head, with 5AXIS alone
 *   MOVNRB/NEXT                  then the same motion as GOTOs
 *   MOVNRB/OFF
 */
#ifndef CLOUDMILL_PATH_SPLINE_H
#define CLOUDMILL_PATH_SPLINE_H

#include "apt.h"
#include "io/path/path.h"

enum spline_stage { SPLINE_NONE, SPLINE_BEGUN, SPLINE_DATA, SPLINE_FALLBACK };

struct spline_parse {
    enum spline_stage stage;
    bool five_axes;
    double length;
    size_t knots, poles;
    int degree;
    struct doubles knot;
    struct vec3s pole, head;
    struct poses fallback;
    struct pose from; /* where the motion starts */
};

/*
 * Reads one MOVNRB statement.  `unit`: millimetres in the stream's unit; `at`: where the tool is.
 * 1: it was MOVNRB/OFF, and the spline is complete and starts where the tool is; 0: it was another
 * part; -1: error.
 */
int spline_parse(struct spline_parse *s, const struct apt *apt, const char *name, double unit,
                 struct pose at, struct error *error);

/* Adds one GOTO of the fallback list. */
void spline_parse_point(struct spline_parse *s, struct pose pose);

/* The whole spline and the pose where it ends; s is empty again. */
struct path_spline spline_parse_finish(struct spline_parse *s, struct pose *end);

void spline_parse_free(struct spline_parse *s);

#endif

/*
 * control - an NC program run as the control runs it, block by block, into a course.
 *
 * Written from the makers' manuals as design and man pages state them, and sharing nothing with
 * the code that writes programs: a mistake there must not be made here once more.  What the
 * control would refuse, or what leaves open where the tool goes, is an error.
 */
#ifndef READBACK_CONTROL_H
#define READBACK_CONTROL_H

#include "course.h"
#include "word.h"

enum dialect_read { READ_FANUC, READ_SIEMENS, READ_HEIDENHAIN, READ_CANON };

struct setup {
    enum dialect_read dialect;
    bool tcp;      /* the machine has tool centre point control */
    bool reversed; /* its rotary axes turn against the ISO sense */
    enum rotary rotary;
};

/* What is known of where the machine is. */
struct place {
    bool known[3];
    double at[3];   /* X Y Z as programmed */
    bool turned[2];
    double turn[2]; /* master, slave; degrees */
    bool has_axis;
    struct vec3 axis;
    bool has_head;
    struct vec3 head; /* second point on the tool axis */
};

struct control {
    const struct setup *setup;
    struct course *course;
    const char *name; /* of the file */
    struct words words;
    size_t line;
    long block; /* N number of this block, -1: none */
    long last_block;
    struct place here;
    /* modal */
    int move;  /* the dialect's own */
    int plane; /* 17, 18, 19 */
    bool metric, absolute, inverse_time, spindle;
    bool tcp;     /* on */
    bool vectors; /* the tool axis is programmed as a vector */
    bool curve;   /* the tool axis follows a second point (ORICURVE) */
    double feed;
    bool feed_here; /* F stands in this block */
    bool ended;     /* M30 was read */
    bool closed;    /* and the mark behind it */
    struct vec3 centre; /* CC of Klartext */
    bool has_centre;
    /* a B-spline being read */
    int order;
    struct doubles knot, weight;
    struct vec3s pole_p, pole_q;
    struct piece spline;
};

/* Runs a whole program.  -1: it can't be run, the place is named. */
int control_read(const char *file, const struct setup *setup, struct course *course,
                 struct error *error);

/* One dialect: the blocks of the file one after another, then the end. */
int control_fanuc(struct control *c, const char *line, struct error *error);
int control_fanuc_end(struct control *c, struct error *error);
int control_siemens(struct control *c, const char *line, struct error *error);
int control_siemens_end(struct control *c, struct error *error);
int control_heidenhain(struct control *c, const char *line, struct error *error);
int control_heidenhain_end(struct control *c, struct error *error);
int control_canon(struct control *c, const char *line, struct error *error);
int control_canon_end(struct control *c, struct error *error);

/* --- what both dialects share ---------------------------------------------------------- */

/* Error with the place of the block. */
int control_error(const struct control *c, struct error *error, const char *what);

/* A word that is not known here. */
int control_unknown(const struct control *c, const struct word *w, struct error *error);

/* An M word: the spindle, the end, and those that move nothing. */
int control_m(struct control *c, const struct word *w, struct error *error);

/* The N number of a block must rise; behind the last of four digits or more it may begin anew. */
int control_block(struct control *c, double number, struct error *error);

/* X Y Z, the rotary words of this machine: true when `name` is one and `to` took the value. */
bool control_axis(const struct control *c, const char *name, double value, struct place *to);

/* After rotary words the axis follows from them; after a vector they are not known. */
void control_turned(const struct control *c, struct place *to);
void control_pointed(struct place *to, struct vec3 axis);

/* A piece from here to there with its swing; its shape is the caller's. */
struct piece control_piece(const struct control *c, const struct place *to);

/* What the control, or good practice, wants to be said before the tool cuts. */
int control_ready(const struct control *c, struct error *error);

/* The tool goes there: checks what a move needs, adds the piece. */
int control_go(struct control *c, const struct place *to, struct piece piece, bool rapid,
               struct error *error);

/* Makes the piece an arc about `centre` in the active plane, counter-clockwise or clockwise. */
int control_arc(const struct control *c, struct piece *piece, struct vec3 centre, bool ccw,
                struct error *error);

/* The same from a radius (negative: more than a half turn). */
int control_arc_radius(const struct control *c, struct piece *piece, double radius, bool ccw,
                       struct error *error);

/* Makes the piece an arc through a point. */
int control_arc_through(const struct control *c, struct piece *piece, struct vec3 middle,
                        struct error *error);

/* One pole more of the spline being read; the first one takes over the piece's swing. */
void control_pole(struct control *c, const struct piece *piece, struct vec3 p, struct vec3 q);

/* The spline is complete: its knots are checked and it is added. */
int control_spline(struct control *c, struct error *error);

#endif

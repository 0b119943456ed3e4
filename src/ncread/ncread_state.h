/*
 * ncread_state - the state of a control while it runs a program, and what the readers of all
 * dialects do with it.
 *
 * A reader brings the words of a block into the state (modal words, the place that the block goes
 * to), makes a piece of it, gives the piece its shape, and lets it go: ncread_piece, ncread_arc
 * ..., ncread_go.
 */
#ifndef CLOUDMILL_NCREAD_STATE_H
#define CLOUDMILL_NCREAD_STATE_H

#include "base/array.h"
#include "ncread/ncread.h"
#include "ncread_hole.h"
#include "ncread_home.h"
#include "ncread_lost.h"
#include "ncread_meaning.h"
#include "ncread_plane.h"
#include "ncread_tool.h"
#include "ncread_watch.h"
#include "ncread_word.h"

#define INCH 25.4 /* mm */

/* How one control reads: its first two lines; the blocks of the file one after another; the end. */
struct ncread_dialect {
    const char *name;
    bool (*begins)(const char *first, const char *second); /* second NULL: there is none */
    int (*block)(struct ncread *c, const char *line, struct error *error);
    int (*end)(struct ncread *c, struct error *error);
    bool offsets; /* it has words for the work offset, of which one is expected */
};

/* The controls, each by the name that its row in machine/control.h has. */
#define NCREAD_DIALECT(name, title, tcp_of_machine, dc) \
    extern const struct ncread_dialect ncread_##name;
CONTROL_TABLE(NCREAD_DIALECT)
#undef NCREAD_DIALECT

/* What is known of where the machine is. */
struct ncread_place {
    bool known[3];
    double at[3]; /* X Y Z as programmed */
    bool turned[2];
    double turn[2]; /* as the machine has them, degrees */
    bool has_axis;
    struct vec3 axis;
    bool has_head;
    struct vec3 head; /* second point on the tool axis */
};

enum { NCREAD_UNKNOWN = 64 };

/* A word that was passed over. */
struct ncread_unknown_word {
    char word[40];
    size_t line, times;
};

/* The state. */
struct ncread {
    const struct ncread_options *options;
    struct nc_motion *motion;
    const char *name; /* of the file */
    struct ncread_words words;
    size_t line;
    const char *text; /* of this line */
    long block;       /* N number of this block, -1: none */
    long last_block;
    long step; /* from one block's number to the next; 0: not known yet */
    struct ncread_place here;
    /* modal */
    int move;    /* the dialect's own */
    int plane;   /* 17, 18, 19 */
    double unit; /* of the program's lengths, mm; 0: not set yet */
    bool absolute, inverse_time, spindle;
    bool said;             /* absolute or incremental words were asked for */
    bool absolute_centre;  /* of arcs, G90.1 */
    bool tcp;              /* on */
    bool vectors;          /* the tool axis is programmed as a vector */
    bool curve;            /* the tool axis follows a second point (ORICURVE) */
    bool parameter;        /* which runs on the curve's parameter (UPATH), not on its length */
    bool length;           /* the tool's length is on */
    bool lengthened;       /* and was, in some block */
    bool tcp_by_length;    /* tool centre point control is a length, too (G43.4): G43 ends it */
    size_t length_assumed; /* line of the first cut without it, whose Z was taken for the tip's */
    double speed;          /* of the spindle, 1/min; 0: not set yet */
    double feed;
    bool feed_here;      /* F stands in this block */
    bool ended;          /* M30 was read */
    bool closed;         /* and the mark after it */
    bool framed;         /* the program began with %, and so ends with it */
    bool titled;         /* a block stood before, or the number O of the program */
    bool machine_frame;  /* X Y Z are those of the machine (#MCS ON) */
    bool setting;        /* a G of this block has numbers of its own: P3 E0.01 */
    bool selecting;      /* and its axis words only name axes */
    bool rounds_by_data; /* corners are rounded by the machine's data: was told */
    struct ncread_unknown_word unknown[NCREAD_UNKNOWN];
    size_t unknown_n;
    struct ncread_place middle; /* of G02.4 */
    bool has_middle;
    struct vec3 centre; /* CC of Klartext */
    bool has_centre;
    char path_control;          /* of TCPM: A or V, until it is told; 0: not said */
    struct ncread_plane tilted; /* the plane that X Y Z are in */
    struct ncread_hole hole;    /* the drilling cycle that is on */
    struct ncread_watch watch;
    struct ncread_home home;
    struct ncread_tool tool;
    struct ncread_lost lost;
    /* a B-spline being read */
    int order;
    struct doubles knot, weight;
    struct vec3s pole_p, pole_q;
    struct ints pole_block; /* where each pole stands: its N number ... */
    struct sizes pole_line; /* ... and its line */
    struct nc_piece spline;
};

/* Error with the place of the block. */
int ncread_error(const struct ncread *c, struct error *error, const char *what);

/* A word that is not known here: an error where it may move the tool or change where it goes, as
 * every G, else it is noted. */
int ncread_unknown(struct ncread *c, const struct ncread_word *w, struct error *error);

/* The same where nothing may be passed over: an error. */
int ncread_unread(struct ncread *c, const struct ncread_word *w, struct error *error);

/* An M word: the spindle, the end, and those that move nothing. */
int ncread_m(struct ncread *c, const struct ncread_word *w, struct error *error);

/* The program is one of ncpost, by its head. */
bool ncread_ours(const struct ncread *c);

/* The N number of a block must rise; after 9900 and more it may begin anew. */
int ncread_block(struct ncread *c, double number, struct error *error);

/* X Y Z, the rotary words of this machine: true when `name` is one and `to` took the value. */
bool ncread_axis(const struct ncread *c, const char *name, double value, struct ncread_place *to);

/* The same for a word that counts from where the axis is; from an unknown place to another. */
bool ncread_axis_by(const struct ncread *c, const char *name, double value,
                    struct ncread_place *to);

/* A rotary word within 0 to 360 that is gone to by the shortest way: true if there is that axis. */
bool ncread_nearest(const struct ncread *c, char name, double value, struct ncread_place *to);

/* After rotary words the axis follows from them; after a vector they are not known. */
void ncread_turned(const struct ncread *c, struct ncread_place *to);
void ncread_pointed(struct ncread_place *to, struct vec3 axis);

/* A piece from here to there with the interpolation of its tool axis; its shape is the caller's. */
struct nc_piece ncread_piece(const struct ncread *c, const struct ncread_place *to);

/* The rotary axes stand at zero: the linear axes go where the tip goes. */
bool ncread_upright(const struct ncread *c);

/* The tool's length was on and is off: Z is that of the spindle's nose. */
bool ncread_nose(const struct ncread *c);

/*
 * Cuts in this block want the tool's length: where a program of others never switches it on, Z is
 * taken for the tip's height, and told; else it is an error.
 */
int ncread_length(struct ncread *c, struct error *error);

/* After each block: a length that comes on after cuts which were taken to need none is an error. */
int ncread_length_watch(struct ncread *c, struct error *error);

/* Checks what the control, or good practice, requires before the tool cuts. */
int ncread_ready(struct ncread *c, struct error *error);

/* The tool goes there: checks what a move needs, adds the piece. */
int ncread_go(struct ncread *c, const struct ncread_place *to, struct nc_piece piece, bool rapid,
              struct error *error);

/* Makes the piece an arc about `centre` in the active plane, counter-clockwise or clockwise. */
int ncread_arc(struct ncread *c, struct nc_piece *piece, struct vec3 centre, bool ccw,
               struct error *error);

/* The same from a radius (negative: more than a half turn). */
int ncread_arc_radius(struct ncread *c, struct nc_piece *piece, double radius, bool ccw,
                      struct error *error);

/* Makes the piece an arc through a point. */
int ncread_arc_through(struct ncread *c, struct nc_piece *piece, struct vec3 middle,
                       struct error *error);

/* One pole more of the spline being read; the first sets how the tool axis is interpolated. */
void ncread_pole(struct ncread *c, const struct nc_piece *piece, struct vec3 p, struct vec3 q);

/* The spline is complete: its knots are checked and it is added. */
int ncread_spline(struct ncread *c, struct error *error);

/* ---- units: words are read as they stand, what is made of them is in mm */

/* The program's lengths are `mm` long from here on; once set it stays so. */
int ncread_unit(struct ncread *c, double mm, struct error *error);

/* Brings a piece, with its arc or polynomials, to mm; the poles of the spline that was read. */
void ncread_unit_piece(struct ncread *c, struct nc_piece *piece);
void ncread_unit_poles(struct ncread *c);

#endif

/*
 * ncread - an NC program run as its control runs it, block by block, into a motion that can be
 * evaluated anywhere (simulate/nc_motion.h).  The door of the folder.
 *
 * In: the file of a program, its control, what the machine has (tool centre point control, rotary
 * axes).  Out: a struct nc_motion in mm and degrees, with the block of each piece.  What the
 * control would refuse, or what leaves open where the tool goes, is an error with its block.
 *
 * Each reader is written from its maker's manual and shares nothing with the code that writes
 * programs: a mistake made there must not be made here once more.
 *
 * Stages, all private to the folder:
 *   1. ncread_word.h: a line as words, as strictly as the control reads them;
 *   2. ncread_fanuc.c, ncread_siemens.c, ncread_heidenhain.c, ncread_linuxcnc.c: a block's words
 *      into the control's modal state and one move.  G code that Fanuc and LinuxCNC share is in
 *      ncread_gcode.h, drilling cycles in ncread_hole.h, tilted planes (3+2) in ncread_plane.h;
 *   3. ncread_state.h: the state of a control while it runs; a move as a piece of the motion,
 *      turned out of a tilted plane and brought to mm.
 *
 * Programs of others are read as far as they use words that are known; what a word of a control's
 * own means may be said in its file (ncread_meaning.h).
 *
 * Sources: Fanuc 30i operator's manual B-63944 and B-64484EN, Siemens 840D sl NC Programming and
 * Cycles, Heidenhain TNC 640 Klartext and Cycle Programming, LinuxCNC G-Codes.
 */
#ifndef CLOUDMILL_NCREAD_H
#define CLOUDMILL_NCREAD_H

#include "base/error.h"
#include "machine/control.h"
#include "machine/machine.h"
#include "math/region.h"
#include "math/transform.h"
#include "simulate/machine_time.h"
#include "simulate/nc_motion.h"

/* How one control reads (ncread_state.h). */
struct ncread_dialect;

/* What the comments before the first move say, in mm: ncread_head.h. */
enum {
    NCREAD_HEAD_TEXT = 1200,
    NCREAD_HEAD_NAME = 120,
    NCREAD_HEAD_SET = 320,
    NCREAD_SCANS = 500,
    NCREAD_COOLANTS = 4,
    NCREAD_HEAD_REGION = 40000
};
struct ncread_head {
    char tool[NCREAD_HEAD_TEXT];    /* all of it; "": nothing */
    double ball;                    /* radius; 0: not said */
    int number, numbers;            /* of its first tool, 0: none; how many tools are said */
    bool flute_given;               /* its length: */
    double flute;                   /* 0: none */
    char holder[NCREAD_HEAD_TEXT];  /* cones R0:R1:L or cylinders R:L joined by +; "": none */
    double scallop, tolerance;      /* 0: not said */
    bool noise_given;               /* of the scan: */
    double noise;                   /* one standard deviation; 0: every point is believed */
    double mesh;                    /* of this: the mesh off the scan; 0: not said */
    double smoothing;               /* what the control may smooth; 0: not said */
    double post, axis;              /* what ncpost spent, mm and degrees; below zero: not said */
    bool contact_feed;              /* feeds are those of the contact point */
    bool centre;                    /* places are the ball's centre, not the tip */
    bool numbered;                  /* by ncpost: in even steps */
    unsigned asked;                 /* enum nc_asked: what its path does amid a tool */
    bool dry;                       /* its first cut is made without coolant */
    bool anticlockwise;             /* and the spindle turns so in it */
    bool of_whole;                  /* the program is a part, and this of all of it: ... */
    double rapid;                   /* way of rapid moves, mm; 0: not said */
    char machine[NCREAD_HEAD_TEXT]; /* its name, as far as it is there; "": not said */
    char control_file[NCREAD_HEAD_NAME]; /* as -c has it, in any case; "": not said */
    char machine_file[NCREAD_HEAD_NAME]; /* the same of -m */
    char region[NCREAD_HEAD_REGION];     /* that it cuts, all of it; "": not said */
    double scan_points[NCREAD_SCANS];    /* of each file of the scan that guarded it, ... */
    uint64_t scan_hash[NCREAD_SCANS];    /* ... their hash (mesh/scan_source.h), ... */
    size_t scans;                        /* ... of the first ones */
    struct transform place;              /* from the numbers of its files to mm of the program */
    int place_rows;                      /* bits of its rows that are said; 7: all */
    char set[NCREAD_HEAD_SET];           /* keys of --set, as far as they are there */
    size_t unmet;                        /* statements of what could not be kept, ... */
    char unmet_first[NCREAD_HEAD_TEXT];  /* ... and how the first of them begins */
};

struct ncread_options {
    const struct ncread_dialect *dialect;
    bool tcp; /* the machine has tool centre point control */
    struct verify_kinematics kinematics;
    bool
        wraps[2]; /* that axis's words are within 0 to 360, and the shortest way is taken to them */
    bool cutcom;  /* radius compensation is wear alone: the path is the tool's centre */
    const char *words;                    /* what the control's file says of words, "": nothing */
    const char *coolant[NCREAD_COOLANTS]; /* blocks of the machine's own that switch it on, */
    const char *coolant_off;              /* and off; NULL, "": M7, M8, M9 alone */
    const struct control_text *text;      /* the control's file, of which the program is, ... */
    const char *control;                  /* its name, ... */
    const char *tool_change, *safe;       /* and its keys; NULL: they are not looked at */
    const char *home;                     /* the machine's own way home; NULL: Z0 alone */
    double z_top;                         /* Z of the machine at the top of its travel, mm */
    const struct machine_tool *tool;      /* the machine's, with their lengths */
    size_t tools;
    struct ncread_head *head; /* is filled; NULL: not wanted */
};

/*
 * Runs a whole program (NULL or "-": standard input) into the motion, which starts as all zero.
 * -1: it can't be run, the place is named.
 */
int ncread_read(const char *file, const struct ncread_options *options, struct nc_motion *motion,
                struct error *error);

/*
 * What the comments at the head of a program say, without running it: of its first lines, of which
 * a head has fewer.  -1: the file can't be read.
 */
int ncread_head_of(const char *file, struct ncread_head *head, struct error *error);

/* The region that a head says, which starts as all zero.  False: it says none, or not all of it. */
bool ncread_head_region(const struct ncread_head *head, struct region *region);

/* What its axes may do; tcp: the control keeps the tool's tip.  The struct of the time has no
 * limits yet; acceleration 0: the machine file gives none. */
struct axis_limits ncread_limits(const struct machine *machine, bool tcp);
struct machine_time_options ncread_time_options(const struct machine *machine);

/* The last digit of lengths in its programs, in their unit, where the machine has a number of
 * digits of its own; else 0. */
double ncread_digit(const struct machine *machine);

/* The reader of a control's programs. */
const struct ncread_dialect *ncread_of(enum control_id control);

/* The control that a program's first two lines are written for; CONTROLS with the error: none. */
enum control_id ncread_tell(const char *file, struct error *error);

/* The rotary axes of a machine file, from its keys type, axes, axis.* and centre.* alone. */
struct verify_kinematics ncread_kinematics(const struct machine *machine);

/* Which of its axes have words within 0 to 360: those without end, by its key rotary.words. */
void ncread_wraps(const struct machine *machine, const struct verify_kinematics *kinematics,
                  bool wraps[2]);

/* A text like `N120 (line 14)` for messages, at least 40 characters. */
void ncread_place(const struct nc_piece *piece, char *text, size_t size);

#endif

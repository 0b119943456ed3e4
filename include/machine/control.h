/*
 * control - the table of the controls that programs are written for and read from.
 *
 * A new control is a row here, a writer src/post/NAME.c with `dialect_NAME` (dialect.h), and a
 * reader src/ncread/ncread_NAME.c with `ncread_NAME` (ncread_state.h), written from the control's
 * manual and not from the writer.  Options, messages, machine files and both lists of dialects
 * follow the table.
 */
#ifndef CLOUDMILL_CONTROL_H
#define CLOUDMILL_CONTROL_H

#include <stdbool.h>

/*
 * ROW(name, title, tcp_of_machine, dc): the name in options and machine files; what people write;
 * true where the control has tool-centre-point control only on machines whose file names this
 * control, because it is done by the machine's kinematics and no word of a program; true where it
 * has C=DC(270), the shortest way to an angle from 0 to 360.
 */
#define CONTROL_TABLE(ROW)                      \
    ROW(fanuc, "Fanuc", false, false)           \
    ROW(siemens, "Siemens", false, true)        \
    ROW(heidenhain, "Heidenhain", false, false) \
    ROW(linuxcnc, "LinuxCNC", true, false)

/* CONTROL_fanuc and so on, in the order of the table. */
#define CONTROL_ID(name, title, tcp_of_machine, dc) CONTROL_##name,
enum control_id { CONTROL_TABLE(CONTROL_ID) CONTROLS };
#undef CONTROL_ID

struct control {
    const char *name, *title;
    bool tcp_of_machine, dc;
};

/* The row of a control. */
const struct control *control_row(enum control_id id);

/* The control of that name, CONTROLS: none. */
enum control_id control_find(const char *name);

/* All names, as a choice of cli.h: fanuc|siemens ... */
const char *control_names(void);

#endif

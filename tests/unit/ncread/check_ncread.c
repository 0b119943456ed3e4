/* check_ncread - small programs of each control, and the motion that they are known to make. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ncread/ncread.h"
#include "scratch.h"

enum {
    FANUC = CONTROL_fanuc,
    SIEMENS = CONTROL_siemens,
    HEIDENHAIN = CONTROL_heidenhain,
    LINUXCNC = CONTROL_linuxcnc
};

/* What stands before and behind the cut: spindle, tool, the tip at 0 0 50 with the axis upright. */
static const char *const head[] = {
    "%\nO0001\nG90 G17 G21 G94\nG53 G0 Z0.\nT1 M6\nS900 M3\nG0 A0. C0.\nG43.4 H1\n"
    "G0 X0. Y0. Z50.\nG1 F500.\n",
    "%_N_T_MPF\nG90 G17 G71 G94\nSUPA G0 Z0 D0\nT=\"B\" D1 M6\nS900 M3\nTRAORI\nORIAXES\n"
    "G0 A0 C0\nG0 X0 Y0 Z50\nG1 F500\n",
    "BEGIN PGM T MM\nL Z+0 R0 FMAX M91\nTOOL CALL 1 Z S900\nM3\nL A+0 C+0 R0 FMAX\n"
    "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\nL X+0 Y+0 Z+50 FMAX\n",
    "%\nG90 G17 G21 G94\nG53 G0 Z0\nT1 M6\nS900 M3\nG0 A0 C0\nG0 X0 Y0\nG43 H1 Z50\nG1 F500\n"};
static const char *const foot[] = {
    "G49\nG53 G0 Z0.\nM5\nM30\n%\n", "TRAFOOF\nSUPA G0 Z0 D0\nM5\nM30\n",
    "FUNCTION RESET TCPM\nL Z+0 R0 FMAX M91\nM5\nM30\nEND PGM T MM\n",
    "G49\nG53 G0 Z0\nM5\nM2\n%\n"};

/* Numbers the blocks of Klartext. */
static void numbered(char *text, size_t size)
{
    char copy[4000], *s = copy;
    size_t n = 0;
    snprintf(copy, sizeof copy, "%s", text);
    for (int i = 0; *s; i++) {
        size_t length = strcspn(s, "\n");
        n += (size_t)snprintf(text + n, size - n, "%d %.*s\n", i, (int)length, s);
        s += length + (s[length] == '\n');
    }
}

/* Reads the cut between head and foot; -1: refused. */
static int read_cut(int control, const char *cut, struct nc_motion *motion, struct error *error)
{
    char text[4000];
    struct ncread_options setup = {.dialect = ncread_of((enum control_id)control),
                                   .tcp = true,
                                   .kinematics = verify_kinematics_trunnion('A', 1)};
    snprintf(text, sizeof text, "%s%s%s", head[control], cut, foot[control]);
    if (control == HEIDENHAIN)
        numbered(text, sizeof text);
    *motion = (struct nc_motion){0};
    return ncread_read(scratch_text(text), &setup, motion, error);
}

/* The first piece at feed that goes anywhere. */
static const struct nc_piece *first_cut(const struct nc_motion *motion)
{
    for (size_t i = 0; i < motion->piece.n; i++)
        if (!motion->piece.item[i].rapid)
            return &motion->piece.item[i];
    return NULL;
}

static const struct {
    int control;
    const char *cut;
    struct vec3 middle,
        end;          /* of the tip half way and at the end of the last piece but the head's */
    struct vec3 axis; /* at the end */
    double feed;
} move_case[] = {
    /* straight, the axis turning: A 30 leans to -y in ISO sense, C 90 turns that to +x */
    {FANUC, "G1 X10. Y4. Z42. A30. C90.\n", {5, 2, 46}, {10, 4, 42}, {0.5, 0, 0.75}, 500},
    {SIEMENS, "G1 X10 Y4 Z42 A30 C90\n", {5, 2, 46}, {10, 4, 42}, {0.5, 0, 0.75}, 500},
    {HEIDENHAIN, "L X+10 Y+4 Z+42 A+30 C+90 F500\n", {5, 2, 46}, {10, 4, 42}, {0.5, 0, 0.75}, 500},
    {LINUXCNC, "G1 X10 Y4 Z42 A30 C90\n", {5, 2, 46}, {10, 4, 42}, {0.5, 0, 0.75}, 500},
    /* a quarter of a circle about (10, 0), from the left to the lower or upper side */
    {FANUC,
     "G3 X10. Y-10. I10. J0. F90.\n",
     {2.928932188134524, -7.071067811865475, 50},
     {10, -10, 50},
     {0, 0, 1},
     90},
    {FANUC,
     "G2 X10. Y10. R10.\n",
     {2.928932188134524, 7.071067811865475, 50},
     {10, 10, 50},
     {0, 0, 1},
     500},
    {SIEMENS,
     "G2 X10 Y10 I10 J0\n",
     {2.928932188134524, 7.071067811865475, 50},
     {10, 10, 50},
     {0, 0, 1},
     500},
    {SIEMENS,
     "G3 X10 Y-10 CR=10\n",
     {2.928932188134524, -7.071067811865475, 50},
     {10, -10, 50},
     {0, 0, 1},
     500},
    {HEIDENHAIN,
     "CC X+10 Y+0\nC X+10 Y+10 DR- F500\n",
     {2.928932188134524, 7.071067811865475, 50},
     {10, 10, 50},
     {0, 0, 1},
     500},
    {LINUXCNC,
     "G2 X10 Y10 I10 J0\n",
     {2.928932188134524, 7.071067811865475, 50},
     {10, 10, 50},
     {0, 0, 1},
     500},
    /* in Z X, clockwise seen from +Y: from -X over -Z, as +Y turns Z to X; and a helix */
    {FANUC, "G18 G2 X20. Z50. I10. K0.\n", {10, 0, 40}, {20, 0, 50}, {0, 0, 1}, 500},
    {LINUXCNC, "G3 X20 Y0 Z44 I10 J0\n", {10, -10, 47}, {20, 0, 44}, {0, 0, 1}, 500},
    /* through a point in space */
    {SIEMENS,
     "CIP X20 Y0 Z50 I1=AC(10) J1=AC(6) K1=AC(58)\n",
     {10, 6, 58},
     {20, 0, 50},
     {0, 0, 1},
     500},
    /* x = 8 p, y = 4 p^2, z = 50 - 8 p^3 over p from 0 to 1, with PL 2: p = q / 2 */
    {SIEMENS,
     "POLY PO[X]=(8) PO[Y]=(4,1) PO[Z]=(42,0,-1) PL=2\n",
     {4, 1, 49},
     {8, 4, 42},
     {0, 0, 1},
     500},
    /* a vector: the great circle to (0.6, 0, 0.8) */
    {HEIDENHAIN, "LN X+10 Y+0 Z+40 TX+0 TY+0 TZ+1 F500\n", {5, 0, 45}, {10, 0, 40}, {0, 0, 1}, 500},
    /* a cubic with uniform knots: its poles' mean by 1 3 3 1 in the middle */
    {FANUC,
     "G6.2 P4 K0. X0. Y0. Z50. A0. C0.\nK0. X2. Y8. Z50. A0. C0.\nK0. X8. Y8. Z50. A0. C0.\n"
     "K0. X10. Y0. Z50. A0. C0.\nK1.\nK1.\nK1.\nK1.\n",
     {5, 6, 50},
     {10, 0, 50},
     {0, 0, 1},
     500},
};

START_TEST(motion_is_known)
{
    struct nc_motion motion;
    struct error error;
    ck_assert_msg(read_cut(move_case[_i].control, move_case[_i].cut, &motion, &error) == 0, "%s",
                  error.text);
    const struct nc_piece *piece = first_cut(&motion);
    ck_assert_ptr_nonnull(piece);
    struct nc_motion_pose middle = nc_motion_at(&motion, piece, 0.5),
                          end = nc_motion_at(&motion, piece, 1);
    struct vec3 axis = move_case[_i].axis;
    axis.z = sqrt(1 - axis.x * axis.x - axis.y * axis.y);
    ck_assert_msg(vec_distance(middle.p, move_case[_i].middle) < 1e-9, "%g %g %g", middle.p.x,
                  middle.p.y, middle.p.z);
    ck_assert_double_lt(vec_distance(end.p, move_case[_i].end), 1e-9);
    ck_assert_double_lt(vec_distance(end.a, axis), 1e-9);
    ck_assert_double_eq(piece->feed, move_case[_i].feed);
    nc_motion_free(&motion);
}
END_TEST

/* In inches all is 25.4 times as long, its feed too. */
START_TEST(inches)
{
    static const char *const from[] = {"G21", "G71", "MM\n", "G21"};
    static const char *const to[] = {"G20", "G70", "INCH\n", "G20"};
    static const char *const cut[] = {"G2 X1. Y1. I1. J0.\n", "G2 X1 Y1 I1 J0\n",
                                      "CC X+1 Y+0\nC X+1 Y+1 DR- F500\n", "G2 X1 Y1 I1 J0\n"};
    char text[4000], changed[4000] = "";
    struct nc_motion motion = {0};
    struct error error;
    struct ncread_options setup = {.dialect = ncread_of((enum control_id)_i),
                                   .tcp = true,
                                   .kinematics = verify_kinematics_trunnion('A', 1)};
    snprintf(text, sizeof text, "%s%s%s", head[_i], cut[_i], foot[_i]);
    char *s = text;
    for (char *at = strstr(s, from[_i]); at; at = strstr(s, from[_i])) {
        strncat(changed, s, (size_t)(at - s));
        strcat(changed, to[_i]);
        s = at + strlen(from[_i]);
    }
    strcat(changed, s);
    if (_i == HEIDENHAIN)
        numbered(changed, sizeof changed);
    ck_assert_msg(ncread_read(scratch_text(changed), &setup, &motion, &error) == 0, "%s",
                  error.text);
    const struct nc_piece *piece = first_cut(&motion);
    struct nc_motion_pose middle = nc_motion_at(&motion, piece, 0.5);
    double side = 25.4 * sqrt(0.5);
    ck_assert_double_lt(vec_distance(middle.p, vec(25.4 - side, side, 50 * 25.4)), 1e-9);
    ck_assert_double_eq_tol(piece->feed, 500 * 25.4, 1e-9);
    nc_motion_free(&motion);
}
END_TEST

/* What no control would do. */
static const struct {
    int control;
    const char *cut, *found;
} refused[] = {
    {FANUC, "G2 X10. Y10. I10. J1.\n", "one distance"},
    {FANUC, "G2 X30. Y0. R10.\n", "diameter"},
    {FANUC, "G1 X10\n", "decimal point"},
    {FANUC, "G1 X1. X2.\n", "twice"},
    {FANUC, "G1 X1. U2.\n", "U2"},
    {FANUC, "G0 X-0.\n", "minus zero"},
    {FANUC, "G1 X1e3\n", "exponent"},
    {FANUC, "G6.2 P4 K0. X1. Y0. Z50. A0. C0.\n", "first pole"},
    {FANUC, "G6.2 P4 K0. X0. Y0. Z50. A0. C0.\nK0. X2. Y8. Z50. A0. C0.\nG1 X1.\n", ""},
    {SIEMENS, "G1 X10 A3=0 B3=0\n", "all three"},
    {SIEMENS, "G1 X10 A3=0 B3=0 C3=2\n", "length 1"},
    {SIEMENS, "CIP X20 Y0 I1=AC(10) J1=AC(0) K1=AC(50)\n", "on a line"},
    {SIEMENS, "POLY PO[X]=(8) PL=0\n", "PL"},
    {SIEMENS, "G1 PO[X]=(8)\n", "without POLY"},
    {SIEMENS, "BSPLINE SD=3 X1 PL=2\n", "BSPLINE with tool vectors or PL"},
    {SIEMENS, "BSPLINE SD=3 X1 A3=0 B3=0 C3=1\n", "BSPLINE with tool vectors or PL"},
    {SIEMENS, "SUPA G0 Z0\n", "TRAORI"},
    {HEIDENHAIN, "L X+00000000000000000000000000000000000010 F500\n", "too long"},
    {HEIDENHAIN, "L X+1 Y+1 Z+1 A+1 C+1 R0 F1 R0 R0 R0 R0 R0 R0 R0 R0 R0 R0\n", "too long"},
    {HEIDENHAIN, "L X10 F500\n", "sign"},
    {HEIDENHAIN, "L X+10 X+11 F500\n", "twice"},
    {HEIDENHAIN, "L X+10 F0\n", "feed"},
    {HEIDENHAIN, "C X+10 Y+10 DR+ F500\n", "CC"},
    {HEIDENHAIN, "LN X+10 TX+0 TY+0 F500\n", "TX TY TZ"},
    {HEIDENHAIN, "M30\nL X+10 F500\n", "END PGM"},
    {FANUC, "G2.4 X5. Y5. Z50.\nG2.4 X9. Y0. Z50.\nG2.4 X8. Y1. Z50.\nG1 X1.\n",
     "G02.4 within G02.4"},
    {FANUC, "G91 G2.4 X5. Y5. Z0.\n", "G02.4 under G91"},
    {FANUC, "G2.4 X5. Y5. Z50.\nG1 X9.\n", "G02.4 without its end"},
    {FANUC, "G49\nG6.2 P4 K0. X0. Y0. Z50.\n", "a place or with an axis"},
    {FANUC, "G91 G6.2 P4 K0. X0. Y0. Z50.\n", "G06.2 under G91"},
    {FANUC, "G6.2 K0. X0. Y0. Z50.\n", "G06.2 without its order P"},
    {FANUC, "G6.2 P5 K0. X0. Y0. Z50. A0. C0.\n", "order is not 2 to 4"},
    {FANUC, "G6.2 P1 K0. X0. Y0. Z50. A0. C0.\n", "order is not 2 to 4"},
    {FANUC, "G6.2 P4 K0. X0. Y0. Z50. A0. C0.\nX1. Y0. Z50. A0. C0.\n", "without its knot K"},
    {FANUC, "G28 Z0.\n", "G28 or G53 under tool centre point control"},
    {FANUC, "G53 G1 Z0.\n", ""},
    {FANUC, "G43.5 H1\nG1 X1. I0. J0.\n", "all of I J K and length 1"},
    {FANUC, "G43.5 H1\nG1 X1. I0. J0. K1.002\n", "all of I J K and length 1"},
    {FANUC, "G43.5 H1\nG1 X1. A1.\n", "rotary words under G43.5"},
    {FANUC, "G5.1 Q1 X1.\n", "G05.1 with a place"},
    {FANUC, "M30\nG1 X1.\n", "expected % after M30"},
    {FANUC, "G1 X1. N5\n", "N after other words"},
    {FANUC, "G20\nG1 X1.\n", "millimetres and inches"},
    {SIEMENS, "G2 X10 Y0 I5 J0 CR=5\n", "not both"},
    {SIEMENS, "G1 X10 I1=AC(5)\n", "CIP wants"},
    {SIEMENS, "CIP X20 Y0\n", "CIP wants"},
    {SIEMENS, "CIP X20 Y0 I1=5 J1=AC(0) K1=AC(50)\n", "without AC()"},
    {SIEMENS, "G91 BSPLINE SD=3 X1\n", "a curve under G91"},
    {SIEMENS, "G1 X1 PW=2\n", "PW without BSPLINE"},
    {SIEMENS, "G1 X1 XH=1 YH=2 ZH=3\n", "ORICURVE"},
    {SIEMENS, "ORICURVE\nPOLY PO[X]=(9) PL=2\n", "without UPATH"},
    {SIEMENS, "UPATH\nSPATH\nORICURVE\nPOLY PO[X]=(9) PL=2\n", "without UPATH"},
    {SIEMENS, "G95\n", "G95, a feed per revolution"},
    {FANUC, "G95\n", "G95, a feed per revolution"},
    {HEIDENHAIN, "M136\n", "M136, a feed per revolution"},
    {HEIDENHAIN, "TOOL CALL 1 Z S900 DL+0.2\n", "DL or DR"},
    {HEIDENHAIN, "TOOL CALL 1 Z DR-0.05 S900\n", "DL or DR"},
    {HEIDENHAIN, "TOOL CALL 1 Z S900 DR2:+1\n", "DL or DR"},
    {HEIDENHAIN, "TOOL CALL \"A DRILL\" Z Sx DL+0 DR2+0\n", "a speed that is no number"},
    {SIEMENS, "G1 X1 X2\n", "twice"},
    {SIEMENS, "G1 X1 A3=0 B3=0 C3=1 A1 C1\n", ""},
    {SIEMENS, "M30\nG1 X1\n", "a block after M30"},
    {SIEMENS, "G2 X0 Y0 CR=5\n", "ends coincide"},
    {HEIDENHAIN, "L Z+10 Z+11 F500\n", "twice"},
    {HEIDENHAIN, "L A+10 X+1 A+11 F500\n", "twice"},
    {HEIDENHAIN, "LN X+1 TX+0 TX+0 TY+0 TZ+1 F500\n", "twice"},
    {HEIDENHAIN, "LN X+1 TX+0 TY+0 TZ+1 TZ+1 F500\n", "twice"},
    {HEIDENHAIN, "L X+1 F500 F600\n", "twice"},
    {HEIDENHAIN, "L X+1 IX+1 F500\n", "twice"},
    {HEIDENHAIN, "L X+10 TX+0 TY+0 TZ+1 F500\n", "LN wants"},
    {HEIDENHAIN, "LN X+10 TX+0 TY+0 TZ+1.002 F500\n", "length 1"},
    {HEIDENHAIN, "CC X+10\n", "CC wants X and Y"},
    {HEIDENHAIN, "CC X+5 Y+0\nC X+10 Y+0 F500\n", "C wants DR+ or DR-"},
    {HEIDENHAIN, "CC X+5 Y+0\nC X+10 Y+0 Z+3 DR+ F500\n", "C wants X, Y, DR and F alone"},
    {HEIDENHAIN, "L Z+0 R0 FMAX M91\n", "M91 under"},
    {HEIDENHAIN, "FUNCTION FROB\n", "FUNCTION"},
    {HEIDENHAIN, "PLANE SPATIAL SPA+0 SPB+0 TURN F500\n", ""},
    {HEIDENHAIN, "L X+1 F-500\n", "feed"},
    {LINUXCNC, "G1 X1 X2\n", "twice"},
    {LINUXCNC, "o100 sub\n", "a subprogram or a loop"},
    {LINUXCNC, "N10 O<name> call\n", "a subprogram or a loop"},
    {LINUXCNC, "M2\nG1 X1\n", "expected % after M2"},
    {LINUXCNC, "G2 X10 Y0 I5.1 J0\n", "one distance"},
    {LINUXCNC, "G2 X30 Y0 R10\n", "diameter"},
    {LINUXCNC, "G2 X0 Y0 R10\n", "ends coincide"},
    {LINUXCNC, "G20\nG1 X1\n", "millimetres and inches"},
    {LINUXCNC, "G4 X1\n", ""},
    {LINUXCNC, "G5.2 X1 Y1\n", "G5.2"},
    {LINUXCNC, "G2 X10 Y10\n", "centre"},
    {LINUXCNC, "G1 X10 I3\n", "a line"},
    {LINUXCNC, "G93 G1 X10\n", "feed"},
    {LINUXCNC, "G49\nG1 X10\n", "length"},
    {LINUXCNC, "M5\nG1 X10\n", "spindle"},
};

START_TEST(refused_with_its_line)
{
    struct nc_motion motion;
    struct error error = {.text = ""};
    ck_assert_int_lt(read_cut(refused[_i].control, refused[_i].cut, &motion, &error), 0);
    ck_assert_msg(strstr(error.text, refused[_i].found) != NULL, "%s", error.text);
    ck_assert_msg(strncmp(error.text, scratch_name(), strlen(scratch_name())) == 0 &&
                      error.text[strlen(scratch_name())] == ':',
                  "%s", error.text);
    nc_motion_free(&motion);
}
END_TEST

/* Words within a turn are of axes without end alone, wherever their travel lies. */
/* Lines of nothing behind the end are no blocks, and a block there is one too many. */
START_TEST(behind_the_end)
{
    static const char *const cut[CONTROLS] = {"G1 X10.\n", "G1 X10\n", "L X+10 F500\n", "G1 X10\n"};
    static const char *const behind[] = {"", "\n", "\n \n\t\n", "\r\n"};
    struct error error;
    for (int i = 0; i < 5; i++) {
        char text[4000];
        struct nc_motion motion = {0};
        struct ncread_options setup = {.dialect = ncread_of((enum control_id)_i),
                                       .tcp = true,
                                       .kinematics = verify_kinematics_trunnion('A', 1)};
        snprintf(text, sizeof text, "%s%s%s%s", head[_i], cut[_i], foot[_i], i == 4 ? "M5\n" : "");
        if (_i == HEIDENHAIN)
            numbered(text, sizeof text);
        size_t n = strlen(text);
        if (i < 4)
            snprintf(text + n, sizeof text - n, "%s", behind[i]);
        int got = ncread_read(scratch_text(text), &setup, &motion, &error);
        ck_assert_msg((got == 0) == (i < 4), "%d: %s", i, error.text);
        nc_motion_free(&motion);
    }
}
END_TEST

START_TEST(words_within_a_turn)
{
    const struct {
        double from, to;
        int words;
        bool within;
    } c[] = {{-9999, 9999, ROTARY_WITHIN, true},  {-9999, 9999, ROTARY_SIGNED, true},
             {-9999, 9999, ROTARY_PLAIN, false},  {-9999, 9999, ROTARY_OWN, false},
             {-9999, 9999, ROTARY_DC, false},     {3800, 4200, ROTARY_WITHIN, false},
             {-360, 360, ROTARY_SIGNED, false},   {-1800, 1801, ROTARY_WITHIN, true},
             {-1800, 1800, ROTARY_WITHIN, false}, {-8000, -4000, ROTARY_SHORTEST, true}};
    for (size_t i = 0; i < sizeof c / sizeof *c; i++) {
        struct machine machine = machine_default();
        struct error error;
        bool wraps[2] = {false, false};
        ck_assert_int_eq(machine_finish(&machine, &error), 0);
        struct verify_kinematics kinematics = ncread_kinematics(&machine);
        machine.rotary_words = c[i].words;
        machine.min[MACHINE_C] = c[i].from;
        machine.max[MACHINE_C] = c[i].to;
        ncread_wraps(&machine, &kinematics, wraps);
        ck_assert_int_eq(kinematics.n, 2);
        for (int k = 0; k < 2; k++) /* A is within 200 degrees */
            ck_assert(wraps[k] == (kinematics.axis[k].letter == 'C' && c[i].within));
    }
}
END_TEST

/* Two seconds in the words of each control. */
START_TEST(dwells)
{
    static const char *const word[] = {[FANUC] = "G4 X2.\n",
                                       [SIEMENS] = "G4 F2\n",
                                       [HEIDENHAIN] =
                                           "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 2\n",
                                       [LINUXCNC] = "G4 P2\n"};
    for (int i = 0; i < CONTROLS; i++) {
        struct nc_motion motion;
        struct error error;
        ck_assert_msg(read_cut(i, word[i], &motion, &error) == 0, "%s", error.text);
        ck_assert_double_eq_tol(motion.dwell, 2.0 / 60, 1e-12);
        nc_motion_free(&motion);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ncread");
    TCase *tcase = tcase_create("ncread");

    tcase_add_test(tcase, dwells);
    tcase_add_loop_test(tcase, motion_is_known, 0, (int)(sizeof move_case / sizeof *move_case));
    tcase_add_loop_test(tcase, inches, 0, CONTROLS);
    tcase_add_loop_test(tcase, refused_with_its_line, 0, (int)(sizeof refused / sizeof *refused));
    tcase_add_loop_test(tcase, behind_the_end, 0, CONTROLS);
    tcase_add_test(tcase, words_within_a_turn);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

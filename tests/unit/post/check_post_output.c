/* post_output: the whole, from a pass on, in parts, in files of so many blocks, and where a block
 * comes from: of paths whose blocks are known; all files together cut what the whole cuts. */
#include "programs.h"

#include "ncread/ncread.h"
#include "post/post_output.h"

static char name[300];

static const struct post_extract whole = {.from = -1, .explain = -1};

static const char two[] = "UNITS/MM\nMULTAX/ON\nCUTTER/8,4\nLOADTL/3\nSPINDL/RPM,5000,CLW\n"
                          "$$-> PASS/1\nRAPID\nGOTO/0,0,20,0,0,1\nFEDRAT/600,MMPM\n"
                          "GOTO/0,0,0,0,0,1\nGOTO/10,0,0,0,0,1\nGOTO/10,0,20,0,0,1\n$$-> PASS/2\n"
                          "RAPID\nGOTO/0,5,20,0,0,1\nGOTO/0,5,-1,0,0,1\nGOTO/10,5,-1,0,0,1\n"
                          "COOLNT/ON\nGOTO/12,5,-1,0,0,1\nRAPID\nGOTO/12,5,20,0,0,1\nFINI\n";

static void begin(const char *text)
{
    struct post_options options = programs_begin(CONTROL_fanuc, text);
    snprintf(name, sizeof name, "%s.nc", scratch_name());
    ck_assert_int_eq(programs_plan(CONTROL_fanuc, &options), 0);
}

static void teardown(void)
{
    remove(name);
    programs_end();
}

static const char *written(struct post_extract extract)
{
    size_t files;
    ck_assert_msg(post_write(post, extract, name, &files, &error) == 0, "%s", error.text);
    ck_assert_uint_eq(files, 1);
    return programs_text(name);
}

/* Start and end by the usual Fanuc blocks, between them the path's motions and no others. */
START_TEST(all_and_from_a_pass_on)
{
    begin(two);
    struct post_extract extract = whole;
    const char *text = strstr(written(whole), "G43.4 H3\n");
    ck_assert_ptr_nonnull(text);
    ck_assert_str_eq(text, "G43.4 H3\nN90 G0 X0. Y0.\nN100 Z20.\nN110 G1 Z0. F600.\nN120 X10.\n"
                           "N130 Z20.\nN140 G0 X0. Y5.\nN150 G1 Z-1.\nN160 X10.\nN170 M8\n"
                           "N180 X12.\nN190 G0 Z20.\nN200 G49 G91 G28 Z0.\nN210 G90\n"
                           "N220 G0 A0. C0.\nN230 M9\nN240 M5\nN250 M30\n");
    extract.from = 2;
    text = strstr(written(extract), "G43.4 H3\n");
    ck_assert_str_eq(text, "G43.4 H3\nN90 G0 X0. Y5.\nN100 Z20.\nN110 G1 Z-1. F600.\nN120 X10.\n"
                           "N130 M8\nN140 X12.\nN150 G0 Z20.\nN160 G49 G91 G28 Z0.\nN170 G90\n"
                           "N180 G0 A0. C0.\nN190 M9\nN200 M5\nN210 M30\n");
    size_t files;
    extract.from = 3;
    ck_assert_int_eq(post_write(post, extract, name, &files, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "found no pass 3 in"));
}
END_TEST

/* From a pass that begins in the cut: over its first place, 50 mm off it, down at feed; what
 * lasted before (coolant, speed) is said again. */
START_TEST(from_within_a_cut)
{
    begin("UNITS/MM\nMULTAX/ON\nCUTTER/8,4\nLOADTL/3\nSPINDL/RPM,5000,CLW\nRAPID\n"
          "GOTO/0,0,30,0,0,1\nFEDRAT/600,MMPM\n$$-> PASS/1\nGOTO/0,0,0,0,0,1\nSPINDL/RPM,4000,CLW\n"
          "COOLNT/MIST\nGOTO/10,0,0,0,0,1\n$$-> PASS/2\nGOTO/10,3,0,0,0,1\nGOTO/0,3,0,0,0,1\n"
          "RAPID\nGOTO/0,3,30,0,0,1\nFINI\n");
    struct post_extract extract = whole;
    extract.from = 2;
    const char *text = written(extract);
    ck_assert_ptr_nonnull(strstr(text, "S4000 M3"));
    ck_assert_ptr_null(strstr(text, "S5000"));
    ck_assert_ptr_nonnull(strstr(text, "M7"));
    text = strstr(text, "X10. Y0.\n");
    ck_assert_ptr_nonnull(text);
    ck_assert_int_eq(strncmp(strchr(text, '\n') + 1, "N100 Z50.\nN110 M7\nN120 G1 Z0. F600.\n", 36),
                     0);
    ck_assert_ptr_nonnull(strstr(text, "Y3.\nN140 X0.\nN150 G0 Z30.\n"));
}
END_TEST

/* N rows of cuts at feed 10 apart in x, each from rapid to rapid; every other line one mm on. */
static void begin_rows(int rows, bool lifted)
{
    char *text = malloc(200 + 120 * (size_t)rows), *to = text;
    to += sprintf(to, "UNITS/MM\nMULTAX/ON\nCUTTER/8,4\nLOADTL/3\nSPINDL/RPM,5000,CLW\nRAPID\n"
                      "GOTO/0,0,20,0,0,1\nFEDRAT/600,MMPM\n");
    for (int i = 0; i < rows; i++) {
        to += sprintf(to, "$$-> PASS/%d\n", i + 1);
        if (lifted)
            to += sprintf(to, "RAPID\nGOTO/0,%d,20,0,0,1\n", i);
        to += sprintf(to, "GOTO/%d,%d,0,0,0,1\nGOTO/%d,%d,-1,0,0,1\n", 10 * (i % 2), i,
                      10 - 10 * (i % 2), i);
        if (lifted)
            to += sprintf(to, "RAPID\nGOTO/%d,%d,20,0,0,1\n", 10 - 10 * (i % 2), i);
    }
    sprintf(to, "RAPID\nGOTO/0,0,20,0,0,1\nFINI\n");
    begin(text);
    free(text);
}

/* The cuts of a program below the surface's 0.5, as ncread runs it: where they end, appended. */
static size_t cuts_of(const char *file, struct vec3s *end, bool *safe)
{
    struct nc_motion motion = {0};
    const struct ncread_options options = {.dialect = ncread_of(CONTROL_fanuc),
                                           .tcp = true,
                                           .kinematics = ncread_kinematics(&machine)};
    ck_assert_msg(ncread_read(file, &options, &motion, &error) == 0, "%s", error.text);
    for (size_t i = 0; i < motion.piece.n; i++) {
        const struct nc_piece *piece = &motion.piece.item[i];
        if (piece->rapid) /* none goes sideways below the plane, and none down into the part */
            *safe = *safe &&
                    (piece->p[1].z > 19.999 ||
                     (hypot(piece->p[1].x - piece->p[0].x, piece->p[1].y - piece->p[0].y) < 1e-6 &&
                      piece->p[1].z > piece->p[0].z));
        else if (piece->p[0].z < 0.5)
            *array_push(end) = piece->p[1];
    }
    size_t n = motion.piece.n;
    if (n > 0) /* off the part at the end */
        *safe = *safe && motion.piece.item[n - 1].p[1].z > 19.999;
    nc_motion_free(&motion);
    return n;
}

static size_t lines_of(const char *text)
{
    size_t n = 0;
    for (; *text; text++)
        n += *text == '\n';
    return n;
}

/* Each file has no more blocks than it may, starts and ends off the part, and all together cut what
 * the whole does, in its order. */
static void split(bool lifted, size_t blocks)
{
    struct post_extract extract = whole;
    struct vec3s all = {0}, parts = {0};
    bool safe = true;
    size_t files, at = 0;
    begin_rows(40, lifted);
    written(whole);
    cuts_of(name, &all, &safe);
    ck_assert_uint_ge(all.n, lifted ? 40 : 79);
    extract.blocks = blocks;
    ck_assert_msg(post_write(post, extract, name, &files, &error) == 0, "%s", error.text);
    ck_assert_uint_ge(files, 2);
    for (size_t k = 1; k <= files; k++) {
        char part[340];
        snprintf(part, sizeof part, "%s-%zu.nc", scratch_name(), k);
        ck_assert_uint_le(lines_of(programs_text(part)), blocks);
        cuts_of(part, &parts, &safe);
        remove(part);
    }
    ck_assert(safe);
    for (size_t i = 0; i < parts.n && at < all.n; i++) /* a place may be cut to twice */
        at += vec_distance(parts.item[i], all.item[at]) < 1e-6;
    ck_assert_uint_eq(at, all.n);
    ck_assert_uint_le(parts.n, all.n + 2 * files);
    array_free(&all);
    array_free(&parts);
}

START_TEST(files_of_so_many_blocks)
{
    static const size_t blocks[] = {45, 60, 101};
    split(_i % 2, blocks[_i / 2]);
}
END_TEST

START_TEST(too_little_room)
{
    struct post_extract extract = whole;
    size_t files, need;
    begin_rows(4, true);
    extract.blocks = 5;
    ck_assert_int_eq(post_write(post, extract, name, &files, &error), -1);
    ck_assert_int_eq(sscanf(strstr(error.text, "at least"), "at least %zu blocks", &need), 1);
    extract.blocks = need - 1;
    ck_assert_int_eq(post_write(post, extract, name, &files, &error), -1);
    FILE *f = fopen(name, "r"); /* nothing is written */
    ck_assert_ptr_null(f);
}
END_TEST

/* Two halves, one after the other, are the whole's bytes. */
START_TEST(halves_are_the_whole)
{
    char *all = calloc(40000, 1), *both = calloc(40000, 1);
    size_t n = 0;
    begin_rows(5, true);
    for (long k = 0; k <= 2; k++) {
        struct post_extract extract = whole;
        size_t files;
        if (k > 0)
            extract.part = (struct path_part){k, 2};
        ck_assert_int_eq(post_write(post, extract, name, &files, &error), 0);
        FILE *f = fopen(name, "r");
        char *to = k == 0 ? all : both + n;
        size_t got = fread(to, 1, 19000, f);
        to[got] = '\0';
        fclose(f);
        ck_assert_uint_gt(got, 100);
        n += k > 0 ? got : 0;
    }
    ck_assert_str_eq(all, both);
    free(all);
    free(both);
}
END_TEST

START_TEST(where_a_block_comes_from)
{
    begin(two);
    struct post_extract extract = whole;
    size_t files;
    extract.explain = 180;
    ck_assert_int_eq(post_write(post, extract, name, &files, &error), 0);
    const char *text = programs_text(name);
    ck_assert_ptr_nonnull(strstr(text, "X12."));
    ck_assert_ptr_nonnull(strstr(text, ":19: pass 2, straight: as the path says it"));
    extract.explain = 200;
    ck_assert_int_eq(post_write(post, extract, name, &files, &error), 0);
    ck_assert_ptr_nonnull(strstr(programs_text(name), "at the start or the end of every program"));
    extract.explain = 260;
    ck_assert_int_eq(post_write(post, extract, name, &files, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "found no block 260, the last one is 250"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_output");
    TCase *tests = tcase_create("post_output");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, all_and_from_a_pass_on);
    tcase_add_test(tests, from_within_a_cut);
    tcase_add_loop_test(tests, files_of_so_many_blocks, 0, 6);
    tcase_add_test(tests, too_little_room);
    tcase_add_test(tests, halves_are_the_whole);
    tcase_add_test(tests, where_a_block_comes_from);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}

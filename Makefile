# cloudmill: see README.md for what it is, HACKING.md for the map of the house.  For GNU make, which
# is `gmake` on a BSD.
#
# make              the tools, in build/bin             make demo     the main job on a real scan
# make figures      pictures like the papers'       make samples  the tasks of the gallery
# make html         the manuals for a browser
# make check        all tests                            make deps     what the tests need (Debian)
#                                                        make deps-all what else some tests use
# make accuracy     gouges and material left, on surfaces known exactly
# make install      PREFIX=/usr/local DESTDIR=           make bench    speed, beside bare C floors
# make faults       every call of the C library fails in turn
# make static           without shared libraries (musl)  make windows  with mingw-w64
# make portability      jobs on other platforms: same bytes?
# make lint sanitize fuzz dist distcheck clean uninstall

# A directive to the make of a BSD, which stops here with these words; to GNU make a rule that nobody
# asks for.
.error : GNU make is needed, type gmake in place of make

PREFIX  = /usr/local
DESTDIR =
CC      = cc
CFLAGS  = -O3 -fno-asynchronous-unwind-tables
BUILD   = build
EXE     =
VERSION := $(shell cat VERSION)

WARN  = -Wall -Wextra -Wshadow -Wconversion
FLAGS = -std=c11 -D_XOPEN_SOURCE=700 -iquote include -ffp-contract=off -fno-math-errno \
        -ffunction-sections -pthread $(WARN)
LIBS  = -Wl,--gc-sections -lm -pthread

tool_src := $(wildcard src/*.c)
lib_src  := $(wildcard src/*/*.c src/io/*/*.c)
page_src := $(wildcard src/verify/page.*)
back_src := $(wildcard tests/readback/*.c)
unit_src := $(wildcard tests/unit/*.c tests/unit/*/*.c tests/unit/io/*/*.c)
help_src := $(wildcard tests/lib/*.c)
bench_src := $(wildcard tests/bench/*.c)
c_files  := $(filter-out tests/data/%,$(wildcard $(foreach top,src include tests,\
              $(addprefix $(top)/,*.[ch] */*.[ch] */*/*.[ch] */*/*/*.[ch]))))
cloud    := $(BUILD)/tests/accuracy/cloud
edges    := $(BUILD)/tests/accuracy/edges
manuals  := $(wildcard man/*.[157])
machines := $(wildcard machines/*.txt)
tool_files := $(wildcard tools/*.txt)
controls := $(wildcard controls/*.txt)
built_in := fanuc siemens heidenhain linuxcnc

tools    := $(tool_src:src/%.c=$(BUILD)/bin/%$(EXE)) $(BUILD)/bin/cloudmill
lib      := $(BUILD)/libcloudmill.a
page_obj := $(page_src:%=$(BUILD)/%.o)
control_obj := $(built_in:%=$(BUILD)/controls/%.o)
lib_obj  := $(lib_src:%.c=$(BUILD)/%.o) $(page_obj) $(control_obj) $(BUILD)/version.o
back_obj := $(back_src:%.c=$(BUILD)/%.o)
help_obj := $(help_src:%.c=$(BUILD)/%.o)
units    := $(unit_src:tests/%.c=$(BUILD)/tests/%)
benches  := $(bench_src:tests/bench/%.c=$(BUILD)/bench/%)
readback := $(if $(back_src),$(BUILD)/tests/readback/readback)

started := $(shell date +%s)

# Debian's packages, beside make and a C compiler.  `make deps`: the tests; tests that want more are
# skipped, and say what they miss.
packages = check pkg-config mandoc python3 locales
# `make deps-all`: every test, make lint, fuzz, coverage, portability, deb.  A package that this
# Debian does not have is told and left out.
packages_all = $(packages) chromium linuxcnc-uspace parallel rsync \
  clang clang-format clang-tidy libclang-rt-dev cppcheck shellcheck gcovr \
  musl-tools gcc-mingw-w64-x86-64-posix wine wine64 qemu-user-static gcc-aarch64-linux-gnu \
  libc6-dev-arm64-cross gcc-i686-linux-gnu libc6-dev-i386-cross lintian debhelper fakeroot zsh fish \
  bash-completion bmake
apt_install = DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends

all: $(tools)

$(BUILD)/tests/lib/%.o: FLAGS += -iquote src -iquote tests/lib
# The Makefile, for it has the flags.
$(BUILD)/%.o: %.c Makefile
	@mkdir -p $(@D)
	$(CC) $(FLAGS) $(CFLAGS) $(CPPFLAGS) -MD -MP -c -o $@ $<

# Readers of models and machines, trimming, clipping and what calls the stages run once: at most -O2,
# so that no tool has more than 1 MB.  An optimiser changes no byte of a result.
once := io/nurbs/% nurbs/trim_% nurbs/construct nurbs/uv_polygon machine/machine% stage/% \
  mesh/mesh_clip mesh/mesh_repair toolpath/pass_extend toolpath/rest_% base/cli \
  io/path/path_tool io/mesh/ply io/mesh/ply_source toolpath/scallop gouge/link% nurbs/pullback \
  toolpath/passes cloud/sheets cloud/edge_flank cloud/edge_meet cloud/cone_tip curve/edge_curve \
  gouge/gouge_refit
$(once:%=$(BUILD)/src/%.o): CFLAGS := $(CFLAGS:-O3=-O2)
# Of these, IGES and STEP files and where rest passes go, also without what makes -O2 longer.
small := io/nurbs/nurbs_text% machine/machine machine/machine_options machine/template base/cli \
  stage/tool_% stage/nurbs_report stage/path_options stage/gouge_options stage/guard_read \
  stage/toolpath_report stage/path_coverage stage/path_check io/nurbs/iges% io/nurbs/step% \
  toolpath/rest_% stage/toolpath_shorten stage/toolpath_moves stage/toolpath_order \
  io/path/path_cycle nurbs/construct mesh/mesh_repair io/path/path_tool mesh/mesh_clip \
  nurbs/uv_polygon stage/plane_passes stage/mesh_% stage/coverage_judge toolpath/pass_extend \
  io/path/path_head io/path/path_write io/mesh/ply_origin io/cloud/cloud_formats nurbs/primitive \
  nurbs/approximate stage/toolpath simulate/unseen_% mesh/mesh_outline io/mesh/stl io/mesh/off \
  io/mesh/meshfile io/cloud/cloud io/cloud/cloud_las gouge/holder_text cloud/steep_facets \
  cloud/rim_points cloud/roof cloud/edge_cliff% cloud/edge_points cloud/noise cloud/outliers \
  cloud/outliers_kept cloud/edge_unknown gouge/link gouge/link_retract nurbs/trim_told \
  nurbs/trim_tidy nurbs/trim_order nurbs/trim_follow nurbs/trim_loops nurbs/pullback cloud/sheets \
  toolpath/passes toolpath/scallop gouge/axis_lone cloud/edge_flank cloud/edge_meet \
  cloud/edge_wide cloud/edge_slope cloud/edge_foot stage/normals stage/path_judged \
  stage/surface_contacts nurbs/trim_crossings planecut stage/cloud_prepare \
  nurbs/trim_seam cloud/rounding cloud/believed cloud/edge_along cloud/scan_edges \
  gouge/guard_points gouge/guard_mesh gouge/axis_plan curve/run cloud/edge_fill
$(small:%=$(BUILD)/src/%.o): CFLAGS := $(patsubst -O2,-Os,$(CFLAGS:-O3=-Os))

# The file VERSION is what `--version`, the tarball and the packages say.
$(BUILD)/version.c: VERSION
	@mkdir -p $(@D)
	echo '#include "base/cli.h"' >$@.new && echo 'const char cloudmill_version[] = "$(VERSION)";' >>$@.new && mv $@.new $@

$(BUILD)/version.o: $(BUILD)/version.c Makefile
	$(CC) $(FLAGS) $(CFLAGS) $(CPPFLAGS) -MD -MP -c -o $@ $<

# The controls that are built in, as strings: controls/fanuc.txt is `const char control_text_fanuc[]`.
$(BUILD)/controls/%.c: controls/%.txt
	@mkdir -p $(@D)
	{ echo 'extern const char control_text_$*[];' && echo 'const char control_text_$*[] =' && \
	  sed -e 's/\\/\\\\/g' -e 's/"/\\"/g' -e 's/.*/"&\\n"/' $< && echo ';'; } >$@.new && mv $@.new $@

$(control_obj): $(BUILD)/controls/%.o: $(BUILD)/controls/%.c Makefile
	$(CC) $(FLAGS) $(CFLAGS) $(CPPFLAGS) -MD -MP -c -o $@ $<

# The files of the verdict's page as strings: page.js is `const char page_js[]`.
$(BUILD)/src/verify/page.%.c: src/verify/page.%
	@mkdir -p $(@D)
	{ echo 'extern const char page_$*[];' && echo 'const char page_$*[] =' && \
	  sed -e 's/\\/\\\\/g' -e 's/"/\\"/g' -e 's/.*/"&\\n"/' $< && echo ';'; } >$@.new && mv $@.new $@

$(page_obj): $(BUILD)/src/verify/page.%.o: $(BUILD)/src/verify/page.%.c Makefile
	$(CC) $(FLAGS) $(CFLAGS) $(CPPFLAGS) -MD -MP -c -o $@ $<

$(lib): $(lib_obj)
	@rm -f $@
	$(AR) rcs $@ $(lib_obj)

# By name, so that an object that was deleted is made again.
$(tool_src:src/%.c=$(BUILD)/bin/%$(EXE)): $(BUILD)/bin/%$(EXE): $(BUILD)/src/%.o $(lib)
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $< $(lib) $(LIBS)

$(BUILD)/bin/cloudmill: src/cloudmill.sh
	@mkdir -p $(@D)
	install -m 755 $< $@

$(BUILD)/tests/readback/readback: $(back_obj) $(help_obj) $(lib)
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $(back_obj) $(help_obj) $(lib) \
	  $$(pkg-config --libs check) $(LIBS)

$(BUILD)/tests/readback/%.o: FLAGS += -iquote src -iquote tests/lib
$(BUILD)/tests/unit/%.o: FLAGS += -iquote src -iquote tests/lib
$(BUILD)/tests/unit/%.o: CFLAGS := $(CFLAGS:-O3=-O1)
$(units): $(BUILD)/tests/unit/%: $(BUILD)/tests/unit/%.o $(help_obj) $(lib)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $< $(help_obj) $(lib) $$(pkg-config --libs check) $(LIBS)

$(BUILD)/tests/accuracy/%.o: FLAGS += -iquote src -iquote tests/lib
$(cloud): $(BUILD)/tests/accuracy/cloud.o $(BUILD)/tests/lib/panel.o $(lib)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

$(edges): $(BUILD)/tests/accuracy/edges.o
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

$(BUILD)/tests/fuzz/%.o: FLAGS += -iquote tests/lib
$(BUILD)/tests/fuzz/replay: $(BUILD)/tests/fuzz/replay.o
	$(CC) $(CFLAGS) $(LDFLAGS) -Wl,--wrap=exit -o $@ $^ $(LIBS)
$(BUILD)/tests/fuzz/fuzz: $(BUILD)/tests/fuzz/fuzz.o
	$(CC) $(CFLAGS) -fsanitize=fuzzer $(LDFLAGS) -Wl,--wrap=exit -o $@ $^ $(LIBS)
$(BUILD)/tests/fuzz/hammer: $(BUILD)/tests/fuzz/hammer.o
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^
$(BUILD)/tests/fuzz/fuzz $(BUILD)/tests/fuzz/replay: $(BUILD)/tests/fuzz/fuzz_reader.o \
  $(BUILD)/tests/lib/scratch.o $(lib)

$(BUILD)/tests/bench/%.o: FLAGS += -iquote tests/lib
$(benches): $(BUILD)/bench/%: $(BUILD)/tests/bench/%.o $(BUILD)/tests/lib/decimals.o $(lib)
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

units: $(units)

# With -j, too, `make deps check` builds no test before what it needs is installed.
$(unit_src:%.c=$(BUILD)/%.o) $(help_obj) $(back_obj): | $(filter deps deps-all,$(MAKECMDGOALS))

check: all $(units) $(readback) $(cloud) $(BUILD)/tests/fuzz/replay
	@CC="$(CC)" BIN="$(abspath $(BUILD))/bin" READBACK="$(abspath $(BUILD))/tests/readback/readback" \
	  CLOUD="$(abspath $(cloud))" REPLAY="$(abspath $(BUILD))/tests/fuzz/replay" UNITS="$(abspath $(units))" MAKE="$(MAKE)" STARTED=$(started) \
	  sh tests/run.sh

demo: all
	@BIN="$(abspath $(BUILD))/bin" sh samples/demo.sh demo

# The tasks of the gallery (samples/tasks), the face with all its points, and the ways side by side.
samples: all
	@set -e; for task in face blade foreign old-control batch watch shop normals papers; do \
	  echo "== $$task"; BIN="$(abspath $(BUILD))/bin" POINTS=26493 sh samples/tasks/$$task.sh; done
	@echo "== ways"; BIN="$(abspath $(BUILD))/bin" sh samples/ways.sh

# The manuals as pages for a browser, with an index.
HTML = html
html:
	sh man/html.sh $(HTML)

figures: all
	@BIN="$(abspath $(BUILD))/bin" sh samples/figures.sh figures

bench: all $(benches)
	@BIN="$(abspath $(BUILD))/bin" FLOOR="$(abspath $(BUILD))/bench" POINTS="$(POINTS)" RUNS="$(RUNS)" \
	  ONLY="$(ONLY)" SCANS="$(SCANS)" GROWTH="$(GROWTH)" sh tests/bench/bench.sh

accuracy: all $(readback) $(cloud)
	@BIN="$(abspath $(BUILD))/bin" READBACK="$(abspath $(BUILD))/tests/readback/readback" \
	  CLOUD="$(abspath $(cloud))" sh tests/accuracy/accuracy.sh

# Sharp and thin shapes that are known exactly.
accuracy-edges: all $(readback) $(edges)
	@BIN="$(abspath $(BUILD))/bin" READBACK="$(abspath $(BUILD))/tests/readback/readback" \
	  EDGES="$(abspath $(edges))" sh tests/accuracy/edges.sh

faults: all
	@BIN="$(abspath $(BUILD))/bin" CC="$(CC)" FAULTS=0 sh tests/house/faults.t

# Tools that need no library: by musl's compiler, and for Windows by mingw-w64's.
static:
	$(MAKE) BUILD=$(BUILD)/static CC=musl-gcc LDFLAGS=-static all

windows:
	$(MAKE) BUILD=$(BUILD)/windows EXE=.exe CC=x86_64-w64-mingw32-gcc AR=x86_64-w64-mingw32-ar \
	  CPPFLAGS='-D__USE_MINGW_ANSI_STDIO=1 -Wno-format' LDFLAGS='-static -s' all

# The same jobs by other compilers, C libraries and machines: the same bytes?
portability:
	@MAKE="$(MAKE)" BUILD="$(BUILD)" sh tests/house/portability.sh $(PLATFORMS)

# Random numbers of another course: SEEDS of them (20).
check-seeds: $(units)
	@UNITS="$(abspath $(BUILD))/tests/unit" sh tests/house/seeds.sh

# A build that counts which line is run.
covered = $(MAKE) BUILD=$(BUILD)/coverage CC=gcc CFLAGS='-O1 -g --coverage'

# Lines of src/ changed by chance: N of them (200), in FOLDERS (all), by the unit tests that run
# them and then TOOL_TESTS, as tests/tool/ncpost-forms.t (those that make coverage was run for).
mutate: all $(units)
	$(covered) all units
	sh tests/house/lines.sh $(BUILD)/coverage $(basename $(unit_src)) $(TOOL_TESTS)
	@CC="$(CC)" BUILD="$(abspath $(BUILD))" sh tests/house/mutate.sh

# Lines that the tests run, folder by folder.
coverage:
	$(covered) all units $(patsubst $(BUILD)/%,$(BUILD)/coverage/%,$(readback) $(cloud) \
	  $(BUILD)/tests/fuzz/replay)
	sh tests/house/lines.sh $(BUILD)/coverage $(TESTS)
	sh tests/house/coverage.sh $(BUILD)/coverage

# The whole table of faults, kind by control; make check has a slice of it.
nc-faults: all
	BIN="$(abspath $(BUILD))/bin" FAULT_SEEDS="1 2 3" FAULT_FITTERS="line arc curve" \
	  sh tests/tool/ncverify-faults.t

# A thousand programs of random jobs, each accepted and safe for the machine.
safety: all
	@BIN="$(abspath $(BUILD))/bin" CC="$(CC)" SAFETY_JOBS="1 450" sh tests/house/safety.t

freeze: all
	@BIN="$(abspath $(BUILD))/bin" sh tests/house/freeze.sh

deps:
	@echo 'make deps: some 25 Debian packages, 50 MB on disk; make and make demo need none of them.'
	apt-get update
	$(apt_install) $(packages)

deps-all:
	@echo 'make deps-all: some 650 Debian packages, 3.5 GB on disk: browser, LinuxCNC, analysers, cross compilers.'
	apt-get update
	$(apt_install) $(packages_all) || for package in $(packages_all); do \
	  $(apt_install) $$package || missing="$$missing $$package"; done; \
	  [ -z "$$missing" ] || echo "not installed:$$missing"

lint:
	clang-format --dry-run --Werror $(c_files)
	! grep -nE '^.{101}' $(c_files)
	cppcheck -j 2 --quiet --std=c11 --enable=warning,performance,portability --inline-suppr \
	  --suppress=missingIncludeSystem --suppress=objectIndex --error-exitcode=1 -I include -I src -I tests/lib -i tests/data \
	  -i tests/fuzz/seeds -i tests/fuzz/found src tests
	clang-tidy --quiet --warnings-as-errors='*' $(tool_src) $(lib_src) -- $(FLAGS)
	shellcheck -S warning -x -P tests/lib src/*.sh tests/*.sh tests/*/*.sh tests/*/*.t tests/house/bare/* \
	  samples/*.sh samples/tasks/*.sh man/*.sh .ci/run

# What is abandoned when a process ends (by the names of functions, for which frames are kept), and
# asking for more memory than there is, are no faults.
# Without the tests of texts, of the build and of libraries put before others.
sanitize:
	mkdir -p $(BUILD)/sanitize && printf "leak:%s\n" create_beside out_open >$(BUILD)/sanitize/leaks
	SLOWER=10 WITHOUT='house/(man|layers|bare|install|portability|faults)[.]t' \
	  ASAN_OPTIONS=allocator_may_return_null=1 \
	  LSAN_OPTIONS=print_suppressions=0:suppressions=$(abspath $(BUILD))/sanitize/leaks \
	  $(MAKE) BUILD=$(BUILD)/sanitize CC=clang \
	  CFLAGS='-O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all' check

# Each reader under libFuzzer and the sanitizers, each tool on broken files: FUZZ_SECONDS in all, READERS
# (default: all; a tool is tool:NAME).
fuzz:
	$(MAKE) BUILD=$(BUILD)/fuzz CC=clang CFLAGS='-O1 -g -fsanitize=fuzzer-no-link,address,undefined \
	  -fno-sanitize-recover=all -fno-omit-frame-pointer' all $(BUILD)/fuzz/tests/fuzz/fuzz \
	  $(BUILD)/fuzz/tests/fuzz/hammer
	FUZZ="$(abspath $(BUILD))/fuzz/tests/fuzz/fuzz" OUT="$(abspath $(BUILD))/fuzz/out" \
	  sh tests/fuzz/fuzz.sh $(READERS)

# What is installed where, FILE=PLACE under PREFIX.  The tools find their data from where they lie, so
# PREFIX is in none of them.
share    := share/cloudmill
names    := $(basename $(notdir $(tools)))
installs  = $(foreach f,$(tools),$(f)=bin/$(notdir $(f))) \
  $(foreach n,$(names),$(BUILD)/completions/$(n)=share/bash-completion/completions/$(n) \
    $(BUILD)/completions/_$(n)=share/zsh/site-functions/_$(n) \
    $(BUILD)/completions/$(n).fish=share/fish/vendor_completions.d/$(n).fish) \
  $(foreach f,$(machines) $(controls) $(tool_files),$(f)=$(share)/$(f)) \
  $(foreach f,$(manuals),$(f)=share/man/man$(subst .,,$(suffix $(f)))/$(notdir $(f)))

# For bash, zsh and fish, made from what the tools say with --help all.
completions: $(BUILD)/completions/made
$(BUILD)/completions/made: $(tools) completions/completions.sh
	sh completions/completions.sh $(BUILD)/bin $(BUILD)/completions
	@touch $@

install: all completions
	@for pair in $(installs); do \
	  [ -e "$${pair%%=*}" ] || case $$pair in */completions/*) continue ;; esac; \
	  to=$(DESTDIR)$(PREFIX)/$${pair#*=}; mkdir -p "$${to%/*}" || exit 1; \
	  case $${pair#*=} in bin/*) mode=755 ;; *) mode=644 ;; esac; \
	  install -m $$mode "$${pair%%=*}" "$$to" || exit 1; \
	  case $$to in */man/*) sed 's/^\.Os cloudmill$$/& $(VERSION)/' "$${pair%%=*}" >"$$to" || exit 1 ;; esac; done
	@echo 'installed in $(DESTDIR)$(PREFIX)'

# Data that are not as they were installed are the user's, and stay; so do folders that hold any.
uninstall:
	@for pair in $(installs); do \
	  to=$(DESTDIR)$(PREFIX)/$${pair#*=}; [ -e "$$to" ] || continue; \
	  case $$to in \
	  */$(share)/*) cmp -s "$${pair%%=*}" "$$to" || { echo "kept, as it was changed: $$to"; continue; } ;; \
	  esac; rm "$$to" || exit 1; done
	@for folder in /machines /controls /tools ''; do \
	  rmdir '$(DESTDIR)$(PREFIX)/$(share)'$$folder 2>/dev/null || :; done

# The sources as they lie here, without git, and the same bytes from the same files.
sources = .ci .clang-format .clang-tidy .editorconfig .gitignore CONTRIBUTING.md HACKING.md LICENSE Makefile NEWS.md \
  README.md VERSION completions controls debian include machines man samples src tests tools
dist:
	find $(sources) -type f ! -name '*~' ! -name '.*.sw?' ! -name '*.[od]' | LC_ALL=C sort | \
	  tar --transform 's,^,cloudmill-$(VERSION)/,' --owner=0 --group=0 --numeric-owner \
	  --mtime=@$(or $(SOURCE_DATE_EPOCH),1767225600) --mode=u+w,go+r-w -cf - -T - | gzip -n9 >cloudmill-$(VERSION).tar.gz

# A package for Debian in $(BUILD)/deb, by debian/ and from the tarball.
deb: dist
	head -n 1 debian/changelog | grep -Fq '($(VERSION)-' || { echo 'debian/changelog is not of $(VERSION)'; exit 1; }
	rm -rf $(BUILD)/deb && mkdir -p $(BUILD)/deb
	gzip -dc cloudmill-$(VERSION).tar.gz | tar --delete --wildcards '*/debian/*' | \
	  gzip -n9 >$(BUILD)/deb/cloudmill_$(VERSION).orig.tar.gz
	tar -xzf cloudmill-$(VERSION).tar.gz -C $(BUILD)/deb
	cd $(BUILD)/deb/cloudmill-$(VERSION) && env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL dpkg-buildpackage -us -uc
	if command -v lintian >/dev/null; then lintian --fail-on error,warning $(BUILD)/deb/*.changes; fi

distcheck: dist
	rm -rf $(BUILD)/distcheck && mkdir -p $(BUILD)/distcheck
	tar -xzf cloudmill-$(VERSION).tar.gz -C $(BUILD)/distcheck
	$(MAKE) -C $(BUILD)/distcheck/cloudmill-$(VERSION) check

clean:
	rm -rf $(BUILD) demo figures html cloudmill-$(VERSION).tar.gz

.PHONY: always all units check demo samples html figures bench accuracy accuracy-edges freeze deps \
  deps-all lint \
  sanitize fuzz faults check-seeds mutate coverage nc-faults safety static windows portability deb completions \
  install uninstall dist distcheck clean

# Not those of other builds, in folders of their own.
-include $(shell find $(BUILD) $(foreach other,deb distcheck portable static windows sanitize coverage fuzz,\
  -path '$(BUILD)/$(other)' -prune -o) -type f -name '*.d' -print 2>/dev/null)

# cloudmill: see README.md for what it is, HACKING.md for the map of the house.
#
# make              the tools, in build/bin             make demo     the main job on a real scan
# make figures      pictures like the papers'
# make check        all tests                            make deps     what the tests need (Debian)
# make accuracy     gouges and material left, on surfaces known exactly
# make install      PREFIX=/usr/local DESTDIR=           make bench    speed, beside bare C floors
# make faults       every call of the C library fails in turn
# make lint sanitize fuzz dist distcheck clean uninstall

PREFIX  = /usr/local
DESTDIR =
CC      = cc
CFLAGS  = -O2 -g
BUILD   = build
VERSION = 0.1.0

WARN  = -Wall -Wextra -Wshadow -Wconversion
FLAGS = -std=c11 -D_XOPEN_SOURCE=700 -iquote include -ffp-contract=off -pthread $(WARN)
DATADIR = $(PREFIX)/share/cloudmill
LIBS  = -lm -pthread

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
manuals  := $(wildcard man/*.[157])
machines := $(wildcard machines/*.txt)
tool_files := $(wildcard tools/*.txt)
controls := $(wildcard controls/*.txt)
built_in := fanuc siemens heidenhain linuxcnc

tools    := $(tool_src:src/%.c=$(BUILD)/bin/%) $(BUILD)/bin/cloudmill
lib      := $(BUILD)/libcloudmill.a
page_obj := $(page_src:%=$(BUILD)/%.o)
control_obj := $(built_in:%=$(BUILD)/controls/%.o)
lib_obj  := $(lib_src:%.c=$(BUILD)/%.o) $(page_obj) $(control_obj)
back_obj := $(back_src:%.c=$(BUILD)/%.o)
help_obj := $(help_src:%.c=$(BUILD)/%.o)
units    := $(unit_src:tests/%.c=$(BUILD)/tests/%)
benches  := $(bench_src:tests/bench/%.c=$(BUILD)/bench/%)
readback := $(if $(back_src),$(BUILD)/tests/readback/readback)

started := $(shell date +%s)

# What `make deps` installs: for the tests, and for lint and fuzz.
packages = check pkg-config mandoc python3 chromium locales clang clang-format clang-tidy libclang-rt-dev cppcheck \
  shellcheck gcovr parallel
# Its interpreter rs274 judges our programs where it is there; else those tests are skipped.
judge = linuxcnc-uspace

all: $(tools)

$(BUILD)/tests/lib/%.o: FLAGS += -iquote src -iquote tests/lib
$(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(FLAGS) $(CFLAGS) $(CPPFLAGS) -MD -MP -c -o $@ $<

# One object holds the place of what is installed; another PREFIX compiles it again.
$(BUILD)/src/base/library_file.o: FLAGS += -DCLOUDMILL_DATADIR='"$(DATADIR)"'
$(BUILD)/src/base/library_file.o: $(BUILD)/datadir
$(BUILD)/datadir: always
	@mkdir -p $(@D)
	@echo '$(DATADIR)' | cmp -s - $@ || echo '$(DATADIR)' >$@

# The controls that are built in, as strings: controls/fanuc.txt is `const char control_text_fanuc[]`.
$(BUILD)/controls/%.c: controls/%.txt
	@mkdir -p $(@D)
	{ echo 'extern const char control_text_$*[];' && echo 'const char control_text_$*[] =' && \
	  sed -e 's/\\/\\\\/g' -e 's/"/\\"/g' -e 's/.*/"&\\n"/' $< && echo ';'; } >$@.new && mv $@.new $@

$(control_obj): $(BUILD)/controls/%.o: $(BUILD)/controls/%.c
	$(CC) $(FLAGS) $(CFLAGS) $(CPPFLAGS) -MD -MP -c -o $@ $<

# The files of the verdict's page as strings: page.js is `const char page_js[]`.
$(BUILD)/src/verify/page.%.c: src/verify/page.%
	@mkdir -p $(@D)
	{ echo 'extern const char page_$*[];' && echo 'const char page_$*[] =' && \
	  sed -e 's/\\/\\\\/g' -e 's/"/\\"/g' -e 's/.*/"&\\n"/' $< && echo ';'; } >$@.new && mv $@.new $@

$(page_obj): $(BUILD)/src/verify/page.%.o: $(BUILD)/src/verify/page.%.c
	$(CC) $(FLAGS) $(CFLAGS) $(CPPFLAGS) -MD -MP -c -o $@ $<

$(lib): $(lib_obj)
	@rm -f $@
	$(AR) rcs $@ $(lib_obj)

$(BUILD)/bin/%: $(BUILD)/src/%.o $(lib)
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
$(BUILD)/tests/unit/%: $(BUILD)/tests/unit/%.o $(help_obj) $(lib)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $< $(help_obj) $(lib) $$(pkg-config --libs check) $(LIBS)

$(BUILD)/tests/accuracy/%.o: FLAGS += -iquote src -iquote tests/lib
$(cloud): $(BUILD)/tests/accuracy/cloud.o $(BUILD)/tests/lib/panel.o
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

$(BUILD)/tests/fuzz/%.o: FLAGS += -iquote tests/lib
$(BUILD)/tests/fuzz/replay: $(BUILD)/tests/fuzz/replay.o
	$(CC) $(CFLAGS) $(LDFLAGS) -Wl,--wrap=exit -o $@ $^ $(LIBS)
$(BUILD)/tests/fuzz/fuzz: $(BUILD)/tests/fuzz/fuzz.o
	$(CC) $(CFLAGS) -fsanitize=fuzzer $(LDFLAGS) -Wl,--wrap=exit -o $@ $^ $(LIBS)
$(BUILD)/tests/fuzz/fuzz $(BUILD)/tests/fuzz/replay: $(BUILD)/tests/fuzz/fuzz_reader.o \
  $(BUILD)/tests/lib/scratch.o $(lib)

$(BUILD)/bench/%: $(BUILD)/tests/bench/%.o
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $< $(LIBS)

units: $(units)

check: all $(units) $(readback) $(cloud) $(BUILD)/tests/fuzz/replay
	@CC="$(CC)" BIN="$(abspath $(BUILD))/bin" READBACK="$(abspath $(BUILD))/tests/readback/readback" \
	  CLOUD="$(abspath $(cloud))" REPLAY="$(abspath $(BUILD))/tests/fuzz/replay" UNITS="$(abspath $(units))" MAKE="$(MAKE)" STARTED=$(started) \
	  sh tests/run.sh

demo: all
	@BIN="$(abspath $(BUILD))/bin" sh samples/demo.sh demo

figures: all
	@BIN="$(abspath $(BUILD))/bin" sh samples/figures.sh figures

bench: all $(benches)
	@BIN="$(abspath $(BUILD))/bin" FLOOR="$(abspath $(BUILD))/bench" sh tests/bench/bench.sh

accuracy: all $(readback) $(cloud)
	@BIN="$(abspath $(BUILD))/bin" READBACK="$(abspath $(BUILD))/tests/readback/readback" \
	  CLOUD="$(abspath $(cloud))" sh tests/accuracy/accuracy.sh

faults: all
	@BIN="$(abspath $(BUILD))/bin" CC="$(CC)" FAULTS=0 sh tests/house/faults.t

# Random numbers of another course: SEEDS of them (20).
check-seeds: $(units)
	@UNITS="$(abspath $(BUILD))/tests/unit" sh tests/house/seeds.sh

# Lines of src/ changed by chance: N of them (200), in FOLDERS (all).
mutate: all $(units)
	@CC="$(CC)" BUILD="$(abspath $(BUILD))" sh tests/house/mutate.sh

# Lines that the tests run, folder by folder.
coverage:
	$(MAKE) BUILD=$(BUILD)/coverage CC=gcc CFLAGS='-O1 -g --coverage' check
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
	@echo 'The tests need some 380 Debian packages, 1.5 GB; make and make demo need none of them.'
	apt-get update
	DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $(packages)
	-DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $(judge)

lint:
	clang-format --dry-run --Werror $(c_files)
	! grep -nE '^.{101}' $(c_files)
	cppcheck -j 2 --quiet --std=c11 --enable=warning,performance,portability --inline-suppr \
	  --suppress=missingIncludeSystem --suppress=objectIndex --error-exitcode=1 -I include -I src -I tests/lib -i tests/data src tests
	clang-tidy --quiet --warnings-as-errors='*' $(tool_src) $(lib_src) -- $(FLAGS)
	shellcheck -S warning -x -P tests/lib src/*.sh tests/*.sh tests/*/*.sh tests/*/*.t tests/house/bare/* \
	  samples/*.sh .ci/run

sanitize:
	$(MAKE) BUILD=$(BUILD)/sanitize CC=clang \
	  CFLAGS='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all' check

# Each reader in turn under libFuzzer and the sanitizers: FUZZ_SECONDS in all, READERS (default: all).
fuzz:
	$(MAKE) BUILD=$(BUILD)/fuzz CC=clang CFLAGS='-O1 -g -fsanitize=fuzzer-no-link,address,undefined \
	  -fno-sanitize-recover=all -fno-omit-frame-pointer' $(BUILD)/fuzz/tests/fuzz/fuzz
	FUZZ="$(abspath $(BUILD))/fuzz/tests/fuzz/fuzz" OUT="$(abspath $(BUILD))/fuzz/out" \
	  sh tests/fuzz/fuzz.sh $(READERS)

install: all
	mkdir -p $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(DATADIR)/machines $(DESTDIR)$(DATADIR)/controls \
	  $(DESTDIR)$(DATADIR)/tools
	install -m 755 $(tools) $(DESTDIR)$(PREFIX)/bin
	if [ -n "$(machines)" ]; then \
	  install -m 644 $(machines) $(DESTDIR)$(DATADIR)/machines; fi
	install -m 644 $(controls) $(DESTDIR)$(DATADIR)/controls
	if [ -n "$(tool_files)" ]; then \
	  install -m 644 $(tool_files) $(DESTDIR)$(DATADIR)/tools; fi
	for page in $(manuals); do \
	  dir=$(DESTDIR)$(PREFIX)/share/man/man$${page##*.}; \
	  mkdir -p $$dir && install -m 644 $$page $$dir || exit 1; done

uninstall:
	rm -f $(tools:$(BUILD)/bin/%=$(DESTDIR)$(PREFIX)/bin/%)
	for page in $(notdir $(manuals)); do \
	  rm -f $(DESTDIR)$(PREFIX)/share/man/man$${page##*.}/$$page; done
	rm -f $(machines:machines/%=$(DESTDIR)$(DATADIR)/machines/%)
	rm -f $(controls:controls/%=$(DESTDIR)$(DATADIR)/controls/%)
	rm -f $(tool_files:tools/%=$(DESTDIR)$(DATADIR)/tools/%)
	-rmdir $(DESTDIR)$(DATADIR)/machines $(DESTDIR)$(DATADIR)/controls \
	  $(DESTDIR)$(DATADIR)/tools $(DESTDIR)$(DATADIR) 2>/dev/null

dist:
	if git rev-parse --git-dir >/dev/null 2>&1; then \
	  git archive --prefix=cloudmill-$(VERSION)/ -o cloudmill-$(VERSION).tar.gz HEAD; \
	else \
	  mkdir -p $(BUILD) && tar --transform 's,^\.,cloudmill-$(VERSION),' --exclude='./$(BUILD)' --exclude=./demo \
	    --exclude=./figures --exclude='./cloudmill-*.tar.gz' -czf $(BUILD)/dist.tar.gz . && \
	  mv $(BUILD)/dist.tar.gz cloudmill-$(VERSION).tar.gz; fi

distcheck: dist
	rm -rf $(BUILD)/distcheck && mkdir -p $(BUILD)/distcheck
	tar -xzf cloudmill-$(VERSION).tar.gz -C $(BUILD)/distcheck
	$(MAKE) -C $(BUILD)/distcheck/cloudmill-$(VERSION) check

clean:
	rm -rf $(BUILD) demo figures cloudmill-$(VERSION).tar.gz

.PHONY: always all units check demo figures bench accuracy freeze deps lint sanitize fuzz faults \
  check-seeds mutate coverage   nc-faults safety install uninstall dist distcheck clean
.SECONDARY:

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)

# Front door: every target is a short name for a few commands of cmake, ctest or tools/.
JOBS ?= $(shell nproc)
B := build
comma := ,
ONE_THREAD := OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 MKL_NUM_THREADS=1 BLIS_NUM_THREADS=1
MAKEFLAGS += --no-print-directory
CHAPTERS := $(wildcard chapters/ch[0-9][0-9]_*)
PROGRAMS := $(sort $(foreach c,$(CHAPTERS),$(if $(wildcard $c/*.cpp),$(firstword $(subst _, ,$(notdir $c))))))
PAGES := $(filter-out docs/instructor.md,$(wildcard docs/*.md))
WOVEN := README.md $(PAGES) $(wildcard examples/README.md chapters/notation.md chapters/ch[0-9][0-9]_*/README.md)
TEXTS := $(WOVEN) chapters/README.md chapters/sheets.md chapters/glossary.md CONTRIBUTING.md CHANGELOG.md $(wildcard chapters/*/exercises/*/README.md docs/instructor.md)
CHAPTER_OF = $(wildcard chapters/$1_*)
# Exercises: a wrong answer is no failure of make. With --question it runs only lines that begin with +, and tells
# by its exit status, without a message, whether a command is left: the one that the verdict holds.
ifeq ($(filter-out ex%,$(or $(MAKECMDGOALS),all)),)
MAKEFLAGS += --question
endif

# What a build leaves out is said where everything is built.
LOG := WARNING
all test: LOG := NOTICE
all: configure            ## compile everything (the default)
	@cmake --build $B -j $(JOBS)
help:                     ## list what there is
	@sed -n 's/^\([a-z][a-zA-Z0-9.%-]*\):[^#]*## \(.*\)/  make \1\t\2/p' Makefile | sed 's/ch%/ch06/; s/ex%/ex6.1/' | expand -t 16
configure:
	@cmake --preset release --log-level=$(LOG) > /dev/null
run: configure            ## run every chapter, draw its figures into build/out, print the summary, make the book
	@rm -f $B/out/*/seconds
	@status=0; cmake --build $B -j $(JOBS) --target run_$(firstword $(PROGRAMS)) || status=1; \
	    cmake --build $B -j $(JOBS) --target run_chapters signorini_command -- -k || status=1; \
	    echo; perl tools/summary.pl $B/out $(PROGRAMS) || status=1; echo; \
	    if command -v doxygen > /dev/null && command -v python3 > /dev/null; then \
	        tools/docs.sh $B/book && echo "open $B/book/index.html" || status=1; \
	    else echo "the book is left out, for want of doxygen or python3: tools/setup.sh book, then make book"; fi; exit $$status
chapters: configure       # and the program, without which nothing can be installed
	@cmake --build $B -j $(JOBS) --target chapters signorini_command
test: all                 ## compile and run every test
	@ctest --test-dir $B -j $$(($(JOBS) + 1)) --output-on-failure  # one more than processors: some wait for a browser
conformance: configure    ## check every member of every family, or one: make conformance WHAT=mortar
	@cmake --build $B -j $(JOBS) --target test_conformance
	@$(if $(WHAT),SIGNORINI_CONFORMANCE='$(WHAT)' $B/bin/test_conformance 'every *$(comma)class/*',\
	    ctest --test-dir $B -j $(JOBS) -L conformance --output-on-failure)
ch%: configure            ## run one chapter, draw its figures into build/out/ch06, say what it found
	@[ -n "$(filter $@,$(PROGRAMS))" ] || { echo "no chapter $@; there are: $(PROGRAMS)" >&2; exit 2; }
	@cmake --build $B -j $(JOBS) --target $@
	@tools/chapter.sh run $B/bin/$@ $B/out/$@
	@FIGURES=draw tools/chapter.sh figures $(call CHAPTER_OF,$@) $B/out/$@
	@echo; perl tools/findings.pl $B/out $@
ex%: ex%.checked          ## check your answer to an exercise, chapters/*/exercises/*/attempt.cpp
	$(shell cat $B/$@.verdict)
ex%.checked:
	+@mkdir -p $B; JOBS=$(JOBS) tools/exercise.sh check ex$* $B && right= || right=@false; echo $$right > $B/ex$*.verdict
results: chapters         ## accept what the programs write now: committed numbers, text and figures
	@for c in $(PROGRAMS); do tools/chapter.sh run $B/bin/$$c $B/out/$$c > /dev/null && \
	    perl tools/compare.pl --update chapters/$${c}_* $B/out/$$c || exit 1; done
	@$B/bin/signorini --keys > examples/results/keys.md
	@perl tools/weave.pl $(WOVEN)
	@perl tools/equations.pl
	@perl tools/words.pl
	@perl tools/course.pl
	@perl tools/sheets.pl
	@for f in figures/fig_*.gp; do tools/figure.sh --check $$f 2> /dev/null || \
	    { tools/figure.sh $$f $${f%.gp}.svg && echo "drew $${f%.gp}.svg"; } || exit 1; done
figures:                  ## draw every committed picture anew from the committed curves
	@for f in figures/fig_*.gp; do tools/figure.sh $$f $${f%.gp}.svg || exit 1; done
text:                     ## put the committed numbers, tables and code into the text, and list equations and words
	@perl tools/weave.pl $(WOVEN)
	@perl tools/equations.pl
	@perl tools/words.pl
	@perl tools/course.pl
	@perl tools/sheets.pl
	@perl tools/mistakes.pl
lint:                     ## check what needs no compiling: quotations, formulas, links, that faults fit the sources
	@perl tools/weave.pl --check $(WOVEN)
	@perl tools/equations.pl --check
	@perl tools/words.pl --check
	@perl tools/course.pl --check
	@perl tools/sheets.pl --check
	@perl tools/mistakes.pl --check
	@perl tools/borrowed.pl .
	@perl tools/evenings.pl --check
	@perl tools/findings.pl --check
	@perl tools/lint-md.pl $(TEXTS) chapters/equations.md chapters/words.md tests/reference/claims.md
	@perl tools/claims.pl
	@tests/faults/run.pl --check
book: lint                ## the web pages, build/book/index.html
	@tools/docs.sh $B/book && echo "open $B/book/index.html"
book-pdf: book            ## the same as one file to print, build/signorini.pdf, with Chromium
	@python3 tools/book-pdf.py $B/book $B/signorini.pdf
slides: book              ## a deck per chapter, build/book/slides.html, cut from its text; measured in Chromium
	@python3 tools/check-slides.py $B/book && echo "open $B/book/slides.html"
site: slides              ## all of it as one folder to publish, build/site: no dead link, no error in its HTML, contrast, keyboard
	@python3 tools/site.py $B/book $B/site && python3 tools/check-reach.py $B/site && echo "open $B/site/index.html"
engine:                   ## compile the library for the pages, with emscripten: then figures of the book compute
	@JOBS=$(JOBS) tools/engine.sh $B/engine
live: configure engine    ## the pages with it; move every control of every live figure in Chromium, and ask the engine in node
	@cmake --build $B -j $(JOBS) --target live
	@$(MAKE) book
	@node tests/live/speed.js $B/engine/engine.js $B/bin/live
	@python3 tools/check-live.py $B/book $B/bin/live $B/live
browser: book             ## open every page in a browser and check it
	@python3 tools/check-docs.py --all $B/book
bench:                    ## what contact costs over one plain linear solve, measured
	@cmake --preset release -DSIGNORINI_BUILD_BENCH=ON > /dev/null
	@cmake --build $B -j $(JOBS) --target price
	@$(ONE_THREAD) $B/bin/price --full
peers:                    ## the same problems by other people's programs and libraries, as far as installed
	@cmake --preset release -DSIGNORINI_BUILD_BENCH=ON > /dev/null
	@cmake --build $B -j $(JOBS) --target peers
	@$(ONE_THREAD) $B/bin/peers --full
effectivity:              ## what the error estimates are worth, on meshes of all elements
	@cmake --preset release -DSIGNORINI_BUILD_BENCH=ON > /dev/null
	@cmake --build $B -j $(JOBS) --target effectivity
	@$(ONE_THREAD) $B/bin/effectivity --full
accuracy:                 ## what an accuracy costs that is asked for, beside meshes picked by hand
	@cmake --preset release -DSIGNORINI_BUILD_BENCH=ON > /dev/null
	@cmake --build $B -j $(JOBS) --target accuracy round_bodies
	@$(ONE_THREAD) $B/bin/accuracy --full && $(ONE_THREAD) $B/bin/round_bodies --full
many_bodies:              ## what stacks of many blocks cost, piles of discs with friction, and dense problems
	@cmake --preset release -DSIGNORINI_BUILD_BENCH=ON > /dev/null
	@cmake --build $B -j $(JOBS) --target many_bodies
	@$(ONE_THREAD) $B/bin/many_bodies --full
fuzz:                     ## invent texts for the readers of scenes, problems and meshes, ten minutes each, with clang
	@JOBS=$(JOBS) tests/fuzz/run.sh
faults:                   ## put deliberate faults into a copy, one at a time: which test notices each, in an hour or two
	@tests/faults/run.pl
sets:                     ## compare what pairs do by g++, clang, -O0, -O3 and -march=native, in an hour of compiling
	@JOBS=$(JOBS) tests/tools/same_sets.sh
grade: configure          ## grade a folder of answers, DIR/student/ex6.1.cpp: build/grade/grades.csv and .xml
	@JOBS=$(JOBS) perl tools/grade.pl "$(DIR)" $B
handout:                  ## build/signorini-handout.tar.gz, without solutions and held-out tests
	@mkdir -p $B && git archive --format=tar.gz --prefix=signorini/ -o $B/signorini-handout.tar.gz HEAD
	@ls -l $B/signorini-handout.tar.gz
package: configure        ## a package for Debian, build/package/*.deb: program, library, headers, manual page, examples, the book if it was made
	@cmake --build $B -j $(JOBS) --target signorini_command
	@cpack --config $B/CPackConfig.cmake > $B/package.log 2>&1 || { cat $B/package.log; exit 1; }
	@ls -l $B/package/*.deb
clean:                    ## remove everything that was built
	rm -rf $B
.PHONY: all help configure run chapters test conformance results figures text lint book book-pdf slides site engine live browser bench peers effectivity accuracy many_bodies \
        fuzz faults sets grade handout package clean

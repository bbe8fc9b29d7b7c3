# pointcore: everything a user, a developer or CI runs. `make help` lists it.
SHELL := /bin/bash
SCENE ?= scenes/knot.toml
# The scans that figures are measured on, where they lie beside the project.
SCANS = ../shared/data
SCAN ?= $(wildcard $(SCANS)/igea.ply)
MODELS ?= $(wildcard $(SCANS)/stanford-bunny.obj $(SCANS)/dragon.ply)
# Where scripts/python-tools installs.
TOOLS = $(or $(CARGO_TARGET_DIR),target)/tools
# Hard cases a number format of stability, and those it sends through the hardware.
CASES ?= 1000000
SPLATS ?= 100000
POINTS ?= $(firstword $(SCAN) surface:100000)
# Points of accuracy measured at a time, and the page it makes of SCENE.
JOBS ?= $(shell nproc)
PAGE ?= out/accuracy/$(basename $(notdir $(SCENE)))/index.html
# Where the record of areas last changed: every figure was checked to be of the hardware there.
REVISION ?= $(shell git log -1 --format=%h -- docs/area.json)
# How the libraries for other languages are built: dev or release.
PROFILE ?= dev
# What cargo builds where the program or a library is wanted, if not those alone; CI names all, which it has built for the tests.
PACKAGES ?=
# The tests of units are found by a macro, where cargo does not look for text to format.
CHECK_FORMATTING = cargo fmt --all --check && rustfmt --check --edition 2024 $(wildcard tb/tests/*.rs tb/tests/*/*.rs)
# What runs under FuseSoC.
CORE ?= tiny_knn
TARGETS ?= lint lint_axi sim sim_axi synth

.DEFAULT_GOAL := help
.PHONY: help house setup setup-tests setup-formal setup-cocotb setup-fpga run run-scan knn process plan gen quick test formal check-formal cocotb bindings c python check bench stability soak mutate accuracy check-page synth check-area mark-area generated check-generated fusesoc driver doc clean

help: ## List the targets
	@grep -hE '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | awk -F ':.*## ' '{ printf "  %-16s %s\n", $$1, $$2 }'
	@echo '  SCENE=FILE chooses the scene of run, plan, gen and accuracy (default $(SCENE)); SCAN=FILE the model of run-scan and bench, MODELS=FILES more for bench;'
	@echo '  POINTS=FILE the points of knn and process (default $(POINTS)), ARGS=... more arguments of these and of run-scan;'
	@echo '  CORE=NAME the core of fusesoc (default $(CORE)), TARGETS=... what it runs (default $(TARGETS)).'

setup: ## Install what running needs: Verilator 5.006 or newer, a C++ compiler
	@./scripts/setup verilator:verilator g++:g++ zlib.h:zlib1g-dev

setup-tests: setup ## Install what the tests need besides: Icarus Verilog, yosys
	@./scripts/setup iverilog:iverilog yosys:yosys

setup-formal: setup-tests ## Install what the proofs need besides: SymbiYosys and a solver, pinned, into target/tools
	@./scripts/setup python3:python3 ensurepip.py:python3-venv cadical:cadical
	@./scripts/python-tools

setup-cocotb: setup-tests ## Install what the tests on AXI need besides: cocotb and its bus models, pinned, into target/tools
	@./scripts/setup python3:python3 ensurepip.py:python3-venv libpython:python3-dev
	@./scripts/python-tools

setup-fpga: ## Install synthesis, place and route, FuseSoC, pinned, into target/tools
	@./scripts/setup python3:python3 ensurepip.py:python3-venv tclsh:tcl
	@./scripts/python-tools

run: setup ## Render SCENE on the generated hardware, in lockstep with its models, into out/
	cargo run --release --bin pointcore -- run $(SCENE)

run-scan: setup ## Render a model of your own, the camera around it, into out/: make run-scan SCAN=FILE (PLY, OBJ, glTF, PCD, LAS, LAZ, XYZ, CSV)
	$(if $(SCAN),,$(error run-scan needs a model: make run-scan SCAN=path/to/model.ply))
	cargo run --release --bin pointcore -- run $(SCAN) $(ARGS)

knn: setup ## Search the nearest neighbors of POINTS on the generated hardware, in lockstep with its model, into out/knn
	cargo run --release --bin pointcore -- knn --points $(POINTS) $(ARGS)

process: setup ## Estimate the normals of POINTS by a program, compared with f64, and draw them by these, into out/process
	cargo run --release --bin pointcore -- process --op normals --points $(POINTS) --check $(ARGS)
	cargo run --release --bin pointcore -- run out/process/points.ply --model golden -o out/process/picture

plan: ## Show which hardware SCENE calls for, and why
	cargo run --release --bin pointcore -- plan $(SCENE)

gen: ## Write the Verilog for SCENE into out/verilog
	cargo run --release --bin pointcore -- gen $(SCENE) -o out/verilog

quick: ## What to run after every change: formatting, tests without a simulator, one unit in lockstep; under 3 minutes once built
	$(CHECK_FORMATTING)
	cargo test -p pointcore-contract -p pointcore-golden -p rtl -p pointcore-hdl --lib
	cargo test -p rtl --test rtl
	cargo test -p pointcore-tb --test units -- layout stream_skid

test: setup-tests ## Run all tests, and say which were skipped
	@./scripts/test

formal: setup-formal ## Prove queues, stacks and the AXI units, or UNIT only (formal/README.md), and that every proof finds faults
	@./scripts/formal $(UNIT)

check-formal: setup-formal ## Prove what formal/record does not hold as it is now
	@./scripts/formal --new

cocotb: setup-cocotb ## Run frames and searches through the tops on AXI, with a bus that stalls and errs (cocotb/README.md)
	@$(TOOLS)/bin/python cocotb/run.py $(CONFIGURATIONS)

driver: setup ## Run the bare-metal drivers in C on the AXI tops, simulated, or CONFIGURATIONS only (examples/bare_metal/)
	@./scripts/driver $(CONFIGURATIONS)

bindings: c python ## Build the libraries for C and for Python, and test both (docs/bindings.md)

c: setup ## Build the C library and run its example; PROFILE=release as it is to be used
	@PROFILE=$(PROFILE) ./scripts/bindings c

python: setup ## Build the Python wheel and test it in a fresh environment; PROFILE=release as it is to be used
	@./scripts/setup python3:python3 ensurepip.py:python3-venv
	@PROFILE=$(PROFILE) ./scripts/bindings python

check: ## Formatting, clippy and documentation without warnings
	$(CHECK_FORMATTING)
	cargo clippy --workspace --all-targets -- -D warnings
	RUSTDOCFLAGS='-D warnings' cargo doc --workspace --no-deps

bench: setup ## Measure frames, searches, operators, stability and accuracy, and merge the figures and docs/area.json's into out/bench.json
	cargo run --release --bin pointcore -- bench $(if $(SCAN),--scan $(abspath $(SCAN))) $(if $(MODELS),--models $(abspath $(MODELS)))
	cargo run --release --bin pointcore -- area --recorded --record docs/area.json --merge out/bench.json
	cargo run --release --bin pointcore -- soak --recorded --record docs/soak.json --merge out/bench.json
	cargo run --release --bin pointcore -- mutate --recorded --record docs/mutation.json --merge out/bench.json
	@./scripts/house --merge >/dev/null
	$(MAKE) stability accuracy

house: ## Count the lines of Rust and of the Verilog, the fields asked for by strings, the files of a unit
	@./scripts/house

stability: setup ## Check the renderer's geometry on CASES hard cases a number format, and SPLATS in lockstep (docs/stability.md)
	cargo run --release --bin pointcore -- stability --cases $(CASES) --hardware $(SPLATS) $(ARGS)

mutate: setup setup-fpga ## Plant single faults in the Verilog of units, and count those that their tests find, into docs/mutation.json (docs/results.md)
	cargo run --release --bin pointcore -- mutate $(ARGS) --jobs $(JOBS) --record docs/mutation.json --tables docs/results.md --merge out/bench.json

soak: setup ## Run random configurations of both cores in lockstep with their models, JOBS at a time, and add the count to docs/soak.json (docs/results.md)
	cargo run --release --bin pointcore -- soak --jobs $(JOBS) --revision $(shell git describe --always --dirty --exclude '*') --record docs/soak.json --tables docs/results.md --merge out/bench.json $(ARGS)

accuracy: ## Sweep what trades accuracy for time and hardware on SCENE, into out/accuracy (docs/accuracy.md)
	cargo run --release --bin pointcore -- accuracy $(SCENE) --jobs $(JOBS) $(ARGS)

check-page: ## Hover over every point of PAGE, made by accuracy, in a real browser; skipped, with a word, where there is none
	@./scripts/check-page $(PAGE) || [ $$? -eq 77 ]

synth: setup-fpga ## Measure area and clock of UNIT (default: all units) on an ECP5; into docs/area.json, the tables of docs/results.md, out/bench.json
	cargo run --release --bin pointcore -- area --record docs/area.json --tables docs/results.md --merge out/bench.json $(UNIT) $(ARGS)

check-area: ## Check that docs/area.json is of the hardware as it is now where it does not say otherwise, and that the tables of docs/results.md are made from it
	cargo build $(or $(PACKAGES),--bin pointcore)
	$(or $(CARGO_TARGET_DIR),target)/debug/pointcore area --check docs/area.json --tables docs/results.md

mark-area: ## Have what docs/area.json holds of other hardware name the REVISION it was measured of (default: where the record last changed)
	cargo run --bin pointcore -- area --mark-stale $(REVISION) --record docs/area.json --tables docs/results.md

generated: ## Write the Verilog of all configurations into generated/ and the diagrams into docs/, which are committed
	@./scripts/generated

check-generated: ## Check that generated/ and the diagrams are what the generator writes now
	@./scripts/generated --check

fusesoc: setup setup-fpga ## Lint, simulate and synthesize CORE of generated/ under FuseSoC
	@./scripts/fusesoc $(CORE) $(TARGETS)

doc: ## Build the documentation
	cargo doc --workspace --no-deps

clean: ## Remove build output, results and the cache of verilated models
	cargo clean
	rm -rf out

//! What is written for a configuration: Verilog, manifest, constraints, a test, and the FuseSoC core that names them.

mod axi_test;
mod constraints;
mod fusesoc;
pub mod place_and_route;
pub mod shell;
mod testbench;

pub use fusesoc::fusesoc_name;

use crate::area::count;
use crate::bus::{Bus, Interface};
use crate::configuration::Configuration;
use crate::generated::GenerateError;
use crate::operators::record_operators;
use crate::points;
use crate::recording::Recording;
use crate::search;
use crate::splat;
use axi_test::AxiTest;
use pointcore_contract::points::Config as PointsConfig;
use pointcore_contract::search::Config as SearchConfig;
use pointcore_contract::splat::Config as SplatConfig;
use pointcore_hdl::compiler::Manifest;
use pointcore_tb::lockstep::LockstepError;
use rtl::Design;
use serde_json::json;
use std::collections::BTreeMap;
use std::iter;
use testbench::Replayed;

/// What generated files say of their origin.
const GENERATOR: &str = concat!("pointcore ", env!("CARGO_PKG_VERSION"));

/// A core that cannot be packaged: a fault of the generator, not of its input.
#[derive(Debug, thiserror::Error)]
pub enum PackageError {
    /// The hardware.
    #[error(transparent)]
    Generate(#[from] GenerateError),
    /// The frame that is recorded for a test.
    #[error(transparent)]
    Frame(#[from] LockstepError),
    /// The search that is recorded for a test.
    #[error(transparent)]
    Search(#[from] search::SearchError),
}

/// What a file is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The design: Verilog-2005.
    Verilog,
    /// The design's AXI top, beside the design.
    Bus,
    /// The module around the design that has few pins, and the constraints of both.
    Pins,
    /// The test, and what it reads.
    Test,
    /// The test of the AXI top, and what it reads.
    BusTest,
    /// The design once more, a file a module.
    Module,
    /// For people and programs, not for the tools of a design.
    Document,
}

/// A file to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its name, behind `modules/` for a module's.
    pub name: String,
    /// What stands in it.
    pub text: String,
    /// What it is for.
    pub role: Role,
}

/// A core and everything that goes with it.
#[derive(Clone, Debug)]
pub struct Package {
    /// The configuration's name.
    pub name: String,
    /// What it is, in a few words.
    pub title: &'static str,
    /// The module that designs instantiate.
    pub top: String,
    /// The files, without the FuseSoC core.
    files: Vec<File>,
    /// How it is placed and routed on an ECP5.
    nextpnr: Vec<&'static str>,
}

impl Package {
    /// The renderer's files for the configuration of this name.
    ///
    /// # Errors
    /// A fault of the generator, or of the model that makes the test.
    pub fn splat(name: &str, core: &splat::SplatCore, config: &SplatConfig) -> Result<Self, PackageError> {
        let text = Configuration::Splat(config.clone()).text();
        let mut package = Self::new(name, "surface splatting", &core.design, &core.manifests, text);
        let bus = Bus::splat(config)?;
        package.add_bus(&bus, &Interface::splat(config));
        package.add_pins(&Configuration::Splat(config.clone()))?;
        package.add_test(&core.design, &splat::record(config, core), splat::record_setup(config, core)?)?;
        package.add_axi_test(&bus, axi_test::of_splat(&bus.design, core, config)?);
        Ok(package)
    }

    /// The search core's files for the configuration of this name.
    ///
    /// # Errors
    /// A fault of the generator, or of the model that makes the test.
    pub fn search(name: &str, core: &search::SearchCore, config: &SearchConfig) -> Result<Self, PackageError> {
        let text = Configuration::Search(config.clone()).text();
        let mut package = Self::new(name, "neighbor search", &core.design, &core.manifests, text);
        let bus = Bus::search(config)?;
        package.add_bus(&bus, &Interface::search(config));
        package.add_pins(&Configuration::Search(config.clone()))?;
        let leaf = search::record_leaf(config, core.latencies().distance)?;
        package.add_test(&core.design, &search::record(config, core)?, leaf)?;
        package.add_axi_test(&bus, axi_test::of_search(&bus.design, config)?);
        Ok(package)
    }

    /// The point processor's files for the configuration of this name.
    ///
    /// # Errors
    /// A fault of the generator, or of the model that makes the test.
    pub fn points(name: &str, core: &points::PointsCore, config: &PointsConfig) -> Result<Self, PackageError> {
        let text = Configuration::Points(config.clone()).text();
        let mut package = Self::new(name, "point processor", &core.design, &core.manifests, text);
        let bus = Bus::points(config)?;
        package.add_bus(&bus, &Interface::points(config));
        package.add_pins(&Configuration::Points(config.clone()))?;
        let leaf = search::record_leaf(&config.search, core.latencies().search.distance)?;
        package.add_test(&core.design, &points::record(config, core)?, leaf)?;
        package.add_axi_test(&bus, axi_test::of_points(&bus.design, config)?);
        Ok(package)
    }

    fn new(
        name: &str,
        title: &'static str,
        design: &Design,
        datapaths: &BTreeMap<String, Manifest>,
        config: String,
    ) -> Self {
        let top = design.top().to_owned();
        let manifest = json!({
            "generator": GENERATOR,
            "top": top,
            "datapaths": datapaths,
            "modules": count::modules(design),
            "area": count::document(design),
        });
        let manifest = serde_json::to_string_pretty(&manifest).expect("manifests have string keys");
        let mut package = Self { name: name.to_owned(), title, top, files: Vec::new(), nextpnr: Vec::new() };
        package.add(format!("{}.v", package.top), design.verilog().to_owned(), Role::Verilog);
        package.add("manifest.json", manifest + "\n", Role::Document);
        package.add("config.toml", config, Role::Document);
        for (ending, text) in constraints::of(&package.top) {
            package.add(format!("{}.{ending}", package.top), text, Role::Document);
        }
        package
    }

    /// Adds a file.
    pub fn add(&mut self, name: impl Into<String>, text: String, role: Role) {
        self.files.push(File { name: name.into(), text, role });
    }

    /// Adds the core as a block for designs in rust-hdl.
    pub fn add_rust_hdl(&mut self, design: &Design) {
        let words = self.top.split('_').filter_map(|word| Some((word.get(..1)?.to_uppercase(), word.get(1..)?)));
        let name: String = words.map(|(initial, rest)| initial + rest).collect();
        self.add(format!("{}.rs", self.top), design.rust_hdl_struct(&name), Role::Document);
    }

    /// Adds the core once more as `modules/MODULE.v`, and `modules/TOP.f`, which lists them children first, each by its name alone.
    pub fn add_modules(&mut self, design: &Design) {
        let mut list = String::new();
        for (module, text) in design.files().iter().rev() {
            list += &format!("{module}.v\n");
            self.add(format!("modules/{module}.v"), text.clone(), Role::Module);
        }
        self.add(format!("modules/{}.f", self.top), list, Role::Module);
    }

    /// The AXI top, and its registers for people and for C.
    fn add_bus(&mut self, bus: &Bus, interface: &Interface) {
        self.add(format!("{}.v", bus.design.top()), bus.design.verilog().to_owned(), Role::Bus);
        self.add("registers.md", interface.markdown(), Role::Document);
        self.add("registers.h", interface.header(), Role::Document);
    }

    /// The core between registers and behind few pins: what can be placed on a device and loaded as it is.
    fn add_pins(&mut self, configuration: &Configuration) -> Result<(), GenerateError> {
        let name = format!("{}_pins", self.top.trim_end_matches("_top"));
        self.nextpnr = place_and_route::arguments(configuration);
        let shell = shell::wrap_named(&name, configuration.module()?)?;
        self.add(format!("{name}.v"), shell.outermost(), Role::Pins);
        for (ending, text) in constraints::of(&name) {
            self.add(format!("{name}.{ending}"), text, Role::Pins);
        }
        Ok(())
    }

    /// A test that replays what golden models did: of the whole, of a unit alone, and of all operators side by side.
    fn add_test(
        &mut self,
        design: &Design,
        recording: &Recording,
        unit: (Design, Recording),
    ) -> Result<(), GenerateError> {
        let name = format!("{}_test", self.top.trim_end_matches("_top"));
        let alone: Vec<_> = iter::once(unit).chain(record_operators(design)?).collect();
        let whole = Replayed { design, recording };
        let alone = alone.iter().map(|(design, recording)| Replayed { design, recording });
        for (file, text) in testbench::files(&name, whole, &alone.collect::<Vec<_>>()) {
            self.add(file, text, Role::Test);
        }
        Ok(())
    }

    /// A test that plays a script on the buses.
    fn add_axi_test(&mut self, bus: &Bus, test: AxiTest) {
        let name = format!("{}_test", bus.design.top());
        self.add(format!("{name}.sv"), test.text, Role::BusTest);
        self.add(format!("{name}.hex"), test.vectors, Role::BusTest);
    }

    /// All files, the FuseSoC core among them.
    #[must_use]
    pub fn files(&self) -> Vec<File> {
        let core = File { name: format!("{}.core", self.name), text: fusesoc::text(self), role: Role::Document };
        self.files.iter().cloned().chain([core]).collect()
    }

    /// The files for a purpose.
    fn files_for(&self, role: Role) -> impl Iterator<Item = &File> {
        self.files.iter().filter(move |file| file.role == role)
    }
}

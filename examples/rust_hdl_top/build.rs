//! Generates the search core and the rust-hdl block that stands for it.

#[path = "src/config.rs"]
mod config;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use pointcore_hdl::compiler::Options;
use pointcore_hdl::search::top;
use rtl::elaborate;

fn main() -> Result<(), Box<dyn Error>> {
    let core = top::core(&config::config(), &Options::default())?;
    let design = elaborate(&core.module)?;
    let folder = env::var("OUT_DIR")?;
    fs::write(Path::new(&folder).join("search_top.v"), design.verilog())?;
    fs::write(Path::new(&folder).join("search_top.rs"), design.rust_hdl_struct("SearchTop"))?;
    println!("cargo::rerun-if-changed=src/config.rs");
    Ok(())
}

//! The FuseSoC core (CAPI2) of a package.

use super::{File, GENERATOR, Package, Role};

/// The filesets of the design where there is a file a module: with `--flag split` those, else the single file.
const SPLIT: &str = r#""!split? (rtl)", "split? (modules)""#;

/// What FuseSoC calls the core of a configuration: vendor, library, name, version.
#[must_use]
pub fn fusesoc_name(configuration: &str) -> String {
    // What a part of a name may consist of.
    let allowed = |c: char| if c.is_ascii_alphanumeric() || "_-.".contains(c) { c } else { '_' };
    let name: String = configuration.chars().map(allowed).collect();
    format!("pointcore:cores:{name}:{}", env!("CARGO_PKG_VERSION"))
}

/// A fileset with those files that have a type.
fn fileset<'a>(name: &str, files: impl Iterator<Item = &'a File>) -> String {
    let line = |file: &File| {
        let attributes = match file.name.rsplit('.').next()? {
            "v" => "file_type: verilogSource-2005".to_owned(),
            "sv" => "file_type: systemVerilogSource".to_owned(),
            "lpf" => "file_type: LPF".to_owned(),
            "hex" => format!("file_type: user, copyto: {}", file.name),
            _ => return None,
        };
        Some(format!("      - {}: {{ {attributes} }}\n", file.name))
    };
    format!("  {name}:\n    files:\n{}", files.filter_map(line).collect::<String>())
}

/// A target that runs a test under Verilator.
fn simulation(name: &str, description: &str, filesets: &str, toplevel: &str) -> String {
    format!(
        r"
  {name}:
    description: {description}
    filesets: [{filesets}]
    flow: sim
    flow_options:
      tool: verilator
      mode: binary
      verilator_options: [--x-initial, unique]
      run_options: [+verilator+rand+reset+2]
    toplevel: {toplevel}
"
    )
}

/// The core's text.
pub fn text(package: &Package) -> String {
    let Package { name, title, top, nextpnr, .. } = package;
    let core = top.trim_end_matches("_top");
    let tested = package.files_for(Role::Test).next().is_some();
    let is_split = package.files_for(Role::Module).next().is_some();
    let parts = [("rtl", Role::Verilog), ("axi", Role::Bus), ("pins", Role::Pins)];
    let mut filesets: String = parts.into_iter().map(|(name, role)| fileset(name, package.files_for(role))).collect();
    if tested {
        filesets += &fileset("test", package.files_for(Role::Test));
    }
    let tested_on_axi = package.files_for(Role::BusTest).next().is_some();
    if tested_on_axi {
        filesets += &fileset("axi_test", package.files_for(Role::BusTest));
    }
    if is_split {
        filesets += &fileset("modules", package.files_for(Role::Module));
    }
    let rtl = if is_split { SPLIT } else { "rtl" };
    // Quoted, since YAML would read some of them as numbers.
    let nextpnr: Vec<_> = nextpnr.iter().map(|argument| format!("\"{argument}\"")).collect();
    let nextpnr = nextpnr.join(", ");
    let test = simulation(
        "sim",
        "Replay what the bit-exact model did, comparing every output in every cycle",
        &format!("{rtl}, test"),
        &format!("{core}_test"),
    );
    let axi_test = simulation(
        "sim_axi",
        "Play a script on the buses, comparing every answer with the contract's and the bit-exact model's",
        &format!("{rtl}, axi, axi_test"),
        &format!("{core}_axi_test"),
    );
    format!(
        r#"CAPI=2:
# Written by {GENERATOR}; do not edit.
name: "{vlnv}"
description: "pointcore, {title}: configuration {name}"

filesets:
{filesets}
targets:
  default: &default
    filesets: [{rtl}]
    toplevel: {top}

  lint:
    <<: *default
    description: Check the Verilog with all of Verilator's warnings
    flow: lint
    flow_options:
      tool: verilator
      verilator_options: [-Wall]

  axi: &axi
    description: The core on AXI
    filesets: [{rtl}, axi]
    toplevel: {core}_axi

  lint_axi:
    <<: *axi
    description: Check the core on AXI with all of Verilator's warnings
    flow: lint
    flow_options:
      tool: verilator
      verilator_options: [-Wall]
{test}{axi_test}
  synth:
    <<: *default
    description: Synthesize for ECP5
    flow: generic
    flow_options:
      tool: yosys
      arch: ecp5
      output_format: json

  ecp5:
    description: Synthesize, place and route on an LFE5U-85F behind four pins, and pack the bitstream
    filesets: [{rtl}, pins]
    flow: trellis
    flow_options:
      nextpnr_options: [{nextpnr}, "--timing-allow-fail", "--report", "timing.json"]
    toplevel: {core}_pins
"#,
        vlnv = fusesoc_name(name),
        test = if tested { test.as_str() } else { "" },
        axi_test = if tested_on_axi { axi_test.as_str() } else { "" },
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::SearchCore;
    use pointcore_contract::search::Config;

    #[test]
    fn a_core_lists_a_file_a_module_beside_the_single_file() {
        let config = Config::default();
        let core = SearchCore::generate(&config).unwrap_or_else(|error| panic!("{error}"));
        let mut package = Package::search("one", &core, &config).unwrap_or_else(|error| panic!("{error}"));
        assert!(!text(&package).contains("modules"), "only where they are written");
        package.add_modules(&core.design);
        let core_file = text(&package);
        for (module, _) in core.design.files() {
            assert_eq!(core_file.matches(&format!("- modules/{module}.v: ")).count(), 1, "{module}");
        }
        assert!(core_file.contains(&format!("filesets: [{SPLIT}, axi]")), "{core_file}");
    }

    #[test]
    fn names_have_only_what_fusesoc_allows() {
        assert_eq!(fusesoc_name("a b:c-1.2"), format!("pointcore:cores:a_b_c-1.2:{}", env!("CARGO_PKG_VERSION")));
    }
}

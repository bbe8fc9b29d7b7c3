//! The block `init` as a unit against its model, with each program that has one.

use pointcore_contract::process::queries::{InitInput, InitSettings};
use pointcore_contract::process::{Config, stages};
use pointcore_golden::process::Init;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::process::stage;

use crate::process::scene::configs;
use crate::process::stage::agree;
use crate::support::cases;

#[test]
fn it_agrees_with_the_model_thread_by_thread() {
    let configs: Vec<Config> = configs().into_iter().filter(Config::has_init).collect();
    assert_eq!(configs.len(), 2);
    for config in cases(configs) {
        let init = stage::init(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let model = Init::new(&config, init.manifest.latency);
        agree::<_, InitInput, InitSettings>(&config, &stages::init::UNIT, (init, model));
    }
}

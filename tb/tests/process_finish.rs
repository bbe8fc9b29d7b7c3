//! The block `final` as a unit against its model, with each program.

use pointcore_contract::process::queries::{FinalInput, FinalSettings};
use pointcore_contract::process::stages;
use pointcore_golden::process::Finish;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::process::stage;

use crate::process::scene::configs;
use crate::process::stage::agree;
use crate::support::cases;

#[test]
fn it_agrees_with_the_model_thread_by_thread() {
    for config in cases(configs()) {
        let finish = stage::finish(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let model = Finish::new(&config, finish.manifest.latency);
        agree::<_, FinalInput, FinalSettings>(&config, &stages::finish::UNIT, (finish, model));
    }
}

//! What the scripts for Slurm submit: a stand-in for `sbatch` writes down what it is asked.

use crate::command::{WRONG_INPUT, Workplace};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Output};

/// Keeps arguments and script of each job, and says its number.
const SBATCH: &str = r#"#!/bin/sh
number=$(($(cat number 2>/dev/null || echo 6) + 1))
echo $number | tee number
{ printf '%s\n' "$@"; echo; cat; } >job$number
"#;

fn submit(workplace: &Workplace, script: &str, arguments: &[&str]) -> Output {
    let folder = workplace.path();
    for (name, text) in [("sbatch", SBATCH), ("program", "#!/bin/sh\n"), ("git", "#!/bin/sh\necho abc1234\n")] {
        fs::write(folder.join(name), text).expect("a temporary folder can be written");
        fs::set_permissions(folder.join(name), fs::Permissions::from_mode(0o755)).expect("the file is ours");
    }
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scripts").join(script);
    let path = format!("{}:{}", folder.display(), std::env::var("PATH").expect("there are tools"));
    let mut command = Command::new(script);
    command.args(arguments).current_dir(folder).env("PATH", path).env("POINTCORE", "./program");
    command.output().expect("the script can be run")
}

fn job(workplace: &Workplace, number: u32) -> String {
    fs::read_to_string(workplace.path().join(format!("job{number}"))).expect("a job was submitted")
}

#[test]
fn an_array_is_followed_by_a_job_that_ends_when_it_fails() {
    for (script, arguments) in
        [("accuracy-slurm", ["3", "a scene.toml", "--vary"]), ("soak-slurm", ["3", "--cases", "12"])]
    {
        let workplace = Workplace::new();
        let output = submit(&workplace, script, &arguments);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let (array, after) = (job(&workplace, 7), job(&workplace, 8));
        assert!(array.contains("\n--array=1-3\n") && !array.contains("--dependency"), "{array}");
        assert!(
            array.contains(r#"--shard "$SLURM_ARRAY_TASK_ID/3" --jobs "${SLURM_CPUS_PER_TASK:-1}" || "#),
            "{array}"
        );
        assert!(after.contains("\n--dependency=afterok:7\n--kill-on-invalid-dep=yes\n"), "{after}");
        assert!(!after.contains("--shard") && !after.contains("--array"), "{after}");
        let quoted = arguments[1].replace(' ', "\\ ");
        assert!([&array, &after].iter().all(|job| job.contains(&quoted)), "{array}\n{after}");
        assert_eq!(after.contains("--record docs/soak.json"), script == "soak-slurm", "{after}");
    }
}

#[test]
fn scripts_say_what_they_need() {
    for script in ["accuracy-slurm", "soak-slurm"] {
        let workplace = Workplace::new();
        let output = submit(&workplace, script, &["none"]);
        assert_eq!(output.status.code(), Some(WRONG_INPUT));
        assert!(String::from_utf8_lossy(&output.stderr).starts_with("usage: "));
        assert!(!workplace.path().join("number").exists(), "nothing is submitted");
    }
}

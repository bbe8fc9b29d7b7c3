//! Rejects motion that makes no sense.

use super::table::{MotionTable, ShutterTable};
use crate::scene::file::SceneFile;
use crate::scene::model::COORDINATE_LIMIT;

/// A year: beyond, single seconds lose their digits.
const TIME_LIMIT: f64 = 3e7;
/// Full turns between two keyframes beyond which nothing is seen but a smear.
const TURNS_LIMIT: f64 = 100.0;

/// A key with its tables, and what is wrong with its value.
type Fault = (String, String);

/// Checks all that a scene says of motion.
pub(in crate::scene) fn check(file: &SceneFile) -> Result<(), Fault> {
    let of_objects = file.objects.iter().enumerate().map(|(index, object)| (format!("object.{index}"), &object.motion));
    let camera = [("camera".to_owned(), &file.camera.motion)];
    let tables = camera.into_iter().chain(of_objects).filter_map(|(key, table)| Some((key, table.as_ref()?)));
    for (key, table) in tables {
        check_motion(table).map_err(|(name, problem)| (format!("{key}.motion{name}"), problem))?;
        if file.shutter.is_none() {
            let problem =
                "needs to be told when the shutter is open: add `[shutter]` with `open` and `close` in seconds";
            return Err((format!("{key}.motion"), problem.to_owned()));
        }
        for (sequence, given) in
            [("turntable", file.camera.turntable.is_some()), ("frames", file.camera.frames.is_some())]
        {
            if given {
                let problem = format!("goes without motion, but `{key}.motion` has some: give either");
                return Err((format!("camera.{sequence}"), problem));
            }
        }
    }
    file.shutter.as_ref().map_or(Ok(()), check_shutter)
}

fn check_shutter(shutter: &ShutterTable) -> Result<(), Fault> {
    for (key, time) in [("shutter.open", shutter.open), ("shutter.close", shutter.close)] {
        check_time(time).map_err(|problem| (key.to_owned(), problem))?;
    }
    if shutter.close <= shutter.open {
        let problem = format!("is {}: expected more than `shutter.open`, which is {}", shutter.close, shutter.open);
        return Err(("shutter.close".to_owned(), problem));
    }
    Ok(())
}

fn check_time(time: f64) -> Result<(), String> {
    let valid = time.abs() <= TIME_LIMIT;
    valid.then_some(()).ok_or_else(|| format!("is {time}: expected seconds up to {TIME_LIMIT:e}"))
}

fn check_motion(table: &MotionTable) -> Result<(), Fault> {
    let fault = |name: &str, problem: String| Err((name.to_owned(), problem));
    let keyframes = &table.keyframes;
    match (table.velocity, keyframes.len()) {
        (Some(_), 1..) => return fault(".velocity", "goes without keyframes: give either".to_owned()),
        (None, 0..=1) => {
            let problem = "is no motion yet: give `velocity`, or two keyframes or more (`[[….motion.keyframe]]`)";
            return fault("", problem.to_owned());
        }
        _ => {}
    }
    let translations = keyframes.iter().map(|keyframe| (".keyframe", keyframe.translate));
    let velocity = table.velocity.map(|velocity| (".velocity", velocity));
    for (name, vector) in velocity.into_iter().chain(translations) {
        if !vector.iter().all(|component| component.abs() <= COORDINATE_LIMIT) {
            return fault(name, format!("is {vector:?}: expected numbers up to {COORDINATE_LIMIT:e}"));
        }
    }
    for (index, keyframe) in keyframes.iter().enumerate() {
        check_time(keyframe.time).map_err(|problem| (format!(".keyframe.{index}.time"), problem))?;
        if !keyframe.rotate_degrees.iter().all(|angle| angle.abs() <= 360.0 * TURNS_LIMIT) {
            let problem = format!("is {:?}: expected angles up to {TURNS_LIMIT} full turns", keyframe.rotate_degrees);
            return fault(&format!(".keyframe.{index}.rotate_degrees"), problem);
        }
    }
    for (index, pair) in keyframes.windows(2).enumerate() {
        if pair[1].time <= pair[0].time {
            let problem = format!("is {}: expected later than the one before, at {}", pair[1].time, pair[0].time);
            return fault(&format!(".keyframe.{}.time", index + 1), problem);
        }
    }
    Ok(())
}

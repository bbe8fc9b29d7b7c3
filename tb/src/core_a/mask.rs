//! What a comparison of core A's units leaves open.

use pointcore_spec::core_a::Port;
use pointcore_spec::core_a::ports::Direction;
use std::ops::Range;

/// A mask for [`Lockstep`](crate::lockstep::Lockstep): an end record carries nothing else, so its other fields are left open.
pub fn end_records(ports: &[Port]) -> impl FnMut(&mut [u64], &mut [u64]) + Send + 'static {
    let outputs: Vec<_> = ports.iter().filter(|port| port.direction == Direction::Output).collect();
    let record = |(end, port): (usize, &&Port)| {
        let stream = port.name.strip_suffix("end").filter(|stream| stream.ends_with('_'))?;
        let fields = outputs[end + 1..].iter().take_while(|port| port.name.starts_with(stream)).count();
        Some((end, end + 1..end + 1 + fields))
    };
    let records: Vec<(usize, Range<usize>)> = outputs.iter().enumerate().filter_map(record).collect();
    move |hardware, golden| {
        for words in [hardware, golden] {
            for (end, fields) in &records {
                if words[*end] == 1 {
                    words[fields.clone()].fill(0);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_spec::core_a::{Config, ports};

    #[test]
    fn only_fields_behind_end_are_open() {
        let ports = ports::splitter(&Config::default());
        let mut mask = end_records(&ports);
        let count = ports.iter().filter(|port| port.direction == Direction::Output).count();
        // `in_ready`, `out_valid`, `out_end`, then the fields.
        let (mut hardware, mut golden) = (vec![1; count], vec![1; count]);
        golden[3] = 7;
        mask(&mut hardware, &mut golden);
        assert_eq!(hardware, golden);
        let (mut hardware, mut golden) = (vec![0; count], vec![0; count]);
        golden[3] = 7;
        mask(&mut hardware, &mut golden);
        assert_ne!(hardware, golden);
    }
}

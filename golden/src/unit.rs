//! How a model meets a test bench: one call a cycle, a word a port.
//!
//! A [`Model`] works on what the contract says that its unit sees and shows; [`Ported`] reads and writes that as words.

use pointcore_contract::{Visit, Words, read, write};

/// A unit seen at its ports.
pub trait Unit {
    /// One cycle. `inputs` and `outputs` hold a word for each port of the unit's list in the contract, each in the
    /// list's order, `rst` the first input. Writes what the unit shows in this cycle, then clocks it.
    fn step(&mut self, inputs: &[u64], outputs: &mut [u64]);
}

/// A synchronous circuit whose outputs are functions of its registers.
pub trait Model: Clone {
    /// What the layout of its ports depends on.
    type Config: Clone;
    /// What the unit sees in a cycle.
    type In: Visit<Words, Config = Self::Config>;
    /// What the unit shows in a cycle.
    type Out: Visit<Words, Config = Self::Config>;

    /// What the unit shows in this cycle.
    fn outputs(&self) -> Self::Out;

    /// One clock edge.
    fn clock(&mut self, inputs: &Self::In);
}

/// A model with its ports as words.
#[derive(Clone, Debug)]
pub struct Ported<M: Model> {
    config: M::Config,
    reset: M,
    model: M,
}

impl<M: Model> Ported<M> {
    /// Wires up a model that is in its initial state.
    pub fn new(config: &M::Config, model: M) -> Self {
        Self { config: config.clone(), reset: model.clone(), model }
    }

    /// The model as it stands.
    pub fn into_model(self) -> M {
        self.model
    }
}

impl<M: Model> Unit for Ported<M> {
    fn step(&mut self, inputs: &[u64], outputs: &mut [u64]) {
        write(&self.config, self.model.outputs(), outputs);
        let (rst, ports) = inputs.split_first().expect("every unit has the input rst");
        if *rst == 0 {
            self.model.clock(&read(&self.config, ports));
        } else {
            self.model.clone_from(&self.reset);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::Visitor;

    #[derive(Clone, Copy, Debug, Default)]
    struct Count {
        value: u32,
    }

    impl Visit<Words> for Count {
        type Config = ();

        fn visit(&mut self, (): &(), visitor: &mut impl Visitor<Words>) {
            visitor.bits(&mut self.value);
        }
    }

    impl Model for Count {
        type Config = ();
        type In = Self;
        type Out = Self;

        fn outputs(&self) -> Self {
            *self
        }

        fn clock(&mut self, inputs: &Self) {
            self.value += inputs.value;
        }
    }

    #[test]
    fn shows_then_clocks_then_resets() {
        let mut unit = Ported::new(&(), Count { value: 7 });
        let shown = [[0, 1], [0, 2], [1, 3], [0, 4], [0, 0]].map(|inputs| {
            let mut outputs = [0];
            unit.step(&inputs, &mut outputs);
            outputs[0]
        });
        assert_eq!(shown, [7, 8, 10, 7, 11]);
    }
}

//! Operators of floating-point numbers, placed by hand.

use std::rc::Rc;

use pointcore_contract::unit::{Input, Output};
use rtl::{Expr, Instance, Module};

use super::ports::WordPort;

const ENABLE: Input<bool> = Input::new("enable", "", "");
const OPERANDS: [Input<u64>; 2] = [Input::new("a", "", ""), Input::new("b", "", "")];
const RESULT: Output<u64> = Output::new("y", "", "");

/// An operator of two operands.
#[derive(Clone, Copy)]
pub(crate) struct Placed(Instance);

impl Placed {
    /// Places the operator's module as an instance of that name.
    pub fn new(m: &mut Module, name: &str, module: impl Into<Rc<Module>>) -> Self {
        Self(m.instance(name, module))
    }

    /// Feeds operands, which go on in cycles where `enable` is set; to be called once.
    pub fn feed(self, m: &mut Module, enable: impl Into<Expr>, operands: [Expr; 2]) {
        ENABLE.feed_word(m, self.0, enable);
        OPERANDS.into_iter().zip(operands).for_each(|(port, operand)| port.feed_word(m, self.0, operand));
    }

    /// What comes of them.
    pub fn result(self, m: &mut Module) -> Expr {
        RESULT.word_of(m, self.0)
    }
}

//! `#[record]`, `#[unit]` and `#[ports]`: what travels and what a unit's ports are, written once as a Rust struct.
//!
//! [`macro@record`] makes of a struct of plain fields one whose fields are words in a model and expressions in hardware, and says
//! their names, widths and meaning. [`macro@unit`] makes of a struct of ports what a model sees and shows in a cycle, and the
//! description that hardware, tests and documents take ports from.

mod annotation;
mod ports;
mod record;
mod unit;

use proc_macro::TokenStream;
use syn::{ItemStruct, parse_macro_input};

/// A record: `#[record(config: Config)]` names what its layout depends on.
///
/// Fields are `bool`, unsigned integers, arrays of them, or other records, whose fields stand in their place. The attributes of a
/// field are expressions of `config`, and of `i` (and `j`), the place in an array:
///
/// * `#[bits(…)]` its width; a `bool` has one bit;
/// * `#[below(…)]` what every value is below, where not all of its bits' are;
/// * `#[count(…)]` how many elements of an array there are, all by default;
/// * `#[name(…)]` its name, where that is not the field's own followed by `i`;
/// * `#[when(…)]` whether it is there at all;
/// * `#[with(…)]` what a record depends on, a reference, where that is not `config`.
#[proc_macro_attribute]
pub fn record(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let arguments = parse_macro_input!(arguments as annotation::RecordArguments);
    let item = parse_macro_input!(item as ItemStruct);
    record::expand(&arguments, &item).unwrap_or_else(|error| error.into_compile_error()).into()
}

/// The ports of a unit whose model does not meet them word by word: `#[ports(unit: Packets<'_, R>)]` names what they depend on.
///
/// As [`macro@unit`], but the struct may have parameters, and a field may be a bus. Makes a module of the struct's name in small
/// letters: `Ports`, of which `Ports::ALL` are the ports, and `interface`.
#[proc_macro_attribute]
pub fn ports(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let arguments = parse_macro_input!(arguments as annotation::RecordArguments);
    let item = parse_macro_input!(item as ItemStruct);
    ports::expand(&arguments, &item).unwrap_or_else(|error| error.into_compile_error()).into()
}

/// A unit's ports: `#[unit(search_sieve, config: Config)]` names its Verilog module and what its ports depend on.
///
/// Fields are `In<R>` and `Out<R>` (`valid`, `ready` and the fields of `R`), `PulseIn<R>` and `PulseOut<R>` (always taken), `Input<R>`
/// and `Output<R>` (there in every cycle; `R` may be an integer of `#[bits(…)]`). Further attributes of a field:
///
/// * `#[port("…")]` the name on the ports, where that is not the field's own; empty for the record's fields alone;
/// * `#[flag("…")]` what a pulse's `valid` is called;
/// * `#[when(…)]` whether it is there at all; on the struct, whether the unit is;
/// * `#[count(…)]` how many streams there are of an array, `[In<R>; 4]`: the first is named as the field, the next `NAME_1`;
/// * `#[with(…)]` what its record depends on, a reference, where that is not `config`.
///
/// Makes a module of the struct's name in small letters: `In` and `Out` for models, `PORTS` for hardware, `UNIT` for lists.
#[proc_macro_attribute]
pub fn unit(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let arguments = parse_macro_input!(arguments as annotation::UnitArguments);
    let item = parse_macro_input!(item as ItemStruct);
    unit::expand(&arguments, &item).unwrap_or_else(|error| error.into_compile_error()).into()
}

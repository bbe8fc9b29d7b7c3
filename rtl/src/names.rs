//! Names that Verilog, SystemVerilog readers of Verilog, and Verilator's C++ all take.

use std::collections::HashSet;
use std::sync::LazyLock;

use super::error::FaultKind;

/// Words that are taken, in alphabetical order.
const RESERVED: &str = "\
    abort alias always and asm assert assign assume auto automatic before begin bind bit bool break buf bufif0 bufif1 byte \
    case casex casez catch cell char checker class clk clocking cmos config const constraint context continue cover \
    covergroup coverpoint cross deassign default defparam delete design disable dist do double edge else end endcase \
    endclass endconfig endfunction endgenerate endgroup endinterface endmodule endpackage endprimitive endprogram \
    endproperty endsequence endspecify endtable endtask enum event eventually expect explicit export extends extern \
    false final first_match float for force foreach forever fork forkjoin friend function generate genvar global \
    goto highz0 highz1 if iff ifnone ignore_bins illegal_bins implements implies import incdir include initial \
    inline inout input inside instance int integer interconnect interface intersect join join_any join_none large \
    let liblist library local localparam logic long longint macromodule matches medium modport module mutable \
    namespace nand negedge nettype new nexttime nmos nor noshowcancelled not notif0 notif1 null operator or output \
    package packed parameter pmos posedge primitive priority private program property protected public pull0 pull1 \
    pulldown pullup pure rand randc randcase randsequence rcmos real realtime ref reg register reject_on release \
    repeat restrict return rnmos rpmos rst rtran rtranif0 rtranif1 scalared sequence shortint shortreal short \
    showcancelled signed sizeof small soft solve specify specparam static string strong strong0 strong1 struct super \
    supply0 supply1 switch table tagged task template this throw throughout time timeprecision timeunit tran tranif0 \
    tranif1 tri tri0 tri1 triand trior trireg true try type typedef typename union unique unique0 unsigned until \
    untyped use uwire var vectored virtual void volatile wait wait_order wand weak weak0 weak1 while wildcard wire \
    with within wor xnor xor";

static WORDS: LazyLock<HashSet<&str>> = LazyLock::new(|| RESERVED.split_whitespace().collect());

/// What speaks against a name, if anything.
pub(super) fn fault(name: &str) -> Option<FaultKind> {
    let bad = |reason| Some(FaultKind::BadName { name: name.into(), reason });
    let letter_first = name.starts_with(|c: char| c.is_ascii_alphabetic());
    if !letter_first || !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
        return bad("names are letters, digits and underscores, a letter first");
    }
    if name.contains("__") || name.ends_with('_') {
        return bad("doubled and final underscores are left to the tools");
    }
    if WORDS.contains(name) {
        return bad("it is a word of Verilog, SystemVerilog or C++, or an implicit port");
    }
    None
}
